#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   test_surprises.sh PLUGIN GAME FROZEN [random]
#
# The game of surprises prints the same lines with the plugin preloaded as without. FROZEN is a library that does not look
# again at contacts that were apart: it must be noticed, or the game has no power. With `random`, random worlds instead.
#
# Environment: BMR_TEST_SEED        the first seed (default 1)
#              BMR_SURPRISES_SEEDS  so many of them (default 10)
set -uo pipefail
plugin=${1:?} game=${2:?} frozen=${3:?} random=${4:-}
seed=${BMR_TEST_SEED:-1} count=${BMR_SURPRISES_SEEDS:-10}
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
failures=0
unset BOOMERANG_EVERYWHERE BOOMERANG BOOMERANG_HOOKS BOOMERANG_STRUCTURE BOOMERANG_PREFILTER BOOMERANG_STATISTICS BOOMERANG_VERBOSE LD_PRELOAD
ulimit -c 0

# Changes after which the plugin is known not to answer as Box2D. Each must still differ somewhere: what was mended is to be
# taken off this list.
#   normals: of bodies of many fixtures, normals that were edited in place and no longer are those of the polygons' sides
differing='normals'

fail() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$1"
}
# play NAME [VARIABLE=VALUE]... -- ARGUMENT...: what the game prints, into $room/NAME
play() {
    local name=$1 variables=()
    shift
    while [ "$1" != -- ]; do
        variables+=("$1")
        shift
    done
    shift
    env "${variables[@]}" "$game" "$@" >"$room/$name" 2>"$room/$name.err"
}
# differ NAME: the changes after which $room/NAME is not as $room/stock, once for each scenario
differ() { diff "$room/stock" "$room/$1" | sed -n 's/^< \([a-z-]*\)[@ ].*/\1/p'; }

if [ "$random" = random ]; then
    asserted=0
    for ((i = seed; i < seed + count; ++i)); do
        status=0 expected=0
        # Some of these worlds end in an assertion of Box2D's: then both must have come as far, to the same one.
        play stock -- random "$i" 1 2>/dev/null || expected=$?
        play played LD_PRELOAD="$plugin" BOOMERANG_EVERYWHERE=on -- random "$i" 1 2>/dev/null || status=$?
        [ "$expected" -eq 0 ] || asserted=$((asserted + 1))
        if [ "$status" -ne "$expected" ] || ! cmp -s "$room/stock" "$room/played"; then
            fail "seed $i: other output than stock's"
        fi
    done
    [ $((10 * asserted)) -le "$count" ] || fail "$asserted of $count seeds end in an assertion of stock Box2D's"
    [ "$failures" -eq 0 ] || { echo "$failures of $count seeds failed"; exit 1; }
    echo "passed: seeds $seed to $((seed + count - 1)), $asserted of them to an assertion of Box2D's"
    exit 0
fi

play power -- power &
play stock -- all || fail "stock Box2D does not survive it: $(tail -n 1 "$room/stock.err")"
[ "$(wc -l <"$room/stock")" -gt 500 ] || fail "few scenarios"
play played LD_PRELOAD="$plugin" BOOMERANG_STATISTICS="$room/json" -- all || fail "with the plugin: exit status $?"
[ -s "$room/json" ] || fail "the plugin is not at work"
differ played | sort -u >"$room/differing"
while read -r change; do
    [[ " $differing " == *" $change "* ]] || fail "$change: other output than stock's: $(diff "$room/stock" "$room/played" | grep -m 1 "^< $change")"
done <"$room/differing"
for change in $differing; do
    grep -qx "$change" "$room/differing" || fail "$change: as in Box2D by now, and still on the list of what differs"
done
# Every scenario comes to its change, and nothing goes unnoticed by a game in which nothing is looked at.
grep 'changed in -1' "$room/stock" && fail "scenarios in which nothing happens"
# Each change shows in events, in its own step or soon: without it they are others.
wait
awk '$1 ~ /^nothing@/ ? $3 >= 0 : $3 < $2 || $3 > $2 + 3' "$room/power" >"$room/weak"
if [ ! -s "$room/power" ] || [ -s "$room/weak" ]; then fail "without power: $(head -n 3 "$room/weak")"; fi
play heeding LD_PRELOAD="$frozen" BMR_FROZEN=heeding -- all &
play frozen LD_PRELOAD="$frozen" -- all || fail "control: exit status $?: $(tail -n 1 "$room/frozen.err")"
wait $! || fail "control, heeding motion: exit status $?"
for control in frozen heeding; do
    differ "$control" | sort -u >"$room/noticed"
    grep -qx nothing "$room/noticed" && fail "control, $control: noticed where nothing happens"
    mapfile -t wanted <"$(dirname "${BASH_SOURCE[0]}")/noticed_$control.txt"
    for change in "${wanted[@]}"; do
        grep -qx "$change" "$room/noticed" || fail "control, $control: $change goes unnoticed"
    done
done
[ "$failures" -eq 0 ] || { echo "$failures claim(s) failed"; exit 1; }
echo "passed: $(wc -l <"$room/stock") lines"
