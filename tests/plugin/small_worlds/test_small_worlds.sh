#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   test_small_worlds.sh LIBRARY PROGRAM
#
# Every small world's hashes of 600 steps are stock's with the library in front: as it is, counting (which leaves no
# world to Box2D) and switched off. Control: other steps give other hashes, of every world.
set -u
library=$1 program=$2
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
failed=0
fails() {
    echo "FAILED: $*"
    failed=$((failed + 1))
}

"$program" hash 600 >"$room/stock" || fails "stock"
worlds=$(wc -l <"$room/stock")
[ "$worlds" -ge 40 ] || fails "there are $worlds worlds only"
for settings in BOOMERANG=on BOOMERANG_STATISTICS="$room/counts" BOOMERANG=off; do
    env "$settings" LD_PRELOAD="$library" "$program" hash 600 >"$room/plugin" || fails "$settings"
    diff "$room/stock" "$room/plugin" >"$room/others" || fails "$settings: $(head -n 3 "$room/others")"
done
# (The library was at work.)
[ -s "$room/counts" ] || fails "nothing was counted"

"$program" hash 599 >"$room/shorter"
same=$(sort "$room/stock" "$room/shorter" | uniq -d | wc -l)
[ "$same" -eq 0 ] || fails "control: $same worlds have the same hash after 599 steps"

echo "$worlds worlds, $failed failed"
[ "$failed" -eq 0 ]
