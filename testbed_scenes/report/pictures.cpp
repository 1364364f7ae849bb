// SPDX-License-Identifier: MIT
#include "report/pictures.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "report/html.h"
#include "theory/event_tables.h"

namespace testbed {
namespace {

constexpr double kWidth = 520.0, kHeight = 340.0, kLegendLine = 8.0, kRowWidth = 520.0, kMargin = 4.0;
/// More lines than this nobody can tell apart.
constexpr size_t kMostStructures = 8;

RowSeries SeriesOf(const std::vector<SceneNumbers> &scenes, const char *name, const Colour &colour,
                   const std::string &figure, bool withRange) {
    RowSeries series = {name, colour, {}};
    for (const SceneNumbers &scene : scenes) {
        series.values.push_back(scene[figure]);
        if (!withRange)
            continue;
        const std::optional<double> least = scene[figure + "_least"], greatest = scene[figure + "_greatest"];
        series.ranges.push_back(least && greatest ? std::make_optional(std::make_pair(*least, *greatest))
                                                  : std::nullopt);
    }
    return series;
}

bool HasValues(const RowPlot &plot) {
    for (const RowSeries &series : plot.series)
        for (const auto &value : series.values)
            if (value)
                return true;
    return false;
}

std::vector<std::string> NamesOf(const std::vector<SceneNumbers> &scenes) {
    std::vector<std::string> names;
    for (const SceneNumbers &scene : scenes)
        names.push_back(scene.name);
    return names;
}

/// How many of stock's calls the plugin did without, in percent.
RowSeries CallsSaved(const std::vector<SceneNumbers> &scenes, const char *name, const Colour &colour,
                     const std::string &call) {
    // Where stock hardly calls at all, a share says nothing.
    constexpr double kFewCalls = 1.0;
    RowSeries series = {name, colour, {}};
    for (const SceneNumbers &scene : scenes) {
        const std::optional<double> stock = scene["stock." + call], plugin = scene["plugin." + call];
        series.values.push_back(stock && plugin && *stock >= kFewCalls
                                    ? std::make_optional(100.0 * (1.0 - *plugin / *stock))
                                    : std::nullopt);
    }
    return series;
}

/// All, or where they are too many, one of each kind: what stands before the last dash is the kind.
std::vector<const bmr_kds_info *> SomeStructures(const std::vector<Run> &runs) {
    const std::vector<const bmr_kds_info *> all = StructuresOf(runs);
    if (all.size() <= kMostStructures)
        return all;
    std::vector<const bmr_kds_info *> some;
    std::set<std::string> kinds;
    for (const bmr_kds_info *structure : all) {
        const std::string name = structure->name;
        if (some.size() < kMostStructures && kinds.insert(name.substr(0, name.rfind('-'))).second)
            some.push_back(structure);
    }
    return some;
}

Picture EventsOf(const std::vector<Run> &runs, const std::string &motion,
                 const std::vector<const bmr_kds_info *> &structures) {
    Plot plot;
    plot.title = motion + ", n = " + std::to_string(runs.front().n);
    plot.xLabel = "D/sigma: diameter over least separation";
    plot.yLabel = "events";
    std::map<size_t, double> ratios;
    for (const Run &run : runs)
        ratios[run.ratioIndex] = run.wantedRatio;
    for (const bmr_kds_info *structure : structures) {
        PlotSeries series = {structure->name, {}, ink::Series(plot.series.size())};
        for (const auto &[index, ratio] : ratios)
            if (const auto mean = MeanOver(runs, motion, structure, index, Quantity::Events))
                series.points.push_back({ratio, *mean});
        if (!series.points.empty())
            plot.series.push_back(std::move(series));
    }
    PlotSeries optimum = {"optimum, offline", {}, ink::kBlack, true};
    for (const auto &[index, ratio] : ratios)
        if (const auto mean = MeanOptimum(runs, motion, index))
            optimum.points.push_back({ratio, *mean});
    if (!optimum.points.empty())
        plot.series.push_back(std::move(optimum));
    return {
        "events-" + motion,
        "Certificates that failed along the motion “" + motion +
            "”, means over all motions of the kind, both axes logarithmic. The optimum is the least number "
            "of separating lines that would do, known only afterwards.",
        plot};
}

/// A quantity against n, at the largest ratio that all numbers of vertices were run at.
std::optional<Picture> AgainstVertices(const Numbers &numbers, const std::string &motion, Quantity quantity,
                                       const char *name, const char *what) {
    Plot plot;
    std::map<double, std::set<size_t>> vertices;
    for (const Run &run : numbers.runs)
        if (run.motion == motion && run.wantedRatio > 0.0)
            vertices[run.wantedRatio].insert(run.n);
    double ratio = 0.0;
    size_t most = 1;
    for (const auto &[each, counts] : vertices)
        if (counts.size() > 1 && counts.size() >= most) {
            most = counts.size();
            ratio = each;
        }
    if (ratio == 0.0)
        return std::nullopt;
    std::map<const bmr_kds_info *, std::map<size_t, std::pair<double, int>>> sums;
    for (const Run &run : numbers.runs)
        if (run.motion == motion && run.wantedRatio == ratio) {
            auto &sum = sums[run.structure][run.n];
            sum.first += QuantityOf(run, quantity);
            ++sum.second;
        }
    std::ostringstream title;
    title << motion << ", D/sigma = " << ratio;
    plot.title = title.str();
    plot.xLabel = "n: vertices of each polygon";
    plot.yLabel = what;
    std::vector<Run> several;
    std::copy_if(
        numbers.runs.begin(), numbers.runs.end(), std::back_inserter(several),
        [&sums](const Run &run) { return sums.count(run.structure) && sums[run.structure].size() > 1; });
    for (const bmr_kds_info *structure : SomeStructures(several)) {
        PlotSeries series = {structure->name, {}, ink::Series(plot.series.size())};
        for (const auto &[n, sum] : sums[structure])
            series.points.push_back({static_cast<double>(n), sum.first / sum.second});
        plot.series.push_back(std::move(series));
    }
    return Picture{std::string(name) + "-" + motion,
                   std::string("How the ") + what + " grow with the number of vertices, along the motion “" +
                       motion + "”. Both axes are logarithmic.",
                   plot};
}

/// One line of a plot over sizes, if there are two points.
void AddSizes(Plot &plot, const std::vector<SceneNumbers> &sizes, const char *figure,
              const std::string &name) {
    PlotSeries series = {name, {}, ink::Series(plot.series.size())};
    for (const SceneNumbers &scene : sizes)
        if (const auto bodies = scene["bodies"], value = scene[figure]; bodies && value)
            series.points.push_back({*bodies, *value});
    std::sort(series.points.begin(), series.points.end(),
              [](const bmr_vec2 &a, const bmr_vec2 &b) { return a.x < b.x; });
    if (series.points.size() > 1)
        plot.series.push_back(std::move(series));
}

/// All runs of a scene over one number of steps, that of most of them: its first steps may cost more than the
/// later ones.
std::vector<SceneNumbers> SizesOf(const Numbers &numbers, const SceneNumbers &scene) {
    std::map<int64_t, std::vector<SceneNumbers>> bySteps;
    bySteps[scene.steps].push_back(scene);
    for (const SceneNumbers &other : numbers.others)
        if (other.name == scene.name)
            bySteps[other.steps].push_back(other);
    return std::max_element(bySteps.begin(), bySteps.end(),
                            [](const auto &a, const auto &b) { return a.second.size() < b.second.size(); })
        ->second;
}

std::string SafeName(std::string name) {
    for (char &c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)))
            c = '-';
    return name;
}

} // namespace

