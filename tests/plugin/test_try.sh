#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# `boomerang try` on the games of this folder: what it says, and how it ends.
#
#   test_try.sh BOOMERANG DIRECTORY-OF-THE-PROGRAMS
set -uo pipefail
boomerang=$(realpath "${1:?}") bin=${2:?}
temp=$(mktemp -d)
holds_shows=$temp/said
trap 'rm -rf "$temp"' EXIT
# shellcheck source=tests/kit/holds.sh
source "$(dirname "${BASH_SOURCE[0]}")/../kit/holds.sh"
unset BOOMERANG BOOMERANG_PAIRS_BY BOOMERANG_COUNTS BOOMERANG_VERBOSE LD_PRELOAD

# tries STATUS ARGUMENT...: it ends with that; what it says, in one line, is in $temp/said. (A run ends with its game; the limit is
# for what would never end.)
rounds=1
tries() {
    local status=$1 got
    shift
    "$boomerang" try --quiet --seconds 60 --rounds "$rounds" "$@" >"$temp/out" 2>&1
    got=$?
    tr '\n' ' ' <"$temp/out" >"$temp/said"
    [ "$got" -eq "$status" ]
}
says() { grep -qE -- "$1" "$temp/said"; }
misses() { ! says "$1"; }

holds "a game with a shared Box2D profits or not, and nothing differs" tries 0 -- "$bin/plain_game"
holds "it says where Box2D is" says 'Box2D is a shared library here, /.*/libbox2d\.so'
holds "it says what is at work" says 'ahead of Box2D 2\.4\.1\. A step'
holds "it says what a step takes" says 'A step takes [0-9.]+ [mu]s in stock Box2D and [0-9.]+ [mu]s with Boomerang: .* \(one round of 240 steps\)'
holds "it says what was compared" says 'Under verify [1-9][0-9,]+ answers were compared with Box2D.s: none differs'
holds "it says how to go on, or why not to" says 'LD_PRELOAD=/.*/libboomerang_box2d.* .*/plain_game|does not pay|will not be noticed'
rounds=2
holds "in two rounds" tries 0 -- "$bin/plain_game"
rounds=1
holds "it says how far apart they are" says '(\([0-9.]+ to [0-9.]+|too noisy to tell, between .* faster) in rounds of 240 steps'
holds "it gives numbers that a reader reads" says 'steps are ([1-9][0-9]?|100|[0-9]\.[0-9]+) % of the time'
holds "through a launcher that goes before its game" tries 0 -- sh -c "$bin/plain_game &"
holds "no --, and options of the game's own" tries 0 "$bin/plain_game" --seconds 7 -- --quiet
holds "a game that goes on for ever is ended" tries 0 --seconds 2 -- "$bin/odd_game" endless
holds "it says what it took" says 'A step takes .* In stock, steps are ([1-9](\.[0-9])?|[1-9][0-9]|100) % of the time'
counts_runs() { "$boomerang" try --rounds 3 -- "$bin/plain_game" 2>"$temp/said" >/dev/null; }
holds "with progress" counts_runs
holds "which counts all runs" says 'run 8 of 8: verify'

