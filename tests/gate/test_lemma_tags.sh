#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   test_lemma_tags.sh ROOT
#
# A lemma is found where it is realised and where it is tested: the table "statements" of core/README.md names both, and both
# carry the statement as a comment "/// Lemma 3.3(a): ...". No row without its tags, no tag without its row, and the numbered
# statements are the paper's, all of them.
set -u
root=$1
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT

numbered='Lemma 3.1
Lemma 3.2
Lemma 3.3(a)
Lemma 3.3(b)
Lemma 3.3(c)
Lemma 3.3(d)
Lemma 3.4(a)
Lemma 3.4(b)
Lemma 3.4(c)
Lemma 3.4(d)
Lemma 4.1
Lemma 4.2
Lemma 4.3
Lemma 4.4(a)
Lemma 4.4(b)
Theorem 5.1
Theorem 5.2
Theorem 5.3
Lemma 6.1
Theorem 6.2'

# The rows of the table: tag, statement, file and function, separated by tabs; one line for each place where the tag must stand.
places() {
    awk -F ' *[|] *' '
        $0 == "<!-- statements -->" { inside = 1; next }
        inside && !/^[|]/ { exit }
        inside && $2 != "the paper" && $2 !~ /^---/ {
            tag = $2
            sub(/ \([a-z][a-z0-9-]+\)$/, "", tag)
            for (column = 4; column <= 5; ++column) {
                count = split($column, parts, /; /)
                if (count == 0) print tag "\t" $3 "\t\t"
                for (i = 1; i <= count; ++i) {
                    split(parts[i], names, "`")
                    print tag "\t" $3 "\t" (column == 4 ? "core/" : "tests/") names[2] "\t" names[4]
                }
            }
        }' "$1/core/README.md"
}

# All tags: file, tag, statement, and the name of the function that the comment stands at.
tags() {
    (cd "$1" && find core tests/claims -name '*.[ch]' -o -name '*.cpp' | sort | xargs awk '
        FNR == 1 { count = 0 }
        /^\/\/\/ (Lemma|Theorem) [0-9]/ || /^\/\/\/ Section [0-9]+, [^:]*: / {
            line = substr($0, 5)
            colon = index(line, ": ")
            tag[++count] = colon ? substr(line, 1, colon - 1) "\t" substr(line, colon + 2) : line "\t"
            next
        }
        count && !/^\/\// {
            name = $0
            sub(/^TEST\(/, "", name)
            sub(/[()].*/, "", name)
            sub(/.*[ *]/, "", name)
            for (i = 1; i <= count; ++i) print FILENAME "\t" tag[i] "\t" name
            count = 0
        }')
}

# check ROOT: prints what is wrong, and nothing where all is right.
check() {
    places "$1" >"$room/places"
    tags "$1" >"$room/tags"
    [ -s "$room/places" ] || echo "core/README.md has no table of statements"
    cut -f 1 "$room/places" | grep -v '^Section' | sort -u >"$room/rows"
    comm -3 <(sort <<<"$numbered") "$room/rows" |
        sed -E 's/^\t(.*)/the paper has no \1, which the table has/; t; s/.*/the table has no &/'
    awk -F '\t' '
        FILENAME == ARGV[1] { there[$1 "\t" $2 "\t" $3 "\t" $4] = 1; next }
        { key = $3 "\t" $1 "\t" $2 ".\t" $4; asked[key] = 1
          if (!there[key]) print $3 ": " $4 " has no \"/// " $1 ": " $2 ".\"" }
        END { for (key in there) if (!asked[key]) { split(key, k, "\t"); print k[1] ": " k[4] " has a tag that no row of the table has: " k[2] ": " k[3] } }
    ' "$room/tags" "$room/places"
}

failed=0
wrong=$(check "$root")
if [ -n "$wrong" ]; then
    echo "FAILED: core/README.md, section 4, and the sources:"
    echo "$wrong"
    failed=1
fi

# The controls: a copy in which one thing is wrong. control WHAT PATTERN FILE SUBSTITUTION
mkdir -p "$room/tree/tests"
cp -r "$root/core" "$room/tree/core"
cp -r "$root/tests/claims" "$room/tree/tests"
control() {
    local what=$1 pattern=$2 file=$3
    perl -0pi -e "$4" "$room/tree/$file"
    if cmp -s "$root/$file" "$room/tree/$file"; then
        echo "FAILED: the control '$what' changes nothing"
        failed=1
    elif ! check "$room/tree" | grep -q -e "$pattern"; then
        echo "FAILED: not noticed: $what"
        failed=1
    fi
    cp "$root/$file" "$room/tree/$file"
}
control 'no tag in the code' 'bmr_hierarchy_height has no "/// Lemma 3.1' core/hierarchy/query.c 's|/// Lemma 3.1:[^\n]*\n||'
control 'no tag in the test' 'the_tiling_is_of_linear_size has no "/// Lemma 4.1' tests/claims/test_mixed.c 's|/// Lemma 4.1:[^\n]*\n||'
control 'a tag at another function' 'bmr_hierarchy_height has no' core/hierarchy/query.c \
    's|(/// Lemma 3.1:[^\n]*\n)(.*?\n}\n)|$2|s; s|\z|\n/// Lemma 3.1: here.\nvoid other(void) {\n}\n|'
control 'another statement' 'has no "/// Lemma 4.1' core/hierarchy/mixed_tiling.c 's|(/// Lemma 4.1: .*?)m\) cells|$1n) cells|'
control 'a tag that is not in the paper' 'a tag that no row of the table has: Lemma 9.9' core/hierarchy/compass.c \
    's|/// Lemma 3.3\(a\)|/// Lemma 9.9: all is well.\n/// Lemma 3.3(a)|'
control 'a tag without a statement' 'a tag that no row of the table has: Lemma 3.2' core/geometry/hull.c 's|\nstatic |\n/// Lemma 3.2\nstatic |'
control 'a row that is not in the paper' 'the paper has no Lemma 9.9' core/README.md 's/\| Lemma 3.1 /| Lemma 9.9 /'
control 'a row that is missing' 'the table has no Theorem 5.3' core/README.md 's/\| Theorem 5.3 [^\n]*\n//'
control 'no table' 'has no table' core/README.md 's/<!-- statements -->//'
[ "$failed" -eq 0 ] && echo "passed"
exit "$failed"
