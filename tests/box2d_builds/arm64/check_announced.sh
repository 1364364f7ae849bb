#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   check_announced.sh BUILD PLUGIN
#
# Does the plugin say that it is at work on the Box2D that is not fused and on both that are accelerated, and that the fused one fuses? A
# plugin that did nothing would play every game as stock does. Do both Box2Ds, and the lanes, differ as they are said to?
set -uo pipefail
build=${1:?} plugin=${2:?}
temp=$(mktemp -d)
trap 'rm -rf "$temp"' EXIT
# shellcheck source=tests/kit/holds.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../kit/holds.sh"
unset BOOMERANG BOOMERANG_PAIRS_BY BOOMERANG_COUNTS BOOMERANG_VERBOSE LD_PRELOAD
# shellcheck source=tests/box2d_builds/processor.sh
source "$(dirname "${BASH_SOURCE[0]}")/../processor.sh"
processor_for fused || exit 1

# says VARIANT LINE [PRELOADED]: its one line begins so (of the accelerated game, where it is said what is preloaded), steps were counted, and edges asked.
says() {
    rm -f "$temp/counts"
    "${runner[@]}" -E "LD_PRELOAD=${3-$plugin}" -E BOOMERANG_VERBOSE=1 -E "BOOMERANG_COUNTS=$temp/counts" \
        "$build/$1/games_$1${3+_accelerated}" 97 >/dev/null 2>"$temp/err"
    grep -q "^boomerang: $2" "$temp/err" && grep -q '^steps [1-9]' "$temp/counts" && grep -q '^edge_checks [1-9]' "$temp/counts"
}
says_not() { ! says "$@"; }
work='on; ahead of Box2D 2.4.1$'
inside='on; compiled with Box2D 2.4.1$'
refuses() { says fused "$work" || grep -q '^boomerang: not at work, .*: this Box2D fuses products' "$temp/err"; }
holds "unfused: at work" says unfused "$work"
holds "fused: refused" refuses
holds "unfused, accelerated: at work" says unfused "$inside" ''
holds "fused, accelerated: at work" says fused "$inside" ''
holds "control: what is said of one is not said of the other" says_not fused "$work"

has_fused() { "${OBJDUMP:-aarch64-linux-gnu-objdump}" -d --no-show-raw-insn "$build/$1/libbox2d.so.2" | grep -cE '[[:space:]]fn?m(add|sub|la|ls)[[:space:]]' >/dev/null; }
has_not_fused() { ! has_fused "$1"; }
holds "fused: fuses" has_fused fused
holds "unfused: does not" has_not_fused unfused
has_lanes() { "${OBJDUMP:-aarch64-linux-gnu-objdump}" -d --no-show-raw-insn "$plugin" | grep -cE "[[:space:]]f$1[[:space:]]+v[0-9]+\\.4s" >/dev/null; }
holds "the plugin is in lanes" has_lanes 'mul|add|sub'
lanes_are_unfused() { ! has_lanes 'ml[as]'; }
holds "and none of them is fused" lanes_are_unfused
all_hold