const std::string &Picture::Title() const {
    return std::visit([](const auto &each) -> const std::string & { return each.title; }, plot);
}

std::string Picture::Description() const {
    std::string text = "Plot: " + Title() + ". ";
    std::string axes, names;
    std::visit(
        [&](const auto &each) {
            axes = each.xLabel;
            for (const auto &series : each.series)
                names += (names.empty() ? "" : ", ") + series.name;
        },
        plot);
    return text + "Along the x axis: " + axes + ". Shown: " + names + ". A table has the numbers.";
}

std::vector<Picture> ScenePictures(const Numbers &numbers) {
    const std::vector<SceneNumbers> &scenes = numbers.scenes;
    std::vector<Picture> pictures;
    auto add = [&](const char *name, const char *caption, RowPlot plot) {
        plot.rows = NamesOf(scenes);
        if (HasValues(plot))
            pictures.push_back({name, caption, std::move(plot)});
    };
    add("speed-up-step",
        "Time of a whole step, stock Box2D's over the plugin's: right of the dashed line the plugin is "
        "faster. A "
        "mark is the median over pairs of runs, a bar reaches from the least to the greatest.",
        {"Whole step, times as fast as stock",
         "stock / plugin, by the clock",
         {},
         {SeriesOf(scenes, "contacts alone", ink::kBlue, "ratio_register.step", false),
          SeriesOf(scenes, "all hooks", ink::kRed, "ratio.step", true)},
         true,
         1.0});
    add("speed-up-narrow-phase",
        "The same for the narrow phase alone (b2ContactManager::Collide), which is what the plugin replaces.",
        {"Narrow phase, times as fast as stock",
         "stock / plugin, by Box2D's own profile",
         {},
         {SeriesOf(scenes, "contacts alone", ink::kBlue, "ratio_register.narrow_phase", false),
          SeriesOf(scenes, "all hooks", ink::kRed, "ratio.narrow_phase", true)},
         true,
         1.0});
    add("calls-saved",
        "Calls of Box2D's three separation tests that were not made, of all that stock makes. A scene in "
        "which "
        "stock makes fewer than one such call a step has no mark.",
        {"Calls saved, percent",
         "percent of stock's calls",
         {},
         {CallsSaved(scenes, "b2CollidePolygons", ink::kBlue, "polygon_tests_per_step"),
          CallsSaved(scenes, "b2TimeOfImpact", ink::kRed, "toi_calls_per_step"),
          CallsSaved(scenes, "b2Distance", ink::kGreen, "distance_calls_per_step")}});
    return pictures;
}

