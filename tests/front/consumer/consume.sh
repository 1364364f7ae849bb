#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# One step of the consumer test: tests/front/consumer/consume.sh STEP
#   install            installs the build tree into $WORK/prefix
#   find_package       builds the programs with CMake on what is installed there, and runs them; and again on the build tree
#   pkg_config         the same with nothing but the compiler and pkg-config
#   pages              types the programs of the pages into an empty folder, builds them on what is installed, and runs them
#   fetch_content      builds them together with the sources, which FetchContent adds, and runs them
#   static_box2d       builds a program with Box2D inside: what CMake says of it, and that it runs
#   accelerated        a game with a Box2D of its own, of the sources BOX2D_SOURCE, accelerated by what is installed (for whoever has
#                      such sources: tests/stages/builds.sh)
#   plain              a plain configure is what a user installs, needs Box2D alone, and says in a line each what it leaves out
#   uninstall          takes the installation away and checks that no file is left
# Environment: SOURCE, BUILD (the tree to install from), WORK (a directory of our own), WITH_BOX2D, WITH_KINETIC, WITH_REPAIR (ON or OFF), CC, CXX.
set -euo pipefail
step=$1
consumer=$SOURCE/tests/front/consumer
# Its path has a folder of our name, which is the user's.
prefix=$WORK/boomerang/prefix
out=$WORK/$step
manifest=$BUILD/install_manifest.txt

fail() {
    printf 'consumer: %s\n' "$*" >&2
    exit 1
}

build_with_cmake() {
    rm -rf "$out"
    cmake -S "$consumer/$step" -B "$out" -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" -DCONSUME_BOX2D="$WITH_BOX2D" -DCONSUME_KINETIC="$WITH_KINETIC" -DCONSUME_REPAIR="$WITH_REPAIR" "$@"
    cmake --build "$out"
}

run_programs() {
    "$out/bin/consume_core"
    [ ! -x "$out/bin/consume_kinetic" ] || "$out/bin/consume_kinetic"
    [ ! -x "$out/bin/consume_repair" ] || "$out/bin/consume_repair"
    if [ "$WITH_BOX2D" = ON ]; then
        local program
        for program in "$out"/bin/consume*box2d; do "$program"; done
    fi
}

# Installing overwrites the list of what was installed from this tree, which may be somebody's real installation.
with_own_manifest() {
    local kept=$WORK/install_manifest.kept
    rm -f "$kept"
    [ ! -f "$manifest" ] || mv "$manifest" "$kept"
    # shellcheck disable=SC2064
    trap "rm -f '$manifest'; [ ! -f '$kept' ] || mv '$kept' '$manifest'" EXIT
    "$@"
}

install_and_keep_list() {
    cmake --install "$BUILD" --prefix "$prefix"
    cp "$manifest" "$WORK/manifest.txt"
}

# (By itself it installs what it takes away: ctest runs the end of a fixture without its beginning.)
uninstall_all() {
    [ -n "$(find "$prefix" -type f 2>"$WORK/none.txt")" ] || install_and_keep_list
    [ -n "$(find "$prefix" -type f)" ] || fail "nothing was installed"
    # What Python leaves beside a module that was imported goes with it.
    local module
    while read -r module; do
        mkdir "$module/__pycache__" && touch "$module/__pycache__/pair.pyc"
    done < <(find "$prefix" -type d -path '*-packages/boomerang')
    cp "$WORK/manifest.txt" "$manifest"
    cmake --build "$BUILD" --target uninstall
}

# What the target `installable` does not build, of what is installed: `cmake --install` would miss it after testbed_scenes/run.
# (The script bin/boomerang is made when the tree is configured.)
not_installable() {
    local file
    ninja -C "$BUILD" -t commands installable | tr ' ' '\n' | sed "s|^$BUILD/||" | sort -u >"$WORK/commands.txt"
    grep -oE "\"$BUILD/(lib|bin|manual)/[^\"]*\"" "$BUILD/cmake_install.cmake" | tr -d '"' | sort -u | while read -r file; do
        [ -L "$file" ] || [ "$file" = "$BUILD/bin/boomerang" ] || grep -qxF "${file#"$BUILD"/}" "$WORK/commands.txt" || echo "$file"
    done
}

