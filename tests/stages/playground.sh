# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# with --long alone: the playground's page is made by Emscripten, and tried in a browser on a desktop's and a phone's size

stage_playground() {
    bmr_need_packages chromium chromium-driver python3-selenium || return 1
    in_tree playground
    check "playground: made" bmr_quietly "$BMR_BUILD_DIR/make.log" env BMR_JOBS="$jobs" BMR_BUILD_DIR="$build_base" "$root/playground/make" || return 1
    check "playground: tried" /usr/bin/python3 "$root/tests/front/test_playground_page.py" "$BMR_BUILD_DIR/playground.html" || true
    # With a function taken out, it fails, and for that.
    check "playground: control" playground_control
}

playground_control() {
    local status=0
    sed 's/"events_in_all"/"no_such_function"/g' "$BMR_BUILD_DIR/playground.html" >"$work/playground.html"
    /usr/bin/python3 "$root/tests/front/test_playground_page.py" "$work/playground.html" \
        PlaygroundPage.test_every_motion_and_structure_plays >"$work/playground" 2>&1 || status=$?
    [ "$status" -eq 1 ] && grep -q '^FAILED' "$work/playground"
}
