# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# the tests under those sanitizers, at a tenth of their iterations; with --long all that can run there

# Not there: what preloads the library (a sanitizer's runtime wants to be the first of a process), and what tests the
# testbed's pages and command line or the scripts. The actor with the library preloaded neither: its fuzzer does that work.
stage_sanitized_tests() {
    local which=() out='preloaded|front|gate'
    [ "$long" = yes ] || { which=(--label-regex '^(claims|random|contracts|glue|as_stock)$') && out+='|settings'; }
    build_sanitizers || return 1
    rm -rf "$BMR_BUILD_DIR/profiles"
    mkdir "$BMR_BUILD_DIR/profiles"
    echo "$long" >"$BMR_BUILD_DIR/profiles/long"
    BMR_TEST_SCALE=${BMR_TEST_SCALE:-0.1} \
        run_tests "tests (sanitizers)" --label-exclude "^($out)\$" "${which[@]}"
}
