#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# How long a step of a small world takes whose code and data a renderer has put out of the caches: stock Box2D, the plugin
# switched off, and the plugin, in turn. Medians over processes, which lie at other addresses each time.
set -euo pipefail

usage() {
    cat <<'TEXT'
usage: cold_steps.sh [--processes N] [--warm] BUILD_DIRECTORY [WORLD:SIZE...]

Prints a row of Markdown for each world (default: bullet:12 car:9 dominos:6 platforms:9): nanoseconds of a step, and stock over each.
--processes N   of each of the three (default: 30)
--warm          nothing is put out of the caches
Exit codes: 0 done; 2 wrong usage; 3 a program failed.
TEXT
}

processes=30 warm='' steps=600 build=''
worlds=()
while [[ $# -gt 0 ]]; do
    case $1 in
    --processes) processes=${2:?}; shift ;;
    --warm) warm=warm ;;
    --help) usage; exit 0 ;;
    -*) usage >&2; exit 2 ;;
    *) if [[ -z $build ]]; then build=$1; else worlds+=("$1"); fi ;;
    esac
    shift
done
program=$build/bin/bench_cold_steps plugin=$build/lib/libboomerang_box2d.so
[[ -x $program && -e $plugin ]] || { usage >&2; exit 2; }
[[ ${#worlds[@]} -gt 0 ]] || worlds=(bullet:12 car:9 dominos:6 platforms:9)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

median() { sort -n "$1" | awk '{ all[NR] = $1 } END { printf "%d", all[int((NR + 1) / 2)] }'; }

# ratio FILE: stock over it, process by process: the median, and the first and the last quarter.
ratio() {
    paste "$scratch/stock" "$1" | awk '{ print $1 / $(NF / 2 + 1) }' | sort -n |
        awk '{ all[NR] = $1 } END { printf "%.2f (%.2f to %.2f)", all[int((NR + 1) / 2)], all[int((NR + 3) / 4)], all[int((3 * NR + 1) / 4)] }'
}

echo "| world | contacts | stock, ns | off, ns | plugin, ns | stock / off | stock / plugin |"
echo "| --- | --- | --- | --- | --- | --- | --- |"
for world in "${worlds[@]}"; do
    rm -f "$scratch"/*
    for ((i = 0; i < processes; ++i)); do
        "$program" "${world%:*}" "${world#*:}" $steps $warm >>"$scratch/stock" || exit 3
        BOOMERANG=off LD_PRELOAD=$plugin "$program" "${world%:*}" "${world#*:}" $steps $warm >>"$scratch/off" || exit 3
        BOOMERANG=on LD_PRELOAD=$plugin "$program" "${world%:*}" "${world#*:}" $steps $warm >>"$scratch/on" || exit 3
    done
    echo "| $world | $(awk 'NR == 1 { print $2 }' "$scratch/stock") | $(median "$scratch/stock") | $(median "$scratch/off") |" \
        "$(median "$scratch/on") | $(ratio "$scratch/off") | $(ratio "$scratch/on") |"
done
