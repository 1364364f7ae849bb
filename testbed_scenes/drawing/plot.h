// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PLOT_H
#define BOOMERANG_TESTBED_PLOT_H

#include <string>
#include <vector>

#include "drawing/canvas.h"

namespace testbed {

/// One line of a plot; points with a coordinate that a logarithmic axis cannot show are left out.
struct PlotSeries {
    std::string name;
    std::vector<bmr_vec2> points;
    Colour colour;
    std::size_t mark = 0; ///< which of eight shapes its marks have, filled ones first
    bool dashed = false;  ///< a bound or a fit rather than a measurement: no marks
};

struct Plot {
    std::string title, xLabel, yLabel;
    bool logX = true, logY = true;
    std::vector<PlotSeries> series;
};

/// Draws the plot into a rectangle of the page: frame, ticks at round numbers (decades where logarithmic,
/// with 2 and 5 where they are few), series with their marks, a legend inside where there is
/// room most. A plot without a point says so.
void DrawPlot(Canvas &canvas, const Rectangle &page, const Plot &plot);

} // namespace testbed

#endif
