// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_EXIT_LINE_H
#define BOOMERANG_GLUE_EXIT_LINE_H

#include <cstdint>

#include "base/compiler.h"

/// @file
/// What the library says when the process ends. With BOOMERANG_VERBOSE=1, also in Mode::Off, it is one line
/// on stderr: how many steps the process took, how long each was, and how many pairs it had.
///
/// `boomerang try` (plugin/boomerang.sh.in) reads that line. BOOMERANG_STEPS=N, which it sets, ends the count
/// after N steps, and says the line at once.

namespace bmr {

namespace internal {
extern bool timesSteps;
} // namespace internal

/// Are steps timed, and their pairs counted? A load and a test.
inline bool StepsAreTimed() {
    return BMR_RARELY(internal::timesSteps);
}

/// From here on. Also for Options::verbosity.
void TimeSteps();
/// Does so if the environment asks for it. To be called ahead of the first step, any number of times.
void ReadVerbosity();
/// Do tests want counts (BOOMERANG_COUNTS names a file, which gets them when the process ends)?
bool CountsAreWanted();

/// Lives as long as a step that is timed. A step inside another one is a part of it; one that ends by an
/// exception is not counted.
class TimedStep {
public:
    TimedStep();
    void End() const;
    ~TimedStep();
    TimedStep(const TimedStep &) = delete;
    TimedStep &operator=(const TimedStep &) = delete;

private:
    int64_t m_begin;
    bool m_outermost;
};

/// Where StepsAreTimed: the contacts of awake bodies in one pass over contacts, and those that touch.
void NotePairs(uint64_t awake, uint64_t touching);

/// Calls it when the process ends: by exit, or by SIGINT, SIGTERM or SIGHUP where steps are timed and the
/// game does not handle that signal itself. At most four functions.
void CallAtEnd(void (*say)());

} // namespace bmr

#endif
