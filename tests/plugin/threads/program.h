// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_THREADS_PROGRAM_H
#define BOOMERANG_TEST_THREADS_PROGRAM_H

#include <vector>

#include "worlds.h"

/// @file
/// All that threads_stock and threads_plugin do differently.

namespace threads {

/// Scenes of polygons of any size; none in stock.
const std::vector<Chosen> &ScenesOfThePlugin();

/// bmr::Install, perhaps with statistics: did this call put the plugin to work? False in stock.
bool Install(bool counting);
/// Is it at work? True in stock, which has nothing to install.
bool IsInstalled();

/// Reads the statistics, which never go back. False where one did, or where they do not belong together.
struct StatisticsReader {
    bool Read();
    unsigned long long steps = 0, evaluations = 0; ///< as they were read last
};

} // namespace threads

#endif
