# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# clang-format over all sources, and comments that it tore

check_format() {
    local log=$work/clang-format status=0
    (cd "$root" && sources '*.c' '*.h' '*.cpp' | xargs -n 20 -P "$jobs" clang-format --dry-run -Werror 2>"$log") || status=1
    [ "$status" -eq 0 ] || sed -nE 's/^([^:]+):[0-9]+:.*/to mend it: clang-format -i \1/p' "$log" | sort -u
    return "$status"
}

torn_comments() { awk -f "$root/tests/stages/torn_comments.awk" "$@"; }

# Where clang-format cuts a line of a comment, it cannot put the rest to the next line if that has another indent.
check_comments() {
    local log=$work/torn-comments
    (cd "$root" && sources '*.c' '*.h' '*.cpp' | xargs awk -f tests/stages/torn_comments.awk) >"$log"
    sed 's/^/a comment was torn: /' "$log"
    [ ! -s "$log" ]
}

# The control: the lines that end in TORN are found, and no others.
check_torn_comments_are_found() {
    local sample=$work/torn.c
    cat >"$sample" <<'SAMPLE'
/// A sentence that fills its line up to the very last column of all the columns that there are, and that was
/// torn TORN
/// off where somebody put in a word; the line after that goes on with the same indent as the one before it,
/// as if nothing had happened.
// - An item of a list whose continuation has a hanging indent, so that what was cut off stands alone in its
// own line TORN
//   while the rest of the item goes on below it, deeper in, where it has always been and where it is now.
int x; ///< a comment behind code that is long enough to be cut where the column is full, which is where it ends
    /// A short line.
    /// Another one, whose first word had room on the line before: that is how its author broke the paragraph.
/// The end of a paragraph is short, too, and it is not torn, for behind it there is nothing that goes on with
/// it.
///
/// A line that ends with a colon is followed by a list or a formula, and it may be as short as it likes to be,
/// as here:
///     first    a table, whose columns are kept apart by blanks
///     second   and the next row of it, which is much like the one before it, and nearly as long as a line.
/// The last word of a sentence may stand alone, where the next sentence begins a line of its own, for emphasis
/// here.
/// And this is the next sentence.
SAMPLE
    # The marks stand behind what is looked at.
    sed 's/ TORN$//' "$sample" >"$work/unmarked.c"
    diff <(grep -n ' TORN$' "$sample" | cut -d : -f 1) <(torn_comments "$work/unmarked.c" | cut -d : -f 2)
}

stage_format() {
    check "clang-format" check_format
    check "comments" check_comments
    check "torn comments are found" check_torn_comments_are_found
}