mkdir -p "$WORK"
case $step in
install)
    rm -rf "$prefix"
    missed=$(not_installable)
    [ -s "$WORK/commands.txt" ] && [ -z "$missed" ] || fail "the target installable does not build $missed"
    with_own_manifest install_and_keep_list
    # What boomerang_accelerate compiles is there, file by file.
    if [ "$WITH_BOX2D" = ON ]; then
        for folder in core/include core/geometry core/hierarchy core/certificate core/pair core/kds core/budget core/exact32 \
            core/convex32 core/outline box2d_glue plugin/hooks plugin/include plugin/renamed; do
            diff -r -x '*.txt' -x '*.md' "$SOURCE/$folder" "$prefix/share/boomerang/source/$folder" >"$WORK/sources.txt" ||
                fail "the installed sources are others: $(head -n 1 "$WORK/sources.txt")"
        done
    fi
    # No link of an installed page is dead, but for those to the tests.
    python3 "$SOURCE/tests/front/check_links.py" "$prefix/share/doc/boomerang" >"$WORK/links.txt" || true
    ! grep -vE ': (\.\./)*tests/' "$WORK/links.txt" || fail "a link of an installed page is dead"
    grep -q 'README.md: tests/README.md leads nowhere' "$WORK/links.txt" || fail "control: no link was looked at"
    # What ships inside a game must not depend on GSL, which is GPL-3. (libboomerang_kinetic is what does.)
    while read -r library; do
        ! readelf --dynamic "$library" | grep NEEDED | grep -i gsl || fail "$library links GSL"
    done < <(find "$prefix" -name '*.so' ! -name libboomerang_kinetic.so)
    # The installed testbed finds its workers, the library that counts and the plugin to preload, from anywhere.
    if [ -x "$prefix/bin/boomerang-testbed" ]; then
        (cd / && "$prefix/bin/boomerang-testbed" compare needles --steps 5 --no-time) >"$WORK/compare.txt" 2>&1 ||
            fail "the installed testbed does not compare: $(cat "$WORK/compare.txt")"
        ! grep '^note:' "$WORK/compare.txt" || fail "the installed testbed misses a library"
        grep -q '^needles .* identical *identical *identical$' "$WORK/compare.txt" ||
            fail "the installed testbed does not run both ways"
    fi
    ;;
find_package)
    build_with_cmake -DCMAKE_PREFIX_PATH="$prefix"
    run_programs
    grep -q "^boomerang_DIR:PATH=$prefix/" "$out/CMakeCache.txt" ||
        fail "this was another Boomerang than the one that this test installed"
    # The build tree is a prefix, too.
    build_with_cmake -DCMAKE_PREFIX_PATH="$BUILD"
    run_programs
    grep -q "^boomerang_DIR:PATH=$BUILD$" "$out/CMakeCache.txt" || fail "this was another Boomerang than that of the build tree"
    ;;
pkg_config)
    rm -rf "$out"
    mkdir -p "$out/bin"
    directory=$(dirname "$(find "$prefix" -name boomerang-core.pc)")
    export PKG_CONFIG_PATH=$directory
    read -ra flags < <(pkg-config --cflags --libs boomerang-core)
    "$CC" -std=c11 "$consumer/consume_core.c" -o "$out/bin/consume_core" "${flags[@]}"
    if [ "$WITH_KINETIC" = ON ]; then
        read -ra flags < <(pkg-config --cflags --libs boomerang-kinetic)
        "$CC" -std=c11 "$consumer/consume_kinetic.c" -o "$out/bin/consume_kinetic" "${flags[@]}"
    fi
    if [ "$WITH_REPAIR" = ON ]; then
        read -ra flags < <(pkg-config --cflags --libs boomerang-repair)
        "$CXX" -std=c++11 "$consumer/consume_repair.cpp" -o "$out/bin/consume_repair" "${flags[@]}"
    fi
    if [ "$WITH_BOX2D" = ON ]; then
        read -ra flags < <(pkg-config --cflags --libs boomerang-box2d)
        # What a game includes is C++11, and without a warning.
        "$CXX" -std=c++11 -Wall -Wextra -pedantic -Werror "$consumer/consume_box2d.cpp" -o "$out/bin/consume_box2d" "${flags[@]}"
        for program in recorder_alone "recorder -DWITH_PLUGIN"; do
            read -ra words <<<"$program"
            read -ra flags < <(pkg-config --cflags --libs boomerang-recorder ${words[1]:+boomerang-box2d})
            "$CXX" -std=c++11 -Wall -Wextra -pedantic -Werror "${words[@]:1}" "$consumer/consume_recorder.cpp" -o "$out/bin/consume_${words[0]}_box2d" "${flags[@]}"
        done
    fi
    LD_LIBRARY_PATH=$(dirname "$directory") run_programs
    ;;
