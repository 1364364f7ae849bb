#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# check_quoted.sh PROGRAM SOURCE README: the fenced block that follows the line "<!-- from NAME.c -->" (NAME.py) is a part of the source,
# and the one that follows "<!-- output of NAME -->" is all that the program prints.
set -uo pipefail
program=${1:?} source=${2:?} readme=${3:?}
file=$(basename "$source")
name=${file%.*}

# The lines of the fenced block after a marker, read from standard input.
block() {
    awk -v marker="$1" '$0 == marker { armed = 1; next }
        /^```/ { if (inside) exit; if (armed) { inside = 1; next } }
        inside { print }'
}

# Is a text right?
agrees() {
    local code output
    code=$(block "<!-- from $file -->")
    [ -n "$code" ] && [[ $(<"$source") == *"$code"* ]] || { echo "$file is not quoted as it is"; return 1; }
    output=$(block "<!-- output of $name -->" <<<"$text")
    [ -n "$output" ] && [ "$output" = "$printed" ] || { echo "$name prints:"; echo "$printed"; return 1; }
}

fail() {
    echo "FAILED: $*"
    exit 1
}
printed=$("$program") || fail "$name does not run"
text=$(<"$readme")
agrees <<<"$text" || fail "$readme"

# The control: a text with another word in the code, or another figure in the output, is wrong.
good=$text
text=${good//bmr_/bmr_other_}
text=${text//bmr./other.}
agrees <<<"$text" >/dev/null && fail "a wrong quotation was not noticed"
text=${good//level 0/level 7}
text=${text//the same bodies/other bodies}
text=${text//piece 0/piece 7}
text=${text//of 9 pairs/of 8 pairs}
text=${text//of the energy left/of the energy lost}
text=${text//audits: all true/audits: none}
agrees <<<"$text" >/dev/null && fail "a wrong output was not noticed"
echo "passed: $name"
