// SPDX-License-Identifier: MIT
#include "markdown.h"

#include <algorithm>
#include <string>

#include "figures.h"
#include "scene_tables.h"
#include "table.h"

namespace testbed {
namespace {

std::string Number(const std::optional<double> &figure, int decimals) {
    return figure ? Fixed(figure, decimals) : std::string();
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

void WriteRow(std::ostream &out, const std::vector<std::string> &cells) {
    out << '|';
    for (const std::string &cell : cells)
        out << ' ' << cell << " |";
    out << '\n';
}

void WriteHead(std::ostream &out, const std::vector<std::string> &cells) {
    WriteRow(out, cells);
    out << "| ---";
    for (size_t i = 1; i < cells.size(); ++i)
        out << " | ---:";
    out << " |\n";
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
    WriteHead(out, {"whole step, stock / plugin", "scene", "ratio"});
    const auto row = [&](const char *name, const SceneResult &result) {
        WriteRow(out, {name, result.scene.name, StepRatio(Figures(result))});
    };
    row("best", *timed.front());
    row("middle", *timed[timed.size() / 2]);
    row("worst", *timed.back());
    out << '\n';
}

void WriteTable(std::ostream &out, const std::vector<SceneResult> &results, const SceneTable &layout) {
    out << "\n**" << layout.title << "**\n\n";
    std::vector<std::string> names = {"scene"};
    for (const SceneColumn &column : layout.columns)
        names.push_back(std::string(column.group) + (*column.group != '\0' ? ": " : "") + column.name);
    WriteHead(out, names);
    for (const SceneResult &result : results) {
        const Figures figures(result);
        std::vector<std::string> cells = {result.scene.name};
        for (const SceneColumn &column : layout.columns)
            cells.push_back(Number(figures[column.figure], column.decimals));
        WriteRow(out, cells);
    }
    out << '\n';
    for (const std::string &line : layout.legend)
        out << line << ".\n";
}

void WriteTimes(std::ostream &out, const std::vector<SceneResult> &results, int repeat) {
    WriteHead(out, {"scene", "stock, us a step", "plugin, us a step", "contacts alone", "all hooks"});
    for (const SceneResult &result : results) {
        const Figures figures(result);
        WriteRow(out, {result.scene.name, Number(figures["stock.step_us_per_step"], 1),
                       Number(figures["plugin.step_us_per_step"], 1),
                       Number(figures["ratio_register.step"], 2), StepRatio(figures)});
    }
    out << "\nWhole steps, the median of " << repeat
        << " interleaved runs; stock over plugin, in brackets the least and the greatest of the pairs of "
           "runs.\n";
}

} // namespace

void WriteMarkdown(std::ostream &out, const std::vector<SceneResult> &results,
                   const CompareOptions &options) {
    if (options.verify) {
        WriteTable(out, results, VerifyTable());
        return;
    }
    if (options.time) {
        WriteHeadline(out, results);
        WriteTimes(out, results, options.repeat);
    }
    for (const SceneTable *table : {&TestTable(), &BudgetTable(), &EventTable()})
        WriteTable(out, results, *table);
}

} // namespace testbed
