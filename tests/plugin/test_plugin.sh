#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# libboomerang_box2d.so as a file, and in the programs it may meet.
#
#   test_plugin.sh PLUGIN LIBBOX2D DIRECTORY-OF-THE-PROGRAMS SOURCES-OF-THE-PLUGIN
set -uo pipefail
plugin=${1:?} box2d=${2:?} bin=${3:?} source=${4:?}
temp=$(mktemp -d)
trap 'rm -rf "$temp"' EXIT
failures=0
unset BOOMERANG BOOMERANG_PAIRS_BY BOOMERANG_COUNTS BOOMERANG_VERBOSE LD_PRELOAD

fail() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$1"
    [ ! -s "$temp/err" ] || sed 's/^/    stderr: /' "$temp/err" | tail -n 5
}

# game "PROGRAM [ARGUMENT]..." [VARIABLE=VALUE]...: runs it into $temp/out and $temp/err; what the library counts into
# $temp/counts, where it comes to work.
game() {
    local words
    read -ra words <<<"$1"
    shift
    : >"$temp/counts"
    local status=0
    env BOOMERANG_COUNTS="$temp/counts" "$@" "$bin/${words[0]}" "${words[@]:1}" >"$temp/out" 2>"$temp/err" || status=$?
    grep '^boomerang: [0-9]* steps, ' "$temp/err" >"$temp/last_line"
    sed -i '/^boomerang: [0-9]* steps, /d' "$temp/err"
    return "$status"
}

# plays_as_stock "PROGRAM [ARGUMENT]..." [VARIABLE=VALUE]...: preloaded, and under verify, it prints what it prints without.
plays_as_stock() {
    local played=$1 mode
    shift
    env "$bin"/$played >"$temp/stock_of_it" 2>"$temp/err" || fail "$played: failed without the plugin"
    for mode in on verify; do
        game "$played" LD_PRELOAD="$plugin" BOOMERANG="$mode" "$@" || fail "$played, $mode: exit status $?"
        cmp -s "$temp/out" "$temp/stock_of_it" || fail "$played, $mode: other output than stock's"
        if [ "$mode" = verify ]; then verified "$played"; else quiet "$played, $mode"; fi
        at_work "$played, $mode"
        [ "$(number differences)" -eq 0 ] || fail "$played, $mode: differences"
    done
}

# number NAME: what was counted of it.
number() {
    local found
    found=$(sed -n "s/^$1 //p" "$temp/counts")
    echo "${found:-0}"
}

same_output() { cmp -s "$temp/out" "$temp/stock" || fail "$1: other output than stock's"; }
quiet() { [ ! -s "$temp/err" ] || fail "$1: something on stderr"; }
# verified WHAT: on stderr is what mode verify says when all is well, once for each process that verified, and no more.
verified() {
    grep -q '^boomerang: verified [1-9][0-9,]* answers, 0 differ$' "$temp/err" || fail "$1: it does not say what was verified"
    grep -v '^boomerang: verified [0-9,]* answers, 0 differ$' "$temp/err" && fail "$1: something else on stderr"
}
at_work() { [ "$(number evaluations)" -gt 0 ] || fail "$1: the plugin is not at work"; }
at_rest() { [ ! -s "$temp/counts" ] || fail "$1: the plugin is at work"; }
one_line() {
    [ "$(wc -l <"$temp/err")" -eq 1 ] || fail "$1: not one line on stderr"
    grep -q "$2" "$temp/err" || fail "$1: stderr lacks /$2/"
}

