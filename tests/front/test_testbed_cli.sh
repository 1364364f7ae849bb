#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The command line of boomerang-testbed: exit codes, messages, and the form of what it prints and writes.
#
#   test_testbed_cli.sh DIRECTORY-OF-THE-PROGRAMS
set -uo pipefail

# shellcheck source=cli.sh
source "$(dirname "${BASH_SOURCE[0]}")/cli.sh"
# Small scenes, so that this test takes seconds: a classic one and a hard one.
classic=pyramid
hard=needles
steps=12

# A directory of workers that misbehave: fake NAME writes a script that stands in for both.
fake_workers() {
    mkdir -p "$scratch/$1"
    {
        echo '#!/bin/sh'
        echo "if [ \"\$1\" = --list-json ]; then exec \"$bin/boomerang-scene\" --list-json; fi"
        cat
    } >"$scratch/$1/boomerang-scene"
    chmod +x "$scratch/$1/boomerang-scene"
    cp "$scratch/$1/boomerang-scene" "$scratch/$1/boomerang-scene-plugin"
}

test_list_shows_every_scene() {
    says "^  $classic " 0 list
    out_has "^  $hard .*(size [0-9]*, [0-9]* steps)"
    clean
}

# The sentence is what the sides counted, and its quotient theirs. Counted behind the plugin: what it answers does not reach Box2D.
test_questions_and_events_are_told_first() {
    local lib=$bin/../lib
    LD_PRELOAD=$lib/libboomerang-count.so "$bin/boomerang-scene" needles --mode count --steps 20 | sed 's/^summary //' >"$scratch/stock.json"
    LD_PRELOAD=$lib/libboomerang_box2d.so:$lib/libboomerang-count.so "$bin/boomerang-scene-plugin" needles --mode count --steps 20 |
        sed 's/^summary //' >"$scratch/plugin.json"
    expect 0 compare needles --steps 20 --no-time --details
    out_has '^needles +[0-9]+ +[0-9]+ +[0-9.]+ +0\.0 '
    python3 - "$scratch/stock.json" "$scratch/plugin.json" "$scratch/out" <<'PYTHON' >"$scratch/err" || fail "the sentence is not what was counted"
import json, re, sys
stock, plugin = (json.load(open(path)) for path in sys.argv[1:3])
questions = sum(stock[calls] for calls in ("polygon_tests", "toi_calls", "distance_calls")) / 20
events = sum(count for kind, count in plugin["plugin"]["events"].items() if kind != "handover") / 20
said = re.match(r"needles: ([\d,.]+) questions a step in stock, ([\d,.]+) events: one for ([\d,.]+)\n", open(sys.argv[3]).read())
printed = [float(word.replace(",", "")) for word in said.groups()]
print(printed, questions, events)
sys.exit(not (questions > 9000 and abs(printed[0] - questions) <= 0.5 and abs(printed[1] - events) <= 0.5 and abs(printed[2] - questions / events) <= 0.5))
PYTHON
    says '^1 scene identical' 0 compare needles --steps 2 --no-time --quiet
    ! grep -q 'questions' "$scratch/out" || fail "--quiet tells more than the verdict"
}

test_compare_reports_identical_scenes() {
    expect 0 compare "$classic" "$hard" --steps "$steps" --repeat 1
    head -n 1 "$scratch/out" | grep -Eq '^2 scenes together: [0-9,.]+ questions a step in stock, ' || fail "questions and events are not what it says first"
    sed -n 2p "$scratch/out" | grep -Eq '^2 scenes identical, 0 different; step [0-9.]+x' || fail "the verdict is not what it says first"
    out_has "^$classic +$steps( +identical){3}( +[0-9.]+){5}\$"
    out_has "^$hard +$steps( +identical){3}( +[0-9.]+){5}\$"
    [ "$(wc -l <"$scratch/out")" -eq 9 ] || fail "more than a sentence, a verdict, two scenes and a word on details"
    err_empty
    clean
    [ "$(awk '{ if (length($0) > most) most = length($0) } END { print most + 0 }' "$scratch/out")" -le 132 ] ||
        fail "lines wider than a wide terminal"
}

# Whatever the caller has in the environment is not what the workers get.
test_compare_ignores_the_callers_plugin_settings() {
    BOOMERANG=off BOOMERANG_VERBOSE=1 expect 0 compare "$hard" --steps "$steps" --no-time --quiet
    err_empty
}

