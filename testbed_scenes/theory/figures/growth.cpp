// SPDX-License-Identifier: MIT
// Table 1, measured: how the number of events grows with the diameter over the separation.
#include <cmath>
#include <optional>

#include "drawing/plot.h"
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

Plot PlotOf(bmr_family family, const std::string &title, bool logarithmic) {
    Experiment experiment;
    experiment.motions = {family};
    experiment.n = kVertices;
    for (const Wanted &wanted : kStructures)
        experiment.structures.push_back(StructureNamed(wanted.structure));
    for (double ratio = 4.0; ratio <= 4096.0; ratio *= 4.0)
        experiment.ratios.push_back(ratio);
    for (unsigned seed = 1; seed <= kSeeds; ++seed)
        experiment.seeds.push_back(seed);
    const std::vector<Run> runs = Perform(experiment, [](const std::string &, size_t, size_t) {});

    Plot plot;
    plot.title = title;
    plot.xLabel = "D / sigma";
    plot.yLabel = "events";
    plot.logY = !logarithmic;
    size_t index = 0;
    for (const Wanted &wanted : kStructures) {
        // The rivals would squeeze everything else where the scale is linear.
        const bmr_kds_info *info = StructureNamed(wanted.structure);
        PlotSeries series = {wanted.label, {}, ink::Series(index), index};
        ++index;
        for (size_t i = 0; i < experiment.ratios.size(); ++i)
            if (const std::optional<double> mean = MeanOver(runs, bmr_family_name(family), info, i))
                series.points.push_back({experiment.ratios[i], *mean});
        if (!(logarithmic && info->role == BMR_KDS_RIVAL))
            plot.series.push_back(std::move(series));
    }
    PlotSeries optimum = {"offline optimum", {}, ink::kBlack, index};
    for (size_t i = 0; i < experiment.ratios.size(); ++i)
        if (const std::optional<double> mean = MeanOptimum(runs, bmr_family_name(family), i))
            optimum.points.push_back({experiment.ratios[i], *mean});
    plot.series.push_back(std::move(optimum));
    if (!logarithmic) {
        PlotSeries root = {"sqrt(D/sigma)", {}, ink::kGrey, 0, true};
        for (const double ratio : experiment.ratios)
            root.points.push_back({ratio, std::sqrt(ratio)});
        plot.series.push_back(std::move(root));
    }
    return plot;
}

} // namespace

void DrawGrowth(Canvas &canvas) {
    // Half a minute of work, the same for every format.
    static const Plot line = PlotOf(BMR_FAMILY_LINE, "passing on a straight line", true);
    static const Plot orbit = PlotOf(BMR_FAMILY_ORBIT, "one orbit", false);
    const double half = 0.5 * canvas.Width();
    DrawPlot(canvas, {4.0, 4.0, half - 4.0, canvas.Height() - 4.0}, line);
    DrawPlot(canvas, {half + 4.0, 4.0, canvas.Width() - 4.0, canvas.Height() - 4.0}, orbit);
}

} // namespace testbed
