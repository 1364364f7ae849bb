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

# number FILE OPERATOR VALUE PATTERN: compares the number that the pattern of sed finds in brackets.
number() {
    local got
    got=$(sed -nE "s/$4/\\1/p" "$1" | head -n 1)
    awk -v got="$got" -v value="$3" "BEGIN { exit !(got != \"\" && got + 0 $2 value + 0) }" || fail "$4: $got is not $2 $3"
}

# What a run printed without its times on the clock.
counted() { grep -v '^clock' "$1"; }

# kept FILE ARGUMENT...: runs the world, and keeps what it prints.
kept() {
    expect 0 world "${@:2}"
    cp "$scratch/out" "$1"
}

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
    says '^check: .* [1-9][0-9]* of them overlap' 0 world "${small[@]}" --answer pass --check
}

test_runs_are_equal_and_conserve() {
    expect 0 world "${small[@]}" --quiet
    [ ! -s "$scratch/out" ] || fail "--quiet prints"
    kept "$scratch/a" "${small[@]}" --boundary open
    kept "$scratch/b" "${small[@]}" --boundary open
    [ "$(counted "$scratch/a")" = "$(counted "$scratch/b")" ] || fail "a second run counts otherwise"
    # Control: another seed is another world.
    kept "$scratch/c" "${small[@]}" --boundary open --seed 2
    [ "$(counted "$scratch/a" | sed 1,2d)" != "$(counted "$scratch/c" | sed 1,2d)" ] || fail "another seed counts the same"
    number "$scratch/a" '>' 5 '^contact +([0-9]+).*'
    for drift in 'energy to' 'momentum to' 'angular momentum to'; do
        number "$scratch/a" '<' 1e-12 "^conserved:.* $drift ([-+.e0-9]+).*"
        number "$scratch/a" '>' -1e-12 "^conserved:.* $drift ([-+.e0-9]+).*"
    done
    # Control: inelastic bodies lose energy, and it is told.
    kept "$scratch/d" "${small[@]}" --boundary open --answer 0.5 --zeno elastic
    number "$scratch/d" '<' 99 '^conserved: +not the energy \(([.0-9]+) % are left\).*'
    number "$scratch/d" '<' 1e-12 '^conserved:.* momentum to ([-+.e0-9]+).*'
}

test_all_pairs_have_the_same_contacts() {
    kept "$scratch/cells" "${small[@]}"
    kept "$scratch/all" "${small[@]}" --all-pairs
    [ "$(grep '^contact' "$scratch/cells")" = "$(grep '^contact' "$scratch/all")" ] || fail "all pairs have other contacts"
    # Every two bodies, and each with every wall; cells watch fewer.
    number "$scratch/all" '==' 270 '^watched: +([0-9]+) pairs.*'
    number "$scratch/cells" '<' 270 '^watched: +([0-9]+) pairs.*'
    number "$scratch/all" '==' 0 '^cross +([0-9]+).*'
    number "$scratch/cells" '>' 0 '^cross +([0-9]+).*'
}

test_growth_is_a_table() {
    expect 0 world gas --seconds 1 --growth 10,20
    clean
    out_has '^10 .*\(1.00\)'
    out_has '^20 '
    says '"x" is no number of bodies' 2 world gas --growth 10,x
}

test_a_run_is_drawn() {
    local run=(world gas --bodies 20 --seconds 1 --quiet)
    expect 0 "${run[@]}" --picture "$scratch/run.svg" --step 10 --all
    grep -q '<svg' "$scratch/run.svg" || fail "no picture"
    # Cells, disks and trails are layers: without them there is less to draw.
    expect 0 "${run[@]}" --picture "$scratch/bare.svg" --step 10 --bare
    [ "$(grep -c '<path' "$scratch/run.svg")" -gt "$(($(grep -c '<path' "$scratch/bare.svg") + 50))" ] || fail "--all draws no more than --bare"
    says '3 pictures of gas, steps 0 to 10' 0 "${run[@]:0:6}" --picture "$scratch/series.svg" --frames 0:10:5
    out_has '^contact +[0-9]' # and the figures, as without pictures
    [ "$(find "$scratch" -name 'series-000[012].svg' | wc -l)" -eq 3 ] || fail "not three pictures"
    ! cmp -s "$scratch/series-0000.svg" "$scratch/series-0002.svg" || fail "nothing moves"
    says 'the last step of gas is 30, not 31' 2 "${run[@]}" --picture "$scratch/none.svg" --step 31
    says 'the last step of gas is 30, not 32' 2 "${run[@]}" --picture "$scratch/none.svg" --frames 2:32
    says 'there is no body 99 after step 10' 2 "${run[@]}" --picture "$scratch/none.svg" --step 10 --focus 99
    # A picture changes no count.
    kept "$scratch/plain" "${run[@]:1:5}"
    kept "$scratch/drawn" "${run[@]:1:5}" --picture "$scratch/drawn.svg" --step 3
    [ "$(counted "$scratch/plain")" = "$(counted "$scratch/drawn" | sed 1,2d)" ] || fail "a picture changes the counts"
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
gas --seed -1|--seed
gas --density 0|--density: a number above 0
gas --density nan|--density
gas --density 0.9|no room
gas --seconds -1|--seconds
gas --sizes 0.5|--sizes
gas --sizes 1e4|--sizes
gas --vertices 2|--vertices: N or FEWEST:MOST
gas --vertices 9:8|--vertices
gas --answer 1.5|--answer
gas --answer hard|elastic, pass or a restitution is wanted, not "hard"
gas --answer elastik|nearest is "elastic"
gas --structure lazy-dudly|nearest is "lazy-dudley"
gas --structure point-lazy-dudley|for points
gas --shape sphere|--shape
gas --zeno-speed 1|without --zeno elastic
gas --step 10|--picture
gas --all|--picture
gas --picture x.svg|which step
gas --picture x.svg --frames 5:3|FIRST:LAST
gas --picture x.txt --step 3|should end in .svg, .png or .pdf
gas --picture x.svg --step 3 --growth 10|growth
cooling --bodies 3|periodic box
WORDS
    expect 3 world gas --picture "$scratch/none/run.svg" --step 3
    says 'fewer than 2e.04 steps' 2 world gas --picture "$scratch/run.svg" --step 3 --seconds 700
}

run_tests