std::vector<Picture> EventPictures(const Numbers &numbers) {
    std::vector<Picture> pictures;
    const std::vector<size_t> vertices = numbers.Vertices();
    // Of several numbers of vertices, the one with most runs is that of the tables.
    std::vector<Run> most;
    for (const size_t n : vertices)
        if (std::vector<Run> runs = numbers.RunsOf(n); runs.size() > most.size())
            most = std::move(runs);
    const std::vector<const bmr_kds_info *> structures = SomeStructures(most);
    for (const std::string &motion : MotionsOf(most)) {
        Picture picture = EventsOf(most, motion, structures);
        const Plot &plot = std::get<Plot>(picture.plot);
        if (std::any_of(plot.series.begin(), plot.series.end(),
                        [](const PlotSeries &series) { return series.points.size() > 1; }))
            pictures.push_back(std::move(picture));
    }
    for (const std::string &motion : MotionsOf(numbers.runs)) {
        if (auto picture = AgainstVertices(numbers, motion, Quantity::Events, "vertices-events", "events"))
            pictures.push_back(std::move(*picture));
        if (auto picture =
                AgainstVertices(numbers, motion, Quantity::Work, "vertices-work", "failure times computed"))
            pictures.push_back(std::move(*picture));
    }
    return pictures;
}

std::vector<Picture> CostPictures(const Numbers &numbers) {
    std::vector<Picture> pictures;
    for (const SceneNumbers &scene : numbers.scenes) {
        const std::vector<SceneNumbers> sizes = SizesOf(numbers, scene);
        Plot plot;
        plot.title = scene.name + ", larger and larger";
        plot.xLabel = "bodies";
        plot.yLabel = "microseconds a step";
        AddSizes(plot, sizes, "stock.step_us_per_step", "whole step, stock");
        AddSizes(plot, sizes, "plugin.step_us_per_step", "whole step, plugin");
        AddSizes(plot, sizes, "stock.narrow_phase_us_per_step", "narrow phase, stock");
        AddSizes(plot, sizes, "plugin.narrow_phase_us_per_step", "narrow phase, plugin");
        if (!plot.series.empty())
            pictures.push_back({"bodies-" + scene.name,
                                "What a step costs as the number of bodies grows; both axes are logarithmic.",
                                std::move(plot)});
    }
    for (const SeriesFile &file : numbers.costs) {
        Plot plot;
        plot.title = file.yHeading + " against " + file.xHeading;
        plot.xLabel = file.xHeading;
        plot.yLabel = file.yHeading;
        plot.series = file.series;
        std::string name = "cost-" + SafeName(file.xHeading);
        const auto taken = std::count_if(pictures.begin(), pictures.end(), [&name](const Picture &picture) {
            return picture.name.compare(0, name.size(), name) == 0;
        });
        if (taken != 0)
            name += "-" + std::to_string(taken + 1);
        pictures.push_back({name, "Measured costs, both axes logarithmic.", std::move(plot)});
    }
    return pictures;
}

void WriteSvg(std::ostream &out, const Picture &picture) {
    if (const auto *rows = std::get_if<RowPlot>(&picture.plot)) {
        const double height = HeightOf(*rows) + 2.0 * kMargin;
        Canvas canvas(out, kRowWidth, height);
        DrawPlot(canvas, {kMargin, kMargin, kRowWidth - kMargin, height - kMargin}, *rows);
        canvas.Write();
    } else {
        Plot plot = std::get<Plot>(picture.plot);
        plot.legendBelow = true;
        const double height = kHeight + kLegendLine * static_cast<double>(plot.series.size());
        Canvas canvas(out, kWidth, height);
        DrawPlot(canvas, {kMargin, kMargin, kWidth - kMargin, height - kMargin}, plot);
        canvas.Write();
    }
}

namespace {

void ReplaceAll(std::string &text, const std::string &from, const std::string &to) {
    for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

} // namespace

std::string EmbeddedSvg(const std::string &svg, const std::string &prefix, const std::string &description) {
    const size_t start = svg.find("<svg"), end = svg.find('>', start);
    if (start == std::string::npos || end == std::string::npos)
        throw std::runtime_error("cairo wrote no SVG");
    const size_t box = svg.find("viewBox=", start);
    const std::string viewBox = svg.substr(box, svg.find('"', box + 9) + 1 - box);
    std::string inside = svg.substr(end + 1);
    ReplaceAll(inside, " id=\"", " id=\"" + prefix);
    ReplaceAll(inside, "href=\"#", "href=\"#" + prefix);
    ReplaceAll(inside, "url(#", "url(#" + prefix);
    // The modern name: within HTML, the old prefix need not be declared.
    ReplaceAll(inside, "xlink:href", "href");
    return "<svg role=\"img\" aria-label=\"" + Escaped(description) + "\" " + viewBox + ">" + inside;
}

} // namespace testbed
