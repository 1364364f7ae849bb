#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   check_instructions.sh BUILD [SCENE...]
#
# What an accelerated Box2D costs: instructions of b2World::Step (callgrind). No scene may cost more than the same Box2D as it is, and each
# must need as few, but for a hundredth, as the preloaded library with the installed Box2D does in the same run. BUILD: a build tree of
# this project with BOOMERANG_BOX2D_SOURCE. BOX2D_BUILDS_STEPS: of each scene (default 100).
set -uo pipefail
build=${1:?}
shift
scenes=("$@")
[ ${#scenes[@]} -gt 0 ] || scenes=(planks needles sensors bullets coins-pile star-pile pyramid tiles)
profile=$(mktemp)
trap 'rm -f "$profile"' EXIT
# shellcheck source=tests/kit/holds.sh
source "$(dirname "${BASH_SOURCE[0]}")/../kit/holds.sh"
unset BOOMERANG BOOMERANG_PAIRS_BY BOOMERANG_COUNTS BOOMERANG_VERBOSE LD_PRELOAD
export LD_BIND_NOW=1

steps=${BOX2D_BUILDS_STEPS:-100}

# instructions SCENE PROGRAM [VARIABLE=VALUE...]: sets REPLY
instructions() {
    env "${@:3}" valgrind -q --tool=callgrind --toggle-collect='b2World::Step(float, int, int)' --callgrind-out-file="$profile" \
        "$build/bin/$2" "$1" --steps "$steps" --mode time >/dev/null 2>&1
    REPLY=$(awk '/^summary:/ { print $2; exit }' "$profile")
    [ "${REPLY:-0}" -gt 0 ]
}

# measure SCENE: sets stock, accelerated, installed and preloaded
measure() {
    instructions "$1" boomerang-scene-vendored && stock=$REPLY && instructions "$1" boomerang-scene-accelerated && accelerated=$REPLY &&
        instructions "$1" boomerang-scene && installed=$REPLY &&
        instructions "$1" boomerang-scene BOOMERANG=on LD_PRELOAD="$build/lib/libboomerang_box2d.so" && preloaded=$REPLY
}
is_as_little() { awk -v s="$stock" -v p="$preloaded" -v a="$accelerated" 'BEGIN { exit !(a <= s && a <= 1.01 * p) }'; }

# Instructions a step, and by how much: the installed Box2D over the preloaded library and over the accelerated one, and the latter's own
# Box2D as it is over it.
printf '%-12s %12s %12s %12s %12s %10s %12s %8s\n' scene installed preloaded stock accelerated preloaded accelerated own
for scene in "${scenes[@]}"; do
    holds "$scene runs" measure "$scene" || continue
    awk -v n="$scene" -v i="$installed" -v p="$preloaded" -v s="$stock" -v a="$accelerated" -v steps="$steps" \
        'function ratio(x, y) { return x > 0 ? sprintf("%.3f", x / y) : "-" }
         BEGIN { printf "%-12s %12.0f %12.0f %12.0f %12.0f %10s %12s %8s\n", n, i / steps, p / steps, s / steps, a / steps, ratio(i, p), ratio(i, a), ratio(s, a) }'
    holds "$scene: no more than stock needs, and than the preloaded library" is_as_little
done
all_hold