test_exported_symbols_are_hooks_and_the_api() {
    # (Versions have symbols of their own, which are absolute.)
    nm -D --defined-only "$plugin" | awk '$(NF - 1) != "A" { print $NF }' | LC_ALL=C sort >"$temp/versioned"
    sed 's/@.*//' "$temp/versioned" >"$temp/exported"
    { printf '%s\n' _ZN7b2WorldD1Ev _ZN7b2WorldD2Ev; grep -o '_Z[A-Za-z0-9_]*' "$source/../box2d_glue/start/hook_list.h"; } |
        LC_ALL=C sort >"$temp/hooks"
    [ "$(wc -l <"$temp/hooks")" -gt 10 ] || fail "no hooks found"
    grep -v '3bmr\|^bmr_' "$temp/exported" | diff "$temp/hooks" - >"$temp/err" || fail "hooks differ from hook_list.h (< listed, > exported)"
    # They stand in front of functions that Box2D really has.
    nm -D --defined-only "$box2d" | awk '{ print $NF }' | LC_ALL=C sort >"$temp/box2d"
    LC_ALL=C comm -23 "$temp/hooks" "$temp/box2d" | grep . >"$temp/err" && fail "in front of nothing"
    # The API is what its headers declare, and no more.
    grep -h '3bmr' "$temp/exported" | c++filt -p | sed -E 's/^(vtable|typeinfo|typeinfo name) for //; s/^(bmr::[A-Za-z0-9_:~]*).*/\1/' |
        sed -E 's/.*:://; s/^~//' | LC_ALL=C sort -u >"$temp/api"
    [ "$(wc -l <"$temp/api")" -gt 30 ] || fail "no API found"
    while read -r name; do
        grep -rqwF -- "${name#operator}" "$source/include" "$source/../box2d_glue/include" "$source/../box2d_glue/start" "$source/../box2d_glue/debug" ||
            echo "$name"
    done <"$temp/api" >"$temp/err"
    [ ! -s "$temp/err" ] || fail "exported, and in no header"
    # Loaders find them all, linkers none.
    grep -v '3bmr\|^bmr_' "$temp/versioned" | grep -v '[^@]@BOOMERANG_HOOKS$' >"$temp/err" && fail "hooks that a linker would take"
    readelf -VW "$plugin" | grep -q 'Index: 2 .*Name: BOOMERANG_HOOKS$' || fail "hooks that loaders pass over"
}

test_needed_libraries_are_the_least() {
    readelf -d "$plugin" | sed -n 's/.*(NEEDED).*\[\(.*\)\].*/\1/p' | LC_ALL=C sort >"$temp/needed"
    printf '%s\n' libc.so.6 libgcc_s.so.1 libm.so.6 libstdc++.so.6 | diff - "$temp/needed" >"$temp/err" ||
        fail "other libraries are needed"
    readelf -d "$plugin" | grep -q 'SONAME.*\[libboomerang_box2d\.so\.[0-9]*\]' || fail "no versioned soname"
}

test_references_to_box2d_are_weak_and_listed() {
    nm -D --undefined-only "$plugin" | awk '{ sub(/@.*/, "", $NF); print $NF, $(NF - 1) }' | LC_ALL=C sort >"$temp/undefined"
    nm -D --defined-only "$box2d" | awk '{ print $NF }' | LC_ALL=C sort >"$temp/box2d"
    LC_ALL=C join "$temp/undefined" "$temp/box2d" >"$temp/references"
    [ -s "$temp/references" ] || fail "no references found"
    grep ' U$' "$temp/references" >"$temp/err" && fail "strong references to Box2D: add them to weak_box2d.h"
    sed -n 's/^ *\(FUNCTION\|DATA\|SIGN\)(\([A-Za-z0-9_]*\).*/\2/p' "$source/interposed/weak_box2d.h" | LC_ALL=C sort >"$temp/known"
    LC_ALL=C comm -23 "$temp/known" "$temp/box2d" | grep . >"$temp/err" && fail "listed, but Box2D has no such symbol"
}

test_preloaded_is_on_unless_told_off() {
    game plain_game LD_PRELOAD="$plugin"
    same_output preloaded
    quiet preloaded
    at_work preloaded
    [ "$(number steps)" -eq 240 ] || fail "preloaded: not all steps were seen"
    [ "$(number differences)" -eq 0 ] && [ "$(number verified)" -eq 0 ] || fail "preloaded: something was verified"
    local mode
    for mode in off 0; do
        game plain_game LD_PRELOAD="$plugin" BOOMERANG=$mode
        same_output "preloaded, $mode"
        quiet "preloaded, $mode"
        at_rest "preloaded, $mode"
    done
    # Named by a link or another path: by what is loaded, not by the variable alone.
    ln -sf "$plugin" "$temp/other-name.so"
    game plain_game LD_PRELOAD="$temp/other-name.so"
    same_output "preloaded by another name"
    at_work "preloaded by another name"
}

