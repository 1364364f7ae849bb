#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# boomerang::box2d_static in a program: test_wrapped.sh PLAIN-GAME WRAPPED-GAME [TOI]
# With a third argument Box2D itself is inside the program, and times of impact must have been asked for.
set -uo pipefail
plain=${1:?} wrapped=${2:?} static=${3:-}
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
fail() {
    echo "FAILED: $*"
    cat "$room/err"
    exit 1
}
value() { sed -n "s/^ *\"$1\": \"\\{0,1\\}\\([a-z0-9]*\\).*/\\1/p" "$room/json"; }

wanted=$(BOOMERANG='' "$plain") || fail "the plain game does not run"
for mode in '' off on verify; do
    rm -f "$room/json"
    got=$(BOOMERANG=$mode BOOMERANG_STATISTICS=$room/json "$wrapped" 2>"$room/err") || fail "BOOMERANG=$mode: failed"
    [ "$got" = "$wanted" ] || fail "BOOMERANG=$mode: other output than stock's"
    if [ "$mode" = verify ]; then
        [ "$(sed 's/ [0-9,]* answers/ answers/' "$room/err")" = 'boomerang: verified answers, 0 differ' ] || fail "verify: not one line on stderr"
    else
        [ ! -s "$room/err" ] || fail "BOOMERANG=$mode: something on stderr"
    fi
    case $mode in
    '' | off) [ ! -e "$room/json" ] || fail "BOOMERANG=$mode: at work" ;;
    *)
        [ "$(value mode)" = "$mode" ] && [ "$(value steps)" -eq 240 ] && [ "$(value evaluations)" -gt 0 ] ||
            fail "BOOMERANG=$mode: not at work"
        [ "$(value differences)" -eq 0 ] || fail "BOOMERANG=$mode: differences"
        [ -z "$static" ] || [ "$(value toi_queries)" -gt 0 ] || fail "BOOMERANG=$mode: no time of impact came by"
        ;;
    esac
done
echo passed
