#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Core's example that cuts the outline of a file, and outlines in the testbed's commands:
# test_outline_cli.sh DIRECTORY-OF-THE-PROGRAMS
set -uo pipefail
testbed=${1:?}/boomerang-testbed
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() {
    echo "FAILED: $*"
    cat "$scratch/out" "$scratch/err"
    exit 1
}
# run CODE ARGUMENTS...
run() {
    local wanted=$1
    shift
    "$testbed" "$@" >"$scratch/out" 2>"$scratch/err"
    local code=$?
    [ $code -eq "$wanted" ] || fail "$*: exit code $code, not $wanted"
}

# cut_file PROGRAMS CODE FILE
cut_file() {
    "$1/example_outline" "$3" >"$scratch/out" 2>"$scratch/err"
    [ $? -eq "$2" ] || fail "example_outline $3: not the exit code $2"
}
printf '# an L with a hole\n0 0\n4,0\n4 2 # the notch is next\n2 2\n# still the same ring\n2 4\n0 4\n\n\n0.5 0.5\n1 0.5\n1 1\n' >"$scratch/l.txt"
cut_file "$1" 0 "$scratch/l.txt"
grep -Eq '^# 2 rings, 4 notches: [3-8] convex pieces$' "$scratch/out" || fail "not the pieces of an L with a hole"
awk 'NF == 2 { x[++n] = $1; y[n] = $2 } NF == 0 { for (i = 1; i <= n; ++i) { k = i % n + 1; area += (x[i] * y[k] - x[k] * y[i]) / 2 } n = 0 }
    END { exit area != 12 - 0.125 }' "$scratch/out" || fail "the pieces are not the outline"

# What is wrong is said with the lines of the file.
printf '0 0\n2 2\n2 0\n0 2\n' >"$scratch/bow.txt"
cut_file "$1" 2 "$scratch/bow.txt"
grep -q 'cross.*the edge from line 1; the edge from line 3; near 1 1$' "$scratch/err" || fail "the crossing edges go unnamed"
printf '0 0\n1 0\n1 x\n' >"$scratch/word.txt"
cut_file "$1" 2 "$scratch/word.txt"
grep -q 'word.txt:3: not a point' "$scratch/err" || fail "the line that is no point goes unnamed"
printf '0 0\n1 0\n' >"$scratch/two.txt"
cut_file "$1" 2 "$scratch/two.txt"
: >"$scratch/none.txt"
cut_file "$1" 2 "$scratch/none.txt"
grep -q 'has no points' "$scratch/err" || fail "an empty file goes unexplained"
cut_file "$1" 2 "$scratch/missing.txt"

# What stock does not have is held against the plugin that is off; a nudge must be found there, too.
run 0 compare any-bag any-bullets --steps 30 --no-time --quiet
run 1 compare any-stack --steps 5 --no-time --quiet --perturb 2
grep -q 'first difference at step 2' "$scratch/out" || fail "the nudge was not found"
run 0 compare asteroids-outline gears-outline silhouettes caves --steps 20 --no-time --quiet
run 1 compare caves --steps 4 --no-time --quiet --perturb 2
grep -q 'first difference at step 2' "$scratch/out" || fail "the nudge was not found"
run 0 compare asteroids-outline caves --mode verify --steps 20 --no-time --quiet

# Pictures show seams: dashed lines, which there are none of otherwise.
run 0 render caves --size 6 --step 2 -o "$scratch/caves.svg"
grep -q 'dasharray' "$scratch/caves.svg" || fail "no seams"
echo "passed"
