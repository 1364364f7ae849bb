#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   check_instructions.sh BUILD preloaded|alone [SCENE...]
#
# What an accelerated Box2D costs: instructions of b2World::Step (callgrind), of the same Box2D as it is over it. None of the scenes may
# cost more than stock; with `alone` (a Box2D that rounds otherwise than an installed one) the geometric mean must be 1.05 at least;
# with `preloaded`, each as much, but for a hundredth, as the installed Box2D gains by the preloaded library in the same run. BUILD: a
# build tree of this project with BOOMERANG_BOX2D_SOURCE.
set -uo pipefail
build=${1:?} beside=${2:?}
shift 2
scenes=("$@")
[ ${#scenes[@]} -gt 0 ] || scenes=(planks needles sensors bullets coins-pile star-pile pyramid tiles)
profile=$(mktemp)
trap 'rm -f "$profile"' EXIT
# shellcheck source=tests/support/holds.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/holds.sh"
unset BOOMERANG BOOMERANG_HOOKS BOOMERANG_STRUCTURE BOOMERANG_PREFILTER BOOMERANG_STATISTICS BOOMERANG_VERBOSE LD_PRELOAD
export LD_BIND_NOW=1

# instructions SCENE PROGRAM [VARIABLE=VALUE...]: sets REPLY
instructions() {
    env "${@:3}" valgrind -q --tool=callgrind --toggle-collect='b2World::Step(float, int, int)' --callgrind-out-file="$profile" \
        "$build/bin/$2" "$1" --steps 100 --mode time >/dev/null 2>&1
    REPLY=$(awk '/^summary:/ { print $2; exit }' "$profile")
    [ "${REPLY:-0}" -gt 0 ]
}

# measure SCENE: sets stock, accelerated, and preloaded: what the library would need if it gained as much here as there
measure() {
    instructions "$1" boomerang-scene-vendored && stock=$REPLY && instructions "$1" boomerang-scene-accelerated && accelerated=$REPLY ||
        return 1
    preloaded=$accelerated
    [ "$beside" = preloaded ] || return 0
    local shared
    instructions "$1" boomerang-scene && shared=$REPLY &&
        instructions "$1" boomerang-scene BOOMERANG=on LD_PRELOAD="$build/lib/libboomerang_box2d.so" &&
        preloaded=$(awk -v s="$stock" -v i="$shared" -v p="$REPLY" 'BEGIN { printf "%.0f", s * p / i }')
}
is_as_much() { awk -v s="$stock" -v p="$preloaded" -v a="$accelerated" 'BEGIN { exit !(a <= s && a <= 1.01 * p) }'; }
mean_is_enough() { awk -v sum="$logarithms" -v n="${#scenes[@]}" 'BEGIN { printf "mean %.3f\n", exp(sum / n); exit !(exp(sum / n) >= 1.05) }'; }

logarithms=0
printf '%-12s %14s %10s %12s\n' scene 'stock, a step' preloaded accelerated
for scene in "${scenes[@]}"; do
    holds "$scene runs" measure "$scene" || continue
    awk -v n="$scene" -v s="$stock" -v p="$preloaded" -v a="$accelerated" -v beside="$beside" \
        'BEGIN { printf "%-12s %14d %10s %12.3f\n", n, s / 100, beside == "preloaded" ? sprintf("%.3f", s / p) : "-", s / a }'
    logarithms=$(awk -v sum="$logarithms" -v s="$stock" -v a="$accelerated" 'BEGIN { printf "%.6f", sum + log(s / a) }')
    holds "$scene: no more than stock needs, and than the preloaded library would" is_as_much
done
[ "$beside" = preloaded ] || holds "the mean is 1.05 at least" mean_is_enough
all_hold
