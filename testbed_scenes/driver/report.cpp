// SPDX-License-Identifier: MIT
#include "report.h"

#include <algorithm>

#include "figures.h"
#include "table.h"

namespace testbed {
namespace {

void AddFigures(std::vector<Table::Cell> &row, const SceneResult &result,
                const std::vector<SceneColumn> &columns) {
    const Figures figures(result);
    for (const SceneColumn &column : columns) {
        const std::optional<double> figure = figures[column.figure];
        Style style = figure ? Style::Plain : Style::Faint;
        if (figure && column.group == std::string(kRatioGroup))
            style = *figure < kSlower ? Style::Bad : Style::Good;
        row.push_back({Fixed(figure, column.decimals), style});
    }
}

Table TableOf(const std::vector<SceneResult> &results, const SceneTable &layout) {
    const std::vector<SceneColumn> &columns = layout.columns;
    Table table;
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

bool AnyIsAccelerated(const std::vector<SceneResult> &results) {
    return std::any_of(results.begin(), results.end(), [](const SceneResult &result) {
        return FindVariant(result, Side::Accelerated) != nullptr;
    });
}

/// A column for each way to have the plugin at work (the accelerated Box2D's where there is one), one for all
/// of them, and how long a step takes, where that was measured.
void PrintVerdicts(std::ostream &out, const std::vector<SceneResult> &results, const CompareOptions &options,
                   bool colour) {
    std::vector<Side> sides = {Side::Plugin, Side::Preloaded};
    if (AnyIsAccelerated(results))
        sides.push_back(Side::Accelerated);
    auto cell = [](Verdict verdict) {
        return Table::Cell{NameOf(verdict), verdict == Verdict::Identical ? Style::Good : Style::Bad};
    };
    Table table;
    table.AddColumn("", "scene");
    table.AddColumn("", "steps");
    for (const Side side : sides)
        table.AddColumn("bits, against stock's", NameOf(side));
    table.AddColumn("", "all");
    SceneTable times = TimeTable(options.repeat, AnyIsAccelerated(results));
    auto &columns = times.columns;
    columns.erase(std::remove_if(columns.begin(), columns.end(),
                                 [&](const SceneColumn &column) { return !options.time || !column.brief; }),
                  columns.end());
    for (const SceneColumn &column : columns)
        table.AddColumn(column.group, column.name);
    for (const SceneResult &result : results) {
        std::vector<Table::Cell> row = {{result.scene.name, Style::Plain},
                                        {std::to_string(result.steps), Style::Plain}};
        for (const Side side : sides) {
            const Variant *variant = FindVariant(result, side);
            row.push_back(variant != nullptr ? cell(variant->verdict) : Table::Cell{"-", Style::Faint});
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

std::optional<double> MeanRatio(const std::vector<SceneResult> &results, const char *figure) {
    std::vector<double> ratios;
    for (const SceneResult &result : results)
        if (const std::optional<double> ratio = Figures(result)[figure])
            ratios.push_back(*ratio);
    return GeometricMean(ratios);
}

/// Where a figure is in a scene's JSON.
std::string PointerOf(const std::string &figure) {
    std::string pointer = "/figures/" + figure;
    std::replace(pointer.begin(), pointer.end(), '.', '/');
    return pointer;
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
        json[nlohmann::json::json_pointer(PointerOf(name))] = ToJson(value);
    }
    json["summaries"] = {{"stock", {{"count", result.stockCount}, {"time", result.stockTimes}}},
                         {"verify", {{"count", result.verifyCount}, {"words", result.verifyWords}}},
                         {"plugin", {{"count", result.pluginCount}, {"time", result.pluginTimes}}},
                         {"accelerated", {{"time", result.acceleratedTimes}}}};
    return json;
}

nlohmann::json ToJson(const std::vector<SceneResult> &results) {
    nlohmann::json scenes = nlohmann::json::array();
    for (const SceneResult &result : results)
        scenes.push_back(ToJson(result));
    return scenes;
}

nlohmann::json ToJson(const std::vector<SceneResult> &results, const CompareOptions &options) {
    return {
        {"options",
         {{"mode", options.verify ? "verify" : "bits"},
          {"repeat", options.time ? options.repeat : 0},
          {"structure", options.worker.structure.empty() ? "default" : options.worker.structure},
          {"listener", options.worker.listener.empty() ? "none" : options.worker.listener},
          {"perturb", options.perturb ? nlohmann::json(*options.perturb) : nlohmann::json()}}},
        {"scenes", ToJson(results)},
        {"identical", CountOf(results, Verdict::Identical)},
        {"different", CountOf(results, Verdict::Different)},
        {"failed", CountOf(results, Verdict::Failed)},
        {"geometric_mean",
         {{"step_ratio", ToJson(MeanRatio(results, "ratio.step"))},
          {"narrow_phase_ratio", ToJson(MeanRatio(results, "ratio.narrow_phase"))}}},
    };
}

/// "2.75 (2.71 to 2.76)", "no difference (0.99 to 1.03)", or nothing.
std::string StepRatio(const Figures &figures) {
    const auto ratio = figures["ratio.step"], least = figures["ratio.step_least"],
               greatest = figures["ratio.step_greatest"];
    if (!ratio || !least || !greatest)
        return "";
    const bool tells = *least > 1.0 || *greatest < 1.0;
    return (tells ? Fixed(ratio, 2) : "no difference") + " (" + Fixed(least, 2) + " to " +
           Fixed(greatest, 2) + ")";
}

/// Best, middle and worst by the whole step.
void WriteHeadline(std::ostream &out, const std::vector<SceneResult> &results) {
    std::vector<const SceneResult *> timed;
    for (const SceneResult &result : results)
        if (Figures(result)["ratio.step"])
            timed.push_back(&result);
    if (timed.empty())
        return;
    std::stable_sort(timed.begin(), timed.end(), [](const SceneResult *a, const SceneResult *b) {
        return *Figures(*a)["ratio.step"] > *Figures(*b)["ratio.step"];
    });
    Table table;
    for (const char *name : {"whole step, stock / plugin", "scene", "ratio"})
        table.AddColumn("", name);
    const auto add = [&](const char *name, const SceneResult &result) {
        table.AddRow({{name}, {result.scene.name}, {StepRatio(Figures(result))}});
    };
    add("best", *timed.front());
    add("middle", *timed[timed.size() / 2]);
    add("worst", *timed.back());
    table.PrintMarkdown(out);
    out << '\n';
}

void WriteTimes(std::ostream &out, const std::vector<SceneResult> &results, int repeat) {
    Table table;
    for (const char *name : {"scene", "stock, us a step", "plugin, us a step", "stock / plugin"})
        table.AddColumn("", name);
    for (const SceneResult &result : results) {
        const Figures figures(result);
        table.AddRow({{result.scene.name},
                      {Fixed(figures["stock.step_us_per_step"], 1)},
                      {Fixed(figures["plugin.step_us_per_step"], 1)},
                      {StepRatio(figures)}});
    }
    table.PrintMarkdown(out);
    out << "\nWhole steps, the median of " << repeat
        << " interleaved runs; stock over plugin, in brackets the least and the greatest of the pairs of "
           "runs.\n";
}

} // namespace

void PrintTables(std::ostream &out, const std::vector<SceneResult> &results, const CompareOptions &options,
                 bool details, bool colour) {
    auto print = [&](const SceneTable &table) {
        out << '\n' << Styled(table.title, Style::Strong, colour) << '\n';
        TableOf(results, table).Print(out, colour);
    };
    if (options.verify) {
        print(VerifyTable());
        return;
    }
    out << '\n';
    PrintVerdicts(out, results, options, colour);
    const SceneTable times = TimeTable(options.repeat, AnyIsAccelerated(results));
    if (!details) {
        out << '\n'
            << Styled("--details: calls of Box2D, budgets, events and times, and what the columns mean",
                      Style::Faint, colour)
            << '\n';
        return;
    }
    std::vector<SceneTable> tables = {TestTable(), BudgetTable(), EventTable()};
    if (!options.worker.structure.empty())
        tables.push_back(ModeTable());
    if (options.time)
        tables.push_back(times);
    for (const SceneTable &table : tables)
        print(table);
    out << '\n';
    for (const SceneTable &table : tables)
        PrintLegend(out, table.legend, colour);
    PrintLegend(out, VerdictLegend(), colour);
}

void PrintQuestions(std::ostream &out, const std::vector<SceneResult> &results, bool colour) {
    double questions = 0.0, events = 0.0;
    size_t counted = 0;
    std::string name;
    for (const SceneResult &result : results) {
        const Figures figures(result);
        const auto tests = figures["stock.polygon_tests_per_step"],
                   impacts = figures["stock.toi_calls_per_step"],
                   distances = figures["stock.distance_calls_per_step"],
                   happened = figures["events.all_per_step"];
        if (!tests || !impacts || !distances || !happened)
            continue;
        questions += *tests + *impacts + *distances;
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
    if (const auto ratio = MeanRatio(results, "ratio.step"))
        text += "; step " + Fixed(ratio, 2) + "x, narrow phase " +
                Fixed(MeanRatio(results, "ratio.narrow_phase"), 2) + "x as fast as stock (geometric means)";
    out << Styled(text, different + failed == 0 ? Style::Good : Style::Bad, colour) << '\n';
}

void WriteJson(std::ostream &out, const std::vector<SceneResult> &results, const CompareOptions &options) {
    // A worker's stderr may hold anything; a report must be valid all the same.
    out << ToJson(results, options).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

void WriteCsv(std::ostream &out, const std::vector<SceneResult> &results) {
    CsvColumns columns = {{"scene", "/name"},
                          {"group", "/group"},
                          {"size", "/size"},
                          {"seed", "/seed"},
                          {"steps", "/steps"},
                          {"verdict", "/verdict"},
                          {"difference_step", "/difference/step"},
                          {"difference_field", "/difference/field"}};
    const Figures names{SceneResult()};
    for (const auto &entry : names.All())
        columns.emplace_back(entry.first, PointerOf(entry.first));
    WriteCsv(out, ToJson(results), columns);
}

void WriteMarkdown(std::ostream &out, const std::vector<SceneResult> &results,
                   const CompareOptions &options) {
    const auto write = [&](const SceneTable &layout) {
        out << "\n**" << layout.title << "**\n\n";
        TableOf(results, layout).PrintMarkdown(out);
        out << '\n';
        for (const std::string &line : layout.legend)
            out << line << ".\n";
    };
    if (options.verify) {
        write(VerifyTable());
        return;
    }
    if (options.time) {
        WriteHeadline(out, results);
        WriteTimes(out, results, options.repeat);
    }
    for (const SceneTable *table : {&TestTable(), &BudgetTable(), &EventTable()})
        write(*table);
    if (!options.worker.structure.empty())
        write(ModeTable());
}

} // namespace testbed