test_linked_without_a_call_is_off_unless_told_on() {
    game linked_game
    same_output linked
    quiet linked
    at_rest linked
    local mode
    for mode in on 1; do
        game linked_game BOOMERANG=$mode
        same_output "linked, $mode"
        at_work "linked, $mode"
    done
    game linked_game LD_PRELOAD="$plugin"
    same_output "linked and preloaded"
    at_work "linked and preloaded"
}

test_linked_with_a_call_is_on_unless_told_off() {
    local mode
    for mode in '' on verify off; do
        game calling_game BOOMERANG=$mode
        same_output "calling, '$mode'"
        if [ "$mode" = off ]; then at_rest "calling, off"; else at_work "calling, '$mode'"; fi
        if [ "$mode" = verify ]; then verified calling; else quiet "calling, '$mode'"; fi
    done
    game calling_game
    [ "$(number toi_answered)" -gt 0 ] || fail "calling: no time of impact was answered"
}

test_linked_behind_box2d_is_refused() {
    local mode
    for mode in on verify; do
        game late_game BOOMERANG=$mode
        same_output "late, $mode"
        one_line "late, $mode" 'not at work, Box2D runs as it is: /.*/libbox2d\.so.* is ahead of it\. Link boomerang::box2d ahead of Box2D$'
        at_rest "late, $mode"
    done
    game late_game
    same_output "late, nothing said"
    quiet "late, nothing said"
    at_rest "late, nothing said"
}

test_verify_compares_and_finds_nothing() {
    game plain_game LD_PRELOAD="$plugin" BOOMERANG=verify
    same_output verify
    local said
    said=$(sed -n 's/^boomerang: verified \([0-9]*\) answers, 0 differ$/\1/p' "$temp/err")
    one_line verify 'boomerang: verified [1-9][0-9]* answers, 0 differ$'
    [ "$said" = "$(number verified)" ] || fail "verify: says $said, counted $(number verified)"
    [ "$(number verified)" -gt 10000 ] || fail "verify: next to nothing was compared"
    [ "$(number differences)" -eq 0 ] || fail "verify: differences"
    # Also where there was nothing to compare; and not where Boomerang never came to work.
    game linked_game BOOMERANG=verify
    verified "linked, verify"
    game no_game LD_PRELOAD="$plugin" BOOMERANG=verify
    quiet "no game, verify"
}

test_what_is_announced_is_what_is_reached() {
    game plain_game LD_PRELOAD="$plugin" BOOMERANG_VERBOSE=1
    same_output "announced"
    one_line "announced" '^boomerang: on; ahead of Box2D 2\.4\.1$'
    [ "$(number steps)" -eq 240 ] || fail "in front: the step that finds out was counted"
    # Another library takes one of the functions: all is Box2D's.
    game plain_game LD_PRELOAD="$bin/libunheard_pairs.so:$plugin"
    same_output "one function is not reached"
    one_line "one function is not reached" "not at work, .*: Box2D does not call Boomerang's b2ContactManager::FindNewContacts\. Link boomerang::box2d ahead of it, or "
    at_rest "one function is not reached"
    game plain_game LD_PRELOAD="$plugin" BOOMERANG_PAIRS_BY=lazy-dudley
    same_output "another structure"
    [ "$(number edge_checks)" -eq 0 ] && [ "$(number hull_checks)" -gt 0 ] || fail "another structure"
}

# last_line WHAT PATTERN: what is said when the process ends.
last_line() {
    [ "$(wc -l <"$temp/last_line")" -eq 1 ] && grep -qE "$2" "$temp/last_line" || fail "$1: at the end it says: $(cat "$temp/last_line")"
}

