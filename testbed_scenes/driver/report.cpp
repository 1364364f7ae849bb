// SPDX-License-Identifier: MIT
#include "compare.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "terminal.h"

namespace testbed {
namespace {

// --- figures of a scene, from its workers' summaries; nothing where they are unknown ---

using Number = std::optional<double>;
using Figure = std::function<Number(const SceneResult &)>;

Number Quotient(Number a, Number b) {
    return a && b && *b > 0.0 ? *a / *b : Number();
}

/// A summary of a counting run.
using Summary = nlohmann::json SceneResult::*;
constexpr Summary kStockCount = &SceneResult::stockCount, kPluginCount = &SceneResult::pluginCount;

/// The sum of some counts of a run.
Figure Sum(Summary summary, const std::vector<std::string> &names) {
    return [=](const SceneResult &result) {
        Number sum = 0.0;
        for (const std::string &name : names) {
            const Number count = NumberAt(result.*summary, "/" + name);
            sum = sum && count ? *sum + *count : Number();
        }
        return sum;
    };
}

Figure PerStep(const Figure &figure) {
    return [=](const SceneResult &result) {
        const Number all = figure(result);
        return all ? *all * (1.0 / static_cast<double>(std::max<int64_t>(result.steps, 1))) : all;
    };
}

Figure PerStep(Summary summary, const std::vector<std::string> &names) {
    return PerStep(Sum(summary, names));
}

Figure Percent(const Figure &part, const Figure &whole) {
    return [=](const SceneResult &result) {
        const Number some = part(result);
        return some ? Quotient(100.0 * *some, whole(result)) : Number();
    };
}

const std::vector<std::string> kQuestions = {"polygon_tests", "toi_calls", "distance_calls"};

std::vector<std::string> EventNames() {
    std::vector<std::string> names;
    for (const char *event : {"start", "stab", "push", "roll", "coarsen", "contact", "leave"})
        names.push_back(std::string("plugin/events/") + event);
    return names;
}

/// Stock's tests that found a pair apart, and that a certificate answered: proved, or with a budget left, or
/// renewed by the pair's own line. (What is left the plugin searches itself, so that its calls of
/// b2CollidePolygons would not tell.)
Number SavedTests(const SceneResult &result) {
    const Number stock = NumberAt(result.stockCount, "/polygon_tests_apart"),
                 proved = NumberAt(result.pluginCount, "/plugin/proved_apart"),
                 pairs = NumberAt(result.pluginCount, "/plugin/pairs"),
                 updates = NumberAt(result.pluginCount, "/plugin/updates");
    if (!stock || !proved)
        return std::nullopt;
    return std::min(*proved + (pairs && updates ? *pairs - *updates : 0.0), *stock);
}

using Times = std::vector<nlohmann::json> SceneResult::*;
constexpr Times kStockTimes = &SceneResult::stockTimes, kPluginTimes = &SceneResult::pluginTimes;
// Box2D's own profile gives milliseconds, the worker's clock around a step nanoseconds.
constexpr char kNarrowPhase[] = "/collide_ms_total", kWholeStep[] = "/step_ns_total";
constexpr double kFromMilliseconds = 1e3, kFromNanoseconds = 1e-3;

std::vector<double> Column(const std::vector<nlohmann::json> &summaries, const char *time) {
    std::vector<double> values;
    for (const nlohmann::json &summary : summaries)
        if (const Number value = NumberAt(summary, time))
            values.push_back(*value);
    return values;
}

/// The value at this share of the way from the least to the greatest: at 0.5 the median, the mean of two if
/// two are in the middle.
Number Quantile(std::vector<double> values, double share) {
    if (values.empty())
        return std::nullopt;
    std::sort(values.begin(), values.end());
    const double place = share * static_cast<double>(values.size() - 1);
    return 0.5 *
           (values[static_cast<size_t>(std::floor(place))] + values[static_cast<size_t>(std::ceil(place))]);
}

Figure Microseconds(Times times, const char *time) {
    const double factor = time == kNarrowPhase ? kFromMilliseconds : kFromNanoseconds;
    return PerStep([=](const SceneResult &result) {
        const Number median = Quantile(Column(result.*times, time), 0.5);
        return median ? *median * factor : median;
    });
}

/// Stock over the plugin, pair of runs by pair of runs: the least of them (0), the median or the greatest
/// (1).
Figure Ratio(const char *time, double share = 0.5) {
    return [=](const SceneResult &result) {
        const std::vector<double> stock = Column(result.stockTimes, time),
                                  plugin = Column(result.pluginTimes, time);
        std::vector<double> ratios;
        for (size_t i = 0; i < std::min(stock.size(), plugin.size()); ++i)
            if (plugin[i] > 0.0)
                ratios.push_back(stock[i] / plugin[i]);
        return Quantile(std::move(ratios), share);
    };
}

Number MeanRatio(const std::vector<SceneResult> &results, const char *time) {
    double logarithms = 0.0, count = 0.0;
    for (const SceneResult &result : results)
        if (const Number ratio = Ratio(time)(result)) {
            logarithms += std::log(*ratio);
            ++count;
        }
    return count > 0.0 ? std::exp(logarithms / count) : Number();
}

// --- tables of scenes ---

/// The group of columns whose figures are speed-ups.
constexpr char kRatioGroup[] = "step ratio";
/// A whole step slower than this is one to look into: what is nearer to 1 is the machine's noise.
constexpr double kSlower = 0.98;

struct SceneColumn {
    const char *group, *name;
    Figure figure;
    int decimals;
};

/// A table of scenes.
struct SceneTable {
    std::string title;
    std::vector<SceneColumn> columns;
    std::vector<std::string> legend; ///< a line each
};

SceneTable TestTable() {
    return {
        "Separation tests, calls per step",
        {
            {"", "bodies", Sum(kStockCount, {"bodies"}), 0},
            {"", "contacts", Sum(kStockCount, {"contacts"}), 0},
            {"polygon tests", "stock", PerStep(kStockCount, {"polygon_tests"}), 1},
            {"polygon tests", "plugin", PerStep(kPluginCount, {"polygon_tests"}), 1},
            {"of them apart", "stock", PerStep(kStockCount, {"polygon_tests_apart"}), 1},
            {"of them apart", "saved %", Percent(SavedTests, Sum(kStockCount, {"polygon_tests_apart"})), 1},
            {"TOI calls", "stock", PerStep(kStockCount, {"toi_calls"}), 1},
            {"TOI calls", "plugin", PerStep(kPluginCount, {"toi_calls"}), 1},
            {"b2Distance", "stock", PerStep(kStockCount, {"distance_calls"}), 1},
            {"b2Distance", "plugin", PerStep(kPluginCount, {"distance_calls"}), 1},
        },
        {
            "contacts: pairs whose fat boxes overlap, mean per step; polygon tests: b2CollidePolygons; "
            "apart: no point found",
            "TOI calls: b2TimeOfImpact; saved: of the tests that found stock's pairs apart, those that a "
            "certificate answered",
        }};
}

SceneTable BudgetTable() {
    return {
        "How kinetic the world is: pairs and which were updated, per step",
        {
            {"budgets of motion", "pairs", PerStep(kPluginCount, {"plugin/pairs"}), 1},
            {"budgets of motion", "renewed", PerStep(kPluginCount, {"plugin/renewals"}), 1},
            {"budgets of motion", "updates", PerStep(kPluginCount, {"plugin/updates"}), 1},
            {"budgets of motion", "% updates",
             Percent(Sum(kPluginCount, {"plugin/updates"}), Sum(kPluginCount, {"plugin/pairs"})), 1},
            {"of certificates", "events", PerStep(kPluginCount, EventNames()), 2},
            {"of certificates", "% events",
             Percent(Sum(kPluginCount, EventNames()), Sum(kPluginCount, {"plugin/pairs"})), 2},
        },
        {
            "pairs: contacts of bodies that are awake; renewed: by their own line, whose shapes and contact "
            "nobody read",
            "updates: whose contact or shapes were read; of all others nothing but a deadline was",
            "events: certificates made, replaced and given up; %: of the pairs",
        }};
}

SceneTable EventTable() {
    return {
        "What the plugin did instead, per step",
        {
            {"certificate checks", "edge", PerStep(kPluginCount, {"plugin/edge_checks"}), 1},
            {"certificate checks", "hulls", PerStep(kPluginCount, {"plugin/hull_checks"}), 1},
            {"events", "start", PerStep(kPluginCount, {"plugin/events/start"}), 2},
            {"events", "stab", PerStep(kPluginCount, {"plugin/events/stab"}), 2},
            {"events", "push", PerStep(kPluginCount, {"plugin/events/push"}), 2},
            {"events", "roll", PerStep(kPluginCount, {"plugin/events/roll"}), 2},
            {"events", "coarsen", PerStep(kPluginCount, {"plugin/events/coarsen"}), 2},
            {"events", "contact", PerStep(kPluginCount, {"plugin/events/contact"}), 2},
            {"events", "leave", PerStep(kPluginCount, {"plugin/events/leave"}), 2},
            {"answers", "apart", PerStep(kPluginCount, {"plugin/proved_apart"}), 1},
            {"answers", "reused", PerStep(kPluginCount, {"plugin/verdicts_reused"}), 1},
            {"answers", "hand-over", PerStep(kPluginCount, {"plugin/handed_over"}), 1},
        },
        {
            "edge: one remembered edge asked again; hulls: certificates of --structure",
            "start, stab, push, roll, coarsen: the life of a certificate; contact: its end, the exact test "
            "is asked; leave: a new one",
            "apart: proved, without Box2D; reused: of those, at the same poses (--structure); hand-over: the "
            "exact test",
        }};
}

/// How long a step takes: shown beside the verdicts, too.
const std::vector<SceneColumn> kStepColumns = {
    {"whole step, us", "stock", Microseconds(kStockTimes, kWholeStep), 1},
    {"whole step, us", "linked", Microseconds(kPluginTimes, kWholeStep), 1},
    {kRatioGroup, "linked", Ratio(kWholeStep), 2},
    {kRatioGroup, "from", Ratio(kWholeStep, 0.0), 2},
    {kRatioGroup, "to", Ratio(kWholeStep, 1.0), 2},
};

/// Medians of so many runs.
SceneTable TimeTable(int repeat) {
    SceneTable table = {
        "Time per step",
        {
            {"narrow phase, us", "stock", Microseconds(kStockTimes, kNarrowPhase), 1},
            {"narrow phase, us", "linked", Microseconds(kPluginTimes, kNarrowPhase), 1},
            {"narrow phase, us", "ratio", Ratio(kNarrowPhase), 2},
        },
        {"time: median of " + std::to_string(repeat) +
             " runs; ratio: stock / plugin, the median over pairs of runs; above 1 the plugin is faster",
         "from, to: the least and the greatest of the pairs, linked: a difference within them is noise"}};
    table.columns.insert(table.columns.end(), kStepColumns.begin(), kStepColumns.end());
    return table;
}

/// What the ways to have the plugin at work are called, and what "bits" are.
const std::vector<std::string> kVerdictLegend = {
    "linked: a program that was linked with the plugin; preloaded: stock's program, plugin in LD_PRELOAD",
    "bits: every body, contact, impulse and listener event of every step, hashed and compared",
    "question: a call of b2CollidePolygons, b2TimeOfImpact or b2Distance; event: of a certificate",
    "any-...: stock Box2D does not have these polygons; its place has the plugin switched off "
    "(BOOMERANG=off)"};

void AddFigures(std::vector<Table::Cell> &row, const SceneResult &result,
                const std::vector<SceneColumn> &columns) {
    for (const SceneColumn &column : columns) {
        const Number figure = column.figure(result);
        Style style = figure ? Style::Plain : Style::Faint;
        if (figure && column.group == std::string(kRatioGroup))
            style = *figure < kSlower ? Style::Bad : Style::Good;
        row.push_back({Fixed(figure, column.decimals), style});
    }
}

Table TableOf(const std::vector<SceneResult> &results, const SceneTable &layout) {
    const std::vector<SceneColumn> &columns = layout.columns;
    Table table = {};
    table.AddColumn("", "scene");
    for (const SceneColumn &column : columns)
        table.AddColumn(column.group, column.name);
    for (const SceneResult &result : results) {
        std::vector<Table::Cell> row = {{result.scene.name, Style::Plain}};
        AddFigures(row, result, columns);
        table.AddRow(std::move(row));
    }
    return table;
}

/// A column for each way to have the plugin at work, one for all of them, and how long a step takes, where
/// that was measured.
void PrintVerdicts(std::ostream &out, const std::vector<SceneResult> &results, const CompareOptions &options,
                   bool colour) {
    constexpr Side sides[] = {Side::Plugin, Side::Preloaded};
    auto cell = [](Verdict verdict) {
        return Table::Cell{NameOf(verdict), verdict == Verdict::Identical ? Style::Good : Style::Bad};
    };
    Table table = {};
    table.AddColumn("", "scene");
    table.AddColumn("", "steps");
    for (const Side side : sides)
        table.AddColumn("bits, against stock's", NameOf(side));
    table.AddColumn("", "all");
    const std::vector<SceneColumn> columns = options.time ? kStepColumns : std::vector<SceneColumn>();
    for (const SceneColumn &column : columns)
        table.AddColumn(column.group, column.name);
    for (const SceneResult &result : results) {
        std::vector<Table::Cell> row = {{result.scene.name, Style::Plain},
                                        {std::to_string(result.steps), Style::Plain}};
        for (const Side side : sides) {
            const auto variant = result.variants.find(side);
            row.push_back(variant != result.variants.end() ? cell(variant->second)
                                                           : Table::Cell{"-", Style::Faint});
        }
        row.push_back(cell(result.verdict));
        AddFigures(row, result, columns);
        table.AddRow(std::move(row));
    }
    table.Print(out, colour);
}

void PrintLegend(std::ostream &out, const std::vector<std::string> &legend, bool colour) {
    for (const std::string &line : legend)
        out << Styled(line, Style::Faint, colour) << '\n';
}

size_t CountOf(const std::vector<SceneResult> &results, Verdict verdict) {
    return static_cast<size_t>(std::count_if(results.begin(), results.end(),
                                             [verdict](const auto &r) { return r.verdict == verdict; }));
}

} // namespace

void PrintTables(std::ostream &out, const std::vector<SceneResult> &results, const CompareOptions &options,
                 bool details, bool colour) {
    auto print = [&](const SceneTable &table) {
        out << '\n' << Styled(table.title, Style::Strong, colour) << '\n';
        TableOf(results, table).Print(out, colour);
    };
    out << '\n';
    PrintVerdicts(out, results, options, colour);
    if (!details) {
        out << '\n'
            << Styled("--details: calls of Box2D, budgets, events and times, and what the columns mean",
                      Style::Faint, colour)
            << '\n';
        return;
    }
    std::vector<SceneTable> tables = {TestTable(), BudgetTable(), EventTable()};
    if (options.time)
        tables.push_back(TimeTable(options.repeat));
    for (const SceneTable &table : tables)
        print(table);
    out << '\n';
    for (const SceneTable &table : tables)
        PrintLegend(out, table.legend, colour);
    PrintLegend(out, kVerdictLegend, colour);
}

void PrintQuestions(std::ostream &out, const std::vector<SceneResult> &results, bool colour) {
    double questions = 0.0, events = 0.0;
    size_t counted = 0;
    std::string name;
    for (const SceneResult &result : results) {
        const Number asked = PerStep(kStockCount, kQuestions)(result),
                     happened = PerStep(kPluginCount, EventNames())(result);
        if (!asked || !happened)
            continue;
        questions += *asked;
        events += *happened;
        ++counted;
        name = result.scene.name;
    }
    if (counted == 0)
        return;
    out << Styled(QuestionsFor(counted == 1 ? name : std::to_string(counted) + " scenes together", questions,
                               "a step in stock", events),
                  Style::Strong, colour)
        << '\n';
}

void PrintVerdict(std::ostream &out, const std::vector<SceneResult> &results, bool colour) {
    const size_t identical = CountOf(results, Verdict::Identical);
    const size_t different = CountOf(results, Verdict::Different);
    const size_t failed = CountOf(results, Verdict::Failed);
    std::string text = std::to_string(identical) + (identical == 1 ? " scene" : " scenes") + " identical, " +
                       std::to_string(different) + " different";
    if (failed != 0)
        text += ", " + std::to_string(failed) + " failed";
    if (const auto ratio = MeanRatio(results, kWholeStep))
        text += "; step " + Fixed(ratio, 2) + "x, narrow phase " +
                Fixed(MeanRatio(results, kNarrowPhase), 2) + "x as fast as stock (geometric means)";
    out << Styled(text, different + failed == 0 ? Style::Good : Style::Bad, colour) << '\n';
}

} // namespace testbed
