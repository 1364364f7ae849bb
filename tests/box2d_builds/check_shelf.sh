#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   check_shelf.sh BUILD LIBBOX2D
#
# Is each Box2D of the shelf what it is said to be? A build that silently is another one would pass every game. Each property is
# looked for in the variant that has it and in one that has not, so that the look itself is shown to tell them apart.
# LIBBOX2D: the installed library.
set -uo pipefail
build=${1:?} installed=${2:?}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
temp=$(mktemp -d)
trap 'rm -rf "$temp"' EXIT
# shellcheck source=tests/kit/holds.sh
source "$(dirname "${BASH_SOURCE[0]}")/../kit/holds.sh"
# shellcheck source=tests/box2d_builds/processor.sh
source "$here/processor.sh"
unset BOOMERANG LD_PRELOAD

# but HAS VARIANT OTHER: HAS is true of VARIANT and not of OTHER
but() { "$1" "$2" && ! "$1" "$3"; }

library() { ls "$build/$1"/libbox2d.so.2 "$build/$1"/libbox2d.a 2>/dev/null; }
exported() { nm -D --defined-only "$1" | awk '{ print $NF }' | LC_ALL=C sort; }
# (grep reads to the end: else the program that writes would get a broken pipe.)
has_assertions() { strings -a "$(library "$1")" | grep -c 'm_world->IsLocked() == false' >/dev/null; }
has_own_allocator() { nm -D --defined-only "$(library "$1")" | grep -c ' box2dBlocks$' >/dev/null; }
has_fused() { objdump -d --no-show-raw-insn "$(library "$1")" | grep -cE '[[:space:]](vfn?m(add|sub)[0-9a-z]*|fn?m(add|sub)) ' >/dev/null; }
is_archive() { [ -e "$build/$1/libbox2d.a" ] && [ ! -e "$build/$1/libbox2d.so.2" ]; }
has_many_files() { [ "$(ar t "$(library "$1")" | wc -l)" -gt 40 ]; }
differs() { [ -s "$1" ] && [ -s "$2" ] && ! cmp -s "$1" "$2"; }
is_hidden() { readelf -sW "$(library "$1")" | grep -c ' HIDDEN .* _ZN7b2World4StepEfii$' >/dev/null; }

# play VARIANT GAME [VARIABLE=VALUE...]: what stock prints
play() {
    processor_for "$1" && "${runner[@]}" "${@:3}" "$build/$1/games_$1" "$2"
}

# debian: it does what the installed library does, and exports what that exports.
play debian 97 >"$temp/debian"
play debian 97 LD_PRELOAD="$installed" >"$temp/installed"
holds "debian: the installed Box2D's bits" cmp -s "$temp/debian" "$temp/installed"
holds "debian: the installed Box2D's symbols" cmp -s <(exported "$(library debian)") <(exported "$installed")
holds "debian: with assertions; ndebug: without" but has_assertions debian ndebug
play units10 97 >"$temp/units10"
holds "units10: other bits than with 1" differs "$temp/units10" "$temp/debian"
holds "static: an archive" but is_archive static debian
variants=(ndebug static)
if [ -e "$build/hidden" ]; then # the rest is there with --long alone
    variants+=(hidden)
    holds "allocator: has one of its own" but has_own_allocator allocator debian
    play allocator 97 >"$temp/allocator" 2>"$temp/allocator.err"
    holds "allocator: stock's bits" cmp -s "$temp/allocator" "$temp/debian"
    holds "allocator: Box2D asks it for memory" grep -qE '^blocks [1-9]' "$temp/allocator.err"
    holds "fma: fuses" but has_fused fma debian
    play fma 97 >"$temp/fma"
    holds "fma: rounds otherwise" differs "$temp/fma" "$temp/debian"
    holds "static: of Box2D's many files; hidden: of one" but has_many_files static hidden
    holds "hidden: nothing is seen" but is_hidden hidden static
fi
for variant in "${variants[@]}"; do
    play "$variant" 97 >"$temp/$variant"
    holds "$variant: Debian's bits" cmp -s "$temp/$variant" "$temp/debian"
done

all_hold
