// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_COMPARE_H
#define BOOMERANG_TESTBED_COMPARE_H

#include <cstdint>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "terminal.h"
#include "workers.h"

namespace testbed {

struct CompareOptions {
    WorkerOptions worker;
    /// Steps of each scene; nothing means what the scene itself asks for.
    std::optional<int64_t> steps;
    /// Timed runs of each side.
    int repeat = 5;
    bool time = true;
    /// The control: at this step the plugin's worker nudges one velocity, and a difference must be found.
    std::optional<int64_t> perturb;
};

/// The first difference between two runs.
struct Difference {
    /// The side that differs from stock.
    Side side = Side::Plugin;
    int64_t step = 0;
    /// Which of the three hashes differ: "bodies", "bodies, contacts" and so on.
    std::string hashes;
    /// The first field that differs ("body 12 position.x") and its values; empty if the dumps of that step
    /// agree.
    std::string field, stock, plugin;
    /// Fields that differ at that step.
    int64_t fields = 0;
};

enum class Verdict { Identical, Different, Failed };

const char *NameOf(Verdict verdict);

// A json moves without throwing, though clang-tidy takes its assertions for throws.
// NOLINTNEXTLINE(bugprone-exception-escape)
struct SceneResult {
    SceneInfo scene;
    int64_t steps = 0;
    Verdict verdict = Verdict::Failed;      ///< Identical where all variants are
    std::map<Side, Verdict> variants;       ///< ways to have the plugin at work, held against stock
    std::string failure;                    ///< why no verdict was reached, with the worker's last words
    std::optional<Difference> difference;   ///< set where a variant is Different: the earliest
    nlohmann::json stockCount, pluginCount; ///< summaries of the counting runs; null where there were none
    /// Summaries of the timed runs, paired by index.
    std::vector<nlohmann::json> stockTimes, pluginTimes;
};

/// Worker runs that comparing one scene takes: the unit of the progress bar.
int RunsPerScene(const CompareOptions &options);

/// Compares one scene: hashes step by step, then (if they agree) counts, then times. What a worker does wrong
/// ends up in the result, so that one bad scene does not take the others along.
SceneResult CompareScene(const Workers &workers, const SceneInfo &scene, const CompareOptions &options,
                         Progress &progress);

/// One line or a few, without a newline at the end: what differs, or what failed, where not all is identical.
std::string Explain(const SceneResult &result);

/// What stock asked in a step and how many events answered that with the plugin, of all scenes that were
/// counted: a line, or nothing.
void PrintQuestions(std::ostream &out, const std::vector<SceneResult> &results, bool colour);
/// One line: how many are identical, and by what factor a step is faster.
void PrintVerdict(std::ostream &out, const std::vector<SceneResult> &results, bool colour);
/// Scene by scene, for at most 132 columns: whether the bits agree and how long a step takes; with `details`
/// all other tables, too, and a legend.
void PrintTables(std::ostream &out, const std::vector<SceneResult> &results, const CompareOptions &options,
                 bool details, bool colour);
} // namespace testbed

#endif
