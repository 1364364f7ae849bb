# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# which lines of core and the glue those tests ran

stage_coverage() {
    build_sanitizers || return 1
    # After --only coverage the tests are yet to run, or ran when others were chosen.
    [ "$(cat "$BMR_BUILD_DIR/profiles/long" 2>/dev/null)" = "$long" ] || stage_sanitized_tests
    check "coverage" "$root/tests/stages/coverage_report" "$BMR_BUILD_DIR"
}