# Games that have Boomerang as they are.
holds "a game that calls bmr::Install" tries 0 -- "$bin/calling_game"
holds "says so, and no LD_PRELOAD" says 'is linked with Boomerang already \(/.*libboomerang_box2d.*BOOMERANG=off in its environment turns'
holds "nothing is to be preloaded" misses LD_PRELOAD
cp "$bin/linked_game" "$temp/linked game"
g++ -fsanitize=address "$bin/CMakeFiles/plain_game.dir/plain_game.cpp.o" -o "$temp/sanitized" -lbox2d
holds "a game with the address sanitizer of gcc" tries 0 -- "$temp/sanitized"
holds "says which line works" says 'LD_PRELOAD=/[^ ]*libasan\.so[^ ]*:/[^ ]*libboomerang_box2d[^ ]* .*/sanitized|does not pay|will not be noticed'
# (What a game loads is sampled while it runs: it has to run for some samples.)
holds "a game that starts without LD_PRELOAD" tries 3 --seconds 1 -- env -u LD_PRELOAD "$bin/odd_game" endless
holds "took no step that was seen, and why" says 'took no step that Boomerang saw.*RTLD_DEEPBIND.*takes LD_PRELOAD out of the environment'
holds "a game that is linked with the library, and never calls it" tries 0 -- "$temp/linked game"
holds "says so, and a line that a shell takes" says "nothing in it calls bmr::Install.*(BOOMERANG=on /.*/linked\\\\ game|would not pay)"
holds "one that is linked behind Box2D" tries 3 "$bin/late_game"
holds "is looked at as it was built" says 'is linked with Boomerang already, but .*/libbox2d.*Link boomerang::box2d ahead of Box2D\.'
preloaded() { LD_PRELOAD=${boomerang%/bin/*}/lib/libboomerang_box2d.so tries "$@"; }
holds "the library is preloaded already" preloaded 0 -- "$bin/plain_game"
holds "says so" says 'is preloaded already \(LD_PRELOAD\), ahead of Box2D 2'

holds "Box2D inside the program" tries 3 -- "$bin/vendored_game"
holds "says so, and what to do" says 'has Box2D inside .*/vendored_game, where .*boomerang_accelerate\(TARGET\)'
holds "Box2D inside a module that is closed again" tries 3 -- "$bin/host" "$bin/libprivate_2.so"
holds "names the module" says 'inside a module.s own file \(dlopen\), .*/libprivate_2\.so.*boomerang_accelerate\(\)'
holds "Box2D of a module" tries 3 -- "$bin/host" "$bin/libsharing_2.so"
box2d=$(sed -nE 's/.*LD_PRELOAD=([^ ]*) boomerang try .*/\1/p' "$temp/said")
holds "how to play it" says "LD_PRELOAD=/.*/libboomerang_box2d[^ ]*:$box2d .*/host "
holds "which is in sight where it is preloaded" env LD_PRELOAD="$box2d" "$boomerang" try --quiet --rounds 1 -- "$bin/host" \
    "$bin/libsharing_2.so"
holds "Box2D of a module, for all to see" tries 3 "$bin/host" "$bin/libsharing_2.so" global
holds "was there too late, and both are named" says "was loaded after this library\. .*LD_PRELOAD=/.*/libboomerang_box2d[^ ]*:/.*/libbox2d[^ ]* .*/host "
holds "another Box2D under that name" tries 3 -- "$bin/strange_game"
holds "is left alone, and says why" says 'leaves this game.s Box2D alone: the Box2D of this process lacks '
holds "no Box2D at all" tries 3 -- "$bin/no_game"
holds "says so, and how it ended" says 'No Box2D was found in this game.*exit status 7.*no game'
printf 'int main(void) { return 0; }\n' >"$temp/still.c"
gcc -static "$temp/still.c" -o "$temp/still"
if [ "$(uname -m)" = x86_64 ]; then
    # It exits by itself, so that no library for 32 bits need be here.
    printf '.globl _start\n_start: mov $1, %%eax\nxor %%ebx, %%ebx\nint $0x80\n' >"$temp/narrow.s"
    gcc -m32 -nostdlib -static "$temp/narrow.s" -o "$temp/narrow"
    holds "a program for 32 bits" tries 3 -- "$temp/narrow"
    holds "is named as such" says 'narrow is a program for 32 bits, and this Boomerang is built for 64'
fi
holds "a static program" tries 3 -- "$temp/still"
holds "says so" says 'is linked statically'

holds "a game that crashes by itself" tries 4 -- sh -c 'echo oh no; kill -SEGV $$'
holds "is not ours to mend" says 'does not run well without Boomerang either \(was ended by signal 11.*oh no.*Mend that first'
printf 'int missing(void) { return 0; }\n' | gcc -shared -fPIC -x c - -o "$temp/libmissing.so"
printf 'int missing(void); int main(void) { return missing(); }\n' | gcc -x c - -o "$temp/lacking" -L"$temp" -lmissing
rm "$temp/libmissing.so"
holds "a game that lacks a library" tries 4 -- "$temp/lacking"
holds "says which" says 'a library is missing .*libmissing\.so'
holds "no such game" tries 2 -- "$temp/none"
holds "says why" says 'cannot start .*/none: No such file or directory'
holds "a folder" tries 2 -- "$temp"
holds "is no game" says 'it is a folder'
holds "a file that may not be executed" tries 2 -- "$temp/still.c"
holds "is called that" says 'it may not be executed'
cp "$bin/plain_game" "$temp/here"
starts_here() { (cd "$temp" && tries 2 -- here); }
holds "a name without a path" starts_here
holds "is looked for in PATH, and seen here" says 'no folder of PATH has a program of this name; here is one: \./here'
printf '#!/no/such/shell\n' >"$temp/script"
chmod +x "$temp/script"
holds "a script without its interpreter" tries 4 -- "$temp/script"
holds "could not be found" says 'could not be found \(exit status 127'
holds "no game named" tries 2
holds "an unknown option" tries 2 --rouns 3 -- "$bin/plain_game"
holds "is named, and the others" says 'try has no option "--rouns"; it has --seconds, --rounds,'
misspelt() {
    "$boomerang" "$@" >"$temp/out" 2>&1
    [ $? -eq 2 ] && cp "$temp/out" "$temp/said"
}
holds "an unknown command" misspelt tyr
holds "is said which there is" says 'there is no command "tyr"; the command is try'
holds "no command" misspelt
holds "is said which there is" says 'the command is try: boomerang try ./game'
holds "a value that is none" tries 2 --seconds soon -- "$bin/plain_game"
holds "is told the unit" says '--seconds: "soon" is no number of seconds'
holds "a value without end" tries 2 --seconds nan -- "$bin/plain_game"
holds "a library that is none" tries 2 --library "$temp/still.c" -- "$bin/plain_game"
holds "no such library" tries 2 --library "$temp/none.so" -- "$bin/plain_game"

# Controls: a library that crashes is noticed, as is one that changes how a game ends.
printf '#include <stdlib.h>\n__attribute__((constructor)) static void f(void) { abort(); }\n' | gcc -shared -fPIC -x c - -o "$temp/libcrash.so"
holds "control: a library that crashes" tries 1 --library "$temp/libcrash.so" -- "$bin/plain_game"
holds "control: is named as what it is" says 'ends otherwise with the library: as it is, exit status 0; off, was ended by signal 6'

# Who is interrupted leaves no game behind. (The game tells when it is there.)
mkfifo "$temp/there"
"$boomerang" try --quiet --seconds 60 -- sh -c "echo \$\$ >$temp/there; exec sleep 600" >"$temp/out" 2>&1 &
trier=$!
read -r game <"$temp/there"
kill -TERM "$trier"
wait "$trier"
holds "interrupted" test $? -eq 130
holds "the game is gone" test ! -e "/proc/$game"
all_hold "boomerang try: "
