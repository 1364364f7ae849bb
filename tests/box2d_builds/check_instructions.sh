#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   check_instructions.sh BUILD [SCENE...]
#
# What an accelerated Box2D costs: instructions of b2World::Step (callgrind), stock over it, beside stock over the preloaded library in
# the same run. It must gain at least as much (but for a hundredth), and must not cost more than stock. BUILD: a build tree of this
# project with BOOMERANG_BOX2D_SOURCE.
set -uo pipefail
build=${1:?}
shift
scenes=("$@")
[ ${#scenes[@]} -gt 0 ] || scenes=(planks needles sensors bullets coins-pile)
profile=$(mktemp)
trap 'rm -f "$profile"' EXIT
passed=0 failed=0
unset BOOMERANG BOOMERANG_HOOKS BOOMERANG_STRUCTURE BOOMERANG_PREFILTER BOOMERANG_STATISTICS BOOMERANG_VERBOSE LD_PRELOAD
export LD_BIND_NOW=1

# instructions SCENE PROGRAM [VARIABLE=VALUE...]: sets REPLY
instructions() {
    env "${@:3}" valgrind -q --tool=callgrind --toggle-collect='b2World::Step(float, int, int)' --callgrind-out-file="$profile" \
        "$build/bin/$2" "$1" --steps 60 --mode time >/dev/null 2>&1
    REPLY=$(awk '/^summary:/ { print $2; exit }' "$profile")
    [ "${REPLY:-0}" -gt 0 ]
}

printf '%-12s %14s %10s %12s\n' scene 'stock, a step' preloaded accelerated
for scene in "${scenes[@]}"; do
    instructions "$scene" boomerang-scene && stock=$REPLY &&
        instructions "$scene" boomerang-scene BOOMERANG=on LD_PRELOAD="$build/lib/libboomerang_box2d.so" && preloaded=$REPLY &&
        instructions "$scene" boomerang-scene-accelerated && accelerated=$REPLY || {
        failed=$((failed + 1))
        echo "FAILED: $scene does not run"
        continue
    }
    awk -v n="$scene" -v s="$stock" -v p="$preloaded" -v a="$accelerated" \
        'BEGIN { printf "%-12s %14d %10.2f %12.2f\n", n, s / 60, s / p, s / a; exit !(a <= 1.01 * p && a <= s) }' &&
        passed=$((passed + 1)) || {
        failed=$((failed + 1))
        echo "FAILED: $scene: the accelerated Box2D costs more"
    }
done
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
