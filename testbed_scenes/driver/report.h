// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_REPORT_H
#define BOOMERANG_TESTBED_REPORT_H

#include <ostream>
#include <vector>

#include "compare.h"

namespace testbed {

/// The tables, for at most 120 columns, with a legend.
void PrintTables(std::ostream &out, const std::vector<SceneResult> &results, const CompareOptions &options,
                 bool colour);
/// The closing line: how many are identical, and by what factor a step is faster.
void PrintClosingLine(std::ostream &out, const std::vector<SceneResult> &results, bool colour);
/// Everything that is known of every scene.
nlohmann::json ToJson(const std::vector<SceneResult> &results, const CompareOptions &options);
void WriteJson(std::ostream &out, const std::vector<SceneResult> &results, const CompareOptions &options);
/// A header and one row per scene; unknown figures are empty.
void WriteCsv(std::ostream &out, const std::vector<SceneResult> &results);

} // namespace testbed

#endif
