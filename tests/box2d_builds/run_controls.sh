#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   run_controls.sh BUILD PLUGIN CONTROLS
#
# Do the games' comparisons notice? play.sh is given what it must fail on, and must say why: libraries in the plugin's place
# (CONTROLS: where they are) that change a bit or how the game ends, one that is not there, and games that stock does not end well.
set -uo pipefail
build=${1:?} plugin=${2:?} controls=${3:?}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
passed=0 failed=0
export BOX2D_BUILDS_WAYS=preloaded

# notices NAME PATTERN ARGUMENT...: play.sh with these fails and says so
notices() {
    local name=$1 pattern=$2
    shift 2
    if "$here/play.sh" "$build" debian "$@" >"$room/out" 2>&1; then
        echo "FAILED: $name: goes unnoticed"
    elif ! grep -qE "$pattern" "$room/out"; then
        echo "FAILED: $name: noticed, but not for that reason:"
        head -n 5 "$room/out"
    else
        passed=$((passed + 1))
        return
    fi
    failed=$((failed + 1))
}

if "$here/play.sh" "$build" debian "$plugin" only heap draws >"$room/out" 2>&1; then
    passed=$((passed + 1))
else
    failed=$((failed + 1))
    echo "FAILED: the plugin itself does not play what the controls are tried on"
    cat "$room/out"
fi
notices "a unit in the last place of a step" '^FAILED: debian: preloaded: .heap.: exit status 0, .*difference: heap step 9;' \
    "$controls/libother_steps.so" only heap
notices "the same in a random game" "difference: 1 step [0-9]+;" "$controls/libother_steps.so" random 1 1
notices "another ending" 'exit status 3, stock.s is 0' "$controls/libother_ending.so" only heap
notices "a plugin that is not there" 'the plugin was not loaded' "$room/none.so" only heap
notices "a game that does not end well" 'stock Box2D does not survive .none.*game is at fault' "$plugin" only none
notices "no game at all" '0 passed, 0 failed' "$plugin" only
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" -eq 0 ]