# A listener is called as often, and reads the same, whether the plugin is there or not; the three kinds differ, so the option is heard.
test_listeners_are_called_alike() {
    local kind program
    for kind in counts reads acts; do
        for program in boomerang-scene boomerang-scene-plugin; do
            claim="$program mixed-pile --listener $kind"
            "$bin/$program" mixed-pile --mode count --steps 60 --listener $kind 2>"$scratch/err" | grep -o '"listener":{[^}]*}' >"$scratch/$program.$kind" ||
                fail "no listener in the summary"
        done
        cmp -s "$scratch/boomerang-scene.$kind" "$scratch/boomerang-scene-plugin.$kind" || fail "other calls than stock's"
    done
    [ "$(sort -u "$scratch"/boomerang-scene.* | wc -l)" -eq 3 ] || fail "the kinds do the same"
    grep -Eq '"begins":[1-9][0-9]*,"ends":[1-9][0-9]*,"post_solves":[1-9][0-9]*,"pre_solves":[1-9]' "$scratch/boomerang-scene.reads" || fail "a kind of call never came"
}

test_compare_without_time_and_quietly() {
    says "^$classic .*identical\$" 0 compare "$classic" --steps "$steps" --no-time
    expect 0 compare "$classic" --steps "$steps" --no-time --details
    local title
    for title in 'Separation tests, calls per step' 'How kinetic the world is' 'What the plugin did instead' '^bits: every body'; do out_has "$title"; done
    [ "$(awk '{ if (length($0) > most) most = length($0) } END { print most + 0 }' "$scratch/out")" -le 132 ] || fail "wide lines"
    # The structure that was asked for works: no edge is remembered, and hulls are checked.
    says '^needles +0\.0 +[1-9]' 0 compare needles --steps 3 --no-time --details --structure free-direction
    expect 2 compare "$classic" --quiet --details
    expect 0 compare "$classic" --steps "$steps" --no-time --quiet
    [ "$(cat "$scratch/out")" = "1 scene identical, 0 different" ] || fail "not one closing line"
    err_empty
}

# The control: a difference of one bit is found where it was made, and named.
test_compare_finds_a_perturbation() {
    expect 1 compare "$hard" --steps "$steps" --perturb 7
    out_has "^$hard: first difference at step 7, in the hash of .*bodies.* \(linked, preloaded\)"
    out_has '^  body [0-9]+ [a-zA-Z_.]+'
    out_has '^    stock   .*0x'
    out_has '^    plugin  .*0x'
    out_has '^0 scenes identical, 1 different$'
    clean
    expect 0 compare "$hard" --steps "$steps" --no-time --quiet # and without it there is none
    says 'has only the steps 0 to 6' 2 compare "$hard" --steps 7 --perturb 7 --no-time
}

test_worker_failures_exit_with_3() {
    says 'no worker in' 3 --workers "$scratch" list
    fake_workers crashing <<'SH'
echo "step 0 a b c"; echo "Assertion failed: fat" >&2; kill -ABRT $$
SH
    expect 3 --workers "$scratch/crashing" compare "$classic" --steps "$steps"
    out_has 'killed by signal 6'
    out_has 'Assertion failed: fat'
    out_has '1 failed$'
    fake_workers refusing <<'SH'
echo "cannot" >&2; exit 2
SH
    says 'exit status 2' 3 --workers "$scratch/refusing" render "$classic" --step "$steps" -o "$scratch/none.svg"
    fake_workers stopping <<'SH'
echo "step 0 a b c"; echo 'summary {}'
SH
    expect 3 --workers "$scratch/stopping" compare "$classic" --steps "$steps"
    out_has 'ended after 1 steps'
}

# On a terminal: colours and a progress bar, but no colours with NO_COLOR. `script` makes the terminal.
test_terminals_get_colours_unless_told() {
    command -v script >/dev/null || return 0
    local line="'$testbed' compare '$classic' --steps $steps --no-time"
    : >"$scratch/err"
    claim="$line (on a terminal)"
    script -qec "$line" /dev/null </dev/null >"$scratch/out" || fail "it failed"
    LC_ALL=C grep -q $'\033\\[32m' "$scratch/out" || fail "no colours"
    LC_ALL=C grep -q $'\r.*ETA' "$scratch/out" || fail "no progress bar"
    claim="$claim with NO_COLOR"
    NO_COLOR=1 script -qec "$line" /dev/null </dev/null >"$scratch/out" || fail "it failed"
    if LC_ALL=C grep -q $'\033\\[[0-9;]*m' "$scratch/out"; then fail "colours"; fi
}

# Stock does not have outlines: they are held against the plugin that is off, and a nudge must be found there, too.
test_scenes_that_stock_does_not_have() {
    local scene
    for scene in any-stack caves; do
        expect 1 compare $scene --steps 4 --no-time --quiet --perturb 2
        out_has 'first difference at step 2'
    done
    claim="BOOMERANG=verify boomerang-scene-plugin caves"
    BOOMERANG=verify "$bin/boomerang-scene-plugin" caves --steps 20 >"$scratch/out" 2>"$scratch/err" || fail "it fails"
    err_has 'verified [1-9].*, 0 differ'
}

run_tests
