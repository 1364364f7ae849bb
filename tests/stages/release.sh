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
    local scale=1 less=()
    # In a brief run what is taken out of the library for the tests of threads is left to the thread sanitizer's tree.
    [ "$brief" = no ] || scale=0.1 less=(--exclude-regex '^threads_controls$')
    build_release && BMR_TEST_SCALE=${BMR_TEST_SCALE:-$scale} run_tests "tests (release)" "${less[@]}"
}
