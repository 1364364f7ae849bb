# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# all programs, tests and benchmarks with gcc -O3; all tests

stage_release() {
    build_tree release release -DBOOMERANG_BUILD_TESTS=ON -DBOOMERANG_BUILD_BENCHMARKS=ON \
        "-DBOOMERANG_WARNINGS_AS_ERRORS=$strict" && run_tests "tests (release)"
}
