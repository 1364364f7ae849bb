#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   verify_control.sh ROOT COMPILER PLAIN_GAME OBJECTS... -- LINK_ARGUMENTS...
#
# BMR_TRY in the environment: the program `boomerang`, which must see it, too.
#
# The control of BOOMERANG=verify: a plugin whose remembered edges are trusted at a smaller distance than Box2D's is
# preloaded into a plain game. It must say so, once, and the game must go on with Box2D's answers.
set -u
root=$1 compiler=$2 game=$3
shift 3
objects=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    case $1 in */polygon_contact.cpp.o) ;; *) objects+=("$1") ;; esac
    shift
done
shift
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
fail() {
    echo "FAILED: $*"
    cat "$room/err" 2>/dev/null
    exit 1
}

cp -r "$root/box2d_glue" "$room/box2d_glue"
file=$room/box2d_glue/contacts/polygon_contact.cpp
# The distance at which a remembered edge separates.
perl -0pi -e 's/return separation > a\.m_radius \+ b\.m_radius;/return separation > 0.25f * (a.m_radius + b.m_radius);/' "$file"
cmp -s "$file" "$root/box2d_glue/contacts/polygon_contact.cpp" && fail "the substitution finds nothing"
"$compiler" -std=c++17 -O1 -fPIC -fvisibility=hidden -ffp-contract=off -w -DB2_SHARED -I"$root/core/include" -I"$root/core" \
    -I"$root/box2d_glue/include" -I"$room/box2d_glue" -I"$root/plugin" -include "$root/plugin/reach/interposed/weak_box2d.h" -c "$file" \
    -o "$room/widened.o" || fail "does not compile"
"$compiler" -shared -o "$room/libwidened.so" "$room/widened.o" "${objects[@]}" "$@" \
    -Wl,--version-script="$root/plugin/reach/interposed/exports.map" || fail "does not link"

wanted=$("$game") || fail "the game does not run"
got=$(BOOMERANG=verify LD_PRELOAD=$room/libwidened.so "$game" 2>"$room/err") || fail "the game failed"
[ "$got" = "$wanted" ] || fail "verify goes on with an answer that is not Box2D's"
[ "$(grep -c 'first difference from Box2D' "$room/err")" -eq 1 ] || fail "not one line tells of the difference"
grep -Eq 'step [1-9][0-9]*, polygon manifold: pointCount \(0 points here, [12] in Box2D\); fixture .* against fixture ' \
    "$room/err" || fail "the line does not say what differs, where and when"
grep -Eq '^boomerang: verified [1-9][0-9,]* answers, [1-9][0-9,]* differ$' "$room/err" || fail "the last line does not count the differences"
# And without verify the difference is there to be seen: the control is one.
[ "$(BOOMERANG=on LD_PRELOAD=$room/libwidened.so "$game" 2>"$room/err")" != "$wanted" ] || fail "nothing was widened"
if [ -n "${BMR_TRY:-}" ]; then
    "$BMR_TRY" try --quiet --rounds 1 --library "$room/libwidened.so" -- "$game" >"$room/err" 2>&1
    [ $? -eq 1 ] || fail "boomerang try has another exit status than 1"
    tr '\n' ' ' <"$room/err" | grep -qE '[1-9][0-9,]* differ\.' || fail "boomerang try does not say that answers differ"
fi
echo passed
