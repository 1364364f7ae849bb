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
    "$root/tests/stages/soak/run_soak.sh" --control --steps 20000 "$BMR_BUILD_DIR" >"$work/soak" 2>&1 || status=$?
    [ "$status" -eq 1 ] && grep -q 'the plugin grew by' "$work/soak"
}
