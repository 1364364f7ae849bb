#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   test_contributing.sh ROOT BUILD
#
# The commands of CONTRIBUTING.md are of this tree: the targets are built here, and the tests are there. Its diff made what is in the tree.
set -u
root=$1 build=$2
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT

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
        grep -q "^ *Test *#[0-9]*: $name\$" "$room/tests" || echo "no test $name"
    done
    for name in $(sed -n 's/^\(\.[^ ]*\) .*/\1/p' <<<"$block"); do
        [ -x "$root/$name" ] || echo "no command $name"
    done
}

ctest --test-dir "$build" -N >"$room/tests"
failed=0
said=$(wrong "$root/CONTRIBUTING.md")
[ -z "$said" ] || { echo "FAILED: CONTRIBUTING.md: $said"; failed=1; }
# The control: a page that names others.
sed -e 's/test_budget/test_budgets/g' -e 's|^\./tests/run|./tests/walk|' "$root/CONTRIBUTING.md" >"$room/page.md"
[ "$(wrong "$room/page.md" | paste -s -d ,)" = "no target test_budgets,no test test_budgets,no command ./tests/walk" ] ||
    { echo "FAILED: the control: $(wrong "$room/page.md")"; failed=1; }
# taken_back FILE: can the diff of a page be taken back from the tree?
taken_back() {
    sed -n '/^```diff$/,/^```$/{/^```/!p}' "$1" >"$room/diff"
    [ -s "$room/diff" ] && patch --dry-run --reverse --force --fuzz=0 -p1 -d "$root" -i "$room/diff" >/dev/null
}
taken_back "$root/CONTRIBUTING.md" || { echo "FAILED: CONTRIBUTING.md: its diff is not of this tree"; failed=1; }
sed 's/^+\(.*\)class Drifters/+\1class Shifters/' "$root/CONTRIBUTING.md" >"$room/page.md"
! taken_back "$room/page.md" || { echo "FAILED: the control: another diff passes"; failed=1; }
[ "$failed" -eq 0 ] && echo passed
exit "$failed"
