#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   play.sh BUILD VARIANT PLUGIN [SEED...]
#
# Plays worlds of the actor on one Box2D of the shelf: without the plugin, with it preloaded, linked ahead, and (where
# BOX2D_BUILDS_WAYS says so) compiled with it. Exit status and every line must be those without it. BUILD: where the shelf was built.
# An accelerated Box2D that fuses products elsewhere does not: it is held against another program, BOX2D_BUILDS_UNFUSED.
#
# Environment: BOX2D_BUILDS_WAYS   the ways of the plugin (default: preloaded ahead)
#              BOX2D_BUILDS_UNFUSED  the program that has the bits of the accelerated ones (default: the variant's)
#              BMR_TEST_SEED       the first seed (default 1), where none is named
#              BOX2D_BUILDS_SEEDS  so many of them (default 24)
set -uo pipefail
build=${1:?} variant=${2:?} plugin=${3:?}
shift 3
read -ra ways <<<"${BOX2D_BUILDS_WAYS:-preloaded ahead}"
program=$build/$variant/games_$variant
temp=$(mktemp -d)
trap 'rm -rf "$temp"' EXIT
passed=0 failed=0
unset BOOMERANG BOOMERANG_PAIRS_BY BOOMERANG_COUNTS BOOMERANG_VERBOSE LD_PRELOAD
# What goes round for ever ends: many hundred times what a game needs of a processor, however busy the machine is.
ulimit -t 60
ulimit -c 0

# shellcheck source=tests/box2d_builds/processor.sh
source "$(dirname "${BASH_SOURCE[0]}")/processor.sh"
processor_for "$variant" || exit 1

fails() {
    failed=$((failed + 1))
    printf 'FAILED: %s: %s\n' "$variant" "$*"
}

# play NAME PRELOADED PROGRAM ARGUMENT...: what it prints into $temp/NAME, what it says into $temp/NAME.err
play() {
    # (In a shell of its own: what that says of a crash goes to /dev/null.)
    (
        "${runner[@]}" ${2:+"${set_variable[@]}" "LD_PRELOAD=$2"} "$3" "${@:4}" >"$temp/$1" 2>"$temp/$1.err"
        exit $?
    ) 2>/dev/null
}

# first_difference FILE FILE: game and step of the first line that is not the same in both
first_difference() {
    paste -d '\n' "$1" "$2" |
        awk 'NR % 2 { a = $0; next } a != $0 { split(a == "" ? $0 : a, n, " "); print n[1], "step", n[2]; exit }'
}

# game SEED: played in all ways
game() {
    local way played preload status expected=0 wanted stock
    play stock '' "$program" "$@" || expected=$?
    if [ "$expected" -ne 0 ] || [ ! -s "$temp/stock" ]; then
        fails "stock Box2D does not survive '$*' (exit status $expected), so that the game is at fault and not the plugin;" \
            "it came to $(tail -n 1 "$temp/stock" | cut -d' ' -f1,2) and said: $(tail -n 1 "$temp/stock.err")"
        return
    fi
    stock=$expected
    for way in "${ways[@]}"; do
        played=${program}_$way preload='' status=0 wanted=$temp/stock expected=$stock
        if [[ $way = accelerated* && -n ${BOX2D_BUILDS_UNFUSED:-} ]]; then
            wanted=$temp/unfused expected=0
            play unfused '' "$BOX2D_BUILDS_UNFUSED" "$@" || expected=$?
        fi
        [ "$way" != preloaded ] || { played=$program preload=$plugin; }
        play played "$preload" "$played" "$@" || status=$?
        if grep -q '^ERROR: ld.so' "$temp/played.err"; then
            fails "$way: '$*': the plugin was not loaded: $(grep -m1 '^ERROR: ld.so' "$temp/played.err")"
        elif [ "$status" -eq "$expected" ] && cmp -s "$temp/played" "$wanted"; then
            passed=$((passed + 1))
        else
            fails "$way: '$*': exit status $status, stock's is $expected; first difference:" \
                "$(first_difference "$wanted" "$temp/played"); $(tail -n 1 "$temp/played.err")"
        fi
    done
}

for seed; do game "$seed"; done
if [ $# -eq 0 ]; then
    # Worlds whose listeners do what the others seldom do. The game counts that.
    while read -r seed deed; do
        game "$seed"
        grep -q "^did \"$deed\" [0-9][0-9]" "$temp/stock.err" || fails "$seed: its listeners have not done it: $deed"
    done <<<'95 steps the other world
317 edits a shape
97 draws'
    first=${BMR_TEST_SEED:-1} count=${BOX2D_BUILDS_SEEDS:-24} over=0
    printf 'seeds %d to %d\n' "$first" $((first + count - 1))
    # Each in a process of its own: one that ends badly takes no other with it. Some do in stock alone: those are passed over, and so
    # are worlds that are others when fresh memory holds something else.
    for ((seed = first; seed < first + count; ++seed)); do
        if MALLOC_PERTURB_=85 play again '' "$program" "$seed" && MALLOC_PERTURB_=165 play stock '' "$program" "$seed" &&
            cmp -s "$temp/again" "$temp/stock"; then
            game "$seed"
        else
            over=$((over + 1))
        fi
    done
    [ $((5 * over)) -le "$count" ] || fails "stock Box2D does not survive $over of $count seeds"
fi
printf '%s: %d passed, %d failed\n' "$variant" "$passed" "$failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
