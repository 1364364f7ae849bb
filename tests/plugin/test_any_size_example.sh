#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The example of polygons of any size keeps all its bodies, with Boomerang at work and off: test_any_size_example.sh ANY-SIZE
set -uo pipefail
game=${1:?}
fail() {
    echo "FAILED: $*"
    exit 1
}
wanted=$'vertices 256 94 19\nin the bowl 60'
for mode in off '' verify; do
    got=$(BOOMERANG=$mode "$game" 2>&1) || fail "BOOMERANG=$mode: it does not run: $got"
    if [ "$mode" = verify ]; then
        grep -Eq '^boomerang: verified [1-9][0-9,]* answers, 0 differ$' <<<"$got" || fail "verify: it does not end with what was verified: $got"
        got=$(grep -v '^boomerang: verified ' <<<"$got")
    fi
    [ "$got" = "$wanted" ] || fail "BOOMERANG=$mode: $got"
done
echo "passed"
