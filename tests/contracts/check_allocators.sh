#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   check_allocators.sh HEADERS PROGRAM...
#
# Runs the programs, which say of which functions they let every allocation fail. Is every function among them that takes an
# allocator, or says NO_MEMORY? Of the public headers, and of those beside core's sources that the plugin or the tests use.
set -uo pipefail
headers=${1:?}
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

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
    sed -nE 's/^[^(@]*[ *](bmr_[a-z0-9_]+)\(.*/\1/p' | grep -v '_destroy$' | sort -u >"$folder/in_headers"
[ -s "$folder/in_headers" ] || { echo "FAILED: no functions found in $headers"; exit 1; }
for program in "$@"; do
    "$program" | tee -a "$folder/said" || exit 1
done
sed -n 's/^allocates: //p' "$folder/said" | sed 's/, /\n/g' | sort -u >"$folder/covered"
if ! diff "$folder/in_headers" "$folder/covered"; then
    echo "FAILED: functions that allocate (<) are not those that are tested (>)"
    exit 1
fi
