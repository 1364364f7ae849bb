// SPDX-License-Identifier: MIT
#include "report.h"

#include <algorithm>

#include "figures.h"
#include "table.h"

namespace testbed {
namespace {

struct TableColumn {
    const char *group, *name, *figure;
    int decimals;
};

constexpr TableColumn kTestColumns[] = {
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
};

constexpr TableColumn kEventColumns[] = {
    {"certificate checks", "edge", "checks.edge_per_step", 1},
    {"certificate checks", "search", "plugin.edge_searches_per_step", 1},
    {"certificate checks", "kinetic", "checks.kinetic_per_step", 1},
    {"events", "start", "events.start_per_step", 2},
    {"events", "stab", "events.stab_per_step", 2},
    {"events", "push", "events.push_per_step", 2},
    {"events", "roll", "events.roll_per_step", 2},
    {"events", "coarsen", "events.coarsen_per_step", 2},
    {"events", "hand-over", "events.hand_over_per_step", 2},
    {"answers", "proved apart", "plugin.proved_apart_per_step", 1},
    {"answers", "reused", "plugin.verdicts_reused_per_step", 1},
};

constexpr TableColumn kTimeColumns[] = {
    {"narrow phase, us", "stock", "stock.narrow_phase_us_per_step", 1},
    {"narrow phase, us", "linked", "plugin.narrow_phase_us_per_step", 1},
    {"narrow phase, us", "ratio", "ratio.narrow_phase", 2},
    {"whole step, us", "stock", "stock.step_us_per_step", 1},
    {"whole step, us", "register", "register.step_us_per_step", 1},
    {"whole step, us", "linked", "plugin.step_us_per_step", 1},
    {"step ratio", "register", "ratio_register.step", 2},
    {"step ratio", "linked", "ratio.step", 2},
};

constexpr TableColumn kVerifyColumns[] = {
    {"answers", "compared", "verify.compared", 0},
    {"answers", "different", "verify.differences", 0},
};

/// A whole step slower than this is one to look into: what is nearer to 1 is the machine's noise.
constexpr double kSlower = 0.98;

template <size_t N>
void PrintTable(std::ostream &out, const std::vector<SceneResult> &results, const TableColumn (&columns)[N],
                bool colour) {
    Table table;
    table.AddColumn("", "scene");
    for (const TableColumn &column : columns)
        table.AddColumn(column.group, column.name);
    for (const SceneResult &result : results) {
        const Figures figures(result);
        std::vector<Table::Cell> row = {{result.scene.name, Style::Plain}};
        for (const TableColumn &column : columns) {
            const std::optional<double> figure = figures[column.figure];
            Style style = figure ? Style::Plain : Style::Faint;
            if (figure && column.group == std::string("step ratio"))
                style = *figure < kSlower ? Style::Bad : Style::Good;
            row.push_back({Fixed(figure, column.decimals), style});
        }
        table.AddRow(std::move(row));
    }
    table.Print(out, colour);
}

/// A column for each way to have the plugin at work, and one for all of them.
void PrintVerdicts(std::ostream &out, const std::vector<SceneResult> &results, bool colour) {
    constexpr Side kSides[] = {Side::Register, Side::Plugin, Side::Preloaded};
    auto cell = [](Verdict verdict) {
        return Table::Cell{NameOf(verdict), verdict == Verdict::Identical ? Style::Good : Style::Bad};
    };
    Table table;
    table.AddColumn("", "scene");
    table.AddColumn("", "steps");
    for (const Side side : kSides)
        table.AddColumn("bits, against stock's", NameOf(side));
    table.AddColumn("", "all");
    for (const SceneResult &result : results) {
        std::vector<Table::Cell> row = {{result.scene.name, Style::Plain},
                                        {std::to_string(result.steps), Style::Plain}};
        for (const Side side : kSides) {
            const Variant *variant = FindVariant(result, side);
            row.push_back(variant != nullptr ? cell(variant->verdict) : Table::Cell{"-", Style::Faint});
        }
        row.push_back(cell(result.verdict));
        table.AddRow(std::move(row));
    }
    table.Print(out, colour);
}

void PrintLegend(std::ostream &out, const CompareOptions &options, bool colour) {
    auto line = [&out, colour](const std::string &text) {
        out << Styled(text, Style::Faint, colour) << '\n';
    };
    line("contacts: pairs whose fat boxes overlap, mean per step; polygon tests: b2CollidePolygons; apart: "
         "no point found");
    line("TOI calls: b2TimeOfImpact; saved: of the tests that found stock's pairs apart, those that a "
         "certificate answered");
    line("edge: one remembered edge asked again; search: all edges, when it failed; kinetic: a body pair's "
         "certificate asked again");
    line("start, stab, push, roll, coarsen: the life of a certificate; hand-over: its end, the polygons are "
         "searched");
    line(
        "proved apart: answered without Box2D; reused: of those, by what was found at the same poses before");
    if (options.time)
        line("time: median of " + std::to_string(options.repeat) +
             " runs; ratio: stock / plugin, the median over pairs of runs; above 1 the plugin is faster");
    line("register: linked, contacts alone, no hooks; linked: all hooks; preloaded: stock's program, plugin "
         "in LD_PRELOAD");
    line("bits: every body, contact, impulse and listener event of every step, hashed and compared");
}

size_t CountOf(const std::vector<SceneResult> &results, Verdict verdict) {
    return static_cast<size_t>(std::count_if(results.begin(), results.end(),
                                             [verdict](const auto &r) { return r.verdict == verdict; }));
}

std::optional<double> MeanRatio(const std::vector<SceneResult> &results, const char *figure) {
    std::vector<double> ratios;
    for (const SceneResult &result : results)
        if (const std::optional<double> ratio = Figures(result)[figure])
            ratios.push_back(*ratio);
    return GeometricMean(ratios);
}

nlohmann::json ToJson(std::optional<double> value) {
    return value ? nlohmann::json(*value) : nlohmann::json();
}

nlohmann::json ToJson(const SceneResult &result) {
    nlohmann::json json = ToJson(result.scene);
    json["steps"] = result.steps;
    json["verdict"] = result.verdict == Verdict::Different ? "different" : NameOf(result.verdict);
    json["failure"] = result.failure.empty() ? nlohmann::json() : nlohmann::json(result.failure);
    json["difference"] = nullptr;
    if (result.difference) {
        const Difference &difference = *result.difference;
        json["difference"] = {{"side", NameOf(difference.side)}, {"step", difference.step},
                              {"hashes", difference.hashes},     {"field", difference.field},
                              {"stock", difference.stock},       {"plugin", difference.plugin},
                              {"fields", difference.fields}};
    }
    for (const Variant &variant : result.variants)
        json["variants"][NameOf(variant.side)] = NameOf(variant.verdict);
    const Figures figures(result);
    for (const auto &[name, value] : figures.All()) {
        std::string pointer = "/figures/" + name;
        std::replace(pointer.begin(), pointer.end(), '.', '/');
        json[nlohmann::json::json_pointer(pointer)] = ToJson(value);
    }
    json["summaries"] = {{"stock", {{"count", result.stockCount}, {"time", result.stockTimes}}},
                         {"register", {{"time", result.registerTimes}}},
                         {"verify", {{"count", result.verifyCount}, {"words", result.verifyWords}}},
                         {"plugin", {{"count", result.pluginCount}, {"time", result.pluginTimes}}}};
    return json;
}

} // namespace

void PrintTables(std::ostream &out, const std::vector<SceneResult> &results, const CompareOptions &options,
                 bool colour) {
    auto title = [&out, colour](const char *text) {
        out << '\n' << Styled(text, Style::Strong, colour) << '\n';
    };
    if (options.verify) {
        title("Every answer of the plugin beside Box2D's, in one process");
        PrintTable(out, results, kVerifyColumns, colour);
        return;
    }
    title("Separation tests, calls per step");
    PrintTable(out, results, kTestColumns, colour);
    title("What the plugin did instead, per step");
    PrintTable(out, results, kEventColumns, colour);
    if (options.time) {
        title("Time per step");
        PrintTable(out, results, kTimeColumns, colour);
    }
    title("Whether the bits agree");
    PrintVerdicts(out, results, colour);
    out << '\n';
    PrintLegend(out, options, colour);
}

void PrintClosingLine(std::ostream &out, const std::vector<SceneResult> &results, bool colour) {
    const size_t identical = CountOf(results, Verdict::Identical);
    const size_t different = CountOf(results, Verdict::Different);
    const size_t failed = CountOf(results, Verdict::Failed);
    std::string text = std::to_string(identical) + (identical == 1 ? " scene" : " scenes") + " identical, " +
                       std::to_string(different) + " different";
    if (failed != 0)
        text += ", " + std::to_string(failed) + " failed";
    if (const auto ratio = MeanRatio(results, "ratio.step"))
        text += "; step " + Fixed(ratio, 2) + "x, narrow phase " +
                Fixed(MeanRatio(results, "ratio.narrow_phase"), 2) + "x as fast as stock (geometric means)";
    out << Styled(text, different + failed == 0 ? Style::Good : Style::Bad, colour) << '\n';
}

void WriteJson(std::ostream &out, const std::vector<SceneResult> &results, const CompareOptions &options) {
    nlohmann::json scenes = nlohmann::json::array();
    for (const SceneResult &result : results)
        scenes.push_back(ToJson(result));
    const nlohmann::json json = {
        {"options",
         {{"mode", options.verify ? "verify" : "bits"},
          {"repeat", options.time ? options.repeat : 0},
          {"structure", options.worker.structure.empty() ? "default" : options.worker.structure},
          {"prefilter", options.worker.prefilter.empty() ? "default" : options.worker.prefilter},
          {"perturb", options.perturb ? nlohmann::json(*options.perturb) : nlohmann::json()}}},
        {"scenes", scenes},
        {"identical", CountOf(results, Verdict::Identical)},
        {"different", CountOf(results, Verdict::Different)},
        {"failed", CountOf(results, Verdict::Failed)},
        {"geometric_mean",
         {{"step_ratio", ToJson(MeanRatio(results, "ratio.step"))},
          {"narrow_phase_ratio", ToJson(MeanRatio(results, "ratio.narrow_phase"))}}},
    };
    // A worker's stderr may hold anything; a report must be valid all the same.
    out << json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

void WriteCsv(std::ostream &out, const std::vector<SceneResult> &results) {
    out << "scene,group,size,seed,steps,verdict,difference_step,difference_field";
    const Figures names{SceneResult()};
    for (const auto &entry : names.All())
        out << ',' << entry.first;
    out << '\n';
    for (const SceneResult &result : results) {
        out << result.scene.name << ',' << result.scene.group << ',' << result.scene.size << ','
            << result.scene.seed << ',' << result.steps << ','
            << (result.verdict == Verdict::Different ? "different" : NameOf(result.verdict)) << ',';
        if (result.difference)
            out << result.difference->step << ',' << result.difference->field;
        else
            out << ',';
        const Figures figures(result);
        for (const auto &entry : figures.All())
            out << ',' << (entry.second ? Fixed(entry.second, 6) : std::string());
        out << '\n';
    }
}

} // namespace testbed
