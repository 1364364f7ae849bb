// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_TERMINAL_H
#define BOOMERANG_TESTBED_TERMINAL_H

#include <chrono>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

/// @file
/// What a terminal shows: numbers, tables, a progress bar.

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

/// With blanks behind it up to a width, and one blank in any case.
std::string Padded(std::string text, size_t width);

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

    struct Column {
        std::string group, name;
    };

    /// Columns with the same group stand under one heading; a new group is set off by a wider gap.
    Table(std::initializer_list<Column> columns) : m_columns(columns) {}
    void AddColumn(const std::string &group, const std::string &name) { m_columns.push_back({group, name}); }
    void AddRow(std::vector<Cell> cells);
    void Print(std::ostream &out, bool colour) const;

private:
    std::vector<size_t> Widths() const;
    /// Of the columns of the group that begins there, with the gaps between them.
    size_t GroupWidth(const std::vector<size_t> &widths, size_t begin) const;
    size_t GroupEnd(size_t begin) const;
    size_t GapBefore(size_t column) const;

    std::vector<Column> m_columns;
    std::vector<std::vector<Cell>> m_rows;
};

/// Whether escape codes may be written to this file descriptor: a terminal, not dumb, and NO_COLOR is not
/// set.
bool WantsColour(int fd);

/// One line on stderr, rewritten in place: what is being done, how much of the whole, how long it will take.
/// Writes nothing at all when stderr is no terminal, or when it is to be quiet.
class Progress {
public:
    Progress(int units, bool quiet);
    ~Progress();
    Progress(const Progress &) = delete;
    Progress &operator=(const Progress &) = delete;

    /// What is being done now, and how much of the present unit (0 to 1).
    void Show(const std::string &what, double part = 0.0);
    /// One more unit is done.
    void Finish();
    /// So many units are done or no longer needed.
    void FinishUpTo(int units);
    /// Takes the line away, so that other output can be written; the next Show brings it back.
    void Clear();

private:
    void Draw();

    bool m_enabled;
    bool m_visible = false;
    int m_units;
    int m_done = 0;
    double m_part = 0.0;
    std::string m_what;
    std::chrono::steady_clock::time_point m_start;
    std::chrono::steady_clock::time_point m_lastDraw;
};

} // namespace testbed

#endif
