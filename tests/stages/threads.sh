# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# the tests of threads, under the thread sanitizer

# (A sanitizer's report names lines, and needs no more from a debugger's tables: they take a fifth of the time to compile.)
stage_threads() {
    local flags='-O2 -g1 -DNDEBUG'
    build_tree tsan tsan -DBOOMERANG_BUILD_TESTBED=OFF "-DCMAKE_C_FLAGS_RELWITHDEBINFO=$flags" \
        "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=$flags" -- tests/plugin/threads/all &&
        BMR_TEST_SCALE=${BMR_TEST_SCALE:-0.1} run_tests "tests (thread sanitizer)" --label-regex '^threads$'
}
