# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# the fuzzers over their corpora, then on, so many executions each; with --long half an hour each

# What one takes some seconds for; the one that drives Box2D has the longest way to go.
executions_of() {
    case $1 in
    fuzz_events) echo 100 ;;
    fuzz_world) echo 25 ;;
    fuzz_actor) echo 150 ;;
    *) echo 1000 ;;
    esac
}

stage_fuzz() {
    local fuzzer much name
    build_sanitizers || return 1
    for fuzzer in $("$root/tests/random/run" --list); do
        if [ "$long" = yes ]; then
            much=(--seconds "${BMR_FUZZ_SECONDS:-1800}")
        else
            much=(--runs "$(executions_of "$fuzzer")")
        fi
        name="$fuzzer ${much[*]} --seed $seed"
        check "$name" env LLVM_PROFILE_FILE=/dev/null BMR_PRESET="$(sanitizers_preset)" BMR_JOBS="$jobs" \
            BMR_BUILD_DIR="$BMR_BUILD_DIR" "$root/tests/random/run" "${much[@]}" --seed "$seed" "$fuzzer" || true
    done
}
