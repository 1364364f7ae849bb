#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   run_controls.sh MUTANTS ROOT COMPILER SANITIZER PROGRAMS OBJECTS... -- LINK_ARGUMENTS...
#
# Takes one thing out of the shared library at a time, as the file MUTANTS says, and expects the command that it names
# to fail. With nothing taken out the commands must pass. SANITIZER: `thread`, where the objects are of a build with the
# thread sanitizer, else anything; PROGRAMS: the directory of the commands.
set -u
mutants=$1 root=$2 compiler=$3 sanitizer=$4 programs=$5
shift 5
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
# shellcheck source=tests/kit/mutant_library.sh
source "$root/tests/kit/mutant_library.sh"
unset BOOMERANG BOOMERANG_HOOKS BOOMERANG_STRUCTURE BOOMERANG_PREFILTER BOOMERANG_STATISTICS BOOMERANG_VERBOSE
# (A child inherits threads that ended in its parent, and that it cannot join; and would sleep for a second before it ends, to let them
# race.)
export TSAN_OPTIONS=halt_on_error=1:report_thread_leaks=0:atexit_sleep_ms=0
# A bound in seconds for what hangs, which is no verdict.
patience=1500

# passes PLACE COMMAND: does it, with the library in PLACE for its own? VARIABLE=VALUE may stand before the program. (In a
# shell of its own, which says nothing where the command crashes.)
passes() {
    local words
    read -ra words <<<"$2"
    while [[ ${words[0]} = *=* ]]; do
        local -x "${words[0]?}"
        words=("${words[@]:1}")
    done
    cp "$1/libmutant.so" "$1/libboomerang_box2d.so.1"
    local status=0
    (LD_LIBRARY_PATH=$1 timeout "$patience" "$programs/${words[0]}" "${words[@]:1}") >"$1/output" 2>&1 || status=$?
    [ "$status" -ne 124 ] || echo "$2 has not ended after $patience s" | tee -a "$room/hung"
    return "$status"
}

# killed PLACE COMMAND: does it fail there? A race shows where two threads come by in some order, which is luck: many tries.
killed() {
    for _ in {1..25}; do
        passes "$1" "$2" || return 0
    done
    return 1
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

mutate "$room/whole" plugin/reach/interposed/start.cpp plugin/reach/interposed/start.cpp "" >"$room/err" 2>&1
verdict "the whole library builds" $? "$(head -n 5 "$room/err")"
number=0 taken=0
tried=
while IFS='@' read -r name file unit substitution by command; do
    case $name in '' | \#*) continue ;; esac
    [ "$by" = any ] || [ "$by" = "$sanitizer" ] || continue
    # Every third one, unless all are asked for (BMR_LONG_CONTROLS).
    taken=$((taken + 1))
    [ -n "${BMR_LONG_CONTROLS:-}" ] || [ $((taken % 3)) -eq 1 ] || continue
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
        killed "$place" "$command"
        verdict "$name" $? "survives $command"
    fi
    rm -rf "$place"
done <"$mutants"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$number" -gt 0 ] && [ ! -e "$room/hung" ]
