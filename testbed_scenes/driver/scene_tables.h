// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_SCENE_TABLES_H
#define BOOMERANG_TESTBED_SCENE_TABLES_H

#include <string>
#include <vector>

namespace testbed {

/// A column of a table of scenes: its heading, the name of its figure (see driver/figures.h), its decimals.
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
