# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# the library by gcc and by clang, with --long at -O0, -O2 and -O3 -march=native, too: the hashes of all scenes are stock's, and the recorded ones

# build_library NAME COMPILER C++-COMPILER FLAGS: the plugin's library alone, in a tree of its own.
build_library() {
    build_tree "$1" release "-DCMAKE_C_COMPILER=$2" "-DCMAKE_CXX_COMPILER=$3" "-DCMAKE_C_FLAGS_RELEASE=$4" \
        "-DCMAKE_CXX_FLAGS_RELEASE=$4" -DBOOMERANG_BUILD_TESTS=OFF \
        -DBOOMERANG_BUILD_TESTBED=OFF -DBOOMERANG_BUILD_KINETIC=OFF \
        -DBOOMERANG_WARNINGS_AS_ERRORS=ON -- boomerang_box2d &&
        libraries+=(--library "$1=$BMR_BUILD_DIR/lib")
}

stage_determinism() {
    local libraries=()
    if [ "$long" = yes ]; then
        build_library O0 gcc g++ "-O0" || true
        build_library O2 gcc g++ "-O2 -DNDEBUG" || true
        build_library native gcc g++ "-O3 -march=native -DNDEBUG" || true
    fi
    build_library clang-O2 clang clang++ "-O2 -DNDEBUG" || true
    # (The gate has no testbed there.)
    if [ "$long" = yes ] && build_sanitizers; then
        libraries+=(--programs "sanitizers=$BMR_BUILD_DIR")
    fi
    build_release || return 1
    # Box2D and GSL keep what they have to the end of the process.
    check "determinism" env ASAN_OPTIONS=detect_leaks=0 LLVM_PROFILE_FILE=/dev/null BMR_JOBS="$jobs" \
        "$root/tests/stages/determinism/run" "${libraries[@]}" "$BMR_BUILD_DIR"
}
