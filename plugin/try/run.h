// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TRY_RUN_H
#define BOOMERANG_TRY_RUN_H

#include <cstdint>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tell/trial_page.h"

namespace bmr::trial {

/// How long a run may last: until either is reached, or until the game ends by itself.
struct Limits {
    double seconds = 5.0;  ///< by the clock
    uint32_t steps = 0;    ///< 0: any number
    double patience = 3.0; ///< seconds from the wish to end until the game is killed
};

/// One run of the game and what is known of it afterwards.
struct Run {
    bool ended = false; ///< by itself, and not since its time was over
    int status = 0;     ///< as waitpid gives it; of a run that ended by itself
    double seconds = 0.0;
    std::vector<float> microseconds; ///< of each step
    uint32_t steps = 0;              ///< taken; microseconds has the first TrialPage::kMostSteps
    bool loaded = false;             ///< the library was, by some process of the game's
    uint64_t verified = 0, differences = 0;
    std::string way, noPass, whyNot, noStep;
    std::set<std::string> files;        ///< libraries and programs that the game's processes had in memory
    std::vector<std::string> lastWords; ///< the last lines of what the game wrote, on both streams
};

/// Thrown where a run cannot begin: no room for its files, no process.
class CannotRun : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Starts `command` with these variables in front of this process's environment ("NAME=value"; what begins
/// with BOOMERANG is not handed on) and waits. The game's output goes to a file of its own, unless `shown`.
/// With `page`, the library finds a TrialPage. `onTick(seconds, steps)` is called some times a second. All
/// processes that the game has left behind are ended with it. Ended as well where this process is asked to
/// end (SIGINT, SIGTERM): then `IsInterrupted()`.
Run RunGame(const std::vector<std::string> &command, const std::vector<std::string> &variables, bool page,
            bool shown, const Limits &limits, const std::function<void(double, uint32_t)> &onTick);

/// From here on signals that ask this process to end are noted.
void WatchForInterrupts();
bool IsInterrupted();

} // namespace bmr::trial

#endif
