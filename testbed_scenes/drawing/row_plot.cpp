// SPDX-License-Identifier: MIT
#include "drawing/row_plot.h"

#include <algorithm>

#include "drawing/axis.h"

namespace testbed {
namespace {

using plot_style::kTextSize, plot_style::kTick, plot_style::kTitleSize;

constexpr double kRow = 17.0, kUnder = 36.0, kTitle = 20.0, kLegend = 20.0, kBeside = 14.0, kGap = 6.0;
/// Marks of one row stand a little apart, so that equal values do not hide one another.
constexpr double kApart = 4.0;

Axis AxisOf(const RowPlot &plot) {
    Axis axis = {plot.logX};
    auto add = [&axis](double value) {
        if (axis.Shows(value))
            axis.Add(value);
    };
    for (const RowSeries &series : plot.series) {
        for (const auto &value : series.values)
            if (value)
                add(*value);
        for (const auto &range : series.ranges)
            if (range) {
                add(range->first);
                add(range->second);
            }
    }
    if (axis.low <= axis.high && plot.reference)
        add(*plot.reference);
    return axis;
}

struct Rows {
    Rectangle page; ///< inside the axes
    Axis x;

    double XOf(double value) const { return page.left + x.Part(value) * page.Width(); }
    double YOf(size_t row) const { return page.top - (static_cast<double>(row) + 0.5) * kRow; }
};

void DrawAxes(Canvas &canvas, const Rows &frame, const RowPlot &plot) {
    const Rectangle &in = frame.page;
    const Pen grid = {ink::kFaint, 0.7}, axis = {ink::kBlack, 0.9};
    for (const double tick : frame.x.Ticks()) {
        const double at = frame.XOf(tick);
        canvas.Segment(bmr_vec2_make(at, in.bottom), bmr_vec2_make(at, in.top), grid);
        canvas.Segment(bmr_vec2_make(at, in.bottom), bmr_vec2_make(at, in.bottom - kTick), axis);
        canvas.Text(bmr_vec2_make(at, in.bottom), 0.0, -kTick - kTextSize, TickText(tick), kTextSize,
                    Align::Centre);
    }
    for (size_t row = 0; row < plot.rows.size(); ++row) {
        const double y = frame.YOf(row);
        canvas.Segment(bmr_vec2_make(in.left, y), bmr_vec2_make(in.right, y), grid);
        canvas.Text(bmr_vec2_make(in.left, y), -kGap, -0.35 * kTextSize, plot.rows[row], kTextSize,
                    Align::Right);
    }
    canvas.Polygon({bmr_vec2_make(in.left, in.bottom), bmr_vec2_make(in.right, in.bottom),
                    bmr_vec2_make(in.right, in.top), bmr_vec2_make(in.left, in.top)},
                   {}, axis);
    if (plot.reference) {
        const double at = frame.XOf(*plot.reference);
        canvas.Segment(bmr_vec2_make(at, in.bottom), bmr_vec2_make(at, in.top),
                       {ink::kBlack, 1.2, 1.0, {5.0, 3.0}});
    }
    canvas.Text(bmr_vec2_make(0.5 * (in.left + in.right), in.bottom), 0.0, -kUnder + 6.0, plot.xLabel,
                kTextSize, Align::Centre);
}

void DrawSeries(Canvas &canvas, const Rows &frame, const RowPlot &plot, size_t index) {
    const RowSeries &series = plot.series[index];
    const double shift =
        kApart * (0.5 * static_cast<double>(plot.series.size() - 1) - static_cast<double>(index));
    for (size_t row = 0; row < plot.rows.size(); ++row) {
        const double y = frame.YOf(row) + shift;
        if (row < series.ranges.size() && series.ranges[row]) {
            // What the axis cannot show (a logarithm of 0) is at its end, not on the names of the rows.
            const auto [least, greatest] = *series.ranges[row];
            const double from = frame.x.Shows(least) ? frame.XOf(least) : frame.page.left;
            if (frame.x.Shows(greatest))
                canvas.Segment(bmr_vec2_make(from, y), bmr_vec2_make(frame.XOf(greatest), y),
                               {series.colour, 1.6});
        }
        if (row < series.values.size() && series.values[row] && frame.x.Shows(*series.values[row]))
            DrawMark(canvas, bmr_vec2_make(frame.XOf(*series.values[row]), y), index, series.colour);
    }
}

void DrawLegend(Canvas &canvas, double right, double y, const RowPlot &plot) {
    constexpr double kMark = 12.0, kBetween = 16.0;
    double width = -kBetween;
    for (const RowSeries &series : plot.series)
        width += kMark + canvas.TextWidth(series.name, kTextSize) + kBetween;
    double x = right - width;
    for (size_t i = 0; i < plot.series.size(); ++i) {
        DrawMark(canvas, bmr_vec2_make(x + 3.0, y + 0.35 * kTextSize), i, plot.series[i].colour);
        canvas.Text(bmr_vec2_make(x + kMark, y), 0.0, 0.0, plot.series[i].name, kTextSize);
        x += kMark + canvas.TextWidth(plot.series[i].name, kTextSize) + kBetween;
    }
}

} // namespace

double HeightOf(const RowPlot &plot) {
    return kTitle + kLegend + kRow * static_cast<double>(std::max<size_t>(plot.rows.size(), 1)) + kUnder;
}

void DrawPlot(Canvas &canvas, const Rectangle &page, const RowPlot &plot) {
    canvas.ClearPanel();
    double names = 0.0;
    for (const std::string &row : plot.rows)
        names = std::max(names, canvas.TextWidth(row, kTextSize));
    Rows frame = {{page.left + names + 2.0 * kGap, page.bottom + kUnder, page.right - kBeside,
                   page.top - kTitle - kLegend},
                  AxisOf(plot)};
    canvas.Text(bmr_vec2_make(page.left, page.top), 0.0, -kTitleSize - 2.0, plot.title, kTitleSize,
                Align::Left, ink::kBlack, true);
    if (!(frame.x.low <= frame.x.high)) {
        canvas.Text(bmr_vec2_make(0.5 * (page.left + page.right), 0.5 * (page.bottom + page.top)), 0.0, 0.0,
                    "nothing to show", kTextSize, Align::Centre);
        return;
    }
    frame.x.Widen();
    DrawAxes(canvas, frame, plot);
    for (size_t i = 0; i < plot.series.size(); ++i)
        DrawSeries(canvas, frame, plot, i);
    DrawLegend(canvas, frame.page.right, frame.page.top + kGap, plot);
}

} // namespace testbed
