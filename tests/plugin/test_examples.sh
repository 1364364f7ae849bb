#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   test_examples.sh DIRECTORY-OF-THE-EXAMPLES
#
# Each example prints the same with Boomerang off, at work and under verify, and what its comment says; under verify nothing differs.
set -uo pipefail
bin=${1:?}
temp=$(mktemp -d)
holds_shows=$temp/err
trap 'rm -rf "$temp"' EXIT
# shellcheck source=tests/kit/holds.sh
source "$(dirname "${BASH_SOURCE[0]}")/../kit/holds.sh"
unset BOOMERANG BOOMERANG_PAIRS_BY BOOMERANG_COUNTS BOOMERANG_VERBOSE LD_PRELOAD

# plays EXAMPLE MODE PATTERN: all that it prints fits the pattern, and is what it printed first
plays() {
    local got
    got=$(BOOMERANG=$2 BOOMERANG_COUNTS=$temp/counts "$bin/$1" 2>"$temp/err") && [[ $got =~ ^$3$ ]] || return 1
    [ -e "$temp/$1" ] || echo "$got" >"$temp/$1"
    [ "$got" = "$(cat "$temp/$1")" ]
}
says() { grep -qE "$1" "$temp/err"; }
counts() { grep -qE "$1" "$temp/counts"; }

for row in 'game_loop|score [1-9][0-9]+' 'recorder|score 30, health 85, on the platform'; do
    for mode in off '' on verify; do
        holds "${row%%|*}, BOOMERANG=$mode" plays "${row%%|*}" "$mode" "${row#*|}"
        [ "$mode" != verify ] || holds "${row%%|*}: nothing differs" says '^boomerang: verified [1-9][0-9,]* answers, 0 differ$'
        [ "${row%%|*}, $mode" != "game_loop, off" ] || holds "the loop says that it is off" says 'Boomerang off'
        [ "${row%%|*}, $mode" != "game_loop, on" ] || holds "the loop says that it is at work" says 'Boomerang at work'
        [ "${row%%|*}, $mode" != "game_loop, on" ] || holds "times of impact are answered" counts '^toi_answered [1-9]'
    done
done
all_hold
