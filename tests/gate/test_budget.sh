#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Holds each room of the tree to its line of budget.txt: lines, bytes and files, without pictures and corpora.
# usage: test_budget.sh SOURCE_DIR [--print]
# --print writes the list as the tree is. A commit that raises a room does nothing else, and says why.
set -euo pipefail
root=$1
list=$root/tests/gate/budget.txt
git -C "$root" rev-parse --verify --quiet HEAD >/dev/null || {
    echo "test_budget.sh: skipped: $root is no git work tree, so nothing says which files belong to it"
    exit 77
}

measure() {
    cd "$root"
    # (A file that was taken away and is in the index yet is no file of the tree: wc says so.)
    git ls-files -z | grep -zvE '\.(svg|png|gif)$|/corpus/' | xargs -0 wc -lc 2>/dev/null | awk '
        NF != 3 || $3 == "total" { next }
        { split($3, parts, "/"); room = index($3, "/") && parts[1] != "docs" && parts[1] != "cmake" && parts[1] != "tools" && parts[1] != ".ci" ? parts[1] : "rest"
          lines[room] += $1; bytes[room] += $2; files[room]++ }
        END { for (room in lines) print room, lines[room], bytes[room], files[room] }' | sort
}

if [ "${2-}" = --print ]; then
    measure
    exit
fi
# Does the tree keep to the budget? Names each room that does not.
held() {
    awk -v list="$1" '
        BEGIN { while ((getline line < list) > 0) if (line !~ /^#/ && split(line, field, " ") == 4) budget[field[1]] = line }
        !($1 in budget) { print $1 ": has no line in budget.txt"; failed = 1; next }
        { split(budget[$1], may, " "); split("lines bytes files", name, " ")
          for (i = 2; i <= 4; i++) if ($i + 0 > may[i] + 0) { print $1 ": " $i " " name[i - 1] ", budget.txt allows " may[i]; failed = 1 }
          seen++ }
        END { if (seen < 7) { print "only " seen + 0 " rooms were measured"; failed = 1 }; exit failed }' <<<"$measured"
}

measured=$(measure)
status=0
held "$list" || { echo "FAILED: a room is larger than its budget. To raise one is a commit of its own, with a reason." && status=1; }
# Controls: one line, one byte, one file less for one room, and a room without a line.
for field in 2 3 4; do
    held <(awk -v field=$field '$1 == "core" { $field = 1 } { print }' "$list") >/dev/null && { echo "FAILED: control: column $field is not looked at" && status=1; }
done
held <(grep -v '^core ' "$list") >/dev/null && { echo "FAILED: control: a room without a line passes" && status=1; }
[ $status -eq 0 ] && echo passed
exit $status
