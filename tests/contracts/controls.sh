#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   controls.sh PAGE PAGE PROGRAM...
#
# Is every table of the pages printed by a program, and no other? And does each table notice that a page says something else?
set -uo pipefail
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
failures=0
cat "${1:?}" "${2:?}" >"$room/pages"
shift 2
sed '/^| [^-]/ s/ |$/ or else |/' "$room/pages" >"$room/page"
for program in "$@"; do
    "$program" --tables >"$room/tables"
    cat "$room/tables" >>"$room/printed"
    case $program in *_worlds) continue ;; esac # which takes long, and compares as the others do
    noticed=$("$program" "$room/page" | grep -c '^FAILED: table ')
    if [ "$noticed" -ne "$(wc -l <"$room/tables")" ]; then
        echo "FAILED: $program notices another page in $noticed of $(wc -l <"$room/tables") tables"
        failures=1
    fi
done
diff <(grep '^<!-- checked: ' "$room/pages" | sort) <(sort "$room/printed") || { echo "FAILED: the pages' tables (<) are not those of the programs (>)"; failures=1; }
exit "$failures"
