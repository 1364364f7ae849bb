// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_TABLE_H
#define BOOMERANG_TESTBED_TABLE_H

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace testbed {

/// A number with so many decimals, "-" for none.
std::string Fixed(std::optional<double> number, int decimals);
/// Four digits, or as many as are wanted, and no more than tell the number.
std::string General(double number, int digits = 4);

/// "9,605"; below ten with one decimal, unless it is whole.
std::string Counted(double number);
/// "needles: 9,605 questions a step in stock, 48 events: one for 200". A question: a call of
/// b2CollidePolygons, b2TimeOfImpact or b2Distance.
std::string QuestionsFor(const std::string &what, double questions, const std::string &where, double events,
                         const std::string &ofWhat = "");

enum class Style { Plain, Good, Bad, Faint, Strong };

/// The text in its colour; the text alone where colours are not wanted.
std::string Styled(const std::string &text, Style style, bool colour);

/// Rows under columns, in plain text with two header lines: the upper one names groups of columns. Numbers
/// to the right, the first column to the left.
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
