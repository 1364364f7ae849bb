#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# boomerang-testbed world: exit codes, messages, files and pictures, and what the numbers must be.
#
#   test_world_cli.sh DIRECTORY-OF-THE-PROGRAMS
set -uo pipefail

# shellcheck source=cli.sh
source "$(dirname "${BASH_SOURCE[0]}")/cli.sh"
# A small gas, so that this test takes seconds.
small=(gas --bodies 20 --seconds 3)

# number FILE OPERATOR VALUE KEY…: compares a number of a JSON file.
number() {
    local file=$1 operator=$2 value=$3 got
    shift 3
    got=$(json_get "$file" "$@")
    awk -v got="$got" -v value="$value" "BEGIN { exit !(got != \"\" && got + 0 $operator value + 0) }" || fail "$*: $got is not $operator $value"
}

# The figures of a run without its times on the clock.
counted() { grep -v '"clock"\|"microseconds_an_event"' "$1"; }

test_every_scene_runs_and_nothing_overlaps() {
    expect 0 world --list
    for scene in gas cooling swarm asteroids bullet; do
        out_has "^  $scene "
    done
    for scene in gas cooling swarm asteroids bullet; do
        expect 0 world "$scene" --bodies 20 --seconds 1 --check --audit
        clean
        err_empty
        out_has '^contact +[0-9]'
        out_has '^watched: +[0-9]+ pairs'
        out_has '^memory: +[0-9]+ bytes'
        out_has ' 0 of them overlap'
        out_has '^audits: +4 passed'
    done
    # Walls of any width, and plans that are counted.
    expect 0 world asteroids --boundary walls --check --quiet
    says '^plans: +[1-9]' 0 world swarm --bodies 20 --seconds 5
    # Control: bodies that pass through each other do overlap, and are told to.
    expect 0 world "${small[@]}" --answer pass --check --quiet --json "$scratch/pass.json"
    grep -qE '"overlaps": [1-9]' "$scratch/pass.json" || fail "bodies that pass through each other: no overlap is counted"
}

test_runs_are_equal_and_conserve() {
    expect 0 world "${small[@]}" --boundary open --quiet --json "$scratch/a.json"
    [ ! -s "$scratch/out" ] || fail "--quiet prints"
    expect 0 world "${small[@]}" --boundary open --quiet --json "$scratch/b.json"
    [ "$(counted "$scratch/a.json")" = "$(counted "$scratch/b.json")" ] || fail "a second run counts otherwise"
    # Control: another seed is another world.
    expect 0 world "${small[@]}" --boundary open --quiet --seed 2 --json "$scratch/c.json"
    [ "$(counted "$scratch/a.json")" != "$(counted "$scratch/c.json")" ] || fail "another seed counts the same"
    number "$scratch/a.json" '>' 5 0 events contact
    for drift in energy_drift momentum_drift angular_drift; do
        number "$scratch/a.json" '<' 1e-12 0 "$drift"
        number "$scratch/a.json" '>' -1e-12 0 "$drift"
    done
    # Control: inelastic bodies lose energy, and it is told.
    says 'not the energy' 0 world "${small[@]}" --boundary open --answer 0.5 --zeno elastic --json "$scratch/d.json"
    number "$scratch/d.json" '<' 0.99 0 energy_left
    number "$scratch/d.json" '<' 1e-12 0 momentum_drift
}

test_all_pairs_have_the_same_contacts() {
    expect 0 world "${small[@]}" --quiet --json "$scratch/cells.json"
    expect 0 world "${small[@]}" --quiet --all-pairs --json "$scratch/all.json"
    [ "$(json_get "$scratch/cells.json" 0 events contact)" = "$(json_get "$scratch/all.json" 0 events contact)" ] ||
        fail "all pairs have other contacts"
    # Every two bodies, and each with every wall; cells watch fewer.
    number "$scratch/all.json" '==' 270 0 pairs
    number "$scratch/cells.json" '<' 270 0 pairs
    number "$scratch/all.json" '==' 0 0 events cross
    number "$scratch/cells.json" '>' 0 0 events cross
}

test_growth_is_a_table() {
    expect 0 world gas --seconds 1 --growth 10,20 --json "$scratch/growth.json"
    clean
    out_has '^10 .*\(1.00\)'
    out_has '^20 '
    number "$scratch/growth.json" '==' 20 1 bodies
    says '"x" is no number of bodies' 2 world gas --growth 10,x
}

