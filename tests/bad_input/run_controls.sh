#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   run_controls.sh PAGE PROGRAM...
#
# Is every table of the page somebody's, and does a page that says something else fail? Each program is given pages in
# which one cell is another, one row is gone, and one row is new.
set -uo pipefail
page=${1:?}
shift
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
failures=0
fail() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$1"
}

# refuses PROGRAM WHAT MESSAGE [CASE]: the page in $room/page fails, with that message.
refuses() {
    if "$1" check "$room/page" "${@:4}" >"$room/out"; then
        fail "$2: passes"
    elif ! grep -qF "$3" "$room/out"; then
        fail "$2: fails with another message"
        head -n 3 "$room/out"
    else
        passed=$((passed + 1))
    fi
}

# control PROGRAM TABLE: pages that say something else about that table.
control() {
    local program=$1 table=$2 rows row first
    rows=$(awk -v mark="<!-- checked: $table -->" '$0 == mark { on = 1; next } on && !/^\|/ { exit } on { n++ } END { print n - 2 }' "$page")
    for row in 1 $((rows / 2 + 1)) "$rows"; do
        awk -v mark="<!-- checked: $table -->" -v row="$row" '
            $0 == mark { on = 1; n = -2; print; next }
            on && !/^\|/ { on = 0 }
            on && ++n == row { sub(/\| [^|]* \|$/, "| something else |") }
            { print }' "$page" >"$room/page"
        first=$(awk -v mark="<!-- checked: $table -->" -v row="$row" '
            $0 == mark { on = 1; n = -2; next } on && ++n == row { split($0, cells, "|"); gsub(/^ | $/, "", cells[2]); print cells[2]; exit }' "$page")
        column=$(awk -v mark="<!-- checked: $table -->" '
            $0 == mark { getline; n = split($0, cells, "|"); gsub(/^ | $/, "", cells[n - 1]); print cells[n - 1]; exit }' "$page")
        refuses "$program" "$table: another cell in row $row" 'the page says "something else"' "$table / $first / $column"
    done
    awk -v mark="<!-- checked: $table -->" '$0 == mark { on = 1; n = -2; print; next } on && ++n == 1 { on = 0; next } { print }' "$page" >"$room/page"
    refuses "$program" "$table: a row is gone" 'is not on the page once' "no case"
    awk -v mark="<!-- checked: $table -->" '{ print } $0 == mark { on = 1; n = -2; next } on && ++n == 0 { on = 0; print "| a new row | OK |" }' "$page" >"$room/page"
    refuses "$program" "$table: a new row" '"a new row" of the page has no test' "no case"
    grep -vF "<!-- checked: $table -->" "$page" >"$room/page"
    refuses "$program" "$table: no mark" "the page has no table $table" "no case"
}

passed=0
: >"$room/claimed"
for program in "$@"; do
    "$program" list | awk -F ' / ' '!seen[$1]++ { print $1 }' >"$room/tables"
    cat "$room/tables" >>"$room/claimed"
    while read -r table; do
        control "$program" "$table"
    done <"$room/tables"
done
sed -n 's/^<!-- checked: \(.*\) -->$/\1/p' "$page" | sort >"$room/on_page"
sort "$room/claimed" | diff "$room/on_page" - || fail "tables of the page (<) are not those of the programs (>)"
echo "$passed controls passed, $failures failed"
[ "$failures" -eq 0 ] && [ "$passed" -gt 0 ]
