# SPDX-License-Identifier: MIT
#
# What the tests of boomerang-testbed's command line share: sourced with the directory of the programs as $1. A test
# defines functions test_… and calls run_tests at its end.
bin=${1:?usage: test_… DIRECTORY-OF-THE-PROGRAMS}
testbed=$bin/boomerang-testbed

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0
claim=

# Whatever terminal or habit the caller has, these runs are piped and plain.
export TERM=xterm
unset NO_COLOR
# What fontconfig keeps until a program ends is no leak of ours (matters to sanitizer builds alone).
echo 'leak:libfontconfig' >"$scratch/leaks"
export LSAN_OPTIONS="${LSAN_OPTIONS:+$LSAN_OPTIONS:}suppressions=$scratch/leaks:print_suppressions=0"

fail() {
    failures=$((failures + 1))
    printf 'FAILED: %s: %s\n' "$claim" "$1"
    sed 's/^/    stdout: /' "$scratch/out" | tail -n 15
    sed 's/^/    stderr: /' "$scratch/err" | tail -n 15
}

# expect STATUS ARGUMENT…: runs boomerang-testbed and checks its exit status.
expect() {
    local wanted=$1 status=0
    shift
    claim="boomerang-testbed $*"
    "$testbed" "$@" >"$scratch/out" 2>"$scratch/err" || status=$?
    [ "$status" -eq "$wanted" ] || fail "exit status $status, not $wanted"
}

out_has() { grep -Eq -- "$1" "$scratch/out" || fail "stdout lacks /$1/"; }
err_has() { grep -Eq -- "$1" "$scratch/err" || fail "stderr lacks /$1/"; }
err_empty() { [ ! -s "$scratch/err" ] || fail "stderr is not empty"; }

# says PATTERN STATUS ARGUMENT…: that it exits so, and prints (where it fails: on stderr) what has the pattern.
says() {
    local pattern=$1
    shift
    expect "$@"
    if [ "$1" -eq 0 ]; then out_has "$pattern"; else err_has "$pattern"; fi
}

# Neither escape codes nor carriage returns belong into a file or a pipe.
clean() {
    if LC_ALL=C grep -q -e $'\033' -e $'\r' "$scratch/out" "$scratch/err"; then
        fail "escape codes or carriage returns in piped output"
    fi
}

# Every function test_…, in the order of their names.
run_tests() {
    local program test before
    for program in boomerang-testbed boomerang-scene boomerang-scene-plugin; do
        [ -x "$bin/$program" ] || { echo "no $program in $bin"; exit 1; }
    done
    for test in $(declare -F | awk '$3 ~ /^test_/ { print $3 }'); do
        before=$failures
        "$test"
        if [ "$failures" -eq "$before" ]; then echo "passed: $test"; else echo "FAILED: $test"; fi
    done
    [ "$failures" -eq 0 ] || { echo "$failures claim(s) failed"; exit 1; }
}
