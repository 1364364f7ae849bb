#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   test_clocks.sh ROOT
#
# No verdict hangs on a clock, on the number of processors or on chance: whatever reads one of them in tests/ is in the list below,
# with the reason why it decides nothing. A new line asks whoever writes it for a reason.
set -u
root=$1
failed=0

# What looks at the time, waits for it, or draws what nobody gave it.
looks='steady_clock|system_clock|high_resolution|clock_gettime|gettimeofday|std::clock\b|[^a-z_]time\((NULL|nullptr|0)\)|sleep_for|sleep_until|usleep|nanosleep|\bsleep [0-9"$]|\balarm\(|\btimeout ["0-9$]|\bnproc\b|hardware_concurrency|random_device|\$RANDOM|time\.monotonic|time\.time|time\.sleep|\$SECONDS|\bdate \+|urandom|EPOCH'

# file: reason
allowed='
tests/bench/bench_cold_steps.cpp: a benchmark, which prints what it measured
tests/contracts/contracts.cpp: ends what hangs
tests/contracts/process.cpp: ends what hangs
tests/front/browser.py: polls a page; ends what hangs
tests/front/test_usage_cli.sh: polls for a file
tests/determinism/run: how many at once
tests/random/run: tells how long it took; the seconds of a campaign are asked for by name
tests/gate/test_clocks.sh: the list itself
tests/hooks/clock_game.cpp: a test of clocks, which reads before and after
tests/run: how many at once; the seed of a long run, which is printed
tests/soak/run_soak.sh: when to look at the memory
tests/stages/common.sh: tells how long it took
tests/plugin/test_try.sh: a game that goes on for ever, and is interrupted
tests/threads/forking.cpp: between two looks at whether a thread is asleep
tests/threads/run_ways.sh: ends what hangs
'
found=$(cd "$root" && grep -rlE --include='*.c' --include='*.cpp' --include='*.h' --include='*.sh' --include='*.py' --include=run \
    "$looks" tests | LC_ALL=C sort)
while read -r file; do
    grep -q "^$file: " <<<"$allowed" || {
        echo "FAILED: $file looks at a clock, at the processors or at chance, and tests/gate/test_clocks.sh has no reason why that decides nothing:"
        grep -nE "$looks" "$root/$file" | head -n 3
        failed=1
    }
done <<<"$found"
while IFS=: read -r file _; do
    [ -z "$file" ] || grep -qx "$file" <<<"$found" || {
        echo "FAILED: $file is in the list, and looks at nothing"
        failed=1
    }
done <<<"$allowed"
# Control: something is found.
grep -qx tests/hooks/clock_game.cpp <<<"$found" || failed=1
[ "$failed" -eq 0 ] && echo passed
exit "$failed"
