#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   compare.sh STOCK PLUGIN [FIRST_SEED [SEEDS [STEPS]]]
#
# Runs the random worlds with both programs, the plugin in each of its forms, and compares what they print, step
# by step. Says where the first difference is and what differs there. BMR_TEST_SCALE multiplies the seeds.
set -u
stock=$1 plugin=$2 first=${3:-1} steps=${5:-200}
seeds=${4:-$(awk -v scale="${BMR_TEST_SCALE:-1}" 'BEGIN { n = int(200 * scale); print n < 4 ? 4 : n }')}
structures=${BMR_STRUCTURES:-lazy-compass lazy-dudley free-direction}
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
passed=0 failed=0

# fails MESSAGE...: notes a failure
fails() {
    echo "FAILED: $*"
    failed=$((failed + 1))
}

# first_difference FILE FILE: "seed step" of the first line that is not the same in both
first_difference() {
    paste -d '\n' "$1" "$2" | awk 'NR % 2 { a = $0; next } a != $0 { split(a == "" ? $0 : a, n, " "); print n[1], n[2]; exit }'
}

# explain NAME STRUCTURE PREFILTER: what differs in the state at the first difference
explain() {
    local seed step
    read -r seed step < <(first_difference "$room/stock" "$room/$1")
    fails "$2, prefilter $3: first difference at seed $seed, step $step"
    "$stock" "$seed" 1 $((step + 1)) dump "$seed" "$step" >"$room/a"
    "$plugin" "$seed" 1 $((step + 1)) "$2" "$3" dump "$seed" "$step" >"$room/b"
    diff "$room/a" "$room/b" | head -n 20
}

"$stock" "$first" "$seeds" "$steps" >"$room/stock" 2>"$room/stock.err" || { fails "stock ended with $?"; tail -3 "$room/stock.err"; }
lines=$(wc -l <"$room/stock")
[ "$lines" -eq $((seeds * steps)) ] || fails "stock printed $lines lines for $seeds seeds of $steps steps"

# Control: what listeners do while impacts are solved did come by; all of it, in as many worlds as the test has.
[ "$seeds" -lt 200 ] || ! grep -q 'impacts.* 0\b' "$room/stock.err" || fails "$(cat "$room/stock.err")"

for structure in $structures; do
    # One process per core would do; two prefilters, two processes.
    for prefilter in on off; do
        "$plugin" "$first" "$seeds" "$steps" "$structure" $prefilter >"$room/$structure-$prefilter" 2>"$room/$structure-$prefilter.err" &
    done
    wait
    for prefilter in on off; do
        name=$structure-$prefilter
        if cmp -s "$room/stock" "$room/$name"; then
            passed=$((passed + 1))
        else
            explain "$name" "$structure" $prefilter
            tail -n 2 "$room/$name.err"
        fi
    done
done

# Control: one unit in the last place of one velocity, in the last seed, is found, and where it is.
seed=$((first + seeds - 1)) step=$((steps / 2))
"$stock" "$seed" 1 "$steps" perturb "$seed" "$step" >"$room/perturbed"
tail -n "$steps" "$room/stock" >"$room/last"
found=$(first_difference "$room/last" "$room/perturbed")
if [ "$found" = "$seed $step" ]; then
    passed=$((passed + 1))
else
    fails "control: perturbed at seed $seed, step $step; found '$found'"
fi

echo "$seeds seeds of $steps steps: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
