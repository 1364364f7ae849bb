# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# Checks that are counted. Sourced.
passed=0 failed=0

# holds NAME COMMAND [ARGUMENT...]: one check. Where it fails, the beginning of the file $holds_shows is shown, if there is one.
holds() {
    local name=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
        return
    fi
    failed=$((failed + 1))
    printf 'FAILED: %s\n' "$name"
    [ ! -s "${holds_shows:-}" ] || head -c 600 "$holds_shows"
    return 1
}

# all_hold [PREFIX]: the last line, and the exit code.
all_hold() {
    printf '%s%d passed, %d failed\n' "${1:-}" "$passed" "$failed"
    [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
}
