#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   run_core_controls.sh MUTANTS ROOT C_COMPILER CXX_COMPILER LINK_ARGUMENTS...
#
# Makes one fault at a time in a copy of core, as the file MUTANTS says, compiles the source with it (where a header is what is
# faulty, the room's sources and the test), and expects the test to fail. With no fault the tests must pass. A mutant that survives is an
# error of the test. MUTANTS: name @ file in core @ substitution (perl) @ test; the room is the file's folder, or the header's name.
set -u
mutants=$1 root=$2 cc=$3 cxx=$4
shift 4
link=("$@")
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
flags=(-O1 -ffp-contract=off -w "-I$root/tests/kit")
# A test takes a second or two. What takes so many seconds of the processor goes round for ever.
patience=${BMR_PATIENCE:-120}
export BMR_TEST_SCALE=0.1

# compile CORE SOURCE OBJECT: with the headers of a copy of core
compile() {
    local include=("-I$1/include" "-I$1")
    case $2 in
    *.cpp) $cxx -std=c++17 "${flags[@]}" "${include[@]}" -DDOCTEST_LIBRARY_IMPLEMENTATION -c "$2" -o "$3" ;;
    *) $cc -std=c11 "${flags[@]}" "${include[@]}" -c "$2" -o "$3" ;;
    esac
}

# object_of TEST: where it is kept, compiled without a fault
object_of() { echo "$room/${1//\//-}.o"; }

# program PLACE FILE TEST: builds PLACE/test from the copy of core in PLACE, whose FILE is faulty
program() {
    local place=$1 folder=${2%/*} source object
    object=$(object_of "$3")
    case $2 in include/*)
        folder=$(basename "$2" .h) object=$place/test.o
        compile "$place/core" "$root/tests/$3" "$object" || return 1
        ;;
    esac
    mkdir "$place/room"
    # A source stands in front of the library's own; a header is in all sources of the room.
    local sources=("$place/core/$folder"/*.c)
    case $2 in *.c) sources=("$place/core/$2") ;; esac
    for source in "${sources[@]}"; do
        compile "$place/core" "$source" "$place/room/$(basename "$source").o" || return 1
    done
    $cxx "$object" "$place"/room/*.o "${link[@]}" -o "$place/test"
}

# control NUMBER NAME FILE SUBSTITUTION TEST: writes its verdict to $room/NUMBER. No substitution: the test must pass.
control() {
    local number=$1 name=$2 file=$3 substitution=$4 test=$5 place=$room/$1.d
    mkdir "$place"
    cp -r "$root/core" "$place/core"
    [ -z "$substitution" ] || perl -0pi -e "$substitution" "$place/core/$file"
    if [ -n "$substitution" ] && cmp -s "$root/core/$file" "$place/core/$file"; then
        echo "FAILED: $name: the substitution finds nothing in $file" >"$room/$number"
    elif ! program "$place" "$file" "$test" 2>"$place/errors"; then
        { echo "FAILED: $name: does not build"; head -n 5 "$place/errors"; } >"$room/$number"
    elif (ulimit -t "$patience" && "$place/test") >"$place/output" 2>&1; then
        if [ -z "$substitution" ]; then echo "passed: $name"; else echo "FAILED: $name: survives $test"; fi >"$room/$number"
    else
        if [ -z "$substitution" ]; then tail -n 5 "$place/output" && echo "FAILED: $name"; else echo "passed: $name"; fi >"$room/$number"
    fi
    rm -rf "$place"
}

jobs_at_once=${BMR_JOBS:-$(nproc)}
number=0 taken=0
tried=
start() {
    number=$((number + 1))
    control "$number" "$@" &
    while [ "$(jobs -rp | wc -l)" -ge "$jobs_at_once" ]; do wait -n; done
}
while IFS='@' read -r name file substitution test; do
    case $name in '' | \#*) continue ;; esac
    # Every third one, unless all are asked for (BMR_LONG_CONTROLS).
    taken=$((taken + 1))
    [ -n "${BMR_LONG_CONTROLS:-}" ] || [ $((taken % 3)) -eq 1 ] || continue
    case "$tried" in *"@$test@"*) ;; *)
        tried="$tried@$test@"
        compile "$root/core" "$root/tests/$test" "$(object_of "$test")"
        start "with no fault, $test" "$file" "" "$test"
        ;;
    esac
    start "$name" "$file" "$substitution" "$test"
done <"$mutants"
wait

passed=0 failed=0
for i in $(seq "$number"); do
    cat "$room/$i"
    if grep -q "^passed" "$room/$i"; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
