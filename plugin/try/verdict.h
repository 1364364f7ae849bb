// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TRY_VERDICT_H
#define BOOMERANG_TRY_VERDICT_H

#include <optional>
#include <string>
#include <vector>

#include "try/run.h"

namespace bmr::trial {

/// All runs of one game.
struct Trial {
    std::vector<std::string> command;
    std::string program; ///< the file that was started
    std::string preload; ///< LD_PRELOAD: the library, if the game is not linked with it, and what this
                         ///< process has there
    bool preloadedAsItIs = false; ///< what this process has there is the library, too
    Run asItIs;
    std::vector<Run> off, on;  ///< in turns: off[0], on[0], off[1], ...
    std::optional<Run> verify; ///< where the library is at work
};

/// What the shell says of a program that is not there.
constexpr const char *kShellsStatus = "exit status 127";
std::string EndOf(const Run &run);
bool EndedBadly(const Run &run);
/// A run that was ended since its time was over has no end to be compared.
bool EndOtherwise(const Run &a, const Run &b);
bool AnyEndsOtherwise(const Trial &trial);

/// How much shorter steps are, over the steps that all runs have taken: stock's time over Boomerang's.
struct Ratio {
    size_t steps = 0;                    ///< 0: nothing can be compared, and nothing else is set
    double stock = 0.0, boomerang = 0.0; ///< microseconds a step: the median of the rounds' means
    double ratio = 0.0;                  ///< of these two
    double least = 0.0, greatest = 0.0;  ///< of the rounds
    size_t rounds = 0;
    /// Is every round on the same side of 1?
    bool Tells() const { return least > 1.0 || greatest < 1.0; }
};
Ratio RatioOf(const Trial &trial);

enum class Outcome {
    kAtWork,        ///< the same answers, and it was measured
    kDifference,    ///< an answer differs from Box2D's, or the game ends otherwise
    kNotAtWork,     ///< the library does nothing for this game as it is built
    kFailsByItself, ///< the game does not run without the library either
};

/// Ahead of all other runs: can the game be tried at all? kAtWork: it can.
Outcome JudgeAsItIs(const Trial &trial);
/// Of all runs; or of asItIs and off[0], if no step was seen.
Outcome Judge(const Trial &trial);

/// One paragraph, what was found, and one, what to do next. Lines of `columns` at most, but for commands.
std::string Explain(const Trial &trial, Outcome outcome, int columns);
/// The same as a JSON object.
std::string ExplainAsJson(const Trial &trial, Outcome outcome);

} // namespace bmr::trial

#endif
