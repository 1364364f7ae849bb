#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   check_ways.sh BUILD PLUGIN ROOT
#
# Two ways to Boomerang at once: what docs/compile-box2d.md has in its table is so, cell by cell. BUILD: where the shelf was
# built, with the variant `static` accelerated; PLUGIN: libboomerang_box2d.so in its build tree.
set -uo pipefail
build=$(realpath "${1:?}") plugin=$(realpath "${2:?}") root=${3:?}
libraries=$(dirname "$plugin") tree=$(dirname "$(dirname "$plugin")")
ways=$root/tests/box2d_builds/ways
accelerated=$build/static/accelerated/libbox2d.a
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
holds_shows=$room/err
# shellcheck source=tests/kit/holds.sh
source "$root/tests/kit/holds.sh"
unset BOOMERANG BOOMERANG_PAIRS_BY BOOMERANG_COUNTS BOOMERANG_VERBOSE LD_PRELOAD
cd "$room" || exit 1

headers=(-I"$root/core/include" -I"$root/box2d_glue/include" -I"$root/plugin/include" -I"$build/source/include")
compile() { g++ -std=c++11 -O1 -fPIC "${headers[@]}" "$@"; }
compile -c -Dmain=Play "$root/tests/plugin/plain_game.cpp" -o play.o
for with in '' INTERFACE CORE; do
    compile -c ${with:+-DWITH_$with} "$ways/two_ways.cpp" -o "main$with.o"
done
compile -c -DWITH_INTERFACE -DWITH_CORE "$ways/two_ways.cpp" -o mainBOTH.o
# shellcheck disable=SC2054 # the commas are the linker's
linked=(-Wl,--no-as-needed "$plugin" -lbox2d -Wl,-rpath,"$libraries")

# links PROGRAM MAIN LIBRARY...; with a name that ends with .so a library, which Python opens
links() {
    local program=$1 main=$2 shared=()
    shift 2
    [[ $program != *.so ]] || shared=(-shared)
    g++ "${shared[@]}" "main$main.o" play.o -o "$program" "$@" -pthread 2>err
}
# plays COMMAND...: it prints what stock prints behind what it says of the interface; what it says is in $room/said and err.
plays() {
    "$@" >out 2>err && grep -v -e '^64-gon' -e '^core' out >bits && cmp -s stock bits
}
says() { grep -qE -- "$1" out err; }
# Python that has the module and opens a game
python() {
    env PYTHONPATH="$root/core/python" PYTHONDONTWRITEBYTECODE=1 BOOMERANG_LIBRARY_DIR="$libraries" "${preload[@]}" python3 -c "
import ctypes, sys, boomerang
square = boomerang.Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
assert abs(boomerang.distance(square, None, square, boomerang.Pose(3, 0)).distance - 2) < 1e-9
sys.stdout.flush()
ctypes.CDLL(sys.argv[1]).PlayAll()" "$@"
}
preload=()
links game '' -lbox2d
./game >stock || { echo "the game does not run"; exit 1; }

