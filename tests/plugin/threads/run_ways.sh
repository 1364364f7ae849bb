#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   run_ways.sh STOCK PLUGIN [LIBRARY]
#
# What many worlds print must be the same on many threads as one by one, and where stock Box2D has the worlds, the
# same as stock's. STOCK and PLUGIN: threads_stock and threads_plugin; LIBRARY: to be preloaded into STOCK (not under a
# sanitizer). BMR_TEST_SCALE multiplies the steps.
set -u
stock=$1 plugin=$2 library=${3:-}
steps=$(awk -v scale="${BMR_TEST_SCALE:-1}" 'BEGIN { n = int(60 * scale); print n < 12 ? 12 : n }')
temp=$(mktemp -d)
trap 'rm -rf "$temp"' EXIT
unset BOOMERANG BOOMERANG_PAIRS_BY BOOMERANG_COUNTS BOOMERANG_VERBOSE LD_PRELOAD
passed=0 failed=0

verdict() { # NAME STATUS
    if [ "$2" -eq 0 ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $1"
        grep -m 12 -v '^installed' "$temp/err"
    fi
}

# same NAME EXPECTED INSTALLS PROGRAM WAY THREADS [VARIABLE=VALUE]...: it prints what EXPECTED holds, and so many
# calls of Install (a pattern) put the plugin to work.
same() {
    local name=$1 expected=$2 installs=$3 program=$4 way=$5 count=$6 status=0
    shift 6
    env "$@" timeout 1500 "$program" "$way" "$count" "$steps" >"$temp/out" 2>"$temp/err" || status=$?
    cmp -s "$expected" "$temp/out" || status=1
    grep -q "^installed $installs\$" "$temp/err" || status=1
    [ "$status" -eq 0 ] || diff "$expected" "$temp/out" | head -n 4
    verdict "$name, $way on $count threads $*" "$status"
}

"$stock" one-by-one 1 "$steps" >"$temp/stock" 2>"$temp/err"
verdict "stock, one by one" $?
BOOMERANG=on "$plugin" one-by-one 1 "$steps" >"$temp/alone" 2>"$temp/err"
verdict "the plugin, one by one" $?
lines=$(wc -l <"$temp/stock")
[ "$lines" -ge $((16 * steps)) ] && [ "$(wc -l <"$temp/alone")" -eq $((lines + 10 * steps)) ]
verdict "all worlds are there" $?
head -n "$lines" "$temp/alone" | cmp -s - "$temp/stock"
verdict "one by one the plugin gives stock's hashes" $?
# Control: what is compared tells one step from the next, and one world from another.
[ "$(cut -d ' ' -f 3- "$temp/stock" | sort -u | wc -l)" -gt $((lines / 2)) ]
verdict "the hashes are not all the same" $?

# The first steps start the library, on all threads at once.
for way in at-once handed-over short-lived; do
    same plugin "$temp/alone" 0 "$plugin" "$way" 4 BOOMERANG=on
done
same plugin "$temp/alone" 0 "$plugin" beside 4 BOOMERANG=on
same plugin "$temp/alone" 1 "$plugin" counted 3 BOOMERANG=on
same plugin "$temp/alone" 1 "$plugin" counted 3 BOOMERANG=verify
same plugin "$temp/alone" 0 "$plugin" handed-over 3 BOOMERANG=on BOOMERANG_PAIRS_BY=lazy-dudley
same plugin "$temp/alone" 0 "$plugin" handed-over 3 BOOMERANG=on BOOMERANG_PAIRS_BY=free-direction
if [ -n "$library" ]; then
    same preloaded "$temp/stock" 0 "$stock" at-once 4 LD_PRELOAD="$library"
    same preloaded "$temp/stock" 0 "$stock" handed-over 4 LD_PRELOAD="$library"
fi

# The race to install takes place once in a process: many processes, of few steps.
steps=4
"$plugin" installing 1 $steps >"$temp/alone" 2>"$temp/err"
verdict "installed by one thread" $?
for round in $(seq "$(awk -v scale="${BMR_TEST_SCALE:-1}" 'BEGIN { n = int(6 * scale); print n < 2 ? 2 : n }')"); do
    same "plugin, round $round" "$temp/alone" 1 "$plugin" installing 8
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
