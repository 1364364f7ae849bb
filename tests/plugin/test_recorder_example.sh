#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The example of the recorder takes its coins, is hurt once and lands, with Boomerang and without: test_recorder_example.sh RECORDER
set -uo pipefail
game=${1:?}
for mode in off '' verify; do
    got=$(BOOMERANG=$mode "$game" 2>/dev/null)
    [ "$got" = "score 30, health 85, on the platform" ] || { echo "FAILED: BOOMERANG=$mode: $got"; exit 1; }
done
echo "passed: $got"
