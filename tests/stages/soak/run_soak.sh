#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   run_soak.sh BUILD [STEPS [PRELOADED]]
#
# An hour of simulated time (or STEPS) of the scene that makes and destroys all the time, on stock Box2D and with the plugin, every
# hook on: the bits of all steps must agree, and the plugin's resident memory must stay as flat as stock's. Some minutes of computing.
# PRELOADED: a library ahead of the plugin's side, for the control. Exit status 1: other bits, or memory grew.
set -euo pipefail
build=${1:?usage: run_soak.sh BUILD [STEPS [PRELOADED]]} steps=${2:-216000} preloaded=${3:-}
# What the plugin may grow by beyond what stock does: 5 bytes for each step of the hour. One leaked contact (224 bytes) in fifty
# steps is more; steps of malloc's and Box2D's chunks (16 KB) are far less.
readonly ALLOWED_KILOBYTES=1024
work=$(mktemp -d)
declare -A pids first last
trap 'kill "${pids[@]}" 2>/dev/null || true; rm -rf "$work"' EXIT

LD_PRELOAD='' "$build/bin/boomerang-scene" chain-rocks --steps "$steps" --mode hash >"$work/stock" &
pids[stock]=$!
LD_PRELOAD=$preloaded "$build/bin/boomerang-scene-plugin" chain-rocks --steps "$steps" --mode hash >"$work/plugin" &
pids[plugin]=$!
# Each second, from a fifth of the steps on: high-water marks of bodies and contacts rise for a while.
while kill -0 "${pids[stock]}" 2>/dev/null || kill -0 "${pids[plugin]}" 2>/dev/null; do
    for side in stock plugin; do
        kilobytes=$(awk '/^VmRSS:/ { print $2 }' "/proc/${pids[$side]}/status" 2>/dev/null) || continue
        step=$(tail -c 400 "$work/$side" | awk '$1 == "step" && NF == 5 { last = $2 } END { print last + 0 }')
        if [ -n "$kilobytes" ] && [ "$step" -ge $((steps / 5)) ]; then
            first[$side]=${first[$side]:-$kilobytes} last[$side]=$kilobytes
        fi
    done
    sleep 1
done
wait "${pids[stock]}" && wait "${pids[plugin]}"

status=0
for side in stock plugin; do
    grep '^step ' "$work/$side" >"$work/$side.steps"
    printf '%s: %s KB after the warm-up, %s at the end\n' "$side" "${first[$side]:?too few samples: ask for more steps}" "${last[$side]}"
done
if [ "$(wc -l <"$work/stock.steps")" -ne "$steps" ] || ! cmp "$work/stock.steps" "$work/plugin.steps"; then
    echo "run_soak.sh: the bits differ, or steps are missing" >&2
    status=1
fi
beyond=$((last[plugin] - first[plugin] - (last[stock] - first[stock])))
printf 'the plugin grew by %d KB more than stock; %d are allowed\n' "$beyond" "$ALLOWED_KILOBYTES"
[ "$beyond" -le "$ALLOWED_KILOBYTES" ] || status=1
exit "$status"
