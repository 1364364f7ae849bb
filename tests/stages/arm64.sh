# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# with --long alone: ARM64 under qemu-user, by gcc and by clang, products fused and not: the bits of its lanes, and games

# (Debian's g++-multilib and g++-aarch64-linux-gnu exclude each other: apt takes away the one for the other.)
stage_arm64() {
    local compiler
    bmr_need_packages g++-aarch64-linux-gnu qemu-user clang dpkg-dev || return 1
    for compiler in gcc clang; do
        in_tree "arm64-$compiler"
        bmr_say "configuring $BMR_BUILD_DIR, with Box2D's source"
        bmr_quietly "$BMR_BUILD_DIR/boomerang-configure.log" cmake -S "$root/tests/box2d_builds/arm64" -B "$BMR_BUILD_DIR" -G Ninja \
            "-DCMAKE_TOOLCHAIN_FILE=$root/tests/box2d_builds/arm64/toolchain.cmake" "-DARM64_COMPILER=$compiler" \
            -DBOOMERANG_WARNINGS_AS_ERRORS=ON || return 1
        BMR_JOBS=$jobs bmr_build || return 1
        BMR_TEST_SCALE=0.1 run_tests "ARM64 ($compiler)"
    done
}
