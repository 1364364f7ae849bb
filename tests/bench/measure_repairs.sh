#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   measure_repairs.sh [--vertices N] BENCH [OTHER]
#
# What a repair of each structure costs on polygons of N vertices (64): its instructions, counted by callgrind, and its
# time, the median of five runs of the benchmark by the processor's clock. BENCH is a bench_kds; with OTHER, that of
# another revision, its figures stand beside, and the quotients. Instructions are the same on a busy machine; times are not.
set -euo pipefail
usage() { sed -n '4,8s/^# \{0,1\}//p' "$0"; }
[ "${1:-}" != --help ] || { usage; exit 0; }
vertices=64
if [ "${1:-}" = --vertices ]; then
    vertices=${2:?}
    shift 2
fi
[ $# -ge 1 ] && [ -x "$1" ] && [ -x "${2:-$1}" ] || { usage >&2; exit 2; }

# instructions BENCH NAME: of one repair, and how many repairs there were.
instructions() {
    local repairs all
    repairs=$("$1" --once "$2" "$vertices") || repairs=0 # a revision that has no such structure
    [ "${repairs:-0}" -gt 0 ] || { echo "- 0"; return; }
    all=$(valgrind --tool=callgrind --collect-atstart=no --toggle-collect=bmr_kds_repair --callgrind-out-file=/dev/null \
        "$1" --once "$2" "$vertices" 2>&1 | sed -n 's/.*Collected : //p')
    echo "$((all / repairs)) $repairs"
}

# nanoseconds BENCH NAME
nanoseconds() {
    "$1" --benchmark_filter="^$2/$vertices\$" --benchmark_repetitions=5 --benchmark_min_time=0.02 \
        --benchmark_report_aggregates_only=true 2>/dev/null | sed 's/\x1b\[[0-9;]*m//g' |
        awk '$1 ~ /_median$/ { printf "%d", $4; found = 1 } END { if (!found) printf "-" }'
}

# quotient A B
quotient() { if [ "$1" = - ] || [ "$2" = - ]; then echo -; else awk -v a="$1" -v b="$2" 'BEGIN { printf "%.2f", a / b }'; fi; }

printf '%-28s %8s %12s %8s' structure repairs instructions ns
[ $# -lt 2 ] || printf ' %12s %8s %8s %8s' before ns x x-ns
echo
for name in $("$1" --list); do
    read -r count repairs < <(instructions "$1" "$name")
    time=$(nanoseconds "$1" "$name")
    printf '%-28s %8s %12s %8s' "$name" "$repairs" "$count" "$time"
    if [ $# -ge 2 ]; then
        read -r before _ < <(instructions "$2" "$name")
        time_before=$(nanoseconds "$2" "$name")
        printf ' %12s %8s %8s %8s' "$before" "$time_before" "$(quotient "$count" "$before")" "$(quotient "$time" "$time_before")"
    fi
    echo
done
