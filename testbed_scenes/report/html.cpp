// SPDX-License-Identifier: MIT
#include "report/html.h"

#include <algorithm>

namespace testbed {

std::string Escaped(const std::string &text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        case '"':
            escaped += "&quot;";
            break;
        default:
            escaped += c;
        }
    }
    return escaped;
}

namespace {

using Columns = std::vector<HtmlTable::Column>;

size_t GroupEnd(const Columns &columns, size_t begin) {
    size_t end = begin + 1;
    while (end < columns.size() && !columns[begin].group.empty() &&
           columns[end].group == columns[begin].group)
        ++end;
    return end;
}

const char *Divider(const Columns &columns, size_t column) {
    const bool starts =
        column == 0 || columns[column].group.empty() || columns[column].group != columns[column - 1].group;
    return starts ? " class=\"first\"" : "";
}

void WriteHead(std::ostream &out, const HtmlTable &table) {
    const Columns &columns = table.columns;
    const bool grouped = std::any_of(columns.begin(), columns.end(),
                                     [](const HtmlTable::Column &column) { return !column.group.empty(); });
    const char *rows = grouped ? " rowspan=\"2\"" : "";
    out << "<thead>\n<tr><th scope=\"col\"" << rows << ">" << Escaped(table.corner) << "</th>";
    for (size_t i = 0; i < columns.size(); i = GroupEnd(columns, i)) {
        if (columns[i].group.empty())
            out << "<th scope=\"col\"" << rows << Divider(columns, i) << ">" << Escaped(columns[i].name)
                << "</th>";
        else
            out << "<th scope=\"colgroup\" class=\"group\" colspan=\"" << GroupEnd(columns, i) - i << "\">"
                << Escaped(columns[i].group) << "</th>";
    }
    out << "</tr>\n";
    if (grouped) {
        out << "<tr>";
        for (size_t i = 0; i < columns.size(); ++i)
            if (!columns[i].group.empty())
                out << "<th scope=\"col\"" << Divider(columns, i) << ">" << Escaped(columns[i].name)
                    << "</th>";
        out << "</tr>\n";
    }
    out << "</thead>\n";
}

} // namespace

void HtmlTable::Write(std::ostream &out, const std::string &id) const {
    out << "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-labelledby=\"" << id << "\">\n<table>\n"
        << "<caption id=\"" << id << "\"><span>" << Escaped(caption) << "</span></caption>\n";
    WriteHead(out, *this);
    out << "<tbody>\n";
    for (const std::vector<Cell> &row : rows) {
        out << "<tr><th scope=\"row\">" << Escaped(row.front().text) << "</th>";
        for (size_t i = 1; i < row.size(); ++i) {
            std::string kinds = row[i].kind;
            if (*Divider(columns, i - 1) != '\0')
                kinds += kinds.empty() ? "first" : " first";
            out << "<td" << (kinds.empty() ? "" : " class=\"" + kinds + "\"") << ">" << Escaped(row[i].text)
                << "</td>";
        }
        out << "</tr>\n";
    }
    out << "</tbody>\n</table>\n</div>\n";
}

} // namespace testbed
