#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# What testbed_scenes/run and tests/run share: from a fresh Debian 12 to a built tree.
# Sourced, not run:
#
#   source "$root/tools/setup.sh"
#   bmr_need_packages "${BMR_BUILD_PACKAGES[@]}"     install what is missing, or say how and stop
#   bmr_configure release [-DNAME=VALUE…]            cmake --preset, in the preset's own directory
#   bmr_build [TARGET…]                              everything when no target is named
#
# Each function says in a line what takes time, and no more unless it fails; then it shows the
# last lines of what the tool said and the place of the full log. Each returns non-zero on
# failure, so that a script under `set -e` stops there.
#
# Environment: BMR_BUILD_DIR   build here instead of the preset's directory (kept between calls)
#              BMR_JOBS        parallel jobs (default: the number of processors)

bmr_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# The arrays and BMR_BUILD_DIR are for the scripts that source this file.
# shellcheck disable=SC2034
BMR_BUILD_PACKAGES=(build-essential cmake ninja-build pkg-config libbox2d-dev libgsl-dev
    libcli11-dev nlohmann-json3-dev libcairo2-dev libpolyclipping-dev)
# shellcheck disable=SC2034
BMR_TEST_PACKAGES=(doctest-dev libgmp-dev clang libclang-rt-14-dev lld clang-format cppcheck llvm valgrind python3 fonts-dejavu-core
    poppler-utils dpkg-dev fakeroot file)

bmr_say() { printf '%s\n' "$*" >&2; }

# bmr_quietly LOG COMMAND…: keeps the output in LOG and shows its tail only if the command fails.
bmr_quietly() {
    local log=$1 status=0
    shift
    "$@" >"$log" 2>&1 || status=$?
    if [ "$status" -ne 0 ]; then
        tail -n 40 "$log" >&2
        bmr_say "failed ($status): $*"
        bmr_say "the full log: $log"
    fi
    return "$status"
}

# The packages among the arguments that dpkg does not list as installed, one a line.
bmr_missing_packages() {
    local package
    for package in "$@"; do
        if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
            printf '%s\n' "$package"
        fi
    done
}

bmr_have_packages() { command -v dpkg-query >/dev/null && [ -z "$(bmr_missing_packages "$@")" ]; }

bmr_need_packages() {
    local missing=() as_root=() log
    if ! command -v dpkg-query >/dev/null; then
        bmr_say "note: this is no Debian; needed from elsewhere: $*"
        return 0
    fi
    mapfile -t missing < <(bmr_missing_packages "$@")
    [ ${#missing[@]} -gt 0 ] || return 0

    if [ "$(id -u)" -ne 0 ]; then
        if ! sudo -n true 2>/dev/null; then
            bmr_say "Some packages are missing, and this shell may not install them. Please run:"
            bmr_say "    sudo apt-get update && sudo apt-get install -y --no-install-recommends ${missing[*]}"
            return 1
        fi
        as_root=(sudo -n)
    fi
    bmr_say "installing: ${missing[*]}"
    log=$(mktemp "${TMPDIR:-/tmp}/boomerang-apt.XXXXXX") || return 1
    # An update that fails (one mirror of several is down) need not keep the packages from installing.
    "${as_root[@]}" apt-get update >"$log" 2>&1 || bmr_say "note: apt-get update failed; trying with the lists at hand"
    bmr_quietly "$log" "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y --no-install-recommends "${missing[@]}" || return 1
    rm -f "$log"
}

# bmr_configure PRESET [CMAKE-ARGUMENT…]. Sets BMR_BUILD_DIR, where bmr_build builds.
bmr_configure() {
    local preset=$1 where=()
    shift
    if [ -n "${BMR_BUILD_DIR:-}" ]; then
        where=(-B "$BMR_BUILD_DIR")
    elif [ "$preset" = release ]; then
        BMR_BUILD_DIR=$bmr_root/build
    else
        BMR_BUILD_DIR=$bmr_root/build-$preset
    fi
    mkdir -p "$BMR_BUILD_DIR" || return 1
    BMR_BUILD_DIR=$(cd "$BMR_BUILD_DIR" && pwd)
    # A tree that is there keeps its generator (`cmake -B build` makes one for make, the presets for ninja).
    if [ -f "$BMR_BUILD_DIR/CMakeCache.txt" ]; then
        where+=(-G "$(sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$BMR_BUILD_DIR/CMakeCache.txt")")
    else
        bmr_say "configuring $BMR_BUILD_DIR"
    fi
    # From the root: presets are looked up in the current directory.
    (cd "$bmr_root" && bmr_quietly "$BMR_BUILD_DIR/boomerang-configure.log" \
        cmake --preset "$preset" "${where[@]}" "$@")
}

# bmr_watch LOG: says how far ninja or make is, on a terminal each second in one line, elsewhere each half minute, until it is killed or the
# script ends.
bmr_watch() {
    local seconds=0 far
    trap '[ ! -t 2 ] || printf "\r\033[K" >&2; exit' TERM
    while kill -0 $$ 2>/dev/null; do
        sleep 1 >/dev/null 2>&1 &
        wait $! # (TERM interrupts a wait, not a sleep)
        seconds=$((seconds + 1))
        far=$(tail -n 1 "$1" | grep -oE '^\[ *[0-9]+(/[0-9]+|%)\]') || continue
        if [ -t 2 ]; then
            printf '\r\033[K%s %d s' "$far" "$seconds" >&2
        elif [ $((seconds % 30)) -eq 0 ]; then
            bmr_say "$(basename "$(dirname "$1")"): $far after $seconds s"
        fi
    done
}

# bmr_build [TARGET…], in the directory of the last bmr_configure.
bmr_build() {
    local targets=() jobs=${BMR_JOBS:-$(nproc)} log watch status=0
    [ $# -eq 0 ] || targets=(--target "$@")
    # Said even when it will be over at once, which is not known before the build tool has looked for files that came or went.
    bmr_say "building in $BMR_BUILD_DIR with $jobs jobs"
    log=$BMR_BUILD_DIR/boomerang-build.log
    : >"$log"
    bmr_watch "$log" &
    watch=$!
    bmr_quietly "$log" cmake --build "$BMR_BUILD_DIR" --parallel "$jobs" "${targets[@]}" || status=$?
    kill "$watch" 2>/dev/null || true
    wait "$watch" 2>/dev/null || true
    return "$status"
}