test_the_last_line_says_what_steps_took() {
    local steps='^boomerang: 240 steps, [0-9]+\.[0-9][0-9] us each$'
    game plain_game LD_PRELOAD="$plugin" BOOMERANG_VERBOSE=1
    last_line "on" "$steps"
    game plain_game LD_PRELOAD="$plugin" BOOMERANG_VERBOSE=1 BOOMERANG=off
    last_line "off" "$steps"
    quiet "off, verbose"
    game plain_game LD_PRELOAD="$plugin" BOOMERANG_VERBOSE=1 BOOMERANG_STEPS=100
    last_line "of the first steps" "${steps/240/100}"
    game plain_game LD_PRELOAD="$plugin"
    [ ! -s "$temp/last_line" ] || fail "not asked, and said all the same"
    # A game that is ended from outside says it, too.
    (LD_PRELOAD="$plugin" BOOMERANG_VERBOSE=1 BOOMERANG=off exec "$bin/odd_game" endless 2>"$temp/last_line" >"$temp/ready") &
    local game=$! status=0
    while ! [ -s "$temp/ready" ]; do sleep 0.05; done
    kill -TERM "$game"
    wait "$game" || status=$?
    [ "$status" -eq 143 ] || fail "ended by SIGTERM: exit status $status"
    last_line "ended by SIGTERM" '^boomerang: [1-9][0-9]* steps, [0-9.]+ us each$'
}

test_values_that_are_not_understood_get_one_line() {
    game plain_game LD_PRELOAD="$plugin" BOOMERANG=perhaps
    one_line "BOOMERANG=perhaps" 'BOOMERANG=perhaps is not understood.*on, off, verify'
    same_output "BOOMERANG=perhaps"
    at_work "BOOMERANG=perhaps"
    game linked_game BOOMERANG=perhaps
    one_line "linked, BOOMERANG=perhaps" 'not understood'
    game no_game LD_PRELOAD="$plugin" BOOMERANG=perhaps
    quiet "no game, BOOMERANG=perhaps"
    game plain_game LD_PRELOAD="$plugin" BOOMERANG_PAIRS_BY=magic
    one_line "a structure of no name" 'known: .*boomerang/pair.h'
    game plain_game LD_PRELOAD="$plugin" BOOMERANG_VERBOSE=very
    one_line "another verbosity" 'known: 0, 1'
}

# What does not work as it is put together says what to write.
test_wrong_set_ups_get_one_line() {
    game linked_game BOOMERANG_VERBOSE=1
    same_output "Install forgotten"
    one_line "Install forgotten" 'not used: nothing called bmr::Install()\. Call it before the first step, or set BOOMERANG=on$'
    game "no_game" LD_PRELOAD="$plugin:$box2d" BOOMERANG_VERBOSE=1
    one_line "no step" 'not used: this program never called b2World::Step$'
    game plain_game LD_PRELOAD="$box2d:$plugin" BOOMERANG_VERBOSE=1
    same_output "preloaded behind Box2D"
    one_line "preloaded behind Box2D" "not used: $box2d is ahead of it\. Name it first: LD_PRELOAD=\"$plugin $box2d\"\$"
}

test_another_box2d_is_left_alone() {
    local status=0
    LD_LIBRARY_PATH=$bin/strange "$bin/strange_game" >"$temp/strange" || fail "the strange game does not run"
    game strange_game LD_PRELOAD="$plugin" LD_LIBRARY_PATH="$bin/strange" || status=$?
    [ "$status" -eq 0 ] || fail "a Box2D without symbols: exit status $status"
    cmp -s "$temp/out" "$temp/strange" || fail "a Box2D without symbols: other output"
    one_line "a Box2D without symbols" 'not at work, Box2D runs as it is: the Box2D of this process lacks _Z'
    at_rest "a Box2D without symbols"
    game plain_game LD_PRELOAD="$plugin:$bin/libother_sizes.so"
    same_output "a Box2D of other sizes"
    one_line "a Box2D of other sizes" 'has another size of _ZN9b2Contact11s_registersE'
    at_rest "a Box2D of other sizes"
}

