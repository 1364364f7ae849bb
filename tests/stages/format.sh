# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# clang-format over all sources

check_format() {
    local log=$work/clang-format status=0
    (cd "$root" && sources '*.c' '*.h' '*.cpp' | xargs -n 20 -P "$jobs" clang-format --dry-run -Werror 2>"$log") || status=1
    [ "$status" -eq 0 ] || sed -nE 's/^([^:]+):[0-9]+:.*/to mend it: clang-format -i \1/p' "$log" | sort -u
    return "$status"
}

stage_format() { check "clang-format" check_format; }
