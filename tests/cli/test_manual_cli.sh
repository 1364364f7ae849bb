#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The manual page and the completions, which the program writes itself; and what every command has in common.
#
#   test_manual_cli.sh DIRECTORY-OF-THE-PROGRAMS
set -uo pipefail

# shellcheck source=support/cli.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/cli.sh"

commands() { "$testbed" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p'; }
# options COMMAND: the long ones of its --help.
options() { "$testbed" "$1" --help | grep -Eo -- '^  (-[a-z],)?--[a-z0-9-]+' | grep -o -- '--.*'; }

test_the_manual_has_every_option_of_help() {
    local command option
    expect 0 man
    clean
    cp "$scratch/out" "$scratch/page.1"
    [ "$(commands | wc -l)" -ge 9 ] || fail "commands are not found in --help"
    for command in $(commands); do
        # In the page a hyphen of a name is written \-.
        awk -v title=".SS ${command//-/\\\\-}" '/^\.S[SH]/ {on = 0} $0 == title {on = 1} on' "$scratch/page.1" >"$scratch/section"
        [ -s "$scratch/section" ] || fail "no section for $command"
        for option in $(options "$command"); do
            grep -Fq -- "\\fB${option//-/\\-}\\fR" "$scratch/section" || fail "$command lacks $option"
        done
    done
}

test_the_manual_is_well_formed() {
    expect 0 man -o "$scratch/page.1"
    if command -v mandoc >/dev/null; then
        if mandoc -T lint -W warning "$scratch/page.1" | grep -v 'missing date'; then fail "mandoc warns"; fi
    fi
    if command -v groff >/dev/null; then
        [ -z "$(groff -man -Tutf8 -ww "$scratch/page.1" 2>&1 >/dev/null)" ] || fail "groff warns"
        groff -man -Tutf8 -P-cbou "$scratch/page.1" 2>/dev/null | grep -q '^EXIT STATUS' || fail "no such heading"
    fi
}

# complete WORD…: what bash would offer for the last word, one a line.
complete_words() {
    bash -c 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _boomerang_testbed
        printf "%s\n" "${COMPREPLY[@]}"' bash "$scratch/completion" boomerang-testbed "$@" >"$scratch/out"
    claim="completion of: $*"
}

test_bash_completes_commands_options_and_scenes() {
    expect 0 completion bash -o "$scratch/completion"
    bash -n "$scratch/completion" || fail "no bash"
    complete_words ''
    [ "$(sort "$scratch/out")" = "$(commands | sort)" ] || fail "not the commands"
    complete_words co
    [ "$(sort "$scratch/out" | tr '\n' ' ')" = 'compare completion ' ] || fail "not what begins with co"
    local command
    for command in $(commands); do
        complete_words "$command" --
        [ "$(sort "$scratch/out")" = "$(options "$command" | sort)" ] || fail "not its options"
    done
    complete_words compare ''
    [ "$(sort "$scratch/out")" = "$("$testbed" list | grep -Eo '^  [a-z-]+' | tr -d ' ' | sort)" ] ||
        fail "not the scenes"
    complete_words --workers "$bin" compare ne
    [ "$(cat "$scratch/out")" = needles ] || fail "not the scene"
    complete_words compare --structure lazy-c
    [ "$(cat "$scratch/out")" = lazy-compass ] || fail "not the value"
    complete_words events or
    [ "$(cat "$scratch/out")" = orbit ] || fail "not the motion"
    touch "$scratch/a file"
    complete_words compare --json "$scratch/a"
    [ "$(cat "$scratch/out")" = "$scratch/a file" ] || fail "not the file"
}

# The control: what is not there is not offered.
test_bash_completes_nothing_else() {
    complete_words compare nosuch
    [ -z "$(cat "$scratch/out")" ] || fail "something"
    complete_words list --hash
    [ -z "$(cat "$scratch/out")" ] || fail "an option of another command"
    complete_words compare --steps ''
    [ -z "$(cat "$scratch/out")" ] || fail "words for a number"
}

test_zsh_and_fish_read_their_completions() {
    local shell
    for shell in zsh fish; do
        expect 0 completion "$shell" -o "$scratch/completion.$shell"
        grep -q needles "$scratch/completion.$shell" || fail "no scenes"
        if command -v "$shell" >/dev/null; then
            "$shell" -n "$scratch/completion.$shell" 2>"$scratch/err" || fail "$shell does not read it"
        fi
    done
    if command -v fish >/dev/null; then
        fish -c "source '$scratch/completion.fish'; complete -C 'boomerang-testbed run need'" >"$scratch/out"
        [ "$(cat "$scratch/out")" = needles ] || fail "fish does not complete the scene"
    fi
    expect 2 completion tcsh
    expect 2 completion
}

test_every_command_helps_and_refuses() {
    local command
    expect 0 --version
    out_has '^boomerang-testbed [0-9]+\.[0-9]+\.[0-9]+$'
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
    for command in --help --version 'figures --list' 'events --list' list man 'completion bash'; do
        status=0
        claim="boomerang-testbed $command >/dev/full"
        # shellcheck disable=SC2086
        "$testbed" $command >/dev/full 2>"$scratch/err" || status=$?
        [ "$status" -eq 3 ] || fail "exit status $status, not 3"
        err_has 'could not be written'
    done
}

# Whoever reads only a line ends the rest quietly.
test_a_broken_pipe_is_quiet() {
    claim='boomerang-testbed man | head -n 1'
    "$testbed" man 2>"$scratch/err" | head -n 1 >"$scratch/out"
    [ -s "$scratch/out" ] || fail "nothing"
    err_empty
    claim='boomerang-testbed completion bash, nobody reading'
    local status
    { "$testbed" completion bash 2>"$scratch/err"; echo $? >"$scratch/status"; } | true
    status=$(cat "$scratch/status")
    [ "$status" -eq 141 ] || [ "$status" -eq 0 ] || fail "exit status $status"
    err_empty
}

run_tests
