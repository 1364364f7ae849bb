# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# which lines of core, the glue and the plugin those tests ran

stage_coverage() {
    build_sanitizers || return 1
    # After --only coverage the tests are yet to run, or ran when others were chosen.
    [ "$(cat "$BMR_BUILD_DIR/profiles/brief" 2>/dev/null)" = "$brief" ] || stage_sanitized_tests
    local options=()
    [ "$brief" = no ] || options=(--brief)
    check "coverage" "$root/tests/coverage/report" "${options[@]}" "$BMR_BUILD_DIR"
}
