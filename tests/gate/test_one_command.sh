#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   test_one_command.sh ROOT
#
# CI runs the README's second command, exactly that, and nothing else: what passes there passes for whoever types it.
set -u
root=$1
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
failed=0

# told FILE: the commands that the README gives to begin with, a line each
told() { sed -n '/^## See it, check it/,/^## /{/^```sh$/,/^```$/p}' "$1" | sed -n 's/^\(\.[^ ]*\) *#.*/\1/p'; }

# commands FILE: what a script does, without comments, blank lines and what sets it up
commands() { grep -v -e '^ *#' -e '^ *$' -e '^set -euo pipefail$' -e '^cd "\$(dirname "\${BASH_SOURCE\[0\]}")/\.\."$' "$1"; }

# one_command CI README: does the script do the README's second command alone?
one_command() {
    [ "$(told "$2" | paste -s -d ' ')" = "./testbed_scenes/run ./tests/run" ] && [ "$(commands "$1")" = "exec ./tests/run" ]
}

# expect STATUS CLAIM COMMAND…
expect() {
    local wanted=$1 claim=$2 status=0
    shift 2
    "$@" || status=1
    if [ "$status" -ne "$wanted" ]; then
        echo "FAILED: $claim"
        failed=1
    fi
}

expect 0 "CI runs ./tests/run, which is what the README says" one_command "$root/.ci/run" "$root/README.md"
# Controls: an option, another command, a README that says something else.
sed 's|exec ./tests/run|exec ./tests/run --quick|' "$root/.ci/run" >"$room/option"
expect 1 "control: an option is noticed" one_command "$room/option" "$root/README.md"
sed 's|exec ./tests/run|BMR_JOBS=1 ./tests/run|' "$root/.ci/run" >"$room/variable"
expect 1 "control: a setting is noticed" one_command "$room/variable" "$root/README.md"
sed 's|exec ./tests/run|set -a; BMR_TEST_SCALE=0.0001\n&|' "$root/.ci/run" >"$room/set"
expect 1 "control: a setting behind set is noticed" one_command "$room/set" "$root/README.md"
sed 's|exec ./tests/run|./testbed_scenes/run\n&|' "$root/.ci/run" >"$room/more"
expect 1 "control: a second command is noticed" one_command "$room/more" "$root/README.md"
sed 's|^\./tests/run |./tests/run --quick |' "$root/README.md" >"$room/README.md"
expect 1 "control: another README is noticed" one_command "$root/.ci/run" "$room/README.md"
[ "$failed" -eq 0 ] && echo passed
exit "$failed"
