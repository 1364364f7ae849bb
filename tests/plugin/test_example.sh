#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The example scores the same with Boomerang and without, and does what its comment says: test_example.sh GAME-LOOP
set -uo pipefail
game=${1:?}
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
fail() {
    echo "FAILED: $*"
    cat "$room/err"
    exit 1
}
wanted=$(BOOMERANG=off "$game" 2>"$room/err") || fail "it does not run"
grep -q 'Boomerang off' "$room/err" || fail "BOOMERANG=off: it is on"
[[ $wanted =~ ^score\ [1-9][0-9]+$ ]] || fail "nobody scores: $wanted"
for mode in '' on verify; do
    rm -f "$room/counts"
    got=$(BOOMERANG=$mode BOOMERANG_COUNTS=$room/counts "$game" 2>"$room/err") || fail "BOOMERANG=$mode: failed"
    [ "$got" = "$wanted" ] || fail "BOOMERANG=$mode: $got, not $wanted"
    grep -q 'Boomerang at work' "$room/err" || fail "BOOMERANG=$mode: it is off"
    grep -q '^differences 0$' "$room/counts" || fail "BOOMERANG=$mode: differences, or nothing was counted"
    grep -q '^toi_answered [1-9]' "$room/counts" || fail "BOOMERANG=$mode: no time of impact was answered"
done
grep -q '^verified [1-9]' "$room/counts" || fail "nothing was verified"
echo "passed: $wanted"
