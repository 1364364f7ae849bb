#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   measure.sh PROGRAM [-n PROCESSES] [-f FROM] [-s STEPS] [-w "NAME..."] LIBRARY...
#
# Small worlds by the processor's time: microseconds a step from step FROM on (default 1000, STEPS 3000), stock and
# with each LIBRARY preloaded ("off": the first one with BOOMERANG=off; "stock": stock once more, which shows what
# noise is). Each figure is the median of many processes (default 11), run in turns: the layout of addresses alone
# changes one process by a tenth. `spread` is half the distance between the quartiles of the processes' ratios,
# over the square root of their number. Start: the first step's time above stock's, of the median world.
set -eu
program=$1
shift
processes=11 from=1000 steps=3000 names='' libraries=()
while [ $# -gt 0 ]; do
    case $1 in
    -n) processes=$2; shift ;;
    -f) from=$2; shift ;;
    -s) steps=$2; shift ;;
    -w) names=$2; shift ;;
    *) libraries+=("$1") ;;
    esac
    shift
done
[ ${#libraries[@]} -gt 0 ] || { echo "usage: measure.sh PROGRAM [-n N] [-f N] [-s N] [-w NAMES] LIBRARY..." >&2; exit 2; }
[ -n "$names" ] || names=$("$program" list)

# run KEY ENVIRONMENT...: lines "KEY world first step"
run() {
    local key=$1
    shift
    env "$@" "$program" time "$name" "$from" "$steps" | sed "s/^/$key /"
}

for name in $names; do
    for ((k = 0; k < processes; k++)); do
        run stock K=1
        for ((i = 0; i < ${#libraries[@]}; i++)); do
            case ${libraries[i]} in
            stock) run "$i" K=1 ;;
            off) run "$i" BOOMERANG=off LD_PRELOAD="${libraries[0]}" ;;
            *) run "$i" LD_PRELOAD="${libraries[i]}" ;;
            esac
        done
    done
done | awk -v libraries="${libraries[*]}" '
    function sorted(key, n,    i, j, v) {
        for (i = 1; i <= n; i++) s[i] = value[key, i]
        for (i = 2; i <= n; i++) { v = s[i]; for (j = i - 1; j > 0 && s[j] > v; j--) s[j + 1] = s[j]; s[j + 1] = v }
    }
    function median(key, n) { sorted(key, n); return n % 2 ? s[(n + 1) / 2] : (s[n / 2] + s[n / 2 + 1]) / 2 }
    function add(key, v) { value[key, ++count[key]] = v }
    {
        if (!($2 in seen)) { seen[$2] = 1; world[++worlds] = $2 }
        add($1 " step " $2, $4)
        add($1 " first " $2, $3)
        if ($1 == "stock") last = $4
        else add($1 " ratio " $2, last / $4)
    }
    END {
        many = split(libraries, name, " ")
        printf "%-16s %9s", "world", "stock us"
        for (i = 0; i < many; i++) printf " %9s %6s %6s", substr(name[i + 1], length(name[i + 1]) > 9 ? length(name[i + 1]) - 8 : 1), "ratio", "spread"
        print ""
        for (w = 1; w <= worlds; w++) {
            stock = median("stock step " world[w], count["stock step " world[w]])
            printf "%-16s %9.3f", world[w], stock
            for (i = 0; i < many; i++) {
                key = i " step " world[w]
                ours = median(key, count[key])
                key = i " ratio " world[w]
                n = count[key]
                sorted(key, n)
                spread = (s[int((3 * n + 3) / 4)] - s[int((n + 3) / 4)]) / 2 / sqrt(n)
                printf " %9.3f %6.3f %6.3f", ours, stock / ours, spread
                sum[i] += log(stock / ours)
                if (stock > 2) { above[i] += log(stock / ours) }
                if (!(i in least) || stock / ours < least[i]) least[i] = stock / ours
                add(i " start", median(i " first " world[w], count[i " first " world[w]]) - median("stock first " world[w], count["stock first " world[w]]))
            }
            print ""
            if (stock > 2) large++
        }
        for (i = 0; i < many; i++)
            printf "%s: geometric mean %.3f, of the %d above 2 us %.3f, least %.3f; start %.0f us\n", name[i + 1], exp(sum[i] / worlds), large, large ? exp(above[i] / large) : 0, least[i], median(i " start", worlds)
    }'