test_memory_may_be_the_programs_own() { plays_as_stock own_memory_game; }

test_programs_without_box2d_run_as_ever() {
    local status=0
    game no_game LD_PRELOAD="$plugin" BOOMERANG=on || status=$?
    [ "$status" -eq 7 ] && [ "$(cat "$temp/out")" = "no game" ] || fail "no game: changed"
    quiet "no game"
    game vendored_game LD_PRELOAD="$plugin" || fail "Box2D inside the program: failed"
    quiet "Box2D inside the program"
    at_rest "Box2D inside the program"
    game vendored_game LD_PRELOAD="$plugin" BOOMERANG_VERBOSE=1
    one_line "Box2D inside the program, verbose" 'not used: .* never called b2World::Step through this library\. If .*, use boomerang_accelerate()$'
    LD_PRELOAD=$plugin /bin/ls / >"$temp/out" 2>"$temp/err" || fail "ls failed"
    quiet ls
}

test_programs_keep_the_box2d_inside_them() {
    local game setting
    "$bin/vendored_game" >"$temp/strange" || fail "the game with a Box2D inside does not run"
    for game in inside_game_{bfd,gold,lld}; do
        [ -e "$bin/$game" ] || continue
        for setting in '' on verify; do
            game "$game" BOOMERANG="$setting" || fail "$game, '$setting': exit status $?"
            cmp -s "$temp/out" "$temp/strange" || fail "$game, '$setting': other output"
            quiet "$game, '$setting'"
            at_rest "$game, '$setting'"
        done
    done
    game inside_game || fail "its own Box2D inside, the system's besides: at work"
    one_line "its own Box2D inside, the system's besides" 'not at work, .* of its own inside (boomerang_accelerate '
}

test_no_box2d_need_be_there() {
    local status=0
    mkdir -p "$temp/broken"
    : >"$temp/broken/libbox2d.so.2" # whoever asks for it does not start
    game plain_game LD_LIBRARY_PATH="$temp/broken" && fail "control: a game runs with a libbox2d that is none"
    game no_game LD_PRELOAD="$plugin" LD_LIBRARY_PATH="$temp/broken" BOOMERANG=on || status=$?
    [ "$status" -eq 7 ] && [ "$(cat "$temp/out")" = "no game" ] || fail "no game, no libbox2d: changed"
    quiet "no game, no libbox2d"
}

# played MODULE WHAT [VARIABLE=VALUE]...: the host of a module prints what it prints without the library.
played() {
    local module=$bin/$1.so what=$2
    shift 2
    "$bin/host" "$module" >"$temp/stock_of_it" || fail "$what: failed without the plugin"
    game "host $module" "$@" || fail "$what: exit status $?"
    cmp -s "$temp/out" "$temp/stock_of_it" || fail "$what: other output"
}

test_modules_keep_their_own_box2d() {
    local module setting
    for module in libprivate_2 libsharing_2; do
        for setting in '' off on verify; do
            played "$module" "$module, '$setting'" LD_PRELOAD="$plugin" BOOMERANG="$setting"
            quiet "$module, '$setting'"
            at_rest "$module, '$setting'"
        done
        played "$module" "$module, verbose" LD_PRELOAD="$plugin" BOOMERANG_VERBOSE=1
        one_line "$module, verbose" "not used: .* a module's own .*\(boomerang_accelerate()\|LD_PRELOAD=\"$plugin /.*/libbox2d.*\"\)\$"
    done
    game "host $bin/libsharing_2.so global" LD_PRELOAD="$plugin"
    one_line "a module's Box2D for all to see" "was loaded after this library\. Name both: LD_PRELOAD=\"$plugin /.*/libbox2d.*\"\$"
    # Named with the library, the one that the module would bring is in search order.
    for setting in '' verify; do
        played libsharing_2 "both preloaded, '$setting'" LD_PRELOAD="$plugin:$box2d" BOOMERANG="$setting"
        if [ "$setting" = verify ]; then verified "both preloaded"; else quiet "both preloaded"; fi
        at_work "both preloaded, '$setting'"
    done
    # Control, and the limit: where there are two, calls by name all go to the one that is in search order.
    game "host $bin/libprivate_2.so" LD_PRELOAD="$plugin:$box2d" BOOMERANG=off
    grep -q 'steps 10' "$temp/out" && fail "control: another Box2D in front changes nothing"
}

