# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# with --long alone: an hour of simulated time, whose bits are stock's and whose memory stays as flat

stage_soak() {
    build_release || return 1
    check "soak" "$root/tests/stages/soak/run_soak.sh" "$BMR_BUILD_DIR" || true
    # With a leak in it, it fails, and for that.
    check "soak: control" soak_control
}

soak_control() {
    local status=0
    cc -shared -fPIC -O1 -o "$work/leaking_step.so" "$root/tests/stages/soak/leaking_step.c" -ldl || return 1
    # (Off: a library that is at work wants to see the step first.)
    BOOMERANG=off "$root/tests/stages/soak/run_soak.sh" "$BMR_BUILD_DIR" 20000 "$work/leaking_step.so" >"$work/soak" 2>&1 || status=$?
    [ "$status" -eq 1 ] && grep -q 'the plugin grew by' "$work/soak"
}
