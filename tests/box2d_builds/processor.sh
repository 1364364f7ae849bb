# SPDX-License-Identifier: MIT
# Sourced. Which processor a variant of the shelf runs on: this one, or, where it lacks what `fma` and `regrouped` are compiled for, one that qemu-user
# plays.
# shellcheck shell=bash disable=SC2034

# lacks_fma: true where this machine's processor cannot run what is compiled with -march=haswell
lacks_fma() {
    [ -z "${BOX2D_BUILDS_PROCESSOR:-}" ] || return 0
    local feature
    [ "$(uname -m)" = x86_64 ] || return 1
    for feature in avx2 bmi1 bmi2 fma movbe; do
        grep -qw "$feature" /proc/cpuinfo || return 0
    done
    return 1
}

# processor_for VARIANT: sets the arrays runner, what a program is started with, and set_variable, how the runner is told of a
# variable of the program's. Says what is missing where it cannot. BOX2D_BUILDS_PROCESSOR: a processor of qemu's to be used in any
# case, e.g. Haswell-noTSX. BOX2D_BUILDS_EMULATOR: the command that runs programs of another processor, all variants (tests/box2d_builds/arm64).
processor_for() {
    if [ -n "${BOX2D_BUILDS_EMULATOR:-}" ]; then
        read -ra runner <<<"env $BOX2D_BUILDS_EMULATOR -E BOOMERANG=on"
        set_variable=(-E)
        return
    fi
    runner=(env BOOMERANG=on) set_variable=()
    if [[ ! $1 =~ ^(fma|regrouped)$ ]] || ! lacks_fma; then return; fi
    if ! command -v qemu-x86_64 >/dev/null; then
        echo "box2d_builds: this processor has no fused multiply-add: the variant $1 needs qemu-user" >&2
        return 1
    fi
    runner=(env qemu-x86_64 -cpu "${BOX2D_BUILDS_PROCESSOR:-Haswell-noTSX}" -E BOOMERANG=on) set_variable=(-E)
}
