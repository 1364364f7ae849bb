#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   test_list.sh ROOT
#
# The gate makes some of the faults of faults.txt, a long run all of them. Each finds its place in the sources, and is there once by its
# name. The controls: lists in which one row is wrong. The sites that drawn.py draws are those that it finds.
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

# Sites that are drawn: of one file all; a larger sample begins with the smaller one; each line is found again, or is told to be gone.
mkdir -p "$room/core"
cp -r "$root/core/geometry" "$root/core/pair" "$room/core"
drawn() { python3 "$root/tests/faults/drawn.py" --root "$room" "$@"; }
wrong() {
    echo "FAILED: $1"
    failed=1
}
drawn --all "$root/tests/faults/sample.c" | diff "$root/tests/faults/sample.txt" - || wrong 'the sites of sample.c'
drawn 1 30 >"$room/many"
drawn 1 9 | cmp -s - <(head -n 9 "$room/many") || wrong 'a larger sample begins with the smaller one'
drawn 2 30 | cmp -s - "$room/many" && wrong 'another seed, another sample'
[ -z "$(drawn --gone "$room/many")" ] || wrong 'each line is found again'
sed '2s/ @ / another @ /' "$room/many" >"$room/moved"
[ "$(drawn --gone "$room/moved")" = "$(sed -n 2p "$room/moved")" ] || wrong 'a line that is gone'

[ "$failed" -eq 0 ] && echo passed
exit "$failed"
