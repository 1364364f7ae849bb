#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# One hour of simulated time of the scene that makes and destroys all the time, on stock Box2D and with the
# plugin, every hook on: the bits of all steps must agree, and the plugin's memory must stay as flat as stock's.
# Some minutes of computing; not part of the tests.
set -euo pipefail

usage() {
    cat <<'TEXT'
usage: run_soak.sh [--steps N] [--scene NAME] [--control] BUILD_DIRECTORY

Runs boomerang-scene and boomerang-scene-plugin of BUILD_DIRECTORY side by side, samples their resident memory, and
compares what they print after each step.
  --steps N      how many steps (default 216000: an hour at 60 steps a second)
  --scene NAME   which scene (default chain-rocks)
  --csv FILE     keep the samples: side,seconds,step,kilobytes
  --control      let each step of the plugin's side lose a kilobyte: the script must then fail
Exit codes: 0 flat and identical; 1 not; 2 wrong usage; 3 a program failed.
TEXT
}

# What may be resident in the end beyond what was after the warm-up, over and above what stock grew by: 5 bytes
# for each step of the hour. One leaked contact (224 bytes) in fifty steps is more; steps of malloc's and Box2D's
# chunks (16 KB) are far less.
readonly ALLOWED_KILOBYTES=1024
# The scene's high-water marks of bodies and contacts rise for a while.
readonly WARM_UP_PERCENT=20
readonly SAMPLE_SECONDS=1

steps=216000 scene=chain-rocks control=0 csv='' build=''
while [[ $# -gt 0 ]]; do
    case $1 in
    --steps) steps=${2:?}; shift ;;
    --scene) scene=${2:?}; shift ;;
    --csv) csv=${2:?}; shift ;;
    --control) control=1 ;;
    --help) usage; exit 0 ;;
    -*) usage >&2; exit 2 ;;
    *) build=$1 ;;
    esac
    shift
done
if [[ -z $build || ! -x $build/bin/boomerang-scene-plugin || ! $steps =~ ^[1-9][0-9]*$ ]]; then
    usage >&2
    exit 2
fi

work=$(mktemp -d)
pids=()
clean_up() {
    local pid
    for pid in "${pids[@]}"; do
        kill "$pid" 2>/dev/null || true
    done
    rm -rf "$work"
}
trap clean_up EXIT

preload=''
if [[ $control = 1 ]]; then
    cc -shared -fPIC -O1 -o "$work/leaking_step.so" "$(dirname "$0")/leaking_step.c" -ldl
    preload=$work/leaking_step.so
fi
"$build/bin/boomerang-scene" "$scene" --steps "$steps" --mode hash >"$work/stock" &
pids+=($!)
LD_PRELOAD=$preload "$build/bin/boomerang-scene-plugin" "$scene" --steps "$steps" --mode hash >"$work/plugin" &
pids+=($!)
sides=(stock plugin)

# side,seconds,step,kilobytes, as long as it runs
sample() {
    local side=$1 pid=$2 kilobytes step
    kilobytes=$(awk '/^VmRSS:/ { print $2 }' "/proc/$pid/status" 2>/dev/null) || return 1
    step=$(tail -c 400 "$work/$side" | awk '$1 == "step" && NF == 5 { last = $2 } END { print last + 0 }')
    [[ -n $kilobytes ]] && echo "$side,$SECONDS,$step,$kilobytes" >>"$work/samples"
}
while :; do
    running=0
    for i in 0 1; do
        if sample "${sides[i]}" "${pids[i]}"; then
            running=1
        fi
    done
    [[ $running = 1 ]] || break
    sleep "$SAMPLE_SECONDS"
done
failed=0
for i in 0 1; do
    wait "${pids[i]}" || { echo "run_soak.sh: ${sides[i]} failed" >&2; failed=1; }
done
pids=()
[[ $failed = 0 ]] || exit 3
[[ -z $csv ]] || { echo "side,seconds,step,kilobytes"; cat "$work/samples"; } >"$csv"

status=0
for side in "${sides[@]}"; do
    grep '^step ' "$work/$side" >"$work/$side.steps"
done
if [[ $(wc -l <"$work/stock.steps") != "$steps" ]] || ! cmp "$work/stock.steps" "$work/plugin.steps"; then
    echo "run_soak.sh: the bits differ, or steps are missing" >&2
    status=1
fi
awk -F, -v steps="$steps" -v percent=$WARM_UP_PERCENT -v allowed=$ALLOWED_KILOBYTES '
    $3 >= steps * percent / 100 {
        if (!($1 in first))
            first[$1] = $4
        last[$1] = $4
        count[$1]++
        if ($4 > most[$1])
            most[$1] = $4
    }
    END {
        for (side in count)
            printf "%-6s %d samples: %d KB after the warm-up, %d at the end, %d at most\n", side, count[side],
                first[side], last[side], most[side]
        if (count["stock"] < 2 || count["plugin"] < 2) {
            print "too few samples: ask for more steps" > "/dev/stderr"
            exit 1
        }
        beyond = (last["plugin"] - first["plugin"]) - (last["stock"] - first["stock"])
        printf "the plugin grew by %d KB more than stock; %d are allowed\n", beyond, allowed
        exit beyond > allowed
    }' "$work/samples" || status=1
exit $status
