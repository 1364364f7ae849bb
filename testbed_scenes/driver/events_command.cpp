// SPDX-License-Identifier: MIT
#include "commands.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include <unistd.h>

#include "drawing/canvas.h"
#include "terminal.h"
#include "theory/event_tables.h"

namespace testbed {
namespace {

/// Steps between two ratios of a range, as a factor.
constexpr double kRatioFactor = 4.0;
/// Columns of structures in one table: what fits some 110 characters.
constexpr size_t kNarrowColumns = 8, kWideColumns = 6;

struct EventsCommand {
    std::vector<std::string> motions;    ///< none: all
    std::vector<std::string> structures; ///< names or groups; none: "default"
    std::string shape = "ellipse:disc";
    std::string ratios = "8:2048";
    unsigned seeds = 3;
    std::string csv;
    bool noOptimum = false, quiet = false, list = false, box2d = false;
    Experiment experiment; ///< --n and --audit write here; the fields above give the rest
};

// --- what is asked for ---

const std::vector<std::string> kGroups = {"points", "translation", "rigid", "rivals"};

std::vector<std::string> MotionNames() {
    return NamesOf(BMR_FAMILY_COUNT, [](size_t i) { return bmr_family_name(static_cast<bmr_family>(i)); });
}

std::vector<std::string> ShapeNames() {
    return NamesOf(BMR_NGON_COUNT, [](size_t i) { return bmr_ngon_name(static_cast<bmr_ngon>(i)); });
}

/// What a word on the command line stands for: a group or one structure.
std::vector<const bmr_kds_info *> StructuresFor(const std::string &word) {
    std::vector<const bmr_kds_info *> found;
    for (size_t i = 0; i < bmr_kds_count(); ++i) {
        const bmr_kds_info *info = bmr_kds_at(i);
        const bool rival = info->role == BMR_KDS_RIVAL, point = info->domain == BMR_KDS_POINT;
        if (word == info->name || (word == "rivals" && rival) || (word == "points" && point && !rival) ||
            (word == "translation" && info->domain == BMR_KDS_TRANSLATION) ||
            (word == "rigid" && info->domain == BMR_KDS_RIGID && !rival))
            found.push_back(info);
    }
    if (found.empty()) {
        std::vector<std::string> names =
            NamesOf(bmr_kds_count(), [](size_t k) { return bmr_kds_at(k)->name; });
        names.insert(names.end(), kGroups.begin(), kGroups.end());
        FailUnknown("structure", word, names);
    }
    return found;
}

bmr_ngon NgonFor(const std::string &word) {
    return static_cast<bmr_ngon>(IndexOf("shape", word, ShapeNames()));
}

/// "LOW:HIGH" in factors of four, or "R1,R2,..".
std::vector<double> RatiosFor(const std::string &text) {
    const bool isRange = text.find(':') != std::string::npos;
    std::vector<double> ratios =
        NumbersIn(text, isRange ? ':' : ',', 1.0, 1e9, "--ratios", "number from 1 to 1e9");
    if (isRange) {
        if (ratios.size() != 2 || ratios[0] > ratios[1])
            throw UsageError("--ratios: a range is LOW:HIGH");
        const double high = ratios[1];
        ratios.pop_back();
        // A little beyond, so that rounding does not lose the last.
        while (ratios.back() * kRatioFactor <= high * 1.000001)
            ratios.push_back(ratios.back() * kRatioFactor);
    }
    std::sort(ratios.begin(), ratios.end());
    return ratios;
}

/// What the command asks for; throws UsageError.
Experiment ExperimentFor(const EventsCommand &command) {
    Experiment experiment = command.experiment;
    for (const std::string &word : command.motions)
        experiment.motions.push_back(static_cast<bmr_family>(IndexOf("motion", word, MotionNames())));
    if (command.motions.empty())
        for (int i = 0; i < BMR_FAMILY_COUNT; ++i)
            experiment.motions.push_back(static_cast<bmr_family>(i));
    const size_t colon = command.shape.find(':');
    const std::string a = command.shape.substr(0, colon),
                      b = colon == std::string::npos ? a : command.shape.substr(colon + 1);
    experiment.ngons[0] = NgonFor(a);
    experiment.point = b == "point";
    if (!experiment.point)
        experiment.ngons[1] = NgonFor(b);
    std::vector<std::string> words = command.structures;
    if (words.empty())
        words = {experiment.point ? "points" : "rigid", "rivals"};
    for (const std::string &word : words)
        for (const bmr_kds_info *info : StructuresFor(word))
            if (std::find(experiment.structures.begin(), experiment.structures.end(), info) ==
                experiment.structures.end())
                experiment.structures.push_back(info);
    experiment.ratios = RatiosFor(command.ratios);
    for (unsigned seed = 1; seed <= command.seeds; ++seed)
        experiment.seeds.push_back(seed);
    experiment.optimum = !command.noOptimum;
    return experiment;
}

void ListStructures() {
    std::cout << "structures\n";
    for (size_t i = 0; i < bmr_kds_count(); ++i) {
        const bmr_kds_info *info = bmr_kds_at(i);
        const char *domain = info->domain == BMR_KDS_POINT         ? "point"
                             : info->domain == BMR_KDS_TRANSLATION ? "translation"
                                                                   : "rigid";
        const char *role = info->role == BMR_KDS_RECOMMENDED ? "recommended"
                           : info->role == BMR_KDS_RIVAL     ? "rival"
                                                             : "control";
        const std::string name = Padded(std::string("  ") + info->name, 28);
        std::cout << Padded(Padded(name + domain, 41) + role, 54) << info->title << " (" << info->section
                  << ")\n";
    }
    const auto print = [](const char *what, const std::vector<std::string> &names, const char *between) {
        std::cout << what << "\n ";
        for (size_t i = 0; i < names.size(); ++i)
            std::cout << (i > 0 ? between : " ") << names[i];
    };
    print("groups", kGroups, ", ");
    print("\nmotions", MotionNames(), " ");
    print("\nshapes", ShapeNames(), " ");
    std::cout << " point (B only)\n";
}

/// "active-cell-compass" stands as "compass" under "active-cell".
std::pair<std::string, std::string> Heading(const std::string &name) {
    const size_t dash = name.rfind('-');
    return {name.substr(0, dash), name.substr(dash + 1)};
}

std::string Rounded(std::optional<double> value) {
    return Fixed(value, value && *value < 9.95 && *value != std::floor(*value) ? 1 : 0);
}

/// The structures' columns of a table, a handful at a time, after some leading columns.
class ColumnBlocks {
public:
    ColumnBlocks(const std::vector<Run> &runs, size_t columns, bool colour)
        : m_motions(MotionsOf(runs)), m_structures(StructuresOf(runs)), m_columns(columns), m_colour(colour) {
    }

