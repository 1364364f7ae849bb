// SPDX-License-Identifier: MIT
#include "drawing/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "drawing/canvas.h"

namespace testbed {
namespace {

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

void Axis::Add(double value) {
    low = std::min(low, Map(value));
    high = std::max(high, Map(value));
}

void Axis::Widen() {
    if (!logarithmic)
        low = std::min(low, 0.0);
    const double by = high > low ? 0.05 * (high - low) : 0.5;
    low -= logarithmic ? by : 0.0;
    high += by;
}

std::vector<double> Axis::Ticks() const {
    std::vector<double> ticks;
    if (logarithmic) {
        const bool few = high - low < 2.2;
        for (int decade = static_cast<int>(std::floor(low)); decade <= high; ++decade)
            for (const double digit : {1.0, 2.0, 5.0})
                if ((few || digit == 1.0) && decade + std::log10(digit) >= low &&
                    decade + std::log10(digit) <= high)
                    ticks.push_back(digit * std::pow(10.0, decade));
        return ticks;
    }
    const double rough = (high - low) / 5.0, power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10.0 * power;
    for (const double digit : {5.0, 2.0, 1.0})
        if (digit * power >= rough)
            step = digit * power;
    for (double tick = std::ceil(low / step) * step; tick <= high + 1e-9 * step; tick += step)
        ticks.push_back(tick);
    return ticks;
}

std::string TickText(double value) {
    char text[32];
    if (value != 0.0 && (std::fabs(value) >= 1e5 || std::fabs(value) < 1e-3)) {
        const int power = static_cast<int>(std::floor(std::log10(std::fabs(value)) + 1e-9));
        std::snprintf(text, sizeof text, "%ge%d", std::round(100.0 * value / std::pow(10.0, power)) / 100.0,
                      power);
    } else {
        std::snprintf(text, sizeof text, "%g", value);
    }
    return text;
}

/// A series' mark at a point of the page. The first eight differ in shape: who sees no colour tells them
/// apart.
void DrawMark(Canvas &canvas, bmr_vec2 page, size_t shape, const Colour &colour) {
    constexpr double kRadius = 2.8, kRim = 1.1;
    constexpr size_t kShapes = 4;
    // Marks keep their shape on a stretched panel: they are drawn in the page's units.
    auto corner = [&page](double dx, double dy) { return bmr_vec2_make(page.x + dx, page.y + dy); };
    const bool hollow = shape / kShapes % 2 == 1;
    const Fill fill = {hollow ? Colour{1.0, 1.0, 1.0} : colour, 1.0};
    const Pen rim = {colour, hollow ? kRim : 0.0};
    switch (shape % kShapes) {
    case 0:
        if (hollow)
            canvas.Circle(page, kRadius, fill, rim);
        else
            canvas.Dot(page, kRadius, colour);
        break;
    case 1:
        canvas.Polygon({corner(-kRadius, -kRadius), corner(kRadius, -kRadius), corner(kRadius, kRadius),
                        corner(-kRadius, kRadius)},
                       fill, rim);
        break;
    case 2:
        canvas.Polygon({corner(-kRadius, -kRadius), corner(kRadius, -kRadius), corner(0.0, 1.3 * kRadius)},
                       fill, rim);
        break;
    default:
        canvas.Polygon({corner(0.0, -1.4 * kRadius), corner(1.4 * kRadius, 0.0), corner(0.0, 1.4 * kRadius),
                        corner(-1.4 * kRadius, 0.0)},
                       fill, rim);
    }
}

using plot_style::kTextSize, plot_style::kTick, plot_style::kTitleSize;

/// Room for the numbers and names of the axes, in units of the page.
constexpr double kLeft = 52.0, kBottom = 36.0, kTop = 24.0, kRight = 10.0;

struct Frame {
    Rectangle page; ///< inside the axes
    Axis x, y;

