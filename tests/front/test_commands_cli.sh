#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# What every command has in common.
#
#   test_commands_cli.sh DIRECTORY-OF-THE-PROGRAMS
set -uo pipefail

# shellcheck source=cli.sh
source "$(dirname "${BASH_SOURCE[0]}")/cli.sh"

commands() { "$testbed" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p'; }
test_every_command_helps_and_refuses() {
    local command
    [ "$(commands | wc -l)" -ge 7 ] || fail "commands are not found in --help"
    says '^boomerang-testbed [0-9]+\.[0-9]+\.[0-9]+$' 0 --version
    for command in $(commands); do
        expect 0 "$command" --help
        err_empty
        expect 2 "$command" --no-such-option
        [ ! -s "$scratch/out" ] || fail "an error on standard output"
        err_has '.'
    done
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
