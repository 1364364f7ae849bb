// SPDX-License-Identifier: MIT
#include "terminal.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <sys/ioctl.h>
#include <unistd.h>

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

std::string Padded(std::string text, size_t width) {
    text.resize(std::max(width, text.size() + 1), ' ');
    return text;
}

std::string Styled(const std::string &text, Style style, bool colour) {
    static constexpr const char *codes[] = {"0", "32", "1;31", "2", "1"}; // in the order of Style
    if (!colour || style == Style::Plain)
        return text;
    return std::string("\033[") + codes[static_cast<int>(style)] + "m" + text + "\033[0m";
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

size_t Table::GroupWidth(const std::vector<size_t> &widths, size_t begin) const {
    size_t total = widths[begin];
    for (size_t i = begin + 1; i < GroupEnd(begin); ++i)
        total += widths[i] + GapBefore(i);
    return total;
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
        const size_t total = GroupWidth(widths, begin);
        widths[GroupEnd(begin) - 1] += std::max(m_columns[begin].group.size(), total) - total;
    }
    return widths;
}

void Table::Print(std::ostream &out, bool colour) const {
    const std::vector<size_t> widths = Widths();
    std::string groups;
    for (size_t begin = 0; begin < m_columns.size(); begin = GroupEnd(begin)) {
        std::string group = m_columns[begin].group;
        const size_t left = GroupWidth(widths, begin) - group.size();
        // A rule over its columns says how far a heading reaches.
        group += group.empty() || left < 2 ? std::string(left, ' ') : " " + std::string(left - 1, '-');
        groups += std::string(GapBefore(begin), ' ') + group;
    }
    groups.erase(groups.find_last_not_of(' ') + 1);
    if (!groups.empty())
        out << Styled(groups, Style::Faint, colour) << '\n';
    std::vector<std::vector<Cell>> rows(1);
    for (const Column &column : m_columns)
        rows[0].push_back({column.name, Style::Strong});
    rows.insert(rows.end(), m_rows.begin(), m_rows.end());
    for (const auto &row : rows) {
        for (size_t i = 0; i < row.size(); ++i) {
            const std::string pad(widths[i] - row[i].text.size(), ' ');
            const std::string text = Styled(row[i].text, row[i].style, colour);
            const bool isLast = i + 1 == row.size();
            out << std::string(GapBefore(i), ' ') << (i == 0 ? text + (isLast ? "" : pad) : pad + text);
        }
        out << '\n';
    }
}

namespace {

constexpr int kBarWidth = 28;
constexpr int kWidthWhenUnknown = 80;
/// More often than this nobody can read, and a terminal over a slow line would hold the workers up.
constexpr std::chrono::milliseconds kBetweenDraws{100};
/// Before this much is done, a forecast is a guess that jumps about.
constexpr double kForecastFrom = 0.02;

bool IsCapableTerminal(int fd) {
    const char *term = std::getenv("TERM");
    return isatty(fd) != 0 && term != nullptr && std::strcmp(term, "dumb") != 0;
}

int TerminalWidth() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
        return kWidthWhenUnknown;
    return size.ws_col;
}

std::string Clock(double seconds) {
    const long whole = std::lround(seconds);
    char text[32];
    std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
    return text;
}

} // namespace

bool WantsColour(int fd) {
    // https://no-color.org: any value but the empty one.
    const char *noColour = std::getenv("NO_COLOR");
    return IsCapableTerminal(fd) && (noColour == nullptr || noColour[0] == '\0');
}

Progress::Progress(int units, bool quiet)
    : m_enabled(!quiet && IsCapableTerminal(STDERR_FILENO)), m_units(std::max(units, 1)),
      m_start(std::chrono::steady_clock::now()), m_lastDraw(m_start) {}

Progress::~Progress() {
    Clear();
}

void Progress::Show(const std::string &what, double part) {
    m_part = std::clamp(part, 0.0, 1.0);
    const bool isNew = what != m_what;
    m_what = what;
    if (isNew || std::chrono::steady_clock::now() - m_lastDraw >= kBetweenDraws)
        Draw();
}

void Progress::Finish() {
    FinishUpTo(m_done + 1);
}

void Progress::FinishUpTo(int units) {
    m_done = units;
    m_part = 0.0;
}

void Progress::Clear() {
    if (!m_visible)
        return;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    m_visible = false;
}

void Progress::Draw() {
    if (!m_enabled)
        return;
    m_lastDraw = std::chrono::steady_clock::now();
    const double elapsed = std::chrono::duration<double>(m_lastDraw - m_start).count();
    const double fraction = std::min((m_done + m_part) / m_units, 1.0);
    const int filled = static_cast<int>(fraction * kBarWidth);
    std::string line = "[" + std::string(static_cast<size_t>(filled), '#') +
                       std::string(static_cast<size_t>(kBarWidth - filled), '.') + "] ";
    char percent[16];
    std::snprintf(percent, sizeof percent, "%3d %%", static_cast<int>(fraction * 100.0));
    line += percent;
    line += fraction < kForecastFrom ? std::string("  ETA  ...")
                                     : "  ETA " + Clock(elapsed * (1.0 - fraction) / fraction);
    line += "  " + m_what;
    // A line that wraps could not be taken back.
    line.resize(std::min(line.size(), static_cast<size_t>(std::max(TerminalWidth() - 1, 1))));
    std::fprintf(stderr, "\r\033[K%s", line.c_str());
    std::fflush(stderr);
    m_visible = true;
}

} // namespace testbed
