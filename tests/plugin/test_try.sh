#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# `boomerang try` on the games of this folder: what it says, and how it ends.
#
#   test_try.sh BOOMERANG DIRECTORY-OF-THE-PROGRAMS
set -uo pipefail
boomerang=${1:?} bin=${2:?}
room=$(mktemp -d)
holds_shows=$room/said
trap 'rm -rf "$room"' EXIT
# shellcheck source=tests/support/holds.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/holds.sh"
unset BOOMERANG BOOMERANG_HOOKS BOOMERANG_STRUCTURE BOOMERANG_PREFILTER BOOMERANG_STATISTICS BOOMERANG_VERBOSE LD_PRELOAD

# tries STATUS ARGUMENT...: it ends with that; what it says, in one line, is in $room/said. (A run ends with its game; the limit is
# for what would never end.)
tries() {
    local status=$1 got
    shift
    "$boomerang" try --quiet --seconds 60 --rounds 1 "$@" >"$room/out" 2>&1
    got=$?
    tr '\n' ' ' <"$room/out" >"$room/said"
    [ "$got" -eq "$status" ]
}
says() { grep -qE -- "$1" "$room/said"; }
number() { sed -nE "s/^ *\"$1\": ([0-9.]+),?\$/\\1/p" "$room/out" | head -n 1; }

holds "a game with a shared Box2D profits or not, and nothing differs" tries 0 -- "$bin/plain_game"
holds "it says where Box2D is" says 'Box2D is a shared library here, /.*/libbox2d\.so'
holds "it says what is at work" says 'ahead of Box2D 2\.4\.1; rounds as Box2D\. All its hooks are at work'
holds "it says what a step takes" says 'A step takes [0-9.]+ [mu]s in stock Box2D and [0-9.]+ [mu]s with Boomerang: .* \([0-9.]+ to [0-9.]+ in rounds of 240 steps\)'
holds "it says what was compared" says 'Under verify [1-9][0-9,]+ answers were compared with Box2D.s: none differs'
holds "it says how to go on, or that it does not pay" says 'LD_PRELOAD=/.*/libboomerang_box2d.* .*/plain_game|does not pay'
holds "through a launcher that goes before its game" tries 0 -- sh -c "$bin/plain_game &"
holds "a number of steps" tries 0 --steps 50 --json -- "$bin/plain_game"
holds "no more steps are compared than were taken" test "$(number steps)" -ge 0
holds "as JSON" python3 - "$room/out" <<'PYTHON'
import json, sys
told = json.load(open(sys.argv[1]))
assert told["outcome"] == "at work" and told["verify"]["verified"] > 0 and told["verify"]["differences"] == 0, told
assert told["off"][0]["steps"] >= 50 and told["on"][0]["steps"] >= 50 and 0 < told["ratio"]["steps"] <= 240, told
PYTHON

holds "Box2D inside the program" tries 3 -- "$bin/vendored_game"
holds "says so, and what to do" says 'has Box2D inside .*/vendored_game, where .*boomerang_accelerate\(TARGET\)'
holds "Box2D inside a module that is closed again" tries 3 -- "$bin/module_host" "$bin/libprivate_module.so"
holds "names the module" says 'has Box2D inside .*/libprivate_module\.so'
holds "Box2D of a module" tries 3 -- "$bin/module_host" "$bin/libsharing_module.so"
box2d=$(sed -nE 's/.*LD_PRELOAD=([^ ]*) boomerang try -- .*/\1/p' "$room/said")
holds "which is in sight where it is preloaded" env LD_PRELOAD="$box2d" "$boomerang" try --quiet --rounds 1 -- "$bin/module_host" \
    "$bin/libsharing_module.so"
holds "another Box2D under that name" tries 3 -- "$bin/strange_game"
holds "is left alone, and says why" says 'leaves this game.s Box2D alone: the Box2D of this process lacks '
holds "no Box2D at all" tries 3 -- "$bin/no_game"
holds "says so, and how it ended" says 'No Box2D was found in this game.*exit status 7.*no game'
printf 'int main(void) { return 0; }\n' >"$room/still.c"
gcc -static "$room/still.c" -o "$room/still"
holds "a static program" tries 3 -- "$room/still"
holds "says so" says 'is linked statically'

holds "a game that crashes by itself" tries 4 -- sh -c 'echo oh no; kill -SEGV $$'
holds "is not ours to mend" says 'does not run well without Boomerang either \(was ended by signal 11.*oh no.*Mend that first'
printf 'int missing(void) { return 0; }\n' | gcc -shared -fPIC -x c - -o "$room/libmissing.so"
printf 'int missing(void); int main(void) { return missing(); }\n' | gcc -x c - -o "$room/lacking" -L"$room" -lmissing
rm "$room/libmissing.so"
holds "a game that lacks a library" tries 4 -- "$room/lacking"
holds "says which" says 'a library is missing .*libmissing\.so'
holds "no such game" tries 2 -- "$room/none"
holds "no game named" tries 2
holds "an unknown option" tries 2 --stepps 3 -- "$bin/plain_game"
holds "is named" says '--stepps'
holds "no such library" tries 2 --library "$room/none.so" -- "$bin/plain_game"

# Controls: a library that crashes is noticed, as is one that changes how a game ends.
printf '#include <stdlib.h>\n__attribute__((constructor)) static void f(void) { abort(); }\n' | gcc -shared -fPIC -x c - -o "$room/libcrash.so"
holds "control: a library that crashes" tries 1 --library "$room/libcrash.so" -- "$bin/plain_game"
holds "control: is named as what it is" says 'ends otherwise with the library: as it is, exit status 0; off, was ended by signal 6'

# Who is interrupted leaves no game behind. (The game tells when it is there.)
mkfifo "$room/there"
"$boomerang" try --quiet --seconds 600 -- sh -c "echo \$\$ >$room/there; exec sleep 600" >"$room/out" 2>&1 &
trier=$!
read -r game <"$room/there"
kill -INT "$trier"
wait "$trier"
holds "interrupted" test $? -eq 130
holds "the game is gone" test ! -e "/proc/$game"
all_hold "boomerang try: "