test_a_run_is_drawn() {
    local run=(world gas --bodies 20 --seconds 1 --rate 10 --quiet)
    expect 0 "${run[@]}" --picture "$scratch/run.svg" --step 10 --all
    grep -q '<svg' "$scratch/run.svg" || fail "no picture"
    # Cells, disks and trails are layers: without them there is less to draw.
    expect 0 "${run[@]}" --picture "$scratch/bare.svg" --step 10 --bare
    [ "$(grep -c '<path' "$scratch/run.svg")" -gt "$(($(grep -c '<path' "$scratch/bare.svg") + 50))" ] || fail "--all draws no more than --bare"
    says '3 pictures of gas, steps 0 to 10' 0 "${run[@]:0:8}" --picture "$scratch/series.svg" --frames 0:10:5
    out_has '^contact +[0-9]' # and the figures, as without pictures
    [ "$(find "$scratch" -name 'series-000[012].svg' | wc -l)" -eq 3 ] || fail "not three pictures"
    ! cmp -s "$scratch/series-0000.svg" "$scratch/series-0002.svg" || fail "nothing moves"
    says 'the last step of gas is 10, not 11' 2 "${run[@]}" --picture "$scratch/none.svg" --step 11
    says 'the last step of gas is 10, not 12' 2 "${run[@]}" --picture "$scratch/none.svg" --frames 2:12
    says 'there is no body 99 after step 10' 2 "${run[@]}" --picture "$scratch/none.svg" --step 10 --focus 99
    # A picture changes no count.
    expect 0 "${run[@]:0:6}" --quiet --json "$scratch/plain.json"
    expect 0 "${run[@]}" --json "$scratch/drawn.json" --picture "$scratch/drawn.svg" --step 3
    [ "$(counted "$scratch/plain.json")" = "$(counted "$scratch/drawn.json")" ] || fail "a picture changes the counts"
    # A periodic box is drawn, by the only line of such dashes, and said in the legend.
    expect 0 "${run[@]}" --boundary periodic --picture "$scratch/box.svg" --step 10
    [ "$(grep -c 'stroke-dasharray:9,5' "$scratch/box.svg")" -eq 2 ] || fail "no periodic box"
    grep -q 'stroke-dasharray:9,5' "$scratch/run.svg" && fail "a periodic box without one"
    [ ! -e "$scratch/none.svg" ] || fail "there is a picture all the same"
}

test_collapse_is_told() {
    expect 3 world cooling --bodies 40 --density 0.3 --shape regular --answer 0.05 --zeno error --seconds 40 --quiet
    err_has 'stopped at time .*body [0-9]* and .*contact after contact.*--zeno elastic'
    says '^softened: +[0-9]' 0 world cooling --bodies 40 --density 0.3 --shape regular --answer 0.5 --zeno-speed 0.1 --seconds 10
}

test_nonsense_is_refused() {
    while IFS='|' read -r words message; do
        # shellcheck disable=SC2086 # words
        says "$message" 2 world $words
    done <<'WORDS'
gasp|nearest is "gas"
gas --bodies 1|--bodies: "1" is no whole number from 2 to
gas --bodies 0|--bodies
gas --seed -1|--seed
gas --seed 1.5|--seed
gas --density 0|--density: a number above 0
gas --density nan|--density
gas --density 0.9|no room
gas --seconds -1|--seconds
gas --seconds 0|--seconds
gas --speed inf|--speed
gas --sizes 0.5|--sizes
gas --sizes 1e4|--sizes
gas --vertices 2|--vertices: N or FEWEST:MOST
gas --vertices 9:8|--vertices
gas --vertices 8:|--vertices
gas --vertices -8|--vertices
gas --answer 1.5|--answer
gas --answer hard|elastic, stick, pass or a restitution is wanted, not "hard"
gas --answer elastik|nearest is "elastic"
gas --structure lazy-dudly|nearest is "lazy-dudley"
gas --structure point-lazy-dudley|for points
gas --shape sphere|--shape
gas --zeno-speed 1|without --zeno elastic
gas --rate 10|--picture
gas --step 10|--picture
gas --all|--picture
gas --picture x.svg|which step
gas --picture x.svg --frames 5:3|FIRST:LAST
gas --picture x.txt --step 3|should end in .svg, .png or .pdf
gas --picture x.svg --step 3 --growth 10|growth
cooling --bodies 3|periodic box
WORDS
    expect 3 world gas --picture "$scratch/none/run.svg" --step 3
    for rate in 0 -1 nan 1e9; do
        says 'above 0' 2 world gas --picture "$scratch/run.svg" --step 3 --rate "$rate"
    done
}

run_tests
