#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   check_ways.sh BUILD PLUGIN ROOT
#
# Two ways to Boomerang at once (docs/compile-box2d.md): CMake refuses them; where it cannot know, the second copy says so and does
# nothing, and the game plays on. BUILD: where the shelf was built, with the variant `static` accelerated; PLUGIN:
# libboomerang_box2d.so in its build tree.
set -uo pipefail
build=$(realpath "${1:?}") plugin=$(realpath "${2:?}") root=${3:?}
libraries=$(dirname "$plugin") tree=$(dirname "$(dirname "$plugin")")
ways=$root/tests/box2d_builds/ways
temp=$(mktemp -d)
trap 'rm -rf "$temp"' EXIT
holds_shows=$temp/err
# shellcheck source=tests/kit/holds.sh
source "$root/tests/kit/holds.sh"
unset BOOMERANG BOOMERANG_PAIRS_BY BOOMERANG_COUNTS BOOMERANG_VERBOSE LD_PRELOAD
cd "$temp" || exit 1

# links PROGRAM MAIN LIBRARY...
links() { g++ "$2.o" play.o -o "$1" "${@:3}" -pthread 2>err; }
compile() {
    g++ -std=c++11 -O1 -I"$root/core/include" -I"$root/box2d_glue/include" -I"$root/plugin/include" -I"$build/source/include" "$@"
}
compile -c -Dmain=Play "$root/tests/plugin/plain_game.cpp" -o play.o
compile -c "$ways/two_ways.cpp" -o silent.o
compile -c -DWITH_INTERFACE "$ways/two_ways.cpp" -o calls.o
links game silent -lbox2d && ./game >stock || { echo "the game does not run"; exit 1; }

# plays COMMAND...: it prints what stock prints
plays() { "$@" >out 2>err && cmp -s stock out; }
says() { grep -qE -- "^boomerang: $1" err; }
one_refuses() { [ "$(grep -c '^boomerang: not at work, .*libboomerang_box2d.so is a second copy here' err)" -eq 1 ]; }

# An accelerated Box2D inside the program, and the library linked by hand, in either order: the one inside works.
second_linked() {
    local order accelerated=$build/static/accelerated/libbox2d.a
    for order in "$plugin $accelerated" "$accelerated $plugin"; do
        # shellcheck disable=SC2086
        links it silent -Wl,--no-as-needed $order -Wl,-rpath,"$libraries" && plays env BOOMERANG_VERBOSE=1 ./it && one_refuses &&
            says 'on; compiled with Box2D' && plays env BOOMERANG=verify ./it && says 'verified [1-9][0-9,]* answers, 0 differ' &&
            links it calls -Wl,--no-as-needed $order -Wl,-rpath,"$libraries" && plays ./it && one_refuses || return 1
    done
}
holds "a second copy that is linked says so" second_linked
# An accelerated shared one (with --long), and the library preloaded: the game plays as stock.
second_preloaded() {
    local place=$build/ndebug/accelerated
    links it silent "$place/libbox2d.so.2" -Wl,-rpath,"$place" && plays env BOOMERANG_VERBOSE=1 ./it && says 'on; compiled with Box2D' &&
        plays env "LD_PRELOAD=$plugin" BOOMERANG_VERBOSE=1 ./it && one_refuses
}
[ ! -e "$build/ndebug/accelerated/libbox2d.so.2" ] || holds "a second copy that is preloaded says so" second_preloaded
preloaded_twice() {
    links it calls -Wl,--no-as-needed "$plugin" -lbox2d -Wl,-rpath,"$libraries" && plays env "LD_PRELOAD=$plugin" BOOMERANG_VERBOSE=1 ./it &&
        says 'on; ahead of Box2D' && ! one_refuses
}
holds "control: the same file is loaded once" preloaded_twice

refused() {
    local how=$1 sentence=$2
    ! cmake -S "$ways" -B "$temp/$how" -G Ninja -DHOW="$how" -DBOX2D_SOURCE="$build/source" -DBOOMERANG_SOURCE="$root" \
        -DCMAKE_PREFIX_PATH="$temp/prefix" >err 2>&1 && tr -s '\n ' '  ' <err | grep -qF "$sentence"
}
for component in development core kinetic runtime; do
    cmake --install "$tree" --prefix "$temp/prefix" --component "$component" >/dev/null
done
for how in add_subdirectory fetch_content package; do
    holds "CMake refuses both, by $how" refused "$how" \
        'game links boomerang::box2d, and boomerang_accelerate(box2d) has compiled Boomerang with its Box2D already: take boomerang::box2d out'
done
holds "an installed package and the sources in one build" refused twice 'Boomerang is in this build already: of find_package(boomerang) and'
holds "a component of no name" refused component 'There is no component "cores"; there are: core, kinetic, box2d'
all_hold "two ways: "
