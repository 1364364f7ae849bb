#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# test_edited.sh GAME: what a game does whose big shapes and outlines are changed in place, with Boomerang off, on and verifying: the
# same, and no difference is found.
set -euo pipefail
game=$1
stock=$(BOOMERANG=off "$game")
[ "$(wc -l <<<"$stock")" -eq 3 ] || { echo "FAILED: the game prints: $stock"; exit 1; }
for mode in on verify; do
    played=$(BOOMERANG=$mode "$game" 2>&1) || { echo "FAILED: BOOMERANG=$mode: $played"; exit 1; }
    played=$(grep -v '^boomerang: verified [1-9][0-9,]* answers, 0 differ$' <<<"$played")
    [ "$played" = "$stock" ] || { echo "FAILED: BOOMERANG=$mode plays otherwise:"; diff <(echo "$stock") <(echo "$played"); exit 1; }
done
echo "passed: $stock"
