#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   check_instructions.sh BUILD VARIANT COUNTER [SCENE...]
#
# What an accelerated Box2D costs on ARM64: instructions of steps 21 to 300 of small scenes and 21 to 80 of large ones, counted by qemu
# (COUNTER: count_instructions.c, compiled for this machine), stock over accelerated. None may need more than the same Box2D as it is, but
# for `bullet`, three bodies of which one flies; the geometric mean is to be 1.05 at least; and the bodies are where
# they are in stock.
set -uo pipefail
build=${1:?} variant=${2:?} counter=${3:?}
shift 3
scenes=("$@")
[ ${#scenes[@]} -gt 0 ] || scenes=(planks needles plates sensors bullets coins-pile coins-gas star-pile asteroids gears mixed-pile terrain tumbler
    pyramid tiles dominos car bridge vertical-stack sensors-classic compound bullet)
last_of() {
    case $1 in
    dominos | car | bridge | vertical-stack | sensors-classic | compound | bullet) echo 300 ;;
    *) echo 80 ;;
    esac
}
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
# shellcheck source=tests/kit/holds.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../kit/holds.sh"
unset BOOMERANG BOOMERANG_PAIRS_BY BOOMERANG_COUNTS BOOMERANG_VERBOSE LD_PRELOAD
read -ra emulator <<<"${BOX2D_BUILDS_EMULATOR:?}"

# steps PROGRAM SCENE NUMBER: sets REPLY to the instructions of the whole program; its output is $room/PROGRAM.NUMBER
steps() {
    "${emulator[@]}" -plugin "$counter" -d plugin "$build/$1" "$2" "$3" >"$room/$1.$3" 2>"$room/err" || return 1
    REPLY=$(awk '$1 == "instructions" { print $2 }' "$room/err")
    [ "${REPLY:-0}" -gt 0 ]
}
# measure PROGRAM SCENE LAST: sets REPLY to those of steps 21 to LAST
measure() {
    local first
    steps "$1" "$2" 20 && first=$REPLY && steps "$1" "$2" "$3" && REPLY=$((REPLY - first)) && [ "$REPLY" -gt 0 ]
}
mean_is_enough() { awk -v sum="$logarithms" -v n="${#scenes[@]}" 'BEGIN { printf "mean %.3f\n", exp(sum / n); exit !(exp(sum / n) >= 1.05) }'; }

logarithms=0
printf '%-16s %14s %14s %8s\n' scene stock accelerated ratio
for scene in "${scenes[@]}"; do
    last=$(last_of "$scene")
    holds "$scene: stock" measure "scene_steps_$variant" "$scene" "$last" || continue
    stock=$REPLY
    holds "$scene: accelerated" measure "scene_steps_${variant}_accelerated" "$scene" "$last" || continue
    accelerated=$REPLY
    awk -v n="$scene" -v s="$stock" -v a="$accelerated" -v steps=$((last - 20)) \
        'BEGIN { printf "%-16s %14.0f %14.0f %8.3f\n", n, s / steps, a / steps, s / a }'
    logarithms=$(awk -v sum="$logarithms" -v s="$stock" -v a="$accelerated" 'BEGIN { printf "%.6f", sum + log(s / a) }')
    [ "$scene" = bullet ] || holds "$scene: no more than stock needs" test "$accelerated" -le "$stock"
    holds "$scene: the bodies are where they are in stock" cmp -s "$room/scene_steps_$variant.$last" "$room/scene_steps_${variant}_accelerated.$last"
    # Control: they do move.
    holds "$scene: control: another step is another place" test "$(cat "$room/scene_steps_$variant.$last")" != "$(cat "$room/scene_steps_$variant.20")"
done
holds "the mean is 1.05 at least" mean_is_enough
all_hold
