// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_REPORT_H
#define BOOMERANG_TESTBED_REPORT_H

#include <ostream>
#include <vector>

#include "compare.h"

namespace testbed {

/// What stock asked in a step and how many events answered that with the plugin, of all scenes that were
/// counted: a line, or nothing.
void PrintQuestions(std::ostream &out, const std::vector<SceneResult> &results, bool colour);
/// One line: how many are identical, and by what factor a step is faster.
void PrintVerdict(std::ostream &out, const std::vector<SceneResult> &results, bool colour);
/// Scene by scene, for at most 132 columns: whether the bits agree and how long a step takes; with `details`
/// all other tables, too, and a legend.
void PrintTables(std::ostream &out, const std::vector<SceneResult> &results, const CompareOptions &options,
                 bool details, bool colour);
/// The tables for a page of documentation: first the best, the middle and the worst scene by the whole step,
/// then a table of times and one of each kind of count. A ratio whose pairs of runs lie on both sides of 1 is
/// "no difference".
void WriteMarkdown(std::ostream &out, const std::vector<SceneResult> &results, const CompareOptions &options);

} // namespace testbed

#endif
