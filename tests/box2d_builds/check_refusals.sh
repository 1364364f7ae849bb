#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   check_refusals.sh BUILD
#
# What boomerang_accelerate cannot do it says in a sentence when a project is configured, each thing in its own: refused/CMakeLists.txt
# has the targets. BUILD: where the shelf was built.
set -uo pipefail
build=${1:?}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
temp=$(mktemp -d)
trap 'rm -rf "$temp"' EXIT
passed=0 failed=0

# refuses CASE SENTENCE
refuses() {
    if cmake -S "$here/refused" -B "$temp/$1" -DCASE="$1" -DBOX2D_SOURCE="$build/source" >"$temp/out" 2>&1; then
        echo "FAILED: $1: not refused"
    elif ! tr -s '\n ' '  ' <"$temp/out" | grep -qF "boomerang_accelerate(box2d): $2"; then # (CMake breaks lines where it likes.)
        echo "FAILED: $1: refused otherwise: $(tr -s '\n ' '  ' <"$temp/out")"
    else
        passed=$((passed + 1))
        return
    fi
    failed=$((failed + 1))
}

other='this is not Box2D 2.4.1 or 2.4.2'
refuses missing 'there is no such target'
refuses imported 'nothing is compiled for this target'
refuses interface 'nothing is compiled for this target'
refuses links 'the target does not compile b2_world.cpp; name the one that does: boomerang_accelerate(sources)'
refuses no_world 'the target does not compile b2_world.cpp'
refuses no_fixture "$other: the target does not compile b2_fixture.cpp"
refuses rope 'this is Box2D 2.4.0'
refuses version3 'this is Box2D 3, which'
refuses other_joint "$other: b2_world.cpp has no \"DestroyJoint(je0\""
refuses other_pairs "$other: b2_contact_manager.cpp has no \"b2ContactManager::FindNewContacts(\""
refuses generator 'b2_world.cpp is listed by a generator expression'
# To the right sources nothing is missing but the language; and what was done once is not done again.
refuses none 'the project needs the language C, too'
refuses below 'the project needs the language C, too'
refuses twice 'it was called for this target before'
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