pages)
    [ "$WITH_BOX2D" = OFF ] || python3 "$SOURCE/tests/front/check_blocks.py" programs "$SOURCE" "$prefix" "$out"
    ;;
fetch_content)
    # The project names no build type, and gets none.
    build_with_cmake -DCMAKE_BUILD_TYPE= -DBOOMERANG_REPOSITORY=none \
        -DFETCHCONTENT_SOURCE_DIR_BOOMERANG="$SOURCE"
    run_programs
    [ -z "$(find "$out" -name 'libboomerang_box2d_glue.*')" ] || fail "a library that no program links was built"
    ;;
static_box2d)
    [ "$WITH_BOX2D" = ON ] || exit 0
    warning='game links boomerang::box2d, which answers for a shared Box2D, and has Box2D inside (box2d).*Call boomerang_accelerate(box2d) instead'
    # configured WARNED [OPTION]...
    configured() {
        local warned=$1
        shift
        rm -rf "$out"
        cmake -S "$consumer/static_box2d" -B "$out" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER="$CC" \
            -DCMAKE_CXX_COMPILER="$CXX" "$@" >"$WORK/static_box2d.txt" 2>&1 || fail "not configured: $(cat "$WORK/static_box2d.txt")"
        # (CMake breaks lines where it likes.)
        if tr -s '\n ' '  ' <"$WORK/static_box2d.txt" | grep -q "$warning"; then
            [ "$warned" = yes ] || fail "a warning where there is nothing to warn of: $*"
        else
            [ "$warned" = no ] || fail "no warning: $*"
        fi
    }
    # As a subdirectory Boomerang takes the project's Box2D.
    configured yes -DBOOMERANG_SOURCE="$SOURCE"
    configured no -DCMAKE_PREFIX_PATH="$prefix" -DBUILD_SHARED_LIBS=ON
    configured yes -DCMAKE_PREFIX_PATH="$prefix" -DLINKED=below
    configured yes -DCMAKE_PREFIX_PATH="$prefix"
    # The installed package has the function that the warning names, and it says what it cannot do.
    ! cmake -S "$consumer/static_box2d" -B "$out.refused" -DCMAKE_PREFIX_PATH="$prefix" -DLINKED=accelerated \
        >"$WORK/static_box2d.txt" 2>&1 || fail "a library without b2_world.cpp is accelerated"
    tr -s '\n ' '  ' <"$WORK/static_box2d.txt" |
        grep -q 'boomerang_accelerate(box2d): the target does not compile b2_world.cpp; name the one that does' ||
        fail "boomerang_accelerate does not say what it cannot do"
    cmake --build "$out"
    for setting in '' on verify; do
        [ "$(BOOMERANG=$setting "$out/bin/game" 2>&1)" = 'time 1 radius 1.5' ] || fail "BOOMERANG=$setting: a game with Box2D inside does not run"
    done
    ;;
accelerated)
    build_with_cmake -DCMAKE_PREFIX_PATH="$prefix" -DBOX2D_SOURCE="${BOX2D_SOURCE:?}"
    grep -q "^boomerang_DIR:PATH=$prefix/" "$out/CMakeCache.txt" ||
        fail "this was another Boomerang than the one that this test installed"
    "$out/bin/consume_box2d"
    "$out/bin/game_stock" >"$WORK/stock.txt" 2>"$WORK/said.txt"
    [ ! -s "$WORK/said.txt" ] || fail "stock says something: $(cat "$WORK/said.txt")"
    BOOMERANG_VERBOSE=1 "$out/bin/game" >"$WORK/game.txt" 2>"$WORK/said.txt"
    cmp "$WORK/stock.txt" "$WORK/game.txt" || fail "the accelerated game has other bits"
    grep -q '^boomerang: on; compiled with Box2D 2\.4\.1$' "$WORK/said.txt" ||
        fail "the installed package does not accelerate: $(cat "$WORK/said.txt")"
    ;;
