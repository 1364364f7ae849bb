#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   test_list.sh ROOT
#
# The gate makes some of the faults of faults.txt, a long run all of them. Each finds its place in the sources, and is there once by its
# name. The controls: lists in which one row is wrong.
set -u
root=$1
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
failed=0
python3 "$root/tests/faults/run" --check || failed=1

# control WHAT PATTERN ROW
control() {
    printf '[core]\n%s\n' "$3" >"$room/list"
    if python3 "$root/tests/faults/run" --check --list "$room/list" >"$room/out" || ! grep -q "$2" "$room/out"; then
        echo "FAILED: not noticed: $1"
        failed=1
    fi
}
row='a fault @ core/budget/budget.c @ s/include/another/ @ test_budget'
printf '[core]\n%s\n' "$row" >"$room/list"
python3 "$root/tests/faults/run" --check --list "$room/list" | grep -qx '1 rows, 0 failed' || failed=1
control 'a line that was written otherwise' 'finds nothing in core/budget/budget.c' "${row/include/no such text}"
control 'a file that is elsewhere' 'no file core/budget/gone.c' "${row/budget.c/gone.c}"
control 'half a substitution' 'not terminated' "${row/another\//another}"
control 'a name that is there twice' 'there twice' "$row"$'\n'"$row"
[ "$failed" -eq 0 ] && echo passed
exit "$failed"