# A host closes a game and opens the next version of its file: the library keeps none of them.
test_games_are_opened_again() {
    local kind setting
    for kind in private sharing; do
        local versions=("$bin/lib${kind}_1.so" "$bin/lib${kind}_2.so" "$bin/lib${kind}_3.so")
        "$bin/host" as "$temp/game.so" "${versions[@]}" >"$temp/stock_of_it" || fail "$kind: failed without the plugin"
        [ "$(sort -u "$temp/stock_of_it" | wc -l)" -eq 3 ] || fail "$kind: control: not three versions"
        for setting in '' off on verify; do
            game "host as $temp/game.so ${versions[*]}" LD_PRELOAD="$plugin" BOOMERANG="$setting" ||
                fail "$kind, '$setting': exit status $?"
            cmp -s "$temp/out" "$temp/stock_of_it" || fail "$kind, '$setting': other versions were played"
            quiet "$kind, '$setting'"
        done
    done
    # Opened for all to see.
    game "host $bin/libsharing_1.so global" LD_PRELOAD="$plugin" BOOMERANG=off || fail "for all to see: exit status $?"
}

test_worlds_are_stepped_to_the_very_end() {
    plays_as_stock "odd_game ending" MALLOC_PERTURB_=165
    command -v valgrind >/dev/null || return 0
    LD_PRELOAD=$plugin valgrind -q --error-exitcode=9 "$bin/odd_game" ending >"$temp/out" 2>"$temp/err" ||
        fail "odd_game ending: valgrind has something to say"
    cmp -s "$temp/out" "$temp/stock_of_it" || fail "odd_game ending: other output under valgrind"
}

test_forked_games_play_on() {
    plays_as_stock "odd_game forking 30 40"
    [ "$(number steps)" -eq 70 ] || fail "the counts are not the parent's"
    game "odd_game forking 30 40 abruptly" LD_PRELOAD="$plugin"
    at_rest "the counts of a child whose parent says nothing"
    # Forked before the first step: who steps starts.
    plays_as_stock "odd_game forking 0 40"
    game "odd_game forking 30 40" LD_PRELOAD="$plugin" BOOMERANG_VERBOSE=1
    one_line "forked, verbose" 'boomerang: on'
    game "odd_game forking 30 40" LD_PRELOAD="$plugin" BOOMERANG=verify
    verified "forked, verify"
    [ "$(wc -l <"$temp/err")" -eq 1 ] || fail "forked, verify: not the parent's line alone"
}

test_the_library_is_refused_where_it_is_opened_in_the_middle() {
    local mode
    "$bin/odd_game" opening >"$temp/stock_of_it" || fail "odd_game opening does not run"
    for mode in on verify; do
        game "odd_game opening $plugin" BOOMERANG="$mode" || fail "opened, $mode: failed"
        cmp -s "$temp/out" "$temp/stock_of_it" || fail "opened, $mode: other output than stock's"
        one_line "opened, $mode" 'not at work, .*libbox2d\.so.* is ahead of it\. '
        at_rest "opened, $mode"
    done
}

"$bin/plain_game" >"$temp/stock" || { echo "plain_game does not run"; exit 1; }
for test in $(declare -F | awk '$3 ~ /^test_/ { print $3 }'); do
    before=$failures
    "$test"
    if [ "$failures" -eq "$before" ]; then echo "passed: $test"; else echo "FAILED: $test"; fi
done
[ "$failures" -eq 0 ] || { echo "$failures claim(s) failed"; exit 1; }
