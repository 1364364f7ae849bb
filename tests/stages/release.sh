# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# all programs, tests and benchmarks with gcc -O3; all tests

# The testbed is compiled the quick way here; that each file includes what it needs shows in the tree of the sanitizers of a
# whole run.
build_release() {
    build_tree release release -DBOOMERANG_BUILD_TESTS=ON -DBOOMERANG_BUILD_BENCHMARKS=ON -DBOOMERANG_QUICK_BUILD=ON \
        "-DBOOMERANG_WARNINGS_AS_ERRORS=$strict"
}

stage_release() {
    local scale=1
    [ "$brief" = no ] || scale=0.25
    build_release && BMR_TEST_SCALE=${BMR_TEST_SCALE:-$scale} run_tests "tests (release)"
}
