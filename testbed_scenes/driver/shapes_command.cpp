// SPDX-License-Identifier: MIT
#include "shapes_command.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "command_line/nearest.h"
#include "commands.h"
#include "output_file.h"
#include "table.h"

namespace testbed {
namespace {

constexpr char kShapesHelp[] =
    "Example: boomerang-testbed compare-shapes gas --vertices 64,256,4096 --curve gas.csv\n"
    "         boomerang-testbed plot gas.csv -o gas.svg\n\n"
    "One fixture runs with the plugin, all others on stock Box2D. A step of bodies of many fixtures takes "
    "milliseconds at 64 vertices and seconds at 1024: above 64 they run few steps, and are held against as "
    "many steps of the one fixture.";

/// A column after the first three: its heading, and where its number comes from.
struct Column {
    const char *group, *name, *csv;
    int decimals;
    std::optional<double> (*number)(const ShapesResult &result, const ShapesRow &row);
};

std::optional<double> Scaled(std::optional<double> number, double factor) {
    if (number)
        *number *= factor;
    return number;
}

const std::vector<Column> &Columns() {
    constexpr double kMillimetres = 1e3;
    static const std::vector<Column> columns = {
        {"", "contacts", "contacts", 0,
         [](const ShapesResult &, const ShapesRow &row) { return NumberAt(row.count, "/contacts"); }},
        {"step", "us", "step_us", 1,
         [](const ShapesResult &, const ShapesRow &row) { return StepTime(row); }},
        {"step", "x octagon", "times_octagon", 2,
         [](const ShapesResult &result, const ShapesRow &row) {
             return TimeRatio(row, FindRow(result, "octagon", 8, row.steps));
         }},
        {"step", "x one", "times_one", 1,
         [](const ShapesResult &result, const ShapesRow &row) {
             const bool many =
                 row.bodies == "many" || row.bodies == "triangles" || row.bodies == "stock triangles";
             return many ? TimeRatio(row, FindRow(result, IsOfOutlines(result.scene) ? "outline" : "one",
                                                  row.vertices, row.steps))
                         : std::nullopt;
         }},
        {"at the end", "awake", "awake", 0,
         [](const ShapesResult &, const ShapesRow &row) { return NumberAt(row.count, "/behaviour/awake"); }},
        {"at the end", "overlap, mm", "overlap_mm", 1,
         [](const ShapesResult &, const ShapesRow &row) {
             return Scaled(NumberAt(row.count, "/behaviour/overlap"), kMillimetres);
         }},
        {"at the end", "energy, J", "energy_j", 1,
         [](const ShapesResult &, const ShapesRow &row) { return NumberAt(row.count, "/behaviour/energy"); }},
        {"at the end", "gained, J", "energy_gain_j", 2,
         [](const ShapesResult &, const ShapesRow &row) {
             return NumberAt(row.count, "/behaviour/energy_gain");
         }},
        {"at the end", "moved, m", "moved_m", 2,
         [](const ShapesResult &, const ShapesRow &row) { return NumberAt(row.count, "/behaviour/moved"); }}};
    return columns;
}

std::string VerticesText(const ShapesRow &row) {
    return row.vertices > 0 ? std::to_string(row.vertices) : "-";
}

void PrintTable(std::ostream &out, const ShapesResult &result, int repeat, bool colour) {
    out << Styled(result.scene.name, Style::Strong, colour) << ": " << result.scene.size << " bodies, "
        << result.steps << " steps: " << result.scene.description << "\n\n";
    Table table;
    table.AddColumn("", "bodies");
    table.AddColumn("", "vertices");
    table.AddColumn("", "steps");
    for (const Column &column : Columns())
        table.AddColumn(column.group, column.name);
    for (const ShapesRow &row : result.rows) {
        std::vector<Table::Cell> cells = {
            {row.bodies, row.bodies == "one" || row.bodies == "outline" ? Style::Strong : Style::Plain},
            {VerticesText(row), Style::Plain},
            {std::to_string(row.steps), Style::Plain}};
        for (const Column &column : Columns()) {
            const std::optional<double> number = column.number(result, row);
            cells.push_back({Fixed(number, column.decimals), number ? Style::Plain : Style::Faint});
        }
        table.AddRow(std::move(cells));
    }
    table.Print(out, colour);
    const std::string time = "step: median of " + std::to_string(repeat) +
                             " runs that take turns; x octagon, x one: how many times as long as a step of "
                             "stock octagons, of one fixture (or outlines)";
    const std::string what =
        IsOfOutlines(result.scene)
            ? "outline: few convex pieces, with the plugin; triangles: with the plugin, too, and on stock"
            : "one: one fixture a body, with the plugin; many: stock fixtures of at most 8 vertices; "
              "octagon, circle: stock";
    for (const std::string &line :
         {what, time,
          std::string("overlap: the deepest, Box2D leaves 5 mm; gained: energy above that of the first step; "
                      "moved: mean distance from the first step's place")})
        out << Styled(line, Style::Faint, colour) << '\n';
}

void WriteCsv(std::ostream &out, const ShapesResult &result) {
    out << "scene,bodies,vertices,steps";
    for (const Column &column : Columns())
        out << ',' << column.csv;
    out << '\n';
    for (const ShapesRow &row : result.rows) {
        out << result.scene.name << ',' << row.bodies << ',' << (row.vertices > 0 ? VerticesText(row) : "")
            << ',' << row.steps;
        for (const Column &column : Columns()) {
            out << ',';
            if (const std::optional<double> number = column.number(result, row))
                out << nlohmann::json(*number).dump();
        }
        out << '\n';
    }
}

/// What `plot` reads. Octagons and circles have no number of vertices to choose: they are lines across.
void WriteCurve(std::ostream &out, const ShapesResult &result) {
    out << "series,vertices,microseconds a step\n";
    const int64_t most = result.rows.back().vertices;
    auto write = [&out](const char *series, int64_t vertices, const ShapesRow &row) {
        if (const std::optional<double> time = StepTime(row))
            out << series << ',' << vertices << ',' << *time << '\n';
    };
    for (const char *bodies : {"many", "one"})
        for (const ShapesRow &row : result.rows)
            if (row.bodies == bodies && (row.steps == result.steps || row.bodies == "many"))
                write(row.bodies == "many" ? "many fixtures" : "one fixture", row.vertices, row);
    for (const ShapesRow &row : result.rows)
        if (row.bodies == "octagon" || row.bodies == "circle")
            for (const int64_t vertices : {int64_t{8}, most})
                write(row.bodies == "octagon" ? "octagons" : "circles", vertices, row);
}

nlohmann::json ToJson(const ShapesResult &result) {
    nlohmann::json json = ToJson(result.scene);
    json["steps"] = result.steps;
    for (const ShapesRow &row : result.rows) {
        nlohmann::json entry = {{"bodies", row.bodies}, {"vertices", row.vertices}, {"steps", row.steps}};
        for (const Column &column : Columns()) {
            const std::optional<double> number = column.number(result, row);
            entry[column.csv] = number ? nlohmann::json(*number) : nlohmann::json();
        }
        entry["summaries"] = {{"count", row.count}, {"time", row.times}};
        json["rows"].push_back(std::move(entry));
    }
    return json;
}

/// "gas" stands for "any-gas".
SceneInfo ChooseScene(const std::vector<SceneInfo> &scenes, const std::string &name) {
    std::string choices;
    std::vector<std::string> names;
    for (const SceneInfo &scene : scenes) {
        if (scene.bodies != "one" || scene.vertices == 0)
            continue;
        if (scene.name == name || scene.name == "any-" + name || scene.name == name + "-outline")
            return scene;
        choices += (choices.empty() ? "" : ", ") + scene.name;
        names.push_back(scene.name);
    }
    throw UsageError("there is no scene \"" + name + "\" of polygons of any size" +
                     command_line::NearestClause("any-" + name, names) + " (all: " + choices + ")");
}

} // namespace

CLI::App *AddCompareShapes(CLI::App &app, ShapesCommand &command) {
    ShapesOptions &options = command.options;
    CLI::App *shapes =
        app.add_subcommand("compare-shapes", "Compare polygons of any size as one fixture with many "
                                             "fixtures, circles and octagons: cost, behaviour");
    shapes
        ->add_option("scene", command.scene,
                     "gas, pile, stack, wheels, ...: what `list` shows as any-..., or one of outlines")
        ->required();
    shapes->add_option("--vertices", options.vertices, "How many vertices, separated by commas")
        ->delimiter(',')
        ->check(CLI::Range(9, 65535))
        ->capture_default_str();
    shapes->add_flag("!--no-many", options.many, "Without bodies of many fixtures");
    shapes->add_flag("!--no-circles", options.circles, "Without circles");
    shapes->add_option("--many-up-to", options.manyUpTo, "Leave bodies of many fixtures out above this")
        ->check(CLI::Range(9, 65535))
        ->capture_default_str();
    shapes
        ->add_option("--many-steps", options.manySteps,
                     "Their steps above " + std::to_string(kManyAtLength) + " vertices")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    shapes->add_option("--steps", options.steps, "Steps of all others (default: the scene's own)")
        ->check(CLI::Range(1, 100000000));
    shapes->add_option("--repeat", options.repeat, "Timed runs of each, interleaved; 0: none")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    shapes->add_option("--json", command.json, "Write everything into this file, as JSON");
    shapes->add_option("--csv", command.csv, "Write the table into this file");
    shapes->add_option("--curve", command.curve,
                       "Write the cost of a step by vertices into this file, for `plot`");
    shapes->add_flag("--quiet", command.quiet, "No table and no progress: the files alone");
    shapes->footer(kShapesHelp);
    return shapes;
}

int Execute(ShapesCommand command, const Workers &workers) {
    const SceneInfo scene = ChooseScene(workers.List(), command.scene);
    std::vector<int64_t> &vertices = command.options.vertices;
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    if (!command.curve.empty() && command.options.repeat == 0)
        throw UsageError("--curve needs timed runs: not --repeat 0");
    if (!command.curve.empty() && IsOfOutlines(scene))
        throw UsageError("--curve is of polygons whose vertices are chosen: not of outlines");
    if (command.quiet && command.json.empty() && command.csv.empty() && command.curve.empty())
        throw UsageError("--quiet prints nothing: give --json, --csv or --curve a file");
    OutputFile json(command.json), csv(command.csv), curve(command.curve);
    Progress progress(RunsOf(scene, command.options), command.quiet);
    const ShapesResult result = CompareShapes(workers, scene, command.options, progress);
    progress.Clear();
    if (!command.quiet)
        PrintTable(std::cout, result, command.options.repeat, WantsColour(STDOUT_FILENO));
    if (json.IsWanted()) {
        json.Stream() << ToJson(result).dump(2) << '\n';
        json.Close();
    }
    if (csv.IsWanted()) {
        WriteCsv(csv.Stream(), result);
        csv.Close();
    }
    if (curve.IsWanted()) {
        WriteCurve(curve.Stream(), result);
        curve.Close();
    }
    return kExitOk;
}

} // namespace testbed
