// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_TABLE_H
#define BOOMERANG_TESTBED_TABLE_H

#include <ostream>
#include <string>
#include <vector>

#include "number_text.h"

namespace testbed {

enum class Style { Plain, Good, Bad, Faint, Strong };

/// The text in its colour; the text alone where colours are not wanted.
std::string Styled(const std::string &text, Style style, bool colour);

/// A table in plain text: two header lines (the upper one names groups of columns), numbers to the right, the
/// first column to the left.
class Table {
public:
    struct Cell {
        std::string text;
        Style style = Style::Plain;
    };

    /// Columns with the same group stand under one heading; a new group is set off by a wider gap.
    void AddColumn(const std::string &group, const std::string &name);
    void AddRow(std::vector<Cell> cells);
    void Print(std::ostream &out, bool colour) const;

private:
    struct Column {
        std::string group, name;
    };
    std::vector<size_t> Widths() const;
    size_t GroupEnd(size_t begin) const;
    size_t GapBefore(size_t column) const;

    std::vector<Column> m_columns;
    std::vector<std::vector<Cell>> m_rows;
};

} // namespace testbed

#endif
