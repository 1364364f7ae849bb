#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   run_controls.sh ROOT COMPILER TEST_OBJECTS... -- LINK_ARGUMENTS...
#
# Takes the handling of one trap at a time out of a copy of the glue, compiles that one file, links the test with
# it, and expects the test case of that trap to fail. A mutant that survives is an error of the test.
# TEST_OBJECTS: objects of the tests that mutants.txt (or the file BMR_MUTANTS) names; LINK_ARGUMENTS: libraries.
set -u
root=$1 compiler=$2
shift 2
objects=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    objects+=("$1")
    shift
done
shift
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
# Optimised as little as can be: what is measured is whether the test fails.
flags="-std=c++17 -O1 -fPIC -ffp-contract=off -w -I$root/core/include -I$root/core -I$root/box2d_glue/include -I$root/box2d_glue/repair/include"

# A test case takes a second at most. What takes so many seconds of the processor, however busy the machine is, goes round for ever.
patience=120

# object_of TEST: its object among those given
object_of() {
    local object
    for object in "${objects[@]}"; do
        case $object in *"/$1.cpp."*) echo "$object" ;; esac
    done
}

# control NUMBER NAME FILE SUBSTITUTION TEST CASE: writes its verdict to $room/NUMBER
control() {
    local number=$1 name=$2 file=$3 substitution=$4 test=$5 case=$6 place=$room/$1.d
    mkdir "$place"
    cp -r "$root/box2d_glue" "$place/box2d_glue"
    perl -0pi -e "$substitution" "$place/box2d_glue/$file"
    if cmp -s "$root/box2d_glue/$file" "$place/box2d_glue/$file"; then
        echo "FAILED: $name: the substitution finds nothing in $file" >"$room/$number"
    elif ! $compiler $flags -I"$place/box2d_glue" -I"$place/box2d_glue/repair" -c "$place/box2d_glue/$file" -o "$place/mutant.o" 2>"$place/errors" ||
        ! $compiler "$(object_of "$test")" "$place/mutant.o" "${link[@]}" -o "$place/test" 2>>"$place/errors"; then
        { echo "FAILED: $name: does not build"; head -n 5 "$place/errors"; } >"$room/$number"
    elif ! "$place/test" -tc="$case" -c 2>/dev/null | grep -q "unskipped test cases passing the current filters: 1$"; then
        echo "FAILED: $name: not one test case is called $case" >"$room/$number"
    elif (ulimit -t "$patience" && "$place/test" -tc="$case") >"$place/output" 2>&1; then
        echo "FAILED: $name: survives $test, \"$case\"" >"$room/$number"
    else
        echo "passed: $name" >"$room/$number"
    fi
    rm -rf "$place"
}

link=("$@")
jobs_at_once=${BMR_JOBS:-$(nproc)}
number=0 taken=0
# NAME, FILE, SUBSTITUTION (perl), TEST, CASE
while IFS='@' read -r name file substitution test case; do
    case $name in '' | \#*) continue ;; esac
    # Every third one, unless all are asked for (BMR_LONG_CONTROLS).
    taken=$((taken + 1))
    [ -n "${BMR_LONG_CONTROLS:-}" ] || [ $((taken % 3)) -eq 1 ] || continue
    number=$((number + 1))
    control "$number" "$name" "$file" "$substitution" "$test" "$case" &
    while [ "$(jobs -rp | wc -l)" -ge "$jobs_at_once" ]; do wait -n; done
done <"${BMR_MUTANTS:-$root/tests/controls/mutants.txt}"
wait

passed=0 failed=0
for i in $(seq "$number"); do
    cat "$room/$i"
    if grep -q "^passed" "$room/$i"; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
