#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   play.sh BUILD SUFFIX [RUNNER...]
#
# The games of one platform: BUILD/bin/game prints what game_stock prints, without a word in the environment, on, off and under verify;
# it says that Box2D was compiled with the plugin, and every answer that verify compares is Box2D's. The interface can be called. SUFFIX: of programs (.exe);
# RUNNER: what starts them.
set -uo pipefail
build=${1:?} suffix=${2?}
shift 2
runner=("$@")
temp=$(mktemp -d)
holds_shows=$temp/said
trap 'rm -rf "$temp"' EXIT
# shellcheck source=tests/kit/holds.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../kit/holds.sh"
# What goes round for ever ends: many hundred times what a game needs of a processor, however busy the machine is.
ulimit -t 120
unset BOOMERANG BOOMERANG_PAIRS_BY BOOMERANG_COUNTS BOOMERANG_VERBOSE LD_PRELOAD

# (Programs of Windows end their lines with two characters.)
play() {
    local name=$1
    shift
    (cd "$build/bin" && env "$@" "${runner[@]}" "./$name$suffix") 2>"$temp/err" | tr -d '\r' >"$temp/out"
    local status=${PIPESTATUS[0]}
    tr -d '\r' <"$temp/err" >"$temp/said"
    return "$status"
}
same() { play "$@" && cmp -s "$temp/out" "$temp/stock"; }
says() { grep -q "^boomerang: $1" "$temp/said"; }

holds "stock runs" play game_stock
cp "$temp/out" "$temp/stock"
holds "stock prints something" grep -q 'begun [1-9]' "$temp/stock"
holds "the same bits" same game
holds "off" same game BOOMERANG=off
holds "on" same game BOOMERANG=on BOOMERANG_VERBOSE=1
holds "compiled with" says 'on; compiled with Box2D 2\.4\.[12]$'
holds "verify" same game BOOMERANG=verify
holds "verify compares, and nothing differs" says 'verified [1-9][0-9,]* answers, 0 differ$'
holds "the interface" play consume_box2d
# Control: stock says nothing of the kind.
play game_stock BOOMERANG=on BOOMERANG_VERBOSE=1
holds "control: a game without the plugin is noticed" test ! -s "$temp/said"
all_hold "$build: "
