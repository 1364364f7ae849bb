#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   verify_control.sh ROOT COMPILER PLAIN_GAME OBJECTS... -- LINK_ARGUMENTS...
#
# BMR_TRY in the environment: the program `boomerang`, which must see it, too.
#
# The controls of BOOMERANG=verify: a plugin whose remembered edges are trusted at a smaller distance than Box2D's is
# preloaded into a plain game, and one whose loop over contacts, in the midst of another one, renews budgets of shapes that were
# changed, into a game that has such loops. Each must say so, once, and the game must go on with Box2D's answers.
set -u
root=$1 compiler=$2 plain=$3
shift 3
objects=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    objects+=("$1")
    shift
done
shift
link=("$@")
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
fail() {
    echo "FAILED: $*"
    cat "$room/err" 2>/dev/null
    exit 1
}
flags="-std=c++17 -O1 -fPIC -fvisibility=hidden -ftls-model=initial-exec -ffp-contract=off -w -DB2_SHARED"
# shellcheck source=tests/kit/mutant_library.sh
source "$root/tests/kit/mutant_library.sh"

# control NAME FILE SUBSTITUTION SAYS GAME...
control() {
    local name=$1 file=$2 substitution=$3 says=$4 wanted got
    shift 4
    mutate "$room/$name" "$file" "$file" "$substitution" >"$room/err" 2>&1 || fail "$name: does not build"
    wanted=$("$@") || fail "$name: the game does not run"
    got=$(BOOMERANG=verify LD_PRELOAD=$room/$name/libmutant.so "$@" 2>"$room/err") || fail "$name: the game failed"
    [ "$got" = "$wanted" ] || fail "$name: verify goes on with an answer that is not Box2D's"
    [ "$(grep -c 'first difference from Box2D' "$room/err")" -eq 1 ] || fail "$name: not one line tells of the difference"
    grep -Eq "step [1-9][0-9]*, $says; fixture .* against fixture " "$room/err" || fail "$name: the line does not say what differs, where and when"
    grep -Eq '^boomerang: verified [1-9][0-9,]* answers, [1-9][0-9,]* differ$' "$room/err" || fail "$name: the last line does not count the differences"
    # And without verify the difference is there to be seen: the control is one.
    [ "$(BOOMERANG=on LD_PRELOAD=$room/$name/libmutant.so "$@" 2>"$room/err")" != "$wanted" ] || fail "$name: nothing is wrong"
}

# The distance at which a remembered edge separates.
control widened box2d_glue/contacts/polygon_contact.cpp \
    's/return separation > a\.m_radius \+ b\.m_radius;/return separation > 0.25f * (a.m_radius + b.m_radius);/' \
    'polygon manifold: pointCount \(0 points here, [12] in Box2D\)' "$plain"
control renewed box2d_glue/ledger/ledger.cpp 's/if \(m_passes > 1\)/if (false)/' 'budget: the contact begins or ends to touch, or is gone' \
    "$(dirname "$plain")/losing_game" resumed
if [ -n "${BMR_TRY:-}" ]; then
    "$BMR_TRY" try --quiet --rounds 1 --library "$room/widened/libmutant.so" -- "$plain" >"$room/err" 2>&1
    [ $? -eq 1 ] || fail "boomerang try has another exit status than 1"
    tr '\n' ' ' <"$room/err" | grep -qE '[1-9][0-9,]* differ\.' || fail "boomerang try does not say that answers differ"
fi
echo passed
