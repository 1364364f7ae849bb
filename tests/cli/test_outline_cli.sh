#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# boomerang-testbed outline, and outlines in the other commands, as their users see them:
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

printf '# an L with a hole\n0 0\n4,0\n4 2 # the notch is next\n2 2\n# still the same ring\n2 4\n0 4\n\n\n0.5 0.5\n1 0.5\n1 1\n' >"$scratch/l.txt"
run 0 outline "$scratch/l.txt" -o "$scratch/l.svg" --json "$scratch/l.json"
grep -Eq '^9 points in 2 rings, 4 notches: [3-8] convex pieces$' "$scratch/out" || fail "not the pieces of an L with a hole"
grep -q '<svg' "$scratch/l.svg" || fail "no picture"
python3 - "$scratch/l.json" <<'CHECK' || fail "the pieces in the file are not the outline"
import json, sys
j = json.load(open(sys.argv[1]))
area = inner = 0
for piece in j["pieces"]:
    p = piece["points"]
    area += sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(p, p[1:] + p[:1])) / 2
    inner += len(piece["inner"])
sys.exit(not (abs(area - (12 - 0.125)) < 1e-12 and inner % 2 == 0 and inner > 0))
CHECK
run 0 outline "$scratch/l.txt" --tolerance 1 --quiet -o "$scratch/rough.png"
[ ! -s "$scratch/out" ] || fail "--quiet speaks"
run 0 outline "$scratch/l.txt" --tolerance 1
grep -q ' 1 convex pieces\| 2 convex pieces' "$scratch/out" || fail "a tolerance makes no fewer pieces"

# What is wrong is said with the lines of the file.
printf '0 0\n2 2\n2 0\n0 2\n' >"$scratch/bow.txt"
run 2 outline "$scratch/bow.txt"
grep -q 'cross.*from line 1 to line 2 and the edge from line 3 to line 4, near 1 1' "$scratch/err" || fail "the crossing edges go unnamed"
printf '0 0\n1 0\n1 x\n' >"$scratch/word.txt"
run 2 outline "$scratch/word.txt"
grep -q 'word.txt:3: not a point' "$scratch/err" || fail "the line that is no point goes unnamed"
printf '0 0\n1 0\n' >"$scratch/two.txt"
run 2 outline "$scratch/two.txt"
: >"$scratch/none.txt"
run 2 outline "$scratch/none.txt"
grep -q 'has no points' "$scratch/err" || fail "an empty file goes unexplained"
run 2 outline "$scratch/l.txt" -o "$scratch/l.bmp"
run 2 outline "$scratch/l.txt" --quiet
run 2 outline "$scratch/l.txt" --tolerance -1
run 2 outline "$scratch/missing.txt"

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
