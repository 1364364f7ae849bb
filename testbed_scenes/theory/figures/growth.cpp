// SPDX-License-Identifier: MIT
// Table 1, measured: how the number of events grows with the diameter over the separation.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "theory/event_tables.h"
#include "theory/figure.h"

namespace testbed {
namespace {

struct Wanted {
    const char *structure;
    const char *label;
};
constexpr Wanted kStructures[] = {{"closest-features", "closest features"},
                                  {"active-cell-compass", "active cell, compass"},
                                  {"lazy-compass", "lazy, compass"},
                                  {"lazy-dudley", "lazy, Dudley"},
                                  {"hybrid", "hybrid"}};
constexpr unsigned kSeeds = 2;
constexpr size_t kVertices = 256;

constexpr double kFirst = 4.0, kLast = 4096.0; ///< D/sigma

struct Series {
    std::string name;
    std::vector<bmr_vec2> points; ///< D/sigma, events
    Colour colour;
    bool dashed = false; ///< a bound rather than a measurement
};

/// Events over D/sigma, which is on a logarithmic scale; the events are, too, or from 0 on.
struct Panel {
    std::string title;
    bool logarithmic;
    std::vector<Series> series;
};

Panel PanelOf(bmr_family family, const std::string &title, bool logarithmic) {
    Experiment experiment;
    experiment.motions = {family};
    experiment.n = kVertices;
    for (const Wanted &wanted : kStructures)
        experiment.structures.push_back(StructureNamed(wanted.structure));
    for (double ratio = kFirst; ratio <= kLast; ratio *= 4.0)
        experiment.ratios.push_back(ratio);
    for (unsigned seed = 1; seed <= kSeeds; ++seed)
        experiment.seeds.push_back(seed);
    const std::vector<Run> runs = Perform(experiment, [](const std::string &, size_t, size_t) {});

    Panel panel = {title, logarithmic, {}};
    const auto add = [&](const std::string &name, const Colour &colour, bool dashed, const auto &valueAt) {
        Series series = {name, {}, colour, dashed};
        for (size_t i = 0; i < experiment.ratios.size(); ++i)
            if (const std::optional<double> value = valueAt(i))
                series.points.push_back({experiment.ratios[i], *value});
        panel.series.push_back(std::move(series));
    };
    size_t index = 0;
    for (const Wanted &wanted : kStructures) {
        const bmr_kds_info *info = StructureNamed(wanted.structure);
        const Colour colour = ink::Series(index++);
        // Where the scale is linear, a rival would squeeze everything else.
        if (logarithmic || info->role != BMR_KDS_RIVAL)
            add(wanted.label, colour, false,
                [&](size_t i) { return MeanOver(runs, bmr_family_name(family), info, i); });
    }
    add("offline optimum", ink::kBlack, false,
        [&](size_t i) { return MeanOptimum(runs, bmr_family_name(family), i); });
    if (logarithmic)
        add("sqrt(D/sigma)", ink::kGrey, true,
            [&](size_t i) { return std::optional<double>(std::sqrt(experiment.ratios[i])); });
    return panel;
}

void DrawPanel(Canvas &canvas, const Rectangle &page, const Panel &panel) {
    constexpr double kText = 10.5, kSwatch = 22.0, kPad = 6.0;
    const Rectangle in = {page.left + 52.0, page.bottom + 36.0, page.right - 10.0, page.top - 24.0};
    double most = 1.0, width = 0.0;
    for (const Series &series : panel.series) {
        width = std::max(width, canvas.TextWidth(series.name, kText));
        for (const bmr_vec2 &point : series.points)
            most = std::max(most, 1.1 * point.y);
    }
    const auto onPage = [&](double ratio, double events) {
        const double up =
            panel.logarithmic ? std::log(std::max(events, 1.0)) / std::log(most) : events / most;
        return bmr_vec2_make(in.left + in.Width() * std::log(ratio / kFirst) / std::log(kLast / kFirst),
                             in.bottom + in.Height() * up);
    };
    const Pen grid = {ink::kFaint, 0.7}, axis = {ink::kBlack, 0.9};
    for (const double ratio : {10.0, 100.0, 1000.0}) {
        const bmr_vec2 at = onPage(ratio, 0.0);
        canvas.Segment(at, bmr_vec2_make(at.x, in.top), grid);
        canvas.Text(at, 0.0, -kText - 4.0, std::to_string(std::lround(ratio)), kText, Align::Centre);
    }
    const double step = most > 50.0 ? 20.0 : 10.0;
    for (double events = panel.logarithmic ? 1.0 : 0.0; events < most;
         events = panel.logarithmic ? 10.0 * events : events + step) {
        const bmr_vec2 at = onPage(kFirst, events);
        canvas.Segment(at, bmr_vec2_make(in.right, at.y), grid);
        canvas.Text(at, -5.0, -0.35 * kText, std::to_string(std::lround(events)), kText, Align::Right);
    }
    canvas.Box(in, {}, axis);
    canvas.Text(bmr_vec2_make(0.5 * (in.left + in.right), page.top - 14.0), 0.0, 0.0, panel.title, 12.0,
                Align::Centre, ink::kBlack, true);
    canvas.Text(bmr_vec2_make(0.5 * (in.left + in.right), in.bottom), 0.0, -32.0, "D / sigma", kText,
                Align::Centre);
    canvas.TextUpwards(bmr_vec2_make(in.left, 0.5 * (in.bottom + in.top)), -41.0, 0.0, "events", kText);
    const double line = 1.35 * kText, height = line * static_cast<double>(panel.series.size()) + 9.0;
    const auto penOf = [](const Series &series) {
        return Pen{series.colour, series.dashed ? 1.0 : 1.6, 1.0,
                   series.dashed ? std::vector<double>{4.0, 3.0} : std::vector<double>()};
    };
    for (const Series &series : panel.series) {
        std::vector<bmr_vec2> points;
        for (const bmr_vec2 &point : series.points)
            points.push_back(onPage(point.x, point.y));
        canvas.Polyline(points, penOf(series));
        for (size_t i = 0; i < points.size() && !series.dashed; ++i)
            canvas.Dot(points[i], 2.8, series.colour);
    }
    // The legend is in a corner without points: the lower right one of logarithms, else the upper left one.
    const double wide = width + kSwatch + 3.0 * kPad;
    const double left = panel.logarithmic ? in.right - kPad - wide : in.left + kPad;
    const double low = panel.logarithmic ? in.bottom + kPad : in.top - kPad - height;
    const Rectangle box = {left, low, left + wide, low + height};
    canvas.Box(box, {{1.0, 1.0, 1.0}, 0.85}, {ink::kFaint, 0.7});
    bmr_vec2 at = bmr_vec2_make(box.left + kPad, box.top - kPad - 0.75 * kText);
    for (const Series &series : panel.series) {
        const double y = at.y + 0.3 * kText;
        canvas.Segment(bmr_vec2_make(at.x, y), bmr_vec2_make(at.x + kSwatch, y), penOf(series));
        canvas.Text(at, kSwatch + kPad, 0.0, series.name, kText);
        at.y -= line;
    }
}

} // namespace

void DrawGrowth(Canvas &canvas) {
    const Panel line = PanelOf(BMR_FAMILY_LINE, "passing on a straight line", false);
    const Panel orbit = PanelOf(BMR_FAMILY_ORBIT, "one orbit", true);
    const double half = 0.5 * canvas.Width();
    DrawPanel(canvas, {4.0, 4.0, half - 4.0, canvas.Height() - 4.0}, line);
    DrawPanel(canvas, {half + 4.0, 4.0, canvas.Width() - 4.0, canvas.Height() - 4.0}, orbit);
}

} // namespace testbed