    bmr_vec2 OnPage(const bmr_vec2 &point) const {
        return bmr_vec2_make(page.left + (x.Map(point.x) - x.low) / (x.high - x.low) * page.Width(),
                             page.bottom + (y.Map(point.y) - y.low) / (y.high - y.low) * page.Height());
    }
};

void DrawAxes(Canvas &canvas, const Frame &frame, const Plot &plot) {
    const Rectangle &in = frame.page;
    const Pen grid = {ink::kFaint, 0.7}, axis = {ink::kBlack, 0.9};
    for (const double tick : frame.x.Ticks()) {
        const double at =
            in.left + (frame.x.Map(tick) - frame.x.low) / (frame.x.high - frame.x.low) * in.Width();
        canvas.Segment(bmr_vec2_make(at, in.bottom), bmr_vec2_make(at, in.top), grid);
        canvas.Segment(bmr_vec2_make(at, in.bottom), bmr_vec2_make(at, in.bottom - kTick), axis);
        canvas.Text(bmr_vec2_make(at, in.bottom), 0.0, -kTick - kTextSize, TickText(tick), kTextSize,
                    Align::Centre);
    }
    for (const double tick : frame.y.Ticks()) {
        const double at =
            in.bottom + (frame.y.Map(tick) - frame.y.low) / (frame.y.high - frame.y.low) * in.Height();
        canvas.Segment(bmr_vec2_make(in.left, at), bmr_vec2_make(in.right, at), grid);
        canvas.Segment(bmr_vec2_make(in.left, at), bmr_vec2_make(in.left - kTick, at), axis);
        canvas.Text(bmr_vec2_make(in.left, at), -kTick - 2.0, -0.35 * kTextSize, TickText(tick), kTextSize,
                    Align::Right);
    }
    canvas.Box(in, {}, axis);
    canvas.Text(bmr_vec2_make(0.5 * (in.left + in.right), in.bottom), 0.0, -kBottom + 4.0, plot.xLabel,
                kTextSize, Align::Centre);
    canvas.TextUpwards(bmr_vec2_make(in.left, 0.5 * (in.bottom + in.top)), -kLeft + 11.0, 0.0, plot.yLabel,
                       kTextSize);
}

void DrawSeries(Canvas &canvas, const Frame &frame, const PlotSeries &series) {
    std::vector<bmr_vec2> points;
    for (const bmr_vec2 &point : series.points)
        if (frame.x.Shows(point.x) && frame.y.Shows(point.y))
            points.push_back(frame.OnPage(point));
    Pen pen = {series.colour, series.dashed ? 1.0 : 1.5};
    if (series.dashed)
        pen.dash = {4.0, 3.0};
    canvas.Polyline(points, pen);
    if (!series.dashed)
        for (const bmr_vec2 &point : points)
            DrawMark(canvas, point, series.mark, series.colour);
}

constexpr double kSwatch = 22.0, kLegendLine = 1.35 * kTextSize, kPad = 6.0;

/// A line of the legend, from its left end on the base line.
void DrawEntry(Canvas &canvas, bmr_vec2 at, const PlotSeries &series) {
    Pen pen = {series.colour, series.dashed ? 1.0 : 1.5};
    if (series.dashed)
        pen.dash = {4.0, 3.0};
    const bmr_vec2 from = bmr_vec2_make(at.x, at.y + 0.3 * kTextSize);
    canvas.Segment(from, bmr_vec2_make(from.x + kSwatch, from.y), pen);
    if (!series.dashed)
        DrawMark(canvas, bmr_vec2_make(from.x + 0.5 * kSwatch, from.y), series.mark, series.colour);
    canvas.Text(bmr_vec2_make(from.x + kSwatch + kPad, at.y), 0.0, 0.0, series.name, kTextSize);
}

/// The legend goes to that upper or lower, left or right corner which hides the fewest points.
void DrawLegend(Canvas &canvas, const Frame &frame, const Plot &plot) {
    double width = 0.0;
    for (const PlotSeries &series : plot.series)
        width = std::max(width, canvas.TextWidth(series.name, kTextSize));
    width += kSwatch + 3.0 * kPad;
    const double height = kLegendLine * static_cast<double>(plot.series.size()) + 1.5 * kPad;
    const Rectangle &in = frame.page;
    Rectangle best = {};
    size_t fewest = SIZE_MAX;
    for (const bool top : {true, false})
        for (const bool left : {true, false}) {
            const double x = left ? in.left + kPad : in.right - kPad - width;
            const double y = top ? in.top - kPad - height : in.bottom + kPad;
            const Rectangle box = {x, y, x + width, y + height};
            size_t hidden = 0;
            for (const PlotSeries &series : plot.series)
                for (const bmr_vec2 &point : series.points) {
                    if (!frame.x.Shows(point.x) || !frame.y.Shows(point.y))
                        continue;
                    const bmr_vec2 at = frame.OnPage(point);
                    hidden += at.x > box.left && at.x < box.right && at.y > box.bottom && at.y < box.top;
                }
            if (hidden < fewest) {
                fewest = hidden;
                best = box;
            }
        }
    canvas.Box(best, {{1.0, 1.0, 1.0}, 0.85}, {ink::kFaint, 0.7});
    double y = best.top - kPad - 0.75 * kTextSize;
    for (size_t i = 0; i < plot.series.size(); ++i, y -= kLegendLine)
        DrawEntry(canvas, bmr_vec2_make(best.left + kPad, y), plot.series[i]);
}

} // namespace

void DrawPlot(Canvas &canvas, const Rectangle &page, const Plot &plot) {
    canvas.ClearPanel();
    Frame frame = {{page.left + kLeft, page.bottom + kBottom, page.right - kRight, page.top - kTop},
                   {plot.logX},
                   {plot.logY}};
    size_t shown = 0;
    for (const PlotSeries &series : plot.series)
        for (const bmr_vec2 &point : series.points)
            if (frame.x.Shows(point.x) && frame.y.Shows(point.y)) {
                frame.x.Add(point.x);
                frame.y.Add(point.y);
                ++shown;
            }
    const bmr_vec2 heading = bmr_vec2_make(0.5 * (frame.page.left + frame.page.right), page.top);
    canvas.Text(heading, 0.0, -kTitleSize - 2.0, plot.title, kTitleSize, Align::Centre, ink::kBlack, true);
    if (shown == 0) {
        canvas.Text(bmr_vec2_make(heading.x, 0.5 * (page.bottom + page.top)), 0.0, 0.0, "nothing to show",
                    kTextSize, Align::Centre);
        return;
    }
    frame.x.Widen();
    frame.y.Widen();
    DrawAxes(canvas, frame, plot);
    for (size_t i = 0; i < plot.series.size(); ++i)
        DrawSeries(canvas, frame, plot.series[i]);
    DrawLegend(canvas, frame, plot);
}

} // namespace testbed
