#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# What things cost in instructions, stock Box2D beside the plugin: tables of the pages. Under callgrind,
# so the figures repeat themselves to a few parts in a thousand whatever else the machine does.
set -euo pipefail

usage() {
    cat <<'TEXT'
usage: measure_costs.sh [--steps N] BUILD_DIRECTORY TABLE...

Tables, each printed as its page has it (docs/scenes.md):
  calls      instructions of one contact, query, overlap, new pair
  listeners  the scenes of games with each contact listener, stock over plugin (SCENES="a b": these alone)
  sizes      docs/any-size-polygons.md: polygons of 8 to 4096 vertices, and circles, with the plugin
  outlines   docs/outlines.md: bodies of outlines beside the same of triangles
--steps N   steps of each scene (default: the scene's own)
Exit codes: 0 done; 2 wrong usage; 3 a program failed.
TEXT
}

steps='' build=''
tables=()
while [[ $# -gt 0 ]]; do
    case $1 in
    --steps) steps=${2:?}; shift ;;
    --help) usage; exit 0 ;;
    -*) usage >&2; exit 2 ;;
    *) if [[ -z $build ]]; then build=$1; else tables+=("$1"); fi ;;
    esac
    shift
done
plugin=$build/lib/libboomerang_box2d.so
worlds=$build/bin/bench_worlds
if [[ ${#tables[@]} = 0 || ! -e $plugin || ! -x $worlds ]]; then
    usage >&2
    exit 2
fi
profile=$(mktemp)
trap 'rm -f "$profile"' EXIT
# The dynamic linker's look-ups would be counted where a function is called first.
export LD_BIND_NOW=1

# profiled OPTIONS... PROGRAM ARGUMENTS...: leaves $profile.
profiled() {
    valgrind -q --tool=callgrind --callgrind-out-file="$profile" "$@" </dev/null >/dev/null || {
        echo "measure_costs.sh: failed: $*" >&2
        exit 3
    }
}

# All instructions that were collected.
# Instructions of the functions whose names begin with $1 and of all that they call, whoever calls them but themselves
# and the plugin below a step: a hook and the function of Box2D's behind it have one name, and the plugin's own pass has it in bmr. (A hook's has the version
# BOOMERANG_HOOKS, which keeps valgrind from demangling it.)
inclusive() {
    sed 's/@BOOMERANG_HOOKS$//' "$profile" | c++filt | awk -v name="$1" '
        function named(text, id) {
            match(text, /\([0-9]+\)/)
            id = substr(text, RSTART, RLENGTH)
            if (length(text) >= RSTART + RLENGTH)
                names[id] = substr(text, RSTART + RLENGTH + 1)
            return names[id]
        }
        function is_of(text) {
            return index(text, name) == 1 || index(text, pass "(") == 1
        }
        BEGIN { pass = name; sub(/^.*::/, "bmr::", pass); sub(/SolveTOI/, "SolveImpacts", pass) }
        /^fn=/ { caller = named($0) }
        /^cfn=/ { callee = named($0) }
        /^calls=/ {
            getline cost
            split(cost, field, " ")
            if (is_of(callee) && !is_of(caller) && (caller !~ /bmr::/ || caller ~ /bmr::(RunStep|IslandPass::Run)/))
                sum += field[2]
        }
        END { printf "%.0f\n", sum }'
}

# world stock|plugin WORLD COUNT STEPS
world() {
    local preload=''
    [[ $1 = stock ]] || preload=$plugin
    LD_PRELOAD=$preload profiled --toggle-collect='MeasuredStep*' "$worlds" "${@:2}"
}

# per_call SIDE FUNCTION WORLD EMPTY_WORLD: instructions of FUNCTION for each pair of WORLD and step, less those
# where the same bodies do not meet. In each world are twice as many bodies as PAIRS, and as many pairs, but for the chains: of 16
# bodies, in 75 pairs.
readonly PAIRS=400
per_call() {
    local side=$1 function=$2 full empty runs=8 pairs=$PAIRS
    [[ $3 = *-chain ]] && pairs=$((2 * PAIRS / 16 * 75))
    [[ $3 = new-* ]] && runs=1
    world "$side" "$3" $PAIRS $runs
    full=$(inclusive "$function")
    world "$side" "$4" $PAIRS $runs
    empty=$(inclusive "$function")
    echo $(((full - empty) / (pairs * runs)))
}

ratio() {
    awk -v a="$1" -v b="$2" 'BEGIN { printf "%.2f", a / b }'
}

calls() {
    local what function full empty stock ours
    echo "| what | stock | plugin | stock / plugin |"
    echo "| --- | --- | --- | --- |"
    while IFS='|' read -r what function full empty; do
        stock=$(per_call stock "$function" "$full" "$empty")
        ours=$(per_call plugin "$function" "$full" "$empty")
        echo "| $what | $stock | $ours | $(ratio "$stock" "$ours") |"
    done <<'TEXT'
contact of two boxes, apart|b2ContactManager::Collide|apart-box|far
the same, each box in nine such pairs|b2ContactManager::Collide|apart-chain|far
contact of two octagons, apart|b2ContactManager::Collide|apart-octagon|far
contact of two boxes, touching|b2ContactManager::Collide|touching-box|far
contact of two octagons, touching|b2ContactManager::Collide|touching-octagon|far
time of impact, box and hexagon, apart|b2World::SolveTOI|toi-polygon|toi-far
time of impact, edge and hexagon, apart|b2World::SolveTOI|toi-edge|toi-far
sensor, two octagons, apart|b2ContactManager::Collide|sensor-apart|far
sensor, two octagons, overlapping|b2ContactManager::Collide|sensor-overlapping|far
new pair|b2ContactManager::FindNewContacts|new-pairs|new-far
TEXT
}

# stepped PROGRAM SCENE OPTIONS...: instructions of a step, the mean of the first 100 (--steps).
stepped() {
    profiled "$build/bin/$1" "${@:2}" --mode time --steps "${steps:-100}"
    echo $(($(inclusive b2World::Step) / ${steps:-100}))
}

# Each scene of games, with the same listener on both sides.
listeners() {
    local name listener stock cells
    echo "| scene | stock, instructions a step | no listener | counts | reads | acts |"
    echo "| --- | --- | --- | --- | --- | --- |"
    for name in ${SCENES:-pyramid-50 cars chain-rocks ragdolls needles-100 mixed-pile}; do
        cells=''
        for listener in none counts reads acts; do
            stock=$(stepped boomerang-scene "$name" --listener "$listener")
            [[ $listener != none ]] || cells=$stock
            cells+=" | $(ratio "$stock" "$(stepped boomerang-scene-plugin "$name" --listener "$listener")")"
        done
        echo "| $name | $cells |"
    done
}

# beside FIRST OTHER...: the first, and each of the others with its ratio to the first.
beside() {
    local cells=$1 other
    for other in "${@:2}"; do
        cells+=" | $other ($(ratio "$other" "$1") x)"
    done
    echo "$cells"
}

sizes() {
    local scene vertices all
    echo "| instructions a step | octagons, stock | octagons | circles | 64 vertices | 256 | 4096 |"
    echo "| --- | --- | --- | --- | --- | --- | --- |"
    for scene in any-gas any-pile; do
        all=("$(stepped boomerang-scene "$scene" --bodies many --vertices 8)")
        all+=("$(stepped boomerang-scene-plugin "$scene" --vertices 8)" "$(stepped boomerang-scene-plugin "$scene" --bodies circle)")
        for vertices in 64 256 4096; do
            all+=("$(stepped boomerang-scene-plugin "$scene" --vertices "$vertices")")
        done
        echo "| \`$scene\` | $(beside "${all[@]}") |"
    done
}

outlines() {
    local scene
    echo "| instructions a step | outlines | triangles, with the plugin | triangles, stock |"
    echo "| --- | --- | --- | --- |"
    for scene in asteroids-outline gears-outline; do
        echo "| \`$scene\` | $(beside "$(stepped boomerang-scene-plugin "$scene" --bodies one)" \
            "$(stepped boomerang-scene-plugin "$scene" --bodies many)" "$(stepped boomerang-scene "$scene" --bodies many)") |"
    done
}

for table in "${tables[@]}"; do
    case $table in
    calls | listeners | sizes | outlines) "$table" ;;
    *) usage >&2; exit 2 ;;
    esac
done
