#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   check_allocators.sh HEADERS PROGRAM...
#
# Is every function that takes an allocator, or says NO_MEMORY, among those whose allocations are made to fail? Of the public
# headers, and of those beside core's sources that the plugin or the tests use. The programs list theirs (--list).
set -uo pipefail
headers=${1:?}
shift
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT

# One line for each declaration, with the comment above it.
functions() {
    awk '
        /^[[:space:]]*\/\/\// { comment = comment " " $0; next }
        /^[[:space:]]*$/ || /^#/ { if (!open) comment = ""; next }
        { text = text " " $0; open = 1 }
        /[;{}][[:space:]]*(\/\/.*)?$/ { print text " @" comment; text = ""; comment = ""; open = 0 }' "$1"/boomerang/*.h \
        "$1"/../hierarchy/mixed_cells.h "$1"/../convex32/convex32*.h
}

# Those that give back have nothing to fail.
functions "$headers" | grep -E '(bmr_error|bool|\*) ?\*?bmr_[a-z0-9_]+\(' |
    grep -E 'const bmr_allocator \*[a-z]+[,)]|@.*(NO_MEMORY|Errors as at creation)' |
    sed -nE 's/^[^(@]*[ *](bmr_[a-z0-9_]+)\(.*/\1/p' | grep -v '_destroy$' | sort -u >"$room/in_headers"
for program in "$@"; do
    "$program" --list || echo "$program does not list its functions"
done | sort -u >"$room/covered"
[ -s "$room/in_headers" ] || { echo "FAILED: no functions found in $headers"; exit 1; }
if ! diff "$room/in_headers" "$room/covered"; then
    echo "FAILED: functions that allocate (<) are not those that are tested (>)"
    exit 1
fi
echo "$(wc -l <"$room/in_headers") functions allocate, and all are tested"
