#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   run_controls.sh ROOT COMPILER SANITIZER PROGRAMS OBJECTS... -- LINK_ARGUMENTS...
#
# Takes one thing that keeps threads apart out of the shared library at a time, and expects the command that
# mutants.txt names to fail with it. With nothing taken out the commands must pass. SANITIZER: `thread`, where the
# objects are of a build with the thread sanitizer, else anything; PROGRAMS: the directory of the commands.
set -u
root=$1 compiler=$2 sanitizer=$3 programs=$4
shift 4
objects=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    objects+=("$1")
    shift
done
shift
link=("$@")
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
linked=
flags="-std=c++17 -O1 -fPIC -fvisibility=hidden -ftls-model=initial-exec -ffp-contract=off -w -DB2_SHARED"
if [ "$sanitizer" = thread ]; then
    linked="-fsanitize=thread"
    flags="$flags -fsanitize=thread"
fi
# shellcheck source=tests/support/mutant_library.sh
source "$root/tests/support/mutant_library.sh"
unset BOOMERANG_HOOKS BOOMERANG_STRUCTURE BOOMERANG_PREFILTER BOOMERANG_VERBOSE
export BOOMERANG=on BOOMERANG_STATISTICS=/dev/null TSAN_OPTIONS=halt_on_error=1

# passes PLACE COMMAND: does it, with the library in PLACE for its own? (In a shell of its own, which says nothing where
# the command crashes.)
passes() {
    local words
    read -ra words <<<"$2"
    cp "$1/libmutant.so" "$1/libboomerang_box2d.so.0"
    (LD_LIBRARY_PATH=$1 timeout 100 "$programs/${words[0]}" "${words[@]:1}") >"$1/output" 2>&1
}

passed=0 failed=0
verdict() { # NAME STATUS WHY
    if [ "$2" -eq 0 ]; then
        passed=$((passed + 1))
        echo "passed: $1"
    else
        failed=$((failed + 1))
        echo "FAILED: $1: $3"
    fi
}

mutate "$room/whole" plugin/start.cpp plugin/start.cpp "" >"$room/err" 2>&1
verdict "the whole library builds" $? "$(head -n 5 "$room/err")"
number=0
tried=
while IFS='@' read -r name file unit substitution by command; do
    case $name in '' | \#*) continue ;; esac
    [ "$by" = any ] || [ "$by" = "$sanitizer" ] || continue
    number=$((number + 1))
    case "$tried" in *"@$command@"*) ;; *)
        tried="$tried@$command@"
        passes "$room/whole" "$command"
        verdict "with nothing taken out, $command" $? "$(tail -n 5 "$room/whole/output")"
        ;;
    esac
    place=$room/$number
    if ! mutate "$place" "$file" "$unit" "$substitution" >"$room/err" 2>&1; then
        verdict "$name" 1 "does not build: $(head -n 5 "$room/err")"
    else
        ! passes "$place" "$command"
        verdict "$name" $? "survives $command"
    fi
    rm -rf "$place"
done <"$root/tests/threads/mutants.txt"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$number" -gt 0 ]
