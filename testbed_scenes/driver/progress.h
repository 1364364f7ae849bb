// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PROGRESS_H
#define BOOMERANG_TESTBED_PROGRESS_H

#include <chrono>
#include <string>

namespace testbed {

/// Whether escape codes may be written to this file descriptor: a terminal, not dumb, and NO_COLOR is not
/// set.
bool WantsColour(int fd);

/// One line on stderr, rewritten in place: what is being done, how much of the whole, how long it will take.
/// Writes nothing at all when stderr is no terminal, or when told to be quiet.
class Progress {
public:
    Progress(int units, bool quiet);
    ~Progress();
    Progress(const Progress &) = delete;
    Progress &operator=(const Progress &) = delete;

    /// What is being done now, and how much of the present unit (0 to 1).
    void Show(const std::string &what, double part);
    /// Draws again, for the clock's sake.
    void Tick();
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