plain)
    # plain [OPTION]...: configured anew
    plain() {
        rm -rf "$out"
        cmake -S "$SOURCE" -B "$out" -G Ninja -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" "$@" >"$WORK/plain.txt" 2>&1 ||
            fail "not configured: $(cat "$WORK/plain.txt")"
        targets=$(cmake --build "$out" --target help)
        ! grep -qE '^(test_|bench_|boomerang-testbed|boomerang_playground)' <<<"$targets" || fail "a plain build has what only developers need"
    }
    # leaves_out WHAT PACKAGE DEBIANS
    leaves_out() { grep -qF "Boomerang: $1 is left out, for there is no $2 (Debian: $3)" "$WORK/plain.txt" || fail "it does not say that $1 is left out"; }
    has() { grep -q "^$1: " <<<"$targets"; }
    plain -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON -DCMAKE_DISABLE_FIND_PACKAGE_GSL=ON
    leaves_out boomerang::kinetic GSL libgsl-dev
    { has boomerang_core_shared && has boomerang_box2d && ! has boomerang_kinetic; } || fail "without CLI11 and GSL other targets are there"
    plain -DCMAKE_DISABLE_FIND_PACKAGE_box2d=ON
    leaves_out boomerang::box2d box2d libbox2d-dev
    { has boomerang_core_shared && ! has boomerang_box2d; } || fail "without Box2D other targets are there"
    # Where a plain install puts the Python module, Debian's Python looks.
    if [ -e /etc/debian_version ] && python=$(PATH=/usr/bin command -v python3); then
        plain -DPython3_EXECUTABLE="$python"
        DESTDIR=$out/there cmake --install "$out" --component python >/dev/null
        module=$(find "$out/there" -type d -name dist-packages)
        "$python" -c 'import sys; sys.exit(sys.argv[1] not in sys.path)' "${module#"$out/there"}" || fail "Python does not look in $module"
    fi
    # The scripts, whose presets are for ninja, go on in a tree that was configured for make.
    rm -rf "$out"
    cmake -S "$SOURCE" -B "$out" -G "Unix Makefiles" -DBOOMERANG_BUILD_BOX2D=OFF >"$WORK/plain.txt" 2>&1 || fail "not configured for make"
    (
        # shellcheck source=tools/setup.sh
        source "$SOURCE/tools/setup.sh"
        BMR_BUILD_DIR=$out
        bmr_configure release -DBOOMERANG_BUILD_BOX2D=OFF -DBOOMERANG_BUILD_TESTS=OFF
    ) || fail "the scripts cannot use a tree for make"
    grep -q '^CMAKE_GENERATOR:INTERNAL=Unix Makefiles$' "$out/CMakeCache.txt" || fail "the tree has another generator"
    # Asked for by name, it is not left out.
    # needs SENTENCE OPTION...
    needs() {
        local sentence=$1
        shift
        rm -rf "$out"
        ! cmake -S "$SOURCE" -B "$out" "$@" >"$WORK/plain.txt" 2>&1 || fail "configured without what it needs: $*"
        tr -s '\n ' '  ' <"$WORK/plain.txt" | grep -qF "$sentence" || fail "it does not say \"$sentence\": $(cat "$WORK/plain.txt")"
    }
    needs 'boomerang::box2d needs box2d (Debian: libbox2d-dev); -DBOOMERANG_BUILD_BOX2D=OFF leaves it out' \
        -DBOOMERANG_BUILD_BOX2D=ON -DCMAKE_DISABLE_FIND_PACKAGE_box2d=ON
    [ "$WITH_BOX2D" = OFF ] || PKG_CONFIG_LIBDIR=$out needs \
        'The testbed needs what is not here; on Debian, `sudo apt-get install libcairo2-dev`.' -DBOOMERANG_BUILD_TESTBED=ON
    ;;
uninstall)
    with_own_manifest uninstall_all
    # (What is not ours stays, empty or not.)
    [ -d "$prefix/include" ] || fail "uninstall took the prefix, which is not ours"
    left=$(find "$prefix" ! -type d)
    [ -z "$left" ] || fail "uninstall left: $left"
    left=$(find "$prefix" -type d -name boomerang)
    [ -z "$left" ] || fail "uninstall left the directory $left"
    ;;
*) fail "unknown step '$step'" ;;
esac
