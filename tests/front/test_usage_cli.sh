#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# What every command has in common: help, what is said of a command line that makes no sense, and of an output
# that cannot be written.
#
#   test_usage_cli.sh DIRECTORY-OF-THE-PROGRAMS
set -uo pipefail

# shellcheck source=cli.sh
source "$(dirname "${BASH_SOURCE[0]}")/cli.sh"
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

commands() { "$testbed" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p'; }
test_every_command_helps_and_refuses() {
    local command
    [ "$(commands | wc -l)" -ge 6 ] || fail "commands are not found in --help"
    says '^boomerang-testbed [0-9]+\.[0-9]+\.[0-9]+$' 0 --version
    for command in $(commands); do
        says 'Exit codes: 0 .* 1 .* 2 .* 3 ' 0 "$command" --help
        err_empty
        clean
        expect 2 "$command" --no-such-option
        [ ! -s "$scratch/out" ] || fail "an error on standard output"
        err_has '.'
    done
}

# Names are offered where they are near, and not otherwise.
test_what_makes_no_sense_is_refused() {
    expect 2
    while IFS='@' read -r words message; do
        # shellcheck disable=SC2086 # words
        says '^boomerang-testbed: ' 2 $words
        err_has "$message"
        clean
    done <<'WORDS'
@a command is wanted: list, compare, render,
--nope@there is no option "--nope" \(
rendr@no command "rendr"; the nearest is "render"
foo@no command "foo" \(boomerang-testbed --help
--workers /no/such list@list: --workers: Directory does not exist: /no/such$
compare --stpes 3@compare has no option "--stpes"; the nearest is "--steps" \(boomerang-testbed compare --help
compare --zzz@no option "--zzz" \(
compare neddles@nearest is "needles"
compare pyramid --steps 0@no whole number from 1 to 100000000
compare pyramid --size 1000001@no whole number from 1 to 1000000
compare pyramid --steps many@no whole number
compare pyramid --repeat 0@--repeat
compare pyramid --structure lazy@--structure
compare planks --repeat 2 --no-time@compare: --repeat excludes --no-time$
render@
list tiles@list: .*not expected: tiles \(boomerang-testbed list --help
compare plancks@no scene "plancks"; the nearest is "planks"
compare asteroid@no scene "asteroid"; the nearest is "asteroids"
compare xyzzy@no scene "xyzzy" \(boomerang-testbed list shows all\)
compare planks --size 3.5@"3\.5" is no whole number from 1 to
compare planks --seed -1@--seed: "-1" is no whole number from 0
compare planks --seed 18446744073709551616@--seed: "18446744073709551616" is no
compare planks --structure lazy-compas@lazy-compas not in .lazy-compass,.*; the nearest is "lazy-compass"
render planks --step 1 -o x.png --plugin maybe@maybe not in .on,off.$
render planks --widht=400 -o x.png@render has no option "--widht"; the nearest is "--width"
render planks --step 4 -q -o x.png@render has no option "-q"
render planks --step 1 --width 100 -o x.png@^boomerang-testbed: render: --width: "100" is no whole number from 200 to 10000
render planks --step 1 --width 100 -o x.png@^    --width: Width in pixels
render planks --step 1 -o@render: --output: .*missing
render planks --step 1 --step 2@render: --step: At Most 1 .*received 2
render planks --step 1@render: --output is required
render planks --step 1@^    --output: The picture
events circle@no motion "circle" \(--list
WORDS
    expect 0 compare pyramid --size 3 --steps 1 --no-time --seed 18446744073709551615
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
    out_has 'The commands of boomerang-testbed: list, compare'
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
    for command in $(commands); do out_has "(^|[ ,])$command[,.]"; done
}

test_output_that_cannot_be_written_is_a_failure() {
    local command status
    for command in --help --version 'figures --list' 'events --list' list; do
        status=0
        claim="boomerang-testbed $command >/dev/full"
        # shellcheck disable=SC2086
        "$testbed" $command >/dev/full 2>"$scratch/err" || status=$?
        [ "$status" -eq 3 ] || fail "exit status $status, not 3"
        err_has 'could not be written'
    done
}

# Who reads only a line ends the rest quietly.
test_a_broken_pipe_is_quiet() {
    claim='boomerang-testbed list | head -n 1'
    "$testbed" list 2>"$scratch/err" | head -n 1 >"$scratch/out"
    [ -s "$scratch/out" ] || fail "nothing"
    err_empty
    claim='boomerang-testbed list, nobody reading'
    local status
    { "$testbed" list 2>"$scratch/err"; echo $? >"$scratch/status"; } | true
    status=$(cat "$scratch/status")
    [ "$status" -eq 141 ] || [ "$status" -eq 0 ] || fail "exit status $status"
    err_empty
}

run_tests
