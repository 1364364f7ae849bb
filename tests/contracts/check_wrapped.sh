#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   check_wrapped.sh LIBRARY SYMBOL...
#
# Does the library ask for memory in other ways than by these symbols, whose calls are made to fail? Neither by other functions,
# nor by parts of the C++ runtime that would allocate for it.
set -uo pipefail
library=${1:?}
shift
asked=$(nm -D --undefined-only "$library" | awk '{ sub(/@.*/, "", $NF); print $NF }' |
    grep -v '^_ZTI' | grep -E '^_Z(nw|na|dl|da)|alloc|^free$|dup$|dup_|^getline$|asprintf|memalign|basic_string|_List|_Rb_tree|locale' | LC_ALL=C sort)
[ -n "$asked" ] || { echo "FAILED: $library asks for no memory"; exit 1; }
# What the runtime throws with has memory of its own.
other=$(LC_ALL=C comm -23 <(printf '%s\n' "$asked" | grep -v '^__cxa_' | grep -v '^_Z15b2Alloc_Defaulti$') <(printf '%s\n' "$@" | LC_ALL=C sort))
if [ -n "$other" ]; then
    echo "FAILED: memory is asked for in other ways:" $other
    exit 1
fi
echo "memory is asked for by" $asked
