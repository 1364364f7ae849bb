#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# `boomerang-testbed plot`: what it draws, and what it will not read.
#
#   test_plot_cli.sh DIRECTORY-OF-THE-PROGRAMS
set -uo pipefail

# shellcheck source=support/cli.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/cli.sh"

test_a_plot_is_drawn() {
    printf '%s\n' series,x,y 'a, with a comma,1000,5' 'a, with a comma,2000,10' b,1000,7 >"$scratch/numbers.csv"
    expect 0 plot "$scratch/numbers.csv" -o "$scratch/plot.svg" --title growth --x bodies --y instructions
    out_has 'plot\.svg$'
    err_empty
    clean
    grep -q '<svg' "$scratch/plot.svg" || fail "no picture"
}

# More numbers must make another picture.
test_numbers_are_drawn() {
    printf '%s\n' series,x,y a,1,1 a,10,10 >"$scratch/few.csv"
    printf '%s\n' series,x,y a,1,1 a,3,9 a,10,10 >"$scratch/more.csv"
    expect 0 plot "$scratch/few.csv" -o "$scratch/few.svg"
    expect 0 plot "$scratch/more.csv" -o "$scratch/more.svg"
    if cmp -s "$scratch/few.svg" "$scratch/more.svg"; then
        fail "a point makes no difference"
    fi
}

test_what_is_no_number_is_refused() {
    local line
    for line in a,0,1 a,1,0 a,-2,1; do
        printf '%s\n' series,x,y a,1,1 "$line" >"$scratch/bad.csv"
        expect 2 plot "$scratch/bad.csv" -o "$scratch/bad.svg"
        err_has "bad\.csv, line 3: [xy] = .* has no place on a logarithmic axis: $line"
        [ ! -e "$scratch/bad.svg" ] || fail "a picture all the same"
    done
    for line in a a,1 a,1,b a,1,2x a,,1 a,1,inf ','; do
        printf '%s\n' series,x,y "$line" >"$scratch/bad.csv"
        expect 2 plot "$scratch/bad.csv" -o "$scratch/bad.svg"
        err_has 'bad\.csv, line 2: not a line of series,x,y'
    done
    : >"$scratch/empty.csv"
    expect 2 plot "$scratch/empty.csv" -o "$scratch/bad.svg"
    err_has 'empty'
    expect 2 plot "$scratch/few.csv" -o "$scratch/bad.gif"
    expect 2 plot "$scratch/missing.csv" -o "$scratch/bad.svg"
}

run_tests
