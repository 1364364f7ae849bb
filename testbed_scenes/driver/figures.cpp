// SPDX-License-Identifier: MIT
#include "figures.h"

#include <algorithm>
#include <cmath>

namespace testbed {
namespace {

std::optional<double> Quotient(std::optional<double> numerator, std::optional<double> denominator) {
    if (!numerator || !denominator || *denominator == 0.0)
        return std::nullopt;
    return *numerator / *denominator;
}

/// One number of each summary in turn; empty if any lacks it.
std::vector<double> Column(const std::vector<nlohmann::json> &summaries, const std::string &pointer) {
    std::vector<double> column;
    for (const nlohmann::json &summary : summaries) {
        const std::optional<double> number = NumberAt(summary, pointer);
        if (!number)
            return {};
        column.push_back(*number);
    }
    return column;
}

/// The median of the ratios of runs that were made one after the other: what slows the machine down for a
/// while slows both runs of a pair, and cancels.
std::vector<double> PairedRatios(const std::vector<double> &stock, const std::vector<double> &plugin) {
    std::vector<double> ratios;
    for (size_t i = 0; i < std::min(stock.size(), plugin.size()); ++i)
        if (plugin[i] > 0.0)
            ratios.push_back(stock[i] / plugin[i]);
    return ratios;
}

std::optional<double> Scaled(std::optional<double> value, double factor) {
    if (!value)
        return std::nullopt;
    return *value * factor;
}

} // namespace

std::optional<double> Median(std::vector<double> values) {
    if (values.empty())
        return std::nullopt;
    std::sort(values.begin(), values.end());
    const size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

std::optional<double> GeometricMean(const std::vector<double> &values) {
    if (values.empty())
        return std::nullopt;
    double logarithms = 0.0;
    for (double value : values)
        logarithms += std::log(value);
    return std::exp(logarithms / static_cast<double>(values.size()));
}

Figures::Figures(const SceneResult &result) {
    AddCounts(result);
    AddEvents(result);
    AddTimes(result);
}

std::optional<double> Figures::operator[](const std::string &name) const {
    for (const auto &[key, value] : m_values)
        if (key == name)
            return value;
    return std::nullopt;
}

void Figures::AddCounts(const SceneResult &result) {
    const double steps = static_cast<double>(std::max<int64_t>(result.steps, 1));
    Add("bodies", NumberAt(result.stockCount, "/bodies"));
    Add("contacts", NumberAt(result.stockCount, "/contacts"));
    for (const char *side : {"stock", "plugin"}) {
        const nlohmann::json &count = side == std::string("stock") ? result.stockCount : result.pluginCount;
        for (const char *call :
             {"polygon_tests", "polygon_tests_apart", "toi_calls", "distance_calls", "overlap_calls"})
            Add(std::string(side) + "." + call + "_per_step",
                Scaled(NumberAt(count, std::string("/") + call), 1.0 / steps));
    }
    std::optional<double> tests = 0.0;
    for (const char *call : {"polygon_tests", "overlap_calls", "toi_calls"}) {
        const std::optional<double> some = NumberAt(result.stockCount, std::string("/") + call);
        tests = tests && some ? *tests + *some : std::optional<double>();
    }
    Add("stock.tests_per_step", Scaled(tests, 1.0 / steps));
    // The share of the tests that told stock nothing but "apart" and that a certificate answered. (What is
    // left the plugin searches itself, so that its calls of b2CollidePolygons would not tell.)
    const std::optional<double> stock = NumberAt(result.stockCount, "/polygon_tests_apart");
    const std::optional<double> proved = NumberAt(result.pluginCount, "/plugin/proved_apart");
    const std::optional<double> pairs = NumberAt(result.pluginCount, "/plugin/pairs");
    const std::optional<double> looks = NumberAt(result.pluginCount, "/plugin/looks");
    // Pairs that nobody looked at had a budget left that a certificate gave them, or were renewed by its
    // line.
    const std::optional<double> answered = proved && pairs && looks ? *proved + (*pairs - *looks) : proved;
    Add("saved.polygon_tests_apart_percent",
        stock && answered ? Quotient(100.0 * std::min(*answered, *stock), stock) : std::optional<double>());
}

void Figures::AddEvents(const SceneResult &result) {
    const double perStep = 1.0 / static_cast<double>(std::max<int64_t>(result.steps, 1));
    auto add = [&](const std::string &name, const std::string &pointer) {
        Add(name, Scaled(NumberAt(result.pluginCount, "/plugin/" + pointer), perStep));
    };
    const std::optional<double> edges = NumberAt(result.pluginCount, "/plugin/edge_checks");
    const std::optional<double> hulls = NumberAt(result.pluginCount, "/plugin/hull_checks");
    Add("checks.all_per_step", edges && hulls ? Scaled(*edges + *hulls, perStep) : std::optional<double>());
    Add("checks.edge_per_step", Scaled(edges, perStep));
    Add("checks.hulls_per_step", Scaled(hulls, perStep));
    const std::optional<double> pairs = NumberAt(result.pluginCount, "/plugin/pairs");
    const std::optional<double> looks = NumberAt(result.pluginCount, "/plugin/looks");
    add("ledger.pairs_per_step", "pairs");
    add("ledger.looks_per_step", "looks");
    add("ledger.renewals_per_step", "renewals");
    Add("ledger.looks_percent", looks && pairs ? Quotient(100.0 * *looks, pairs) : std::optional<double>());
    add("plugin.verdicts_reused_per_step", "verdicts_reused");
    add("plugin.proved_apart_per_step", "proved_apart");
    const auto ofLines = [&](const std::string &name) {
        return NumberAt(result.linesCount, "/plugin/" + name);
    };
    for (const char *count : {"pairs", "looks", "renewals"})
        Add(std::string("lines.") + count + "_per_step", Scaled(ofLines(count), perStep));
    std::optional<double> all = 0.0, lines = 0.0;
    for (const char *event : {"start", "stab", "push", "roll", "coarsen", "contact", "leave"}) {
        const std::optional<double> ofLine = ofLines(std::string("events/") + event);
        lines = lines && ofLine ? *lines + *ofLine : std::optional<double>();
        const std::optional<double> count =
            NumberAt(result.pluginCount, std::string("/plugin/events/") + event);
        Add(std::string("events.") + event + "_per_step", Scaled(count, perStep));
        all = all && count ? *all + *count : std::optional<double>();
    }
    Add("events.all_per_step", Scaled(all, perStep));
    Add("lines.events_per_step", Scaled(lines, perStep));
    Add("events.all_percent", all && pairs ? Quotient(100.0 * *all, pairs) : std::optional<double>());
    add("events.hand_over_per_step", "handed_over");
    Add("verify.compared", NumberAt(result.verifyCount, "/plugin/verified"));
    Add("verify.differences", NumberAt(result.verifyCount, "/plugin/differences"));
}

void Figures::AddTimes(const SceneResult &result) {
    const double steps = static_cast<double>(std::max<int64_t>(result.steps, 1));
    struct Time {
        const char *name, *pointer;
        double toMicroseconds;
    };
    // Box2D's own profile gives milliseconds, the worker's clock around a step nanoseconds.
    constexpr double kFromMilliseconds = 1e3, kFromNanoseconds = 1e-3;
    for (const Time &time :
         {Time{"narrow_phase", "/collide_ms_total", kFromMilliseconds},
          Time{"toi", "/solveTOI_ms", kFromMilliseconds}, Time{"step", "/step_ns_total", kFromNanoseconds}}) {
        const std::vector<double> stock = Column(result.stockTimes, time.pointer);
        const std::vector<double> plugin = Column(result.pluginTimes, time.pointer);
        const double factor = time.toMicroseconds / steps;
        const std::string name = time.name;
        Add("stock." + name + "_us_per_step", Scaled(Median(stock), factor));
        Add("plugin." + name + "_us_per_step", Scaled(Median(plugin), factor));
        const std::vector<double> accelerated = Column(result.acceleratedTimes, time.pointer);
        Add("accelerated." + name + "_us_per_step", Scaled(Median(accelerated), factor));
        Add("ratio_accelerated." + name, Median(PairedRatios(stock, accelerated)));
        const std::vector<double> ratios = PairedRatios(stock, plugin);
        Add("ratio." + name, Median(ratios));
        Add("ratio." + name + "_least",
            ratios.empty() ? std::optional<double>() : *std::min_element(ratios.begin(), ratios.end()));
        Add("ratio." + name + "_greatest",
            ratios.empty() ? std::optional<double>() : *std::max_element(ratios.begin(), ratios.end()));
    }
}

const SceneTable &TestTable() {
    static const SceneTable table = {
        "Separation tests, calls per step",
        {
            {"", "bodies", "bodies", 0},
            {"", "contacts", "contacts", 0},
            {"polygon tests", "stock", "stock.polygon_tests_per_step", 1},
            {"polygon tests", "plugin", "plugin.polygon_tests_per_step", 1},
            {"of them apart", "stock", "stock.polygon_tests_apart_per_step", 1},
            {"of them apart", "saved %", "saved.polygon_tests_apart_percent", 1},
            {"TOI calls", "stock", "stock.toi_calls_per_step", 1},
            {"TOI calls", "plugin", "plugin.toi_calls_per_step", 1},
            {"b2Distance", "stock", "stock.distance_calls_per_step", 1},
            {"b2Distance", "plugin", "plugin.distance_calls_per_step", 1},
        },
        {
            "contacts: pairs whose fat boxes overlap, mean per step; polygon tests: b2CollidePolygons; "
            "apart: "
            "no point found",
            "TOI calls: b2TimeOfImpact; saved: of the tests that found stock's pairs apart, those that a "
            "certificate answered",
        }};
    return table;
}

const SceneTable &BudgetTable() {
    static const SceneTable table = {
        "How kinetic the world is: pairs and who was looked at, per step",
        {
            {"budgets of motion", "pairs", "ledger.pairs_per_step", 1},
            {"budgets of motion", "renewed", "ledger.renewals_per_step", 1},
            {"budgets of motion", "looks", "ledger.looks_per_step", 1},
            {"budgets of motion", "% looks", "ledger.looks_percent", 1},
            {"of certificates", "events", "events.all_per_step", 2},
            {"of certificates", "% events", "events.all_percent", 2},
        },
        {
            "pairs: contacts of bodies that are awake; renewed: by their own line, whose shapes and contact "
            "nobody "
            "read",
            "looks: whose contact or shapes were read; of all others nothing but a deadline was",
            "events: certificates made, replaced and given up; %: of the pairs",
        }};
    return table;
}

const SceneTable &EventTable() {
    static const SceneTable table = {
        "What the plugin did instead, per step",
        {
            {"certificate checks", "edge", "checks.edge_per_step", 1},
            {"certificate checks", "hulls", "checks.hulls_per_step", 1},
            {"events", "start", "events.start_per_step", 2},
            {"events", "stab", "events.stab_per_step", 2},
            {"events", "push", "events.push_per_step", 2},
            {"events", "roll", "events.roll_per_step", 2},
            {"events", "coarsen", "events.coarsen_per_step", 2},
            {"events", "contact", "events.contact_per_step", 2},
            {"events", "leave", "events.leave_per_step", 2},
            {"answers", "apart", "plugin.proved_apart_per_step", 1},
            {"answers", "reused", "plugin.verdicts_reused_per_step", 1},
            {"answers", "hand-over", "events.hand_over_per_step", 1},
        },
        {
            "edge: one remembered edge asked again; search: all edges, when it failed; hulls: of --structure",
            "start, stab, push, roll, coarsen: the life of a certificate; contact: its end, the exact test "
            "is asked; leave: a new one",
            "apart: proved, without Box2D; reused: of those, at the same poses (--structure); hand-over: the "
            "exact test",
        }};
    return table;
}

const SceneTable &ModeTable() {
    static const SceneTable table = {
        "Events of both modes beside Box2D's own distance calls, per step",
        {
            {"stock Box2D", "tests", "stock.tests_per_step", 1},
            {"stock Box2D", "b2Distance", "stock.distance_calls_per_step", 1},
            {"a line a contact", "pairs", "lines.pairs_per_step", 1},
            {"a line a contact", "renewed", "lines.renewals_per_step", 1},
            {"a line a contact", "looks", "lines.looks_per_step", 1},
            {"a line a contact", "events", "lines.events_per_step", 2},
            {"a structure a pair of bodies", "looks", "ledger.looks_per_step", 1},
            {"a structure a pair of bodies", "checks", "checks.hulls_per_step", 1},
            {"a structure a pair of bodies", "events", "events.all_per_step", 2},
            {"a structure a pair of bodies", "exact", "events.hand_over_per_step", 1},
        },
        {
            "tests: b2CollidePolygons, b2TestOverlap and b2TimeOfImpact; b2Distance: within the last two",
            "a line a contact: as games have it; its failure time is bounded instead of computed",
            "a structure a pair of bodies: --structure; checks: its certificates, asked",
            "exact: contact points computed, because a stab reached the hulls or because the two touched",
        }};
    return table;
}

const SceneTable &VerifyTable() {
    static const SceneTable table = {"Every answer of the plugin beside Box2D's, in one process",
                                     {
                                         {"answers", "compared", "verify.compared", 0},
                                         {"answers", "different", "verify.differences", 0},
                                     },
                                     {}};
    return table;
}

SceneTable TimeTable(int repeat, bool accelerated) {
    SceneTable table = {
        "Time per step",
        {
            {"narrow phase, us", "stock", "stock.narrow_phase_us_per_step", 1},
            {"narrow phase, us", "linked", "plugin.narrow_phase_us_per_step", 1},
            {"narrow phase, us", "ratio", "ratio.narrow_phase", 2},
            {"whole step, us", "stock", "stock.step_us_per_step", 1, true},
            {"whole step, us", "linked", "plugin.step_us_per_step", 1, true},
            {kRatioGroup, "linked", "ratio.step", 2, true},
            {kRatioGroup, "from", "ratio.step_least", 2, true},
            {kRatioGroup, "to", "ratio.step_greatest", 2, true},
        },
        {"time: median of " + std::to_string(repeat) +
             " runs; ratio: stock / plugin, the median over pairs of runs; above 1 the plugin is faster",
         "from, to: the least and the greatest of the pairs, linked: a difference within them is noise"}};
    if (accelerated) {
        table.columns.push_back({kRatioGroup, "accelerated", "ratio_accelerated.step", 2, true});
        table.legend.emplace_back(
            "accelerated: Box2D compiled with the plugin, against stock's shared library");
    }
    return table;
}

const std::vector<std::string> &VerdictLegend() {
    static const std::vector<std::string> legend = {
        "linked: a program that was linked with the plugin; preloaded: stock's program, plugin in LD_PRELOAD",
        "accelerated: Box2D compiled with the plugin, where this was built with Box2D's sources",
        "bits: every body, contact, impulse and listener event of every step, hashed and compared",
        "question: a call of b2CollidePolygons, b2TimeOfImpact or b2Distance; event: of a certificate",
        "any-...: stock Box2D does not have these polygons; its place has the plugin told to be off "
        "(BOOMERANG=off)"};
    return legend;
}

} // namespace testbed
