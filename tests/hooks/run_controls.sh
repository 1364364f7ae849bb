#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   run_controls.sh ROOT COMPILER SCENE_PROGRAM OUTSIDE_GAME GAMES OBJECTS... -- LINK_ARGUMENTS...
#
# Takes one piece of a hook out of the shared library at a time, preloads the library into the plain program that runs
# a scene, and expects its hashes to differ from stock's. With nothing taken out they must be stock's. Where the scene is
# called outside_game that program is run instead, with the library for its own, and must fail; other names in _game
# are programs in the directory GAMES, which arguments may follow (a colon for an @), and unheard-ends or unheard-pairs be ahead of
# them: contacts then end, or are made, without a word; `wrapped` likewise: no step is seen; "actor SEED" are so many worlds of the program actor_stock beside SCENE_PROGRAM.
# OBJECTS: those of the shared library; LINK_ARGUMENTS: what else it is linked from.
# BMR_LONG_CONTROLS in the environment: mutants_long.txt, too.
set -u
root=$1 compiler=$2 program=$3 outside_game=$4 games=$5
shift 5
objects=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    objects+=("$1")
    shift
done
shift
link=("$@")
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
# B2_SHARED as in the library's own build: Box2D's functions that are defined here must be seen.
flags="-std=c++17 -O0 -fPIC -fvisibility=hidden -ftls-model=initial-exec -ffp-contract=off -w -DB2_SHARED"
# shellcheck source=tests/kit/mutant_library.sh
source "$root/tests/kit/mutant_library.sh"

# within COMMAND…: as far as it comes. What is run here has a second of the processor at most when it is well: what has used
# $limit goes round for ever without its piece. (Of the processor: the clock goes on where the machine is busy. What has stopped
# without using any is ended at last by the clock.)
limit=20 patience=1500
within() { (ulimit -t "$limit" && exec timeout "$patience" "$@"); }

# hashes SCENE STEPS [LIBRARY]: what the scene prints, with the library in front
nothing=$(cksum </dev/null)
hashes() {
    local -x BOOMERANG_EVERYWHERE=on BOOMERANG_HOOKS=all
    if [[ $1 = "listed "* ]]; then # without a ledger
        BOOMERANG_HOOKS=all,-ledger
        set -- "${1#listed }" "${@:2}"
    fi
    local ahead=
    if [[ $1 = unheard-* ]]; then
        ahead=${1%% *}
        ahead=$games/libunheard_${ahead#unheard-}.so:
        set -- "${1#* }" "${@:2}"
    elif [[ $1 = "wrapped "* ]]; then
        ahead=$games/libwrapping.so:
        set -- "${1#* }" "${@:2}"
    fi
    if [ "$1" = outside_game ]; then
        [ -z "${3:-}" ] || cp "$3" "$(dirname "$3")/libboomerang_box2d.so.1"
        LD_LIBRARY_PATH=${3:+$(dirname "$3")} within "$outside_game"
        return
    fi
    if [[ ${1%% *} = *_game ]]; then
        # (In a shell of its own, which says nothing where the game crashes.)
        (BOOMERANG=on LD_PRELOAD=${3:+$ahead}${3:-} MALLOC_PERTURB_=165 within "$games"/${1//:/@}) 2>/dev/null | cksum
        return
    fi
    if [ "${1%% *}" = actor ]; then
        (BOOMERANG=on LD_PRELOAD=${3:-} MALLOC_PERTURB_=165 within "$(dirname "$program")/actor_stock" seeds "${1#* }" "$2") 2>/dev/null | cksum
        return
    fi
    BOOMERANG=on LD_PRELOAD=${3:-} within "$program" "$1" --steps "$2" 2>/dev/null | grep '^step' | cksum
}

# stock SCENE STEPS: what it prints without the library; run once, for many controls ask the same
stock() {
    local kept=$room/stock-$1-$2
    (
        flock 9
        [ -e "$kept" ] || hashes "$1" "$2" >"$kept"
    ) 9>"$kept.lock"
    cat "$kept"
}

# control NUMBER NAME FILE UNIT SUBSTITUTION SCENE STEPS: writes its verdict to $room/NUMBER
control() {
    local number=$1 name=$2 place=$room/$1.d expected
    if ! mutate "$place" "$3" "$4" "$5" >"$room/$number.err" 2>&1; then
        { echo "FAILED: $name: does not build"; head -n 5 "$room/$number.err"; } >"$room/$number"
        rm -rf "$place"
        return
    fi
    expected=$(stock "$6" "$7")
    if [ -z "$expected" ] || [ "$expected" = "$nothing" ]; then
        echo "FAILED: $name: $6 prints nothing without the library" >"$room/$number"
    elif [ "$(hashes "$6" "$7" "$place/libmutant.so")" = "$expected" ]; then
        echo "FAILED: $name: nothing differs in $6" >"$room/$number"
    else
        echo "passed: $name" >"$room/$number"
    fi
    rm -rf "$place"
}

passed=0 failed=0
# With nothing taken out: the library works when it is made in this way.
if mutate "$room/whole" plugin/hooks/pair_finding.cpp plugin/hooks/pair_finding.cpp "" >"$room/err" 2>&1 &&
    [ "$(hashes churn 100 "$room/whole/libmutant.so")" = "$(stock churn 100)" ] &&
    [ "$(hashes outside_game 0 "$room/whole/libmutant.so")" = passed ]; then
    echo "passed: the whole library gives stock's hashes"
    passed=1
else
    echo "FAILED: the whole library does not give stock's hashes"
    cat "$room/err"
    failed=1
fi

number=0
while IFS='@' read -r name file unit substitution scene steps; do
    case $name in '' | \#*) continue ;; esac
    number=$((number + 1))
    control "$number" "$name" "$file" "$unit" "$substitution" "$scene" "$steps" &
    while [ "$(jobs -rp | wc -l)" -ge "${BMR_JOBS:-$(nproc)}" ]; do wait -n; done
done < <(cat "$root/tests/hooks/mutants.txt" ${BMR_LONG_CONTROLS:+"$root/tests/hooks/mutants_long.txt"})
wait
for i in $(seq "$number"); do
    cat "$room/$i"
    if grep -q "^passed" "$room/$i"; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$number" -gt 0 ]
