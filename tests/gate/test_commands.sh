#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   test_commands.sh ROOT BUILD
#
# What pages tell to type is what there is: CI runs the README's second command alone; tests/run says what it does, and refuses what it
# does not know before it does anything; a page has all variables that the library reads; CONTRIBUTING.md names targets and tests of this
# tree; every place that names the version names the same. Each check has a control.
set -u
root=$1 build=$2
temp=$(mktemp -d)
trap 'rm -rf "$temp"' EXIT
failed=0
fail() {
    echo "FAILED: $*"
    failed=1
}

# changed SED FILE: a copy of the tree's file in which something is another
changed() {
    mkdir -p "$(dirname "$temp/$2")"
    sed -E "$1" "$root/$2" >"$temp/$2"
    ! cmp -s "$root/$2" "$temp/$2" || fail "the control changes nothing in $2: $1"
    echo "$temp/$2"
}

# --- CI

# one_command CI README: does the script do the README's second command alone, but for comments, blank lines and what sets it up?
one_command() {
    [ "$(sed -n '/^## See it, check it/,/^## /{/^```sh$/,/^```$/p}' "$2" | sed -n 's/^\(\.[^ ]*\) *#.*/\1/p' | paste -s -d ' ')" = "./testbed_scenes/run ./tests/run" ] &&
        [ "$(grep -v -e '^ *#' -e '^ *$' -e '^set -euo pipefail$' -e '^cd "\$(dirname "\${BASH_SOURCE\[0\]}")/\.\."$' "$1")" = "exec ./tests/run" ]
}
one_command "$root/.ci/run" "$root/README.md" || fail "CI runs something else than ./tests/run, or the README says something else"
for control in 's|exec ./tests/run|& --quick|' 's|exec ./tests/run|BMR_JOBS=1 ./tests/run|' 's|exec ./tests/run|set -a; BMR_TEST_SCALE=0.0001\n&|' \
    's|exec ./tests/run|./testbed_scenes/run\n&|'; do
    ! one_command "$(changed "$control" .ci/run)" "$root/README.md" || fail "the control: $control in .ci/run is not noticed"
done
! one_command "$root/.ci/run" "$(changed 's|^\./tests/run |./tests/run --quick |' README.md)" || fail "the control: another README is not noticed"

# --- tests/run

# answers STATUS PATTERN ARGUMENT…: exit status, and what it says
answers() {
    local wanted=$1 pattern=$2 status=0
    shift 2
    "$root/tests/run" "$@" >"$temp/said" 2>&1 || status=$?
    [ "$status" -eq "$wanted" ] && grep -q -e "$pattern" "$temp/said" ||
        fail "tests/run $*: exit status $status, not $wanted, or nothing like '$pattern' in: $(head -n 5 "$temp/said")"
}
for word in --long --seed --quick --only --help BMR_JOBS BMR_BUILD_DIR BMR_TEST_SCALE BMR_FUZZ_SECONDS; do
    answers 0 "$word" --help
done
# Each stage has a line; each file of a stage is one that tests/run knows.
for file in "$root"/tests/stages/*.sh; do
    stage=$(basename "$file" .sh)
    case $stage in common | packages) continue ;; esac
    answers 0 "^  $stage  *[a-z]" --help
done
answers 2 "unknown option '--lnog'; see tests/run --help" --lnog
answers 2 "no stage 'fuz'; there are: release .*fuzz" --only fuz
answers 2 "needs a stage: release" --only
answers 2 "needs a number" --seed
answers 2 "needs a number" --seed 0
answers 2 "needs a number" --long --seed x1
BMR_JOBS=0 answers 2 "BMR_JOBS is '0'" --only format
BMR_JOBS=abc answers 2 "BMR_JOBS is 'abc'" --only format

# --- The variables that the library reads stand in one table; those of the tests alone stand in no page.

page=$root/docs/is-it-for-my-game.md
grep -rhoE '"BOOMERANG(_[A-Z_]+)?"' "$root/box2d_glue" "$root/plugin" | tr -d '"' | sort -u |
    grep -vx -e BOOMERANG_COUNTS -e BOOMERANG_EVERYWHERE -e BOOMERANG_PAIRS_BY >"$temp/read"
sed -nE 's/^\| `(BOOMERANG[A-Z_]*)[`=].*/\1/p' "$page" | sort -u >"$temp/table"
[ -s "$temp/table" ] && diff "$temp/read" "$temp/table" || fail "the library reads other variables (<) than the table of $page says (>)"
! grep -nE 'BOOMERANG_(COUNTS|EVERYWHERE|PAIRS_BY)' "$root"/README.md "$root"/docs/*.md || fail "a page has a variable of the tests"

# --- CONTRIBUTING.md

# wrong FILE: what a page's commands name that is not there, one a line
wrong() {
    local block targets names name
    block=$(sed -n '/^## To a green test/,/^## /{/^```sh$/,/^```$/p}' "$1")
    targets=$(sed -n 's/^cmake --build build --target \([^#]*\).*/\1/p' <<<"$block")
    names=$(sed -n "s/^ctest --test-dir build -R '^(\([^)]*\))\$'.*/\1/p" <<<"$block")
    [ -n "$targets" ] && [ -n "$names" ] || echo "the page has no commands"
    for name in $targets; do
        grep -q "^build $name: phony" "$build/build.ninja" || echo "no target $name"
    done
    for name in ${names//|/ }; do
        grep -q "^ *Test *#[0-9]*: $name\$" "$temp/tests" || echo "no test $name"
    done
    for name in $(sed -n 's/^\(\.[^ ]*\) .*/\1/p' <<<"$block"); do
        [ -x "$root/$name" ] || echo "no command $name"
    done
}
ctest --test-dir "$build" -N >"$temp/tests"
said=$(wrong "$root/CONTRIBUTING.md")
[ -z "$said" ] || fail "CONTRIBUTING.md: $said"
said=$(wrong "$(changed 's/test_budget/test_budgets/g; s|^\./tests/run|./tests/walk|' CONTRIBUTING.md)" | paste -s -d ,)
[ "$said" = "no target test_budgets,no test test_budgets,no command ./tests/walk" ] || fail "the control: $said"

# --- The version

# versions ROOT: place and version, a line each
versions() {
    (
        cd "$1" || exit
        sed -n 's/^project(boomerang VERSION \([0-9.]*\) .*/CMakeLists.txt \1/p' CMakeLists.txt
        sed -n 's/^version: /CITATION.cff /p' CITATION.cff
        sed -n 's/^__version__ = "\(.*\)"/core\/python \1/p' core/python/boomerang/__init__.py
        sed -n 's/^## \[\([0-9].*\)\].*/CHANGELOG.md \1/p' CHANGELOG.md | head -n 1
    )
}
# one_version ROOT: are all four places there, and do they agree?
one_version() { [ "$(versions "$1" | wc -l)" -eq 4 ] && [ "$(versions "$1" | cut -d ' ' -f 2 | sort -u | wc -l)" -eq 1 ]; }
one_version "$root" || fail "versions differ: $(versions "$root")"
places=(CMakeLists.txt CITATION.cff CHANGELOG.md core/python/boomerang/__init__.py)
(cd "$root" && cp --parents "${places[@]}" "$temp")
for file in "${places[@]}"; do
    changed '/project\(|^version|__version__|^## \[/s/[0-9]+\.[0-9]+\.[0-9]+/77.0.0/' "$file" >/dev/null
    ! one_version "$temp" || fail "the control: another version in $file is not noticed"
    cp "$root/$file" "$temp/$file"
done
[ "$failed" -eq 0 ] && echo passed
exit "$failed"
