// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_ROW_PLOT_H
#define BOOMERANG_TESTBED_ROW_PLOT_H

#include <optional>
#include <string>
#include <vector>

#include "drawing/canvas.h"

namespace testbed {

/// One quantity of every row.
struct RowSeries {
    std::string name;
    Colour colour;
    std::vector<std::optional<double>> values; ///< one a row; nothing: no mark
    /// One a row, or none at all: a bar from the least to the greatest behind the mark.
    std::vector<std::optional<std::pair<double, double>>> ranges = {};
};

/// Named rows, one under the other, with a mark for each series on a common axis.
struct RowPlot {
    std::string title, xLabel;
    std::vector<std::string> rows;
    std::vector<RowSeries> series;
    bool logX = false;
    /// A line across all rows: where nothing changes.
    std::optional<double> reference = {};
};

/// The height that its rows take, in units of the page.
double HeightOf(const RowPlot &plot);

/// Draws the plot into a rectangle of the page: names to the left, the legend in a line under the title. A
/// plot without a value says so.
void DrawPlot(Canvas &canvas, const Rectangle &page, const RowPlot &plot);

} // namespace testbed

#endif
