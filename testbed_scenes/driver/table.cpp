// SPDX-License-Identifier: MIT
#include "table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace testbed {

std::string Fixed(std::optional<double> number, int decimals) {
    if (!number)
        return "-";
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, *number);
    return text;
}

std::string General(double number, int digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    return text;
}

std::string Counted(double number) {
    std::string text = Fixed(number, number < 9.95 && number != std::floor(number) ? 1 : 0);
    for (size_t end = std::min(text.find('.'), text.size()); end > 3; end -= 3)
        text.insert(end - 3, ",");
    return text;
}

std::string QuestionsFor(const std::string &what, double questions, const std::string &where, double events,
                         const std::string &ofWhat) {
    std::string text = what + ": " + Counted(questions) + " questions " + where + ", ";
    if (events == 0.0)
        return text + "no event" + ofWhat;
    return text + Counted(events) + (events == 1.0 ? " event" : " events") + ofWhat + ": one for " +
           Counted(questions / events);
}

std::string Styled(const std::string &text, Style style, bool colour) {
    if (!colour)
        return text;
    switch (style) {
    case Style::Good:
        return "\033[32m" + text + "\033[0m";
    case Style::Bad:
        return "\033[1;31m" + text + "\033[0m";
    case Style::Faint:
        return "\033[2m" + text + "\033[0m";
    case Style::Strong:
        return "\033[1m" + text + "\033[0m";
    case Style::Plain:
        break;
    }
    return text;
}

void Table::AddColumn(const std::string &group, const std::string &name) {
    m_columns.push_back({group, name});
}

void Table::AddRow(std::vector<Cell> cells) {
    cells.resize(m_columns.size());
    m_rows.push_back(std::move(cells));
}

size_t Table::GroupEnd(size_t begin) const {
    size_t end = begin + 1;
    while (end < m_columns.size() && m_columns[end].group == m_columns[begin].group)
        ++end;
    return end;
}

size_t Table::GapBefore(size_t column) const {
    if (column == 0)
        return 0;
    return m_columns[column].group == m_columns[column - 1].group ? 2 : 4;
}

std::vector<size_t> Table::Widths() const {
    std::vector<size_t> widths;
    for (size_t i = 0; i < m_columns.size(); ++i) {
        size_t width = m_columns[i].name.size();
        for (const auto &row : m_rows)
            width = std::max(width, row[i].text.size());
        widths.push_back(width);
    }
    // A heading wider than its columns widens the last of them.
    for (size_t begin = 0; begin < m_columns.size(); begin = GroupEnd(begin)) {
        size_t total = 0;
        for (size_t i = begin; i < GroupEnd(begin); ++i)
            total += widths[i] + (i > begin ? GapBefore(i) : 0);
        const size_t wanted = m_columns[begin].group.size();
        if (wanted > total)
            widths[GroupEnd(begin) - 1] += wanted - total;
    }
    return widths;
}

void Table::Print(std::ostream &out, bool colour) const {
    const std::vector<size_t> widths = Widths();
    std::string groups, names;
    for (size_t begin = 0; begin < m_columns.size(); begin = GroupEnd(begin)) {
        groups += std::string(GapBefore(begin), ' ');
        size_t total = 0;
        for (size_t i = begin; i < GroupEnd(begin); ++i)
            total += widths[i] + (i > begin ? GapBefore(i) : 0);
        const std::string &group = m_columns[begin].group;
        // A rule over its columns says how far a heading reaches.
        groups += group.empty()
                      ? std::string(total, ' ')
                      : group + (group.size() + 1 < total ? " " + std::string(total - group.size() - 1, '-')
                                                          : std::string(total - group.size(), ' '));
    }
    for (size_t i = 0; i < m_columns.size(); ++i) {
        const std::string pad(widths[i] - m_columns[i].name.size(), ' ');
        names +=
            std::string(GapBefore(i), ' ') + (i == 0 ? m_columns[i].name + pad : pad + m_columns[i].name);
    }
    auto trimmed = [](std::string line) {
        line.erase(line.find_last_not_of(' ') + 1);
        return line;
    };
    groups = trimmed(groups);
    if (!groups.empty())
        out << Styled(groups, Style::Faint, colour) << '\n';
    out << Styled(trimmed(names), Style::Strong, colour) << '\n';
    for (const auto &row : m_rows) {
        for (size_t i = 0; i < row.size(); ++i) {
            const std::string pad(widths[i] - row[i].text.size(), ' ');
            const std::string text = Styled(row[i].text, row[i].style, colour);
            const bool isLast = i + 1 == row.size();
            out << std::string(GapBefore(i), ' ') << (i == 0 ? text + (isLast ? "" : pad) : pad + text);
        }
        out << '\n';
    }
}

} // namespace testbed
