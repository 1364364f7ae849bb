#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   compare.sh STOCK PLUGIN [FIRST_SEED [SEEDS [STEPS]]]
#
# Runs the random worlds with both programs, the plugin in each of its forms, and compares what they print, step
# by step. Says where the first difference is and what differs there. A seed whose world stock does not survive is
# lost, and a lost seed is a failure of its own. BMR_TEST_SEED is the first seed where none is given (default 1),
# BMR_TEST_SCALE multiplies the number of seeds.
set -u
stock=$1 plugin=$2 first=${3:-${BMR_TEST_SEED:-1}} steps=${5:-200}
seeds=${4:-$(awk -v scale="${BMR_TEST_SCALE:-1}" 'BEGIN { n = int(200 * scale); print n < 4 ? 4 : n }')}
structures=${BMR_STRUCTURES:-lazy-compass lazy-dudley free-direction}
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
passed=0 failed=0
# What a game may trap ends a process, and its seed is lost. (tests/determinism has the control, and why fresh memory holds
# numbers.)
export MALLOC_PERTURB_=1
cc -shared -fPIC -o "$room/traps.so" "$(dirname "${BASH_SOURCE[0]}")/../determinism/traps.c" -lm || exit 1

# fails MESSAGE...: notes a failure
fails() {
    echo "FAILED: $*"
    failed=$((failed + 1))
}

# run OUT FIRST SEEDS PROGRAM ARGUMENT...: OUT has the lines of all seeds that the program survives, OUT.lost a line for each of
# the others: the seed, and what was said last. (After a seed that is lost a new process goes on with the next.)
run() {
    local out=$1 next=$2 end=$(($2 + $3)) program=$4 status lost
    shift 4
    : >"$out"
    : >"$out.err"
    : >"$out.lost"
    while [ "$next" -lt "$end" ]; do
        status=0
        LD_PRELOAD=$room/traps.so "$program" "$next" $((end - next)) "$steps" "$@" >"$out.part" 2>"$out.part.err" || status=$?
        cat "$out.part.err" >>"$out.err"
        # The first seed of which not all steps are there.
        lost=$(awk -v next_seed="$next" -v steps="$steps" '{ n[$1]++ } END { s = next_seed; while (n[s] == steps) s++; print s }' "$out.part")
        awk -v lost="$lost" '$1 < lost' "$out.part" >>"$out"
        [ "$status" -ne 0 ] || [ "$lost" -lt "$end" ] || break
        echo "seed $lost, exit status $status: $(tail -n 1 "$out.part.err")" >>"$out.lost"
        next=$((lost + 1))
    done
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

run "$room/stock" "$first" "$seeds" "$stock"
lost=$(wc -l <"$room/stock.lost")
if [ "$lost" -ne 0 ]; then
    fails "stock Box2D did not survive $lost of $seeds random worlds; a random world must be one that it survives"
    cat "$room/stock.lost"
fi
[ "$(wc -l <"$room/stock")" -eq $(((seeds - lost) * steps)) ] || fails "stock did not print $steps lines a seed"

# Control: what listeners do while impacts are solved did come by; all of it, in as many worlds as the test has.
[ "$seeds" -lt 200 ] || ! grep -q 'impacts.* 0\b' "$room/stock.err" || fails "$(cat "$room/stock.err")"

for structure in $structures; do
    # One process per core would do; two prefilters, two processes.
    # With one of them somebody listens to all events, besides, and nothing else may be otherwise for it.
    ways="on off"
    [ "$structure" != free-direction ] || ways="on off told"
    for prefilter in $ways; do
        run "$room/$structure-$prefilter" "$first" "$seeds" "$plugin" "$structure" $prefilter &
    done
    wait
    for prefilter in $ways; do
        name=$structure-$prefilter
        if [ -s "$room/$name.lost" ]; then
            fails "$structure, prefilter $prefilter: with the plugin the program does not end well: $(head -n 1 "$room/$name.lost")"
        elif cmp -s "$room/stock" "$room/$name"; then
            passed=$((passed + 1))
        else
            explain "$name" "$structure" $prefilter
            tail -n 2 "$room/$name.err"
        fi
    done
done

# Control: one unit in the last place of one velocity, in the last seed, is found, and where it is.
seed=$(tail -n 1 "$room/stock" | cut -d ' ' -f 1) step=$((steps / 2))
"$stock" "$seed" 1 "$steps" perturb "$seed" "$step" >"$room/perturbed"
tail -n "$steps" "$room/stock" >"$room/last"
found=$(first_difference "$room/last" "$room/perturbed")
if [ "$found" = "$seed $step" ]; then
    passed=$((passed + 1))
else
    fails "control: perturbed at seed $seed, step $step; found '$found'"
fi

# Control: a process that ends in the second of three seeds has lost that one alone, with the reason; its other seeds are there.
run "$room/ended" "$first" 3 "$stock" end $((first + 1)) "$step"
if [ "$(cat "$room/ended.lost")" = "seed $((first + 1)), exit status 134: told to end" ] &&
    [ "$(cut -d ' ' -f 1 "$room/ended" | uniq -c | awk -v n="$steps" '$1 == n { printf "%s ", $2 }')" = "$first $((first + 2)) " ]; then
    passed=$((passed + 1))
else
    fails "control: ended in seed $((first + 1)); lost: $(cat "$room/ended.lost")"
fi

# Control: so has one that prints all lines and then ends badly.
printf '#!/bin/sh\n"%s" "$@"\nexit 3\n' "$stock" >"$room/bad_end"
chmod +x "$room/bad_end"
run "$room/ended" "$first" 1 "$room/bad_end"
if [ -s "$room/ended.lost" ] && [ "$(wc -l <"$room/ended")" -eq "$steps" ]; then
    passed=$((passed + 1))
else
    fails "control: a program that ends with status 3 goes unnoticed"
fi

echo "seeds $first to $((first + seeds - 1)), $((seeds - lost)) of $seeds run, $steps steps each: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
