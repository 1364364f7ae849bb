# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# the tests of threads, under the thread sanitizer

stage_threads() {
    build_tree tsan tsan -DBOOMERANG_BUILD_TESTBED=OFF -- tests/threads/all &&
        BMR_TEST_SCALE=${BMR_TEST_SCALE:-0.1} run_tests "tests (thread sanitizer)" --label-regex '^threads$'
}
