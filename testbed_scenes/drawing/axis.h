// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_AXIS_H
#define BOOMERANG_TESTBED_AXIS_H

#include <cmath>
#include <string>
#include <vector>

#include "drawing/canvas.h"

namespace testbed {

/// What all plots have in common, in units of the page.
namespace plot_style {
constexpr double kTextSize = 10.0, kTitleSize = 12.0, kTick = 4.0;
} // namespace plot_style

/// One axis: its range in the coordinate that is drawn, the logarithm where logarithmic.
struct Axis {
    bool logarithmic = false;
    double low = INFINITY, high = -INFINITY;

    /// Whether a logarithmic or linear axis has a place for this value at all.
    bool Shows(double value) const { return std::isfinite(value) && (!logarithmic || value > 0.0); }
    double Map(double value) const { return logarithmic ? std::log10(value) : value; }
    /// Makes room for a value that it shows.
    void Add(double value);
    /// Some air at the ends; a linear axis begins at zero or below.
    void Widen();
    /// Round numbers: decades where logarithmic, with 2 and 5 where they are few.
    std::vector<double> Ticks() const;
};

std::string TickText(double value);

/// A series' mark at a point of the page. The first eight differ in shape: whoever sees no colour tells them
/// apart.
void DrawMark(Canvas &canvas, bmr_vec2 page, size_t shape, const Colour &colour);

} // namespace testbed

#endif