    using Leading =
        std::vector<std::pair<std::string, std::function<std::string(const std::string &motion)>>>;
    using CellFor = std::function<Table::Cell(const std::string &motion, const bmr_kds_info *structure)>;
    /// A last row for all motions, if `summary` is given.
    void Print(const Leading &leading, const CellFor &cellFor, const std::string &summaryName = "",
               const std::function<std::string(const bmr_kds_info *)> &summary = {}) const {
        for (size_t first = 0; first < m_structures.size(); first += m_columns) {
            const size_t last = std::min(m_structures.size(), first + m_columns);
            Table table = {{"", "motion"}};
            for (const auto &column : leading)
                table.AddColumn("", column.first);
            for (size_t i = first; i < last; ++i) {
                const auto [group, name] = Heading(m_structures[i]->name);
                table.AddColumn(group, name);
            }
            for (const std::string &motion : m_motions) {
                std::vector<Table::Cell> row = {{motion}};
                for (const auto &column : leading)
                    row.push_back({column.second(motion)});
                for (size_t i = first; i < last; ++i)
                    row.push_back(cellFor(motion, m_structures[i]));
                table.AddRow(std::move(row));
            }
            if (summary) {
                std::vector<Table::Cell> row = {{summaryName, Style::Strong}};
                row.resize(1 + leading.size());
                for (size_t i = first; i < last; ++i)
                    row.push_back({summary(m_structures[i]), Style::Strong});
                table.AddRow(std::move(row));
            }
            table.Print(std::cout, m_colour);
            std::cout << '\n';
        }
    }

private:
    std::vector<std::string> m_motions;
    std::vector<const bmr_kds_info *> m_structures;
    size_t m_columns;
    bool m_colour;
};

void PrintCounts(const std::vector<Run> &runs, size_t ratioIndex, bool optimum, bool colour) {
    ColumnBlocks::Leading leading;
    std::function<std::string(const bmr_kds_info *)> overOptimum;
    if (optimum) {
        leading.emplace_back("optimum", [&](const std::string &motion) {
            return Rounded(MeanOptimum(runs, motion, ratioIndex));
        });
        overOptimum = [&](const bmr_kds_info *structure) {
            return Fixed(OverOptimum(runs, structure, ratioIndex), 2);
        };
    }
    ColumnBlocks(runs, kNarrowColumns, colour)
        .Print(
            leading,
            [&](const std::string &motion, const bmr_kds_info *structure) {
                return Table::Cell{Rounded(MeanOver(runs, motion, structure, ratioIndex))};
            },
            "lines / optimum", overOptimum);
}

/// The paper's Table 1 with numbers in it: how the counts grew, beside the bound.
void PrintGrowth(const std::vector<Run> &runs, bool colour) {
    ColumnBlocks(runs, kWideColumns, colour)
        .Print({}, [&](const std::string &motion, const bmr_kds_info *structure) {
            const std::optional<Growth> growth = GrowthOf(runs, motion, structure);
            return Table::Cell{growth ? TextOf(*growth) : "-"};
        });
}

/// The four qualities of a kinetic structure, over all runs.
void PrintQualities(const std::vector<Run> &runs, bool colour) {
    Table table = {{"", "structure"},
                   {"compact", "conditions"},
                   {"compact", "bytes"},
                   {"responsive: touched", "mean"},
                   {"responsive: touched", "most"},
                   {"local", "replanned"},
                   {"efficient", "events/external"},
                   {"hysteresis", "least rho"}};
    for (const bmr_kds_info *structure : StructuresOf(runs)) {
        const auto [qualities, rho] = QualitiesOver(runs, structure);
        table.AddRow({{structure->name},
                      {Fixed(qualities.conditions, 0)},
                      {Fixed(qualities.bytes, 0)},
                      {Fixed(qualities.touched, 1)},
                      {Fixed(qualities.touched_most, 0)},
                      {Fixed(qualities.replanned, 0)},
                      {Fixed(qualities.efficiency, 1)},
                      {std::isfinite(rho) ? Fixed(rho, 3) : "-"}});
    }
    table.Print(std::cout, colour);
    std::cout << '\n';
}

/// What Box2D asked along the same courses, by motion: means over the courses.
class Box2DTable {
public:
    void Add(const std::string &motion, const Box2DCalls &calls) {
        const auto isIts = [&](const Row &row) { return row.motion == motion; };
        auto row = std::find_if(m_rows.begin(), m_rows.end(), isIts);
        if (row == m_rows.end())
            row = m_rows.insert(row, {motion, {}, 0.0});
        for (size_t i = 0; i < calls.size(); ++i)
            row->sums[i] += calls[i];
        ++row->courses;
    }
    /// A line for each motion: what stock asked, and how many events the first structure had that takes it.
    void PrintQuestions(const std::vector<Run> &runs, size_t ratioIndex) const {
        for (const Row &row : m_rows)
            for (const bmr_kds_info *structure : StructuresOf(runs)) {
                const auto events = MeanOver(runs, row.motion, structure, ratioIndex);
                if (!events)
                    continue;
                const double asked = row.sums[1] + row.sums[2] + row.sums[3];
                std::cout << QuestionsFor(row.motion, asked / row.courses,
                                          "in " + Counted(std::round(row.sums[0] / row.courses)) +
                                              " steps of stock Box2D",
                                          *events, std::string(" of ") + structure->name)
                          << '\n';
                break;
            }
        std::cout << '\n';
    }
    void Print(bool colour) const {
        Table table = {{"", "motion"}, {"", "steps"}};
        for (const char *side : {"stock Box2D", "with the plugin"})
            for (const char *what : {"tests", "impacts", "distances"})
                table.AddColumn(side, what);
        table.AddColumn("with the plugin", "events");
        for (const Row &row : m_rows) {
            std::vector<Table::Cell> cells = {{row.motion}};
            for (const double sum : row.sums)
                cells.push_back({Fixed(sum / row.courses, 0)});
            table.AddRow(std::move(cells));
        }
        table.Print(std::cout, colour);
        std::cout << '\n';
    }

private:
    struct Row {
        std::string motion;
        Box2DCalls sums;
        double courses;
    };
    std::vector<Row> m_rows;
};

void PrintTables(const EventsCommand &command, const Experiment &experiment, const std::vector<Run> &runs,
                 const Box2DTable &box2d) {
    const bool colour = WantsColour(STDOUT_FILENO);
    const size_t motions = experiment.seeds.size(), ratioIndex = experiment.ratios.size() - 1;
    if (command.box2d)
        box2d.PrintQuestions(runs, ratioIndex);
    std::cout << "Mean number of events, " << motions << (motions == 1 ? " motion" : " motions of each kind")
              << ", n = " << runs.front().n << ", D/sigma = " << General(runs.back().ratio, 6) << "\n\n";
    PrintCounts(runs, ratioIndex, experiment.optimum, colour);
    if (experiment.ratios.size() >= 3) {
        std::cout
            << "Growth of events with D/sigma = " << experiment.ratios.front() << " .. "
            << experiment.ratios.back()
            << ": the exponent, or +events per doubling where the\nbound is logarithmic; < the paper's bound "
               "(which hold, `./testbed_scenes/run reproduce table-1` says)\n\n";
        PrintGrowth(runs, colour);
    }
    std::cout << "The four qualities, and the least change from event to event over the distance (rho)\n\n";
    PrintQualities(runs, colour);
    if (command.box2d) {
        std::cout << "Box2D led along the same courses: calls of b2CollidePolygons, b2TimeOfImpact, "
                     "b2Distance, and\nevents of the plugin's structure\n\n";
        box2d.Print(colour);
    }
}

int CountEvents(const EventsCommand &command, const std::string &workersDirectory) {
    Experiment experiment = ExperimentFor(command);
    Box2DTable box2d;
    std::optional<Workers> workers; // only --box2d needs them
    if (command.box2d) {
        workers.emplace(workersDirectory);
        experiment.onCourse = [&](const Course &course, const std::string &motion, size_t ratioIndex,
                                  uint64_t) {
            if (ratioIndex + 1 == experiment.ratios.size())
                box2d.Add(motion, RunInBox2D(course, *workers));
        };
    }
    if (!command.csv.empty())
        CheckWritable(command.csv);
    Progress progress(1, command.quiet);
    const std::vector<Run> runs =
        Perform(experiment, [&](const std::string &what, size_t done, size_t total) {
            progress.Show(what, static_cast<double>(done) / static_cast<double>(std::max<size_t>(total, 1)));
        });
    progress.Clear();
    if (runs.empty())
        throw UsageError("none of these structures takes any of these motions");
    if (!command.quiet)
        PrintTables(command, experiment, runs, box2d);
    if (!command.csv.empty()) {
        std::ostringstream csv;
        WriteCsv(csv, runs);
        WriteWholeFile(command.csv, csv.str());
    }
    return kExitOk;
}

int Execute(const EventsCommand &command, const std::string &workersDirectory) {
    if (command.list) {
        ListStructures();
        return kExitOk;
    }
    return CountEvents(command, workersDirectory);
}

} // namespace

void AddEvents(CLI::App &app, Program &program) {
    const auto kept = std::make_shared<EventsCommand>();
    EventsCommand &command = *kept;
    CLI::App *events = app.add_subcommand(
        "events", "Count the events of the kinetic structures along motions of two polygons");
    events->add_option("motions", command.motions, "Motions that --list shows (default: all)");
    events
        ->add_option("--structures", command.structures,
                     "Structures or groups that --list shows (default: rigid and rivals)")
        ->delimiter(',');
    events->add_option("--n", command.experiment.n, "Vertices of each polygon")
        ->check(Whole(3, 65535))
        ->capture_default_str();
    events->add_option("--shape", command.shape, "Shape of A, or of A:B; B may be a point")
        ->capture_default_str();
    events
        ->add_option("--ratios", command.ratios,
                     "Diameter over least separation: LOW:HIGH in factors of 4, or R1,R2,..")
        ->capture_default_str();
    events->add_option("--seeds", command.seeds, "How many motions of each kind")
        ->check(Whole(1, 100000))
        ->capture_default_str();
    events->add_option("--csv", command.csv, "Write every run into this file, one row a run");
    events->add_flag("--box2d", command.box2d,
                     "Lead two Box2D bodies along the same courses and count what Box2D asks");
    events->add_flag("--audit", command.experiment.audit, "Prove every certificate again, by brute force");
    events->add_flag("--no-optimum", command.noOptimum, "Leave the offline optimum out");
    events->add_flag("--quiet", command.quiet, "No tables");
    events->add_flag("--list", command.list, "Show structures, motions and shapes, and run nothing");
    events->callback([kept, &program] { program.status = Execute(*kept, program.directory); });
}

} // namespace testbed
