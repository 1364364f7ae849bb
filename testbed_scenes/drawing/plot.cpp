// SPDX-License-Identifier: MIT
#include "drawing/plot.h"

#include <algorithm>

#include "drawing/axis.h"

namespace testbed {
namespace {

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
    canvas.Polygon({bmr_vec2_make(in.left, in.bottom), bmr_vec2_make(in.right, in.bottom),
                    bmr_vec2_make(in.right, in.top), bmr_vec2_make(in.left, in.top)},
                   {}, axis);
    canvas.Text(bmr_vec2_make(0.5 * (in.left + in.right), in.bottom), 0.0, -kBottom + 4.0, plot.xLabel,
                kTextSize, Align::Centre);
    canvas.TextUpwards(bmr_vec2_make(in.left, 0.5 * (in.bottom + in.top)), -kLeft + 11.0, 0.0, plot.yLabel,
                       kTextSize);
}

void DrawSeries(Canvas &canvas, const Frame &frame, const PlotSeries &series, size_t index) {
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
            DrawMark(canvas, point, index, series.colour);
}

constexpr double kSwatch = 22.0, kLegendLine = 1.35 * kTextSize, kPad = 6.0;

/// A line of the legend, from its left end on the base line.
void DrawEntry(Canvas &canvas, bmr_vec2 at, const PlotSeries &series, size_t index) {
    Pen pen = {series.colour, series.dashed ? 1.0 : 1.5};
    if (series.dashed)
        pen.dash = {4.0, 3.0};
    const bmr_vec2 from = bmr_vec2_make(at.x, at.y + 0.3 * kTextSize);
    canvas.Segment(from, bmr_vec2_make(from.x + kSwatch, from.y), pen);
    if (!series.dashed)
        DrawMark(canvas, bmr_vec2_make(from.x + 0.5 * kSwatch, from.y), index, series.colour);
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
    canvas.Polygon({bmr_vec2_make(best.left, best.bottom), bmr_vec2_make(best.right, best.bottom),
                    bmr_vec2_make(best.right, best.top), bmr_vec2_make(best.left, best.top)},
                   {{1.0, 1.0, 1.0}, 0.85}, {ink::kFaint, 0.7});
    double y = best.top - kPad - 0.75 * kTextSize;
    for (size_t i = 0; i < plot.series.size(); ++i, y -= kLegendLine)
        DrawEntry(canvas, bmr_vec2_make(best.left + kPad, y), plot.series[i], i);
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
        DrawSeries(canvas, frame, plot.series[i], i);
    DrawLegend(canvas, frame, plot);
}

} // namespace testbed
