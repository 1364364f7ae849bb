# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# the fuzzers over their corpora, then on: 5 s each, 60 s for the one that drives Box2D

stage_fuzz() {
    local fuzzer seconds
    build_sanitizers || return 1
    for fuzzer in $("$root/tests/fuzz/run" --list); do
        seconds=5
        [ "$fuzzer" != fuzz_glue ] || seconds=60
        check "$fuzzer, $seconds s" env LLVM_PROFILE_FILE=/dev/null BMR_PRESET="$(sanitizers_preset)" BMR_JOBS="$jobs" \
            BMR_BUILD_DIR="$BMR_BUILD_DIR" "$root/tests/fuzz/run" --seconds "$seconds" "$fuzzer" || true
    done
}
