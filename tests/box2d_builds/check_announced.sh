#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   check_announced.sh BUILD PLUGIN [ACCELERATED-VARIANT...]
#
# Is the plugin at work on each Box2D of the shelf as far as it is to be, and does it say so? A plugin that did nothing would play every
# game as stock does. The line that BOOMERANG_VERBOSE asks for is held against the table below, and what the library counts
# against the line: what is at work has answered, what is not has not.
set -uo pipefail
build=${1:?} plugin=${2:?}
shift 2
accelerated=("$@")
temp=$(mktemp -d)
trap 'rm -rf "$temp"' EXIT
passed=0 failed=0
unset BOOMERANG BOOMERANG_PAIRS_BY BOOMERANG_COUNTS BOOMERANG_VERBOSE LD_PRELOAD

# shellcheck source=tests/box2d_builds/processor.sh
source "$(dirname "${BASH_SOURCE[0]}")/processor.sh"

all='on; ahead of Box2D 2\.4\.1$'
inside='not at work, .*: .*\(has a Box2D of its own inside (boomerang_accelerate\|If Box2D is compiled into it, use boomerang_accelerate()\)'
unused='not used: this program never called b2World::Step through this library\. If Box2D is compiled into it, use boomerang_accelerate()$'
units='not at work, .*: b2_lengthUnitsPerMeter is 10 here, 1 in the Box2D this was built for$'
fused='not at work, .*: this Box2D fuses products .*$'

fails() {
    failed=$((failed + 1))
    printf 'FAILED: %s\n' "$*"
}

# counted NAME: of what it counted
counted() { sed -n "s/^$1 //p" "$temp/counts"; }

# says VARIANT WAY LINE [COUNT...]: with the plugin in this way, the game's one line is this; these counts are above zero, or, where
# none is named, there are none at all.
says() {
    local variant=$1 way=$2 line=$3 program=$build/$1/games_$1 preload='' name
    shift 3
    if [ "$way" = preloaded ]; then preload=$plugin; else program=${program}_$way; fi
    processor_for "$variant" || return 1
    : >"$temp/counts"
    "${runner[@]}" "${set_variable[@]}" "LD_PRELOAD=$preload" "${set_variable[@]}" BOOMERANG_VERBOSE=1 \
        "${set_variable[@]}" "BOOMERANG_COUNTS=$temp/counts" "$program" 97 >/dev/null 2>"$temp/err"
    sed -i '/^boomerang: [0-9]* steps, /d' "$temp/err" # said at the end
    if ! grep -q "^boomerang: $line" "$temp/err" || [ "$(grep -c '^boomerang: ' "$temp/err")" -ne 1 ]; then
        fails "$variant, $way: says \"$(cat "$temp/err")\", not \"$line\""
        return
    fi
    if [ $# -eq 0 ] && [ -s "$temp/counts" ]; then
        fails "$variant, $way: counts something"
        return
    fi
    # The page says the same of the way as the line.
    if [ $# -gt 0 ] && ! grep -q "; $(counted way)$" "$temp/err"; then
        fails "$variant, $way: the page has another way than \"$(cat "$temp/err")\""
        return
    fi
    for name; do
        if [ "$(counted "$name")" = "" ] || [ "$(counted "$name")" -eq 0 ]; then
            fails "$variant, $way: $name: '$(counted "$name")'"
            return
        fi
    done
    passed=$((passed + 1))
}

# there VARIANT...: those of them that are on the shelf: some are there with --long alone
there() { for variant; do [ ! -e "$build/$variant" ] || echo "$variant"; done; }
for variant in $(there debian ndebug allocator); do
    says "$variant" preloaded "$all" steps evaluations edge_checks touching_answered
    says "$variant" ahead "$all" steps evaluations edge_checks touching_answered
done
for way in preloaded ahead; do
    says units10 "$way" "$units"
    for variant in $(there fma); do says "$variant" "$way" "$fused"; done
done
for variant in $(there static hidden regrouped); do
    says "$variant" preloaded "$unused"
    says "$variant" ahead "$inside"
done
for variant in "${accelerated[@]}"; do
    says "$variant" accelerated 'on; compiled with Box2D 2\.4\.1$' steps evaluations updates touching_answered
done
# Control: what is said of one Box2D is not said of another.
before=$failed
says units10 preloaded "$all" steps >/dev/null
says debian preloaded "$fused" steps >/dev/null
[ "$failed" -eq $((before + 2)) ] && failed=$before || fails "the controls"
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
