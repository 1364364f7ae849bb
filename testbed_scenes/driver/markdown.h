// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_MARKDOWN_H
#define BOOMERANG_TESTBED_MARKDOWN_H

#include <ostream>
#include <vector>

#include "compare.h"

namespace testbed {

/// The tables of `compare` for a page of documentation: first the best, the middle and the worst scene by the
/// whole step, then a table of times and one of each kind of count. A ratio whose pairs of runs lie on both
/// sides of 1 is "no difference". Unknown figures are empty.
void WriteMarkdown(std::ostream &out, const std::vector<SceneResult> &results, const CompareOptions &options);

} // namespace testbed

#endif
