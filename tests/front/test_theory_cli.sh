#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# boomerang-testbed events and figures: exit codes, messages, files, and what the numbers must be.
#
#   test_theory_cli.sh DIRECTORY-OF-THE-PROGRAMS
set -uo pipefail

# shellcheck source=cli.sh
source "$(dirname "${BASH_SOURCE[0]}")/cli.sh"
# A small experiment, so that this test takes seconds.
small=(line orbit --n 16 --ratios 8:512 --seeds 1 --structures lazy-compass,free-fd2,closest-features)

test_events_prints_counts_growth_and_qualities() {
    expect 0 events "${small[@]}"
    clean
    err_empty
    out_has '^motion +optimum +compass +fd2 +features'
    out_has '^line +1 '
    out_has '^orbit '
    out_has 'Growth of events with D/sigma'
    out_has '^orbit .*<1/2'
    out_has '^free-fd2 '
}

test_events_are_written_as_csv() {
    expect 0 events "${small[@]}" --audit --quiet --csv "$scratch/e.csv"
    [ ! -s "$scratch/out" ] || fail "--quiet prints"
    # 2 motions, 4 ratios, 3 structures.
    [ "$(wc -l <"$scratch/e.csv")" -eq 25 ] || fail "the CSV file has not one row a run"
    # Every kind of an event has a column, and together they are the events and one start.
    awk -F, 'NR > 1 { n = 0; for (i = 16; i <= NF; ++i) n += $i; if (n != $6 + 1) { print; bad = 1 } } END { exit bad || NR < 2 }' "$scratch/e.csv" \
        >"$scratch/out" || fail "a row of other events than its kinds"
    expect 0 events "${small[@]}" --quiet --csv "$scratch/again.csv"
    cmp -s "$scratch/e.csv" "$scratch/again.csv" || fail "a second run counts otherwise"
}

test_events_explain_wrong_input() {
    says 'the nearest is "lazy-compass"' 2 events --structures lazy-compas
    says 'the nearest is "disc"' 2 events --shape ellipse:dsic
    says '"x" is no number' 2 events --ratios 8:x
    says 'LOW:HIGH' 2 events --ratios 512:8
    expect 2 events --n 2
    says 'none of these structures' 2 events line --structures points
}

test_events_beside_box2d() {
    says '^line: [1-9][0-9,]* questions in [0-9,]+ steps of stock Box2D, [0-9.]+ events of lazy-dudley: one for [0-9.,]+$' 0 events line --n 64 \
        --ratios 128 --seeds 1 --structures lazy-dudley --box2d
    head -n 1 "$scratch/out" | grep -q '^line: ' || fail "it is not what it says first"
    says 'stock Box2D' 0 events line --n 8 --ratios 8 --seeds 1 --structures free-fd2 --box2d
    # Box2D asks at every step; a structure a few times.
    awk '$1 == "line" { last = $0 } END { split(last, f); exit !(f[3] > 10 && f[9] < f[3]) }' "$scratch/out" || fail "the calls of Box2D are not beside the events"
    says 'a point' 3 events line --shape ellipse:point --ratios 8 --seeds 1 --box2d
}

test_figures_are_drawn() {
    expect 0 figures --list
    local name
    for name in boomerangs dudley mixed-insertion mixed-full mixed-events point-events pair-events inflated window free-direction coarse-line growth; do
        out_has "^$name "
    done
    # All but the one that runs long.
    expect 0 figures boomerangs dudley mixed-insertion mixed-full mixed-events point-events pair-events inflated window free-direction coarse-line -o "$scratch/figures/new"
    for name in boomerangs mixed-events coarse-line; do
        [ "$(wc -c <"$scratch/figures/new/$name.svg")" -gt 5000 ] || fail "$name.svg is empty"
    done
    says 'the nearest is "dudley"' 2 figures dudly
    says 'cannot make the directory' 3 figures dudley -o /dev/null/x
}

run_tests
