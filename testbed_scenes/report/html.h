// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_HTML_H
#define BOOMERANG_TESTBED_HTML_H

#include <ostream>
#include <string>
#include <vector>

namespace testbed {

/// Text that means itself in HTML, in an attribute as well.
std::string Escaped(const std::string &text);

/// A table with a caption and one or two rows of headings; its first column names the rows.
struct HtmlTable {
    struct Cell {
        std::string text;
        const char *kind = ""; ///< a class of the style sheet: "good", "bad", "none"
    };
    struct Column {
        std::string group, name; ///< neighbours of one group stand under one heading
    };

    std::string caption;
    std::string corner; ///< what the rows are
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows; ///< each begins with its name

    /// `id` is unique in the page: where the table is wider than the screen it scrolls by itself, and the
    /// frame that scrolls is named after the caption.
    void Write(std::ostream &out, const std::string &id) const;
};

} // namespace testbed

#endif
