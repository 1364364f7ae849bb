// SPDX-License-Identifier: MIT
#include "progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <sys/ioctl.h>
#include <unistd.h>

namespace testbed {
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

void Progress::Tick() {
    if (std::chrono::steady_clock::now() - m_lastDraw >= kBetweenDraws)
        Draw();
}

void Progress::Finish() {
    ++m_done;
    m_part = 0.0;
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
