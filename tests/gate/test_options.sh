#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   test_options.sh ROOT
#
# tests/run tells what it does and refuses what it does not know, before it does anything. A page tells of all variables of games.
set -u
root=$1
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
failed=0

# answers STATUS PATTERN ARGUMENT…: exit status, and what it says
answers() {
    local wanted=$1 pattern=$2 status=0
    shift 2
    "$root/tests/run" "$@" >"$room/said" 2>&1 || status=$?
    if [ "$status" -ne "$wanted" ] || ! grep -q -e "$pattern" "$room/said"; then
        echo "FAILED: tests/run $*: exit status $status, not $wanted, or nothing like '$pattern' in:"
        head -n 5 "$room/said"
        failed=1
    fi
}

"$root/tests/run" --help >"$room/help" || failed=1
helps() {
    grep -q -e "$1" "$room/help" || { echo "FAILED: tests/run --help says nothing like '$1'" && failed=1; }
}

for word in --long --seed --quick --only --help BMR_JOBS BMR_BUILD_DIR BMR_TEST_SCALE BMR_FUZZ_SECONDS; do
    helps "$word"
done
# Each stage has a line; each file of a stage is one that tests/run knows.
for file in "$root"/tests/stages/*.sh; do
    stage=$(basename "$file" .sh)
    case $stage in common | packages) continue ;; esac
    helps "^  $stage  *[a-z]"
done
answers 2 "unknown option '--lnog'; see tests/run --help" --lnog
answers 2 "no stage 'fuz'; there are: release .*fuzz" --only fuz
answers 2 "needs a stage: release" --only
answers 2 "needs a number" --seed
answers 2 "needs a number" --seed 0
answers 2 "needs a number" --long --seed x1
answers 2 "always errors" --strict
BMR_JOBS=0 answers 2 "BMR_JOBS is '0'" --only format
BMR_JOBS=abc answers 2 "BMR_JOBS is 'abc'" --only format
answers 2 "long" --brief
# The variables that the library reads stand in one table; those of the tests alone stand in no page.
page=$root/docs/is-it-for-my-game.md
grep -rhoE '"BOOMERANG(_[A-Z_]+)?"' "$root/box2d_glue" "$root/plugin" | tr -d '"' | sort -u |
    grep -vx -e BOOMERANG_COUNTS -e BOOMERANG_EVERYWHERE -e BOOMERANG_PAIRS_BY >"$room/read"
sed -nE 's/^\| `(BOOMERANG[A-Z_]*)[`=].*/\1/p' "$page" | sort -u >"$room/table"
[ -s "$room/table" ] && diff "$room/read" "$room/table" ||
    { echo "FAILED: the library reads other variables (<) than the table of $page says (>)" && failed=1; }
! grep -nE 'BOOMERANG_(COUNTS|EVERYWHERE|PAIRS_BY)' "$root"/README.md "$root"/docs/*.md || { echo "FAILED: a page has a variable of the tests" && failed=1; }
[ "$failed" -eq 0 ] && echo passed
exit "$failed"
