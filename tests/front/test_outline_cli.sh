#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Core's example that cuts the outline of a file, and outlines in the testbed's commands:
# test_outline_cli.sh DIRECTORY-OF-THE-PROGRAMS
set -uo pipefail

# shellcheck source=cli.sh
source "$(dirname "${BASH_SOURCE[0]}")/cli.sh"

# cut_file STATUS FILE TEXT [PATTERN]: what core's example makes of a file of this text; where it fails its words have the pattern.
cut_file() {
    local status=0
    claim="example_outline $2"
    { printf '%b' "$3" >"$scratch/$2"; } 2>/dev/null
    "$bin/example_outline" "$scratch/$2" >"$scratch/out" 2>"$scratch/err" || status=$?
    [ "$status" -eq "$1" ] || fail "exit status $status, not $1"
    [ -z "${4:-}" ] || err_has "$4"
}

test_an_outline_is_cut() {
    cut_file 0 l.txt '# an L with a hole\n0 0\n4,0\n4 2 # the notch is next\n2 2\n# still the same ring\n2 4\n0 4\n\n\n0.5 0.5\n1 0.5\n1 1\n'
    out_has '^# 2 rings, 4 notches: [3-8] convex pieces$'
    awk 'NF == 2 { x[++n] = $1; y[n] = $2 } NF == 0 { for (i = 1; i <= n; ++i) { k = i % n + 1; area += (x[i] * y[k] - x[k] * y[i]) / 2 } n = 0 }
        END { exit area != 12 - 0.125 }' "$scratch/out" || fail "the pieces are not the outline"
    # What is wrong is said with the lines of the file.
    cut_file 2 bow.txt '0 0\n2 2\n2 0\n0 2\n' 'cross.*the edge from line 1; the edge from line 3; near 1 1$'
    cut_file 2 word.txt '0 0\n1 0\n1 x\n' 'word.txt:3: not a point'
    cut_file 2 two.txt '0 0\n1 0\n'
    cut_file 2 none.txt '' 'has no points'
    cut_file 2 no/such.txt ''
}

# What stock does not have is held against the plugin that is off; a nudge must be found there, too.
test_scenes_that_stock_does_not_have() {
    local scene
    expect 0 compare any-bag any-bullets asteroids-outline gears-outline silhouettes caves --steps 20 --no-time --quiet
    for scene in any-stack caves; do
        expect 1 compare $scene --steps 4 --no-time --quiet --perturb 2
        out_has 'first difference at step 2'
    done
    for scene in asteroids-outline caves; do
        claim="BOOMERANG=verify boomerang-scene-plugin $scene"
        BOOMERANG=verify "$bin/boomerang-scene-plugin" $scene --steps 20 >"$scratch/out" 2>"$scratch/err" || fail "it fails"
        err_has 'verified [1-9].*, 0 differ'
    done
}

test_pictures_show_seams() {
    expect 0 render caves --size 6 --step 2 -o "$scratch/caves.svg"
    grep -q 'dasharray' "$scratch/caves.svg" || fail "no dashed lines, which there are none of otherwise"
}

run_tests
