#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# What is said of a command line that makes no sense, and of an output that cannot be written.
#
#   test_usage_cli.sh DIRECTORY-OF-THE-PROGRAMS
set -uo pipefail

# shellcheck source=cli.sh
source "$(dirname "${BASH_SOURCE[0]}")/cli.sh"
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

# refused PATTERN ARGUMENT…: exit code 2, and a message that names program and command and has the pattern.
refused() {
    local pattern=$1
    shift
    says '^boomerang-testbed: ' 2 "$@"
    err_has "$pattern"
    clean
}

test_options_that_are_none() {
    refused 'compare has no option "--stpes"; the nearest is "--steps" \(boomerang-testbed compare --help' compare --stpes 3
    refused 'render has no option "--widht"; the nearest is "--width"' render planks --widht=400 -o x.png
    refused 'render has no option "-q"' render planks --step 4 -q -o x.png
    refused 'there is no option "--nope" \(' --nope
    refused 'run: "tiles" is one argument too many' run planks tiles
    refused 'a command is wanted: list, run, compare,'
}

# Names are offered where they are near, and not otherwise.
test_near_names_only() {
    refused 'no scene "plancks"; the nearest is "planks"' run plancks
    refused 'no scene "asteroid"; the nearest is "asteroids"' run asteroid
    refused 'no scene "xyzzy" \(boomerang-testbed list shows all\)' run xyzzy
    refused 'no command "rendr"; the nearest is "render"' rendr
    refused 'no command "foo" \(boomerang-testbed --help' foo
    refused 'no motion "circle" \(--list' events circle
    refused 'no option "--zzz" \(' compare --zzz
}

test_values() {
    refused '^boomerang-testbed: render: --width: "100" is no whole number from 200 to 10000' render planks --step 1 --width 100 -o x.png
    err_has '^    --width: Width in pixels'
    refused '"3\.5" is no whole number from 1 to' run planks --size 3.5
    refused '--seed: "-1" is no whole number from 0' run planks --seed -1
    refused '--seed: "18446744073709551616" is no' run planks --seed 18446744073709551616
    expect 0 run pyramid --size 3 --steps 1 --seed 18446744073709551615
    refused '"lazy-compas" is none of lazy-compass, .*; the nearest is "lazy-compass"' run planks --structure lazy-compas
    refused '"maybe" is none of on, off$' run planks --plugin maybe
    refused 'render: --output: a value is missing' render planks --step 1 -o
    refused 'render: --step: it is given more than once' render planks --step 1 --step 2
    refused 'render needs --output' render planks --step 1
    err_has '^    --output: The picture'
    refused '--repeat and --no-time do not go together' compare planks --repeat 2 --no-time
    refused 'cannot read .*/none: No such file' --workers "$scratch/none" list
}

count=(events line --structures lazy-compass --seeds 40 --n 16 --ratios 8 --quiet --csv)
test_why_a_file_cannot_be_written() {
    local to
    : >"$scratch/file"
    mkdir "$scratch/directory.csv"
    for to in "no/x.csv:there is no directory .*/no" "file/x.csv:Not a directory" "directory.csv:Is a directory"; do
        says "cannot write $scratch/${to%%:*}: ${to#*:}$" 3 events line --csv "$scratch/${to%%:*}"
    done
    says 'cannot write /dev/full: No space left on device' 3 "${count[@]}" /dev/full
}

# What cannot be written whole leaves what was there; what can keeps its link.
test_a_file_is_replaced_whole_or_not_at_all() {
    echo old >"$scratch/old.csv"
    (
        ulimit -f 1
        trap '' XFSZ
        exec "$testbed" "${count[@]}" "$scratch/old.csv"
    ) >"$scratch/out" 2>"$scratch/err" && fail "a file that is too long was written"
    echo old | cmp -s - "$scratch/old.csv" || fail "the old file is gone"
    [ -z "$(find "$scratch" -name 'old.csv.*')" ] || fail "an unfinished file is left"
    ln -sf old.csv "$scratch/link.csv"
    expect 0 "${count[@]}" "$scratch/link.csv"
    [ -L "$scratch/link.csv" ] || fail "the link is gone"
    grep -q '^line,lazy-compass,' "$scratch/old.csv" || fail "what it leads to is not replaced"
}

test_help_builds_nothing() {
    claim='./testbed_scenes/run --help'
    : >"$scratch/err"
    BMR_BUILD_DIR=$scratch/build "$root/testbed_scenes/run" --help >"$scratch/out" 2>&1 || fail "it failed"
    out_has './testbed_scenes/run compare needles'
    out_has 'The commands of boomerang-testbed: list, run'
    local command
    for command in 'compare --help' 'reproduce --help' 'try -h' 'playground --help' '--nope --help'; do
        # shellcheck disable=SC2086
        BMR_BUILD_DIR=$scratch/build "$root/testbed_scenes/run" $command >"$scratch/out" 2>&1 || fail "$command fails"
        out_has 'testbed_scenes/run '
    done
    for command in compair reproduce\ table-7 --nope; do
        local status=0
        # shellcheck disable=SC2086
        BMR_BUILD_DIR=$scratch/build "$root/testbed_scenes/run" $command >"$scratch/out" 2>&1 || status=$?
        [ "$status" -eq 2 ] || fail "$command is not refused"
        out_has 'there is no .*there are .*'
    done
    [ ! -e "$scratch/build" ] || fail "it makes a directory to build in"
    BMR_BUILD_DIR=$scratch/build "$root/testbed_scenes/run" --help >"$scratch/out"
    "$testbed" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p' >"$scratch/commands"
    [ "$(wc -l <"$scratch/commands")" -ge 7 ] || fail "control: no list of commands"
    while read -r command; do out_has "(^|[ ,])$command[,.]"; done < <(grep . "$scratch/commands")
}

run_tests
