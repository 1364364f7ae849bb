// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_TRIAL_H
#define BOOMERANG_GLUE_TRIAL_H

#include <cstdint>

#include "base/compiler.h"
#include "tell/trial_page.h"

/// @file
/// `boomerang try` (plugin/try) starts a game with a file for the library to write to: how long each step
/// took, also in Mode::Off, and what is at work. Nothing of it is there on Windows.

namespace bmr {

namespace internal {
extern TrialPage *trial;
extern BMR_THREAD bool inTimedStep;
} // namespace internal

/// Is this game being tried? A load and a test.
inline bool IsTried() {
    return BMR_RARELY(internal::trial != nullptr);
}

/// Maps the file that the environment names, once; says on stderr if it cannot.
void OpenTrial();

/// Does whoever tries this game want counts?
bool TrialCounts();

/// Tells `boomerang try` why it will see no step of this game.
void TellTrial(const char *whyNoStep);

/// Lives as long as a step of a game that is tried, and tells how long it took, unless it is part of another
/// step of this thread or ends by an exception.
class TimedStep {
public:
    TimedStep();
    void End();
    ~TimedStep();
    TimedStep(const TimedStep &) = delete;
    TimedStep &operator=(const TimedStep &) = delete;

private:
    int64_t m_begin;
    bool m_outermost;
};

} // namespace bmr

#endif
