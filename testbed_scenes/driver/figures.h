// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_FIGURES_H
#define BOOMERANG_TESTBED_FIGURES_H

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare.h"

namespace testbed {

/// The figures of one scene, worked out from its workers' summaries. Names are the columns of the CSV file
/// and, split at the dots, the keys of the JSON file; an unknown figure has no value.
class Figures {
public:
    explicit Figures(const SceneResult &result);

    std::optional<double> operator[](const std::string &name) const;
    const std::vector<std::pair<std::string, std::optional<double>>> &All() const & { return m_values; }
    /// A loop over the values of a temporary would outlive them.
    void All() && = delete;

private:
    void Add(const std::string &name, std::optional<double> value) { m_values.emplace_back(name, value); }
    void AddCounts(const SceneResult &result);
    void AddEvents(const SceneResult &result);
    void AddTimes(const SceneResult &result);

    std::vector<std::pair<std::string, std::optional<double>>> m_values;
};

/// The middle value, or the mean of the two in the middle; nothing of nothing.
std::optional<double> Median(std::vector<double> values);

/// Nothing of nothing.
std::optional<double> GeometricMean(const std::vector<double> &values);

/// A column of a table of scenes: its heading, the name of its figure, its decimals.
struct SceneColumn {
    const char *group, *name, *figure;
    int decimals;
    bool brief = false; ///< shown beside the verdicts, too
};

/// A table of scenes, wherever it is shown: on a terminal or on a page.
struct SceneTable {
    const char *title;
    std::vector<SceneColumn> columns;
    std::vector<std::string> legend; ///< a line each
};

const SceneTable &TestTable();   ///< separation tests, stock against plugin
const SceneTable &BudgetTable(); ///< which pairs were looked at
const SceneTable &EventTable();  ///< what the plugin did instead
const SceneTable &ModeTable();   ///< with --structure: its events beside those of lines, and Box2D's calls
const SceneTable &VerifyTable(); ///< every answer held beside Box2D's
/// Times; medians of so many runs.
/// `accelerated`: with columns of a Box2D that was compiled with the plugin.
SceneTable TimeTable(int repeat, bool accelerated = false);

/// What the ways to have the plugin at work are called, and what "bits" are: for times and verdicts.
const std::vector<std::string> &VerdictLegend();

/// The group of columns whose figures are speed-ups.
constexpr char kRatioGroup[] = "step ratio";
/// A whole step slower than this is one to look into: what is nearer to 1 is the machine's noise.
constexpr double kSlower = 0.98;

} // namespace testbed

#endif
