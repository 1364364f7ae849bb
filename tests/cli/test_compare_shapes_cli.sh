#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# boomerang-testbed compare-shapes as its users see it: test_compare_shapes_cli.sh DIRECTORY-OF-THE-PROGRAMS
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
small=(--size 12 --steps 12 --repeat 1)

run 0 compare-shapes gas --vertices 100,16 "${small[@]}" --many-steps 5 --csv "$scratch/csv" --curve "$scratch/curve" --json "$scratch/json"
grep -Eq '^one +16 +12 ' "$scratch/out" || fail "no row of one fixture"
grep -Eq '^many +100 +5 ' "$scratch/out" || fail "many fixtures of many vertices ran too long"
[ "$(wc -l <"$scratch/csv")" -eq 8 ] || fail "the CSV file has not a row for each world"
# Ascending, whatever was asked; few steps of many fixtures have their like of one.
[ "$(cut -d, -f2,3,4 "$scratch/csv" | tail -n +2 | tr '\n' ' ')" = \
    "octagon,8,12 circle,,12 one,16,12 many,16,12 one,100,12 one,100,5 many,100,5 " ] || fail "the rows are not those"
grep -q '"summaries"' "$scratch/json" || fail "the JSON file lacks the summaries"
run 0 plot "$scratch/curve" -o "$scratch/curve.svg"
grep -q 'svg' "$scratch/curve.svg" || fail "the curve is no picture"
run 0 compare-shapes any-stack --vertices 64 --steps 12 --repeat 0 --no-many --no-circles --quiet --csv "$scratch/csv"
[ ! -s "$scratch/out" ] || fail "--quiet speaks"
[ "$(wc -l <"$scratch/csv")" -eq 3 ] || fail "--no-many and --no-circles leave something in"

run 2 compare-shapes pyramid
grep -q 'no scene "pyramid".*any-gas' "$scratch/err" || fail "the scenes there are go unnamed"
run 2 compare-shapes gas --repeat 0 --curve "$scratch/curve"
run 2 compare-shapes gas --quiet
run 2 compare-shapes gas --vertices 8

# What stock does not have is held against the plugin that is off; a nudge must be found there, too.
run 0 compare any-bag any-bullets --steps 30 --no-time --quiet
run 1 compare any-stack --steps 5 --no-time --quiet --perturb 2
grep -q 'first difference at step 2' "$scratch/out" || fail "the nudge was not found"
echo "passed"
