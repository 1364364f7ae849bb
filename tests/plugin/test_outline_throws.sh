#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Nothing that is thrown at an outline gets through its seams, and Box2D drops no impact with one but those that
# it finds where nothing touches: no more bodies are lost, and no more impacts dropped, than with the same
# pieces as plain polygons, and the bits are the same with Boomerang off, on and verified.
#
#   test_outline_throws.sh OUTLINE_THROWS
#
# BMR_OUTLINE_THROWS: how many throws (30,000). A tenth of them is verified.
set -uo pipefail
program=${1:?}
throws=${BMR_OUTLINE_THROWS:-30000}
temp=$(mktemp -d)
trap 'rm -rf "$temp"' EXIT
failures=0
unset BOOMERANG BOOMERANG_COUNTS BOOMERANG_VERBOSE LD_PRELOAD

fail() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$1"
}

# play NAME MODE FORM THROWS
play() { BOOMERANG=$2 "$program" "$3" "$4" >"$temp/$1" 2>"$temp/err" || fail "$1: exit status $?"; }

# count NAME WHAT: of all rooms.
count() { sed -n "s/^all: .* \([0-9]*\) $2.*/\1/p" "$temp/$1"; }

few=$((throws / 10))
play outlines on outlines "$throws"
play pieces on pieces "$throws"
for mode in off on verify; do
    play "few, $mode" "$mode" outlines "$few"
done
cat "$temp/outlines"
sed -n 's/^all/the same pieces without seams/p' "$temp/pieces"

for mode in on verify; do
    cmp -s "$temp/few, off" "$temp/few, $mode" || fail "$mode: other bits than with Boomerang off"
done
grep -q '^boomerang: verified [1-9][0-9,]* answers, 0 differ$' "$temp/err" || fail "verify: $(cat "$temp/err")"
[ "$(count outlines dropped)" -le "$(count pieces dropped)" ] || fail "more impacts were dropped than with plain pieces"
# Both lose what Box2D's search for impacts misses. Counts of rare events: three deviations of their difference.
awk -v ours="$(count outlines lost)" -v plain="$(count pieces lost)" 'BEGIN { exit !(ours <= plain + 3 * sqrt(ours + plain)) }' ||
    fail "more are lost than with plain pieces"
[ "$failures" -eq 0 ]