cell_linked_preloaded() {
    links it INTERFACE "${linked[@]}" && plays env "LD_PRELOAD=$plugin" BOOMERANG_VERBOSE=1 ./it && says '64-gon: no error; ahead of Box2D' &&
        [ "$(grep -c '^boomerang: [a-z]' err)" -eq 1 ]
}
# The preloaded library sees a shared Box2D that is accelerated, and none that is inside a program.
cell_accelerated_preloaded() {
    links it INTERFACE "$accelerated" && plays env "LD_PRELOAD=$plugin" BOOMERANG_VERBOSE=1 ./it && says '64-gon: no error; compiled with Box2D' &&
        says '^boomerang: on; .*compiled with Box2D' && says '^boomerang: not used: ' && cell_accelerated_preloaded_shared
}
# (With --long there is one.)
cell_accelerated_preloaded_shared() {
    local place=$build/ndebug/accelerated
    [ -e "$place/libbox2d.so.2" ] || return 0
    links it INTERFACE "$place/libbox2d.so.2" -Wl,-rpath,"$place" && plays env "LD_PRELOAD=$plugin" BOOMERANG_VERBOSE=1 ./it &&
        says 'libboomerang_box2d.so stands aside' && says '^boomerang: on; .*compiled with Box2D'
}
refused() {
    local how=$1 sentence=$2
    ! cmake -S "$ways" -B "$room/$how" -G Ninja -DHOW="$how" -DBOX2D_SOURCE="$build/source" -DBOOMERANG_SOURCE="$root" \
        -DCMAKE_PREFIX_PATH="$room/prefix" >err 2>&1 && tr -s '\n ' '  ' <err | grep -qF "$sentence"
}
# CMake refuses it; linked by hand, in either order, the accelerated one works and the library stands aside.
cell_accelerated_linked() {
    local how order
    for how in add_subdirectory fetch_content package; do
        refused "$how" 'game links boomerang::box2d, and boomerang_accelerate(box2d) has compiled Boomerang with its Box2D already: take boomerang::box2d out' ||
            return 1
    done
    for order in "$plugin $accelerated" "$accelerated $plugin"; do
        # shellcheck disable=SC2086
        links it INTERFACE -Wl,--no-as-needed $order -Wl,-rpath,"$libraries" && plays ./it && says '64-gon: no error; compiled with Box2D' &&
            says 'libboomerang_box2d.so stands aside: .* is compiled with Boomerang already' && plays env BOOMERANG_VERBOSE=1 ./it &&
            says '^boomerang: on; .*compiled with Box2D' && plays env BOOMERANG=verify ./it && says 'verified [1-9][0-9,]* answers, 0 differ' &&
            { [ ! -x "$tree/bin/boomerang" ] || "$tree/bin/boomerang" try --quiet --rounds 1 ./it >out 2>err; } || return 1
    done
}
cell_core_preloaded() { links it CORE -lbox2d "$libraries/libboomerang_core.a" && plays env "LD_PRELOAD=$plugin" BOOMERANG_VERBOSE=1 ./it && says 'core: no error' && says 'ahead of Box2D'; }
cell_core_linked() {
    links it BOTH "${linked[@]}" "$libraries/libboomerang_core.a" && plays ./it && says 'core: no error' && says '64-gon: no error; ahead of Box2D' &&
        links it BOTH "$libraries/libboomerang_core.so" -Wl,-rpath,"$libraries" "${linked[@]}" && plays ./it && says '64-gon: no error; ahead of Box2D'
}
cell_core_accelerated() {
    links it BOTH "$libraries/libboomerang_core.a" "$accelerated" && plays ./it && says 'core: no error' && says '64-gon: no error; compiled with' &&
        links it BOTH "$accelerated" "$libraries/libboomerang_core.a" && plays ./it && says '64-gon: no error; compiled with'
}
cell_python_preloaded() {
    preload=("LD_PRELOAD=$plugin libbox2d.so.2" BOOMERANG_VERBOSE=1)
    links it.so '' -lbox2d && plays python "$room/it.so" && says '^boomerang: on; .*ahead of Box2D'
}
cell_python_linked() { links it.so INTERFACE "${linked[@]}" && plays python "$room/it.so" && says '64-gon: no error; ahead of Box2D'; }
cell_python_accelerated() { links it.so INTERFACE "$accelerated" && plays python "$room/it.so" && says '64-gon: no error; compiled with'; }
cell_python_core() { links it.so CORE -lbox2d "$libraries/libboomerang_core.a" && plays python "$room/it.so" && says 'core: no error'; }

for component in development core kinetic runtime; do
    cmake --install "$tree" --prefix "$room/prefix" --component "$component" >/dev/null
done
# The table: row, column, first word of the cell.
awk -F ' *[|] *' '$0 == "<!-- two ways -->" { inside = 1; next } inside && !/^[|]/ { exit }
    inside && !n { for (n = 3; n < NF; ++n) column[n] = tolower($n); next }
    inside && !/^[|] ---/ { for (i = 3; i < NF; ++i) if ($i != "") print tolower($2), column[i], $i }' \
    "$root/docs/compile-box2d.md" >table
holds "the page has the table" test "$(wc -l <table)" -eq 10
while read -r row column word _; do
    word=${word%[:;]}
    preload=()
    holds "$row, $column" "cell_${row}_$column" || continue
    holds "$row, $column: the page says so" test "$word" = "$([ "$row$column" = acceleratedlinked ] && echo refused || echo works)"
done <table
holds "an installed package and the sources in one build" refused twice 'Boomerang is in this build already: of find_package(boomerang) and'
holds "a component of no name" refused component 'There is no component "cores"; there are: core, kinetic, box2d'
all_hold "two ways: "
