// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PLOT_COMMAND_H
#define BOOMERANG_TESTBED_PLOT_COMMAND_H

#include <string>

namespace testbed {

/// Draws measured numbers, for instance those of tests/bench/measure_costs.sh.
struct PlotCommand {
    std::string csv; ///< `series,x,y` a line, below one line of headings
    std::string output;
    std::string title, xLabel, yLabel;
};

int Execute(const PlotCommand &command);

} // namespace testbed

#endif
