# SPDX-License-Identifier: MIT
# Comments whose re-flow broke: clang-format cuts what is too long, and puts the rest on a line of its own where the next line
# has another indent. A line of a comment is torn off where
#   - its first word had no room on the line before,
#   - it is short itself, and the next line goes on with it: no deeper than that is a list's next item, a table or a title,
#   - and it is no end: a colon, or a full stop ahead of a line with the same indent.
# Prints FILE:LINE: TEXT.
BEGIN { limit = 110; short = 74 }

# The comment that a line is, or ends with: its column, its marker with the blanks behind it, its text.
function parse(line) {
    column = -1
    if (!match(line, /\/\/\/?<? +[^ ]/)) return 0
    column = RSTART
    alone = substr(line, 1, RSTART - 1) ~ /^ *$/
    marker = substr(line, RSTART, RLENGTH - 1)
    text = substr(line, RSTART + RLENGTH - 1)
    return 1
}

function first_word(s) { sub(/ .*/, "", s); return s }

FNR == 1 { before = ""; before_column = -1; torn = 0 }
{
    found = parse($0)
    bare = marker
    sub(/ +$/, "", bare)
    if (torn && found && alone && column == torn_column && bare == torn_bare && length(marker) >= torn_indent &&
        text !~ /^(- |[*] |[|@]|[0-9]+[.] |[a-z][)] |SPDX|clang-format|NOLINT)/ && text !~ /[^ ]   *[^ ]/ && torn_text !~ /[^ ]   *[^ ]/ &&
        torn_length + 1 + length(first_word(text)) < limit && !(torn_text ~ / .* .*:$/) &&
        !(torn_text ~ /[.;]$/ && length(marker) == torn_indent))
        print FILENAME ":" FNR - 1 ": " torn_text
    torn = 0
    if (found && alone && before_column == column && length($0) < short && length(before) + 1 + length(first_word(text)) >= limit) {
        torn = 1
        torn_column = column
        torn_bare = bare
        torn_indent = length(marker)
        torn_text = text
        torn_length = length($0)
    }
    before = $0
    before_column = found ? column : -1
}
