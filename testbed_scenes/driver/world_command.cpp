// SPDX-License-Identifier: MIT
//
// `boomerang-testbed world`: runs a kinetic world of many polygons and tells what it cost.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <numeric>
#include <optional>

#include <unistd.h>

#include "boomerang/families.h"
#include "commands.h"
#include "pictures.h"
#include "terminal.h"
#include "worlds/world.h"

namespace testbed {
namespace {

struct WorldCommand {
    WorldChoice choice = WorldScenes().front().choice;
    bool check = false, audit = false, quiet = false, list = false;
    std::string growth;      ///< N1,N2,..
    PictureRequest pictures; ///< without an output: none
};

// --- what may be chosen, and what makes no sense ---

constexpr char kNotes[] = "Lengths are in radii of the smallest body's disk. Polygons have the density 1, "
                          "and their origins at their "
                          "centres of mass.\nThe answer is elastic, pass (through each other), or a "
                          "number: the restitution, "
                          "from 0 to 1.\n--zeno: what becomes of infinitely many contacts in finite time: an "
                          "error that says so, or slow "
                          "ones are answered elastically.\n--picture: the run after a step, or a series (30 "
                          "steps are a unit of time).\n\nExample:\n"
                          "  boomerang-testbed world gas --picture gas.png --frames 0:600:10 --all\n\n";

/// Takes the numbers from `least` (or above it) to `most`; CLI11's own range lets NaN pass.
CLI::Validator Within(double least, double most, bool above = false) {
    return CLI::Validator(
        [=](const std::string &text) {
            char *end = nullptr;
            const double value = std::strtod(text.c_str(), &end);
            if (*end == '\0' && value >= least && value <= most && !(above && value == least))
                return std::string();
            return std::string("a number ") + (above ? "above " : "from ") + General(least) + " to " +
                   General(most) + " is wanted, not " + text;
        },
        "");
}

/// "12" or "8:64".
void ReadVertices(const std::string &text, WorldChoice *choice) {
    unsigned long fewest = 0, most = 0;
    char rest = 0;
    const int read = std::sscanf(text.c_str(), "%lu:%lu%c", &fewest, &most, &rest);
    if (read == 1 && text.find(':') == std::string::npos)
        most = fewest;
    else if (read != 2)
        fewest = 0;
    if (fewest < 3 || most < fewest || most > 65535 || text[0] == '-')
        throw UsageError("--vertices: N or FEWEST:MOST is wanted, from 3 to 65535, not \"" + text + "\"");
    choice->fewestVertices = fewest;
    choice->mostVertices = most;
}

void ReadAnswer(const std::string &text, WorldChoice *choice) {
    if (text == "elastic")
        choice->response = {BMR_RESPONSE_IMPULSE, 1.0};
    else if (text == "pass")
        choice->response = {BMR_RESPONSE_PASS, 0.0};
    else {
        char *end = nullptr;
        const double restitution = std::strtod(text.c_str(), &end);
        if (end == text.c_str() || *end != '\0')
            throw UsageError("--answer: elastic, pass or a restitution is wanted, not \"" + text + "\"" +
                             NearestClause(text, {"elastic", "pass"}));
        if (!(restitution >= 0.0 && restitution <= 1.0))
            throw UsageError("--answer: a restitution is a number from 0 to 1, not " + text);
        choice->response = {BMR_RESPONSE_IMPULSE, restitution};
    }
}

void ReadStructure(const std::string &name, WorldChoice *choice) {
    const bmr_kds_info *info = nullptr;
    if (bmr_kds_find(name.c_str(), &info) != BMR_OK) {
        std::vector<std::string> names;
        for (size_t i = 0; i < bmr_kds_count(); ++i)
            if (bmr_kds_at(i)->domain == BMR_KDS_RIGID)
                names.emplace_back(bmr_kds_at(i)->name);
        FailUnknown("structure", name, names, "`events --list` shows all");
    }
    if (info->domain != BMR_KDS_RIGID)
        throw UsageError("--structure: " + name + " is for points or for bodies that do not turn");
    choice->structure = name;
}

WorldChoice SceneNamed(const std::string &name) {
    const std::vector<WorldScene> &scenes = WorldScenes();
    return scenes[IndexOf("world", name,
                          NamesOf(scenes.size(), [&](size_t i) { return scenes[i].choice.scene; }))]
        .choice;
}

// --- what is printed ---

void Print(const std::vector<WorldFigures> &runs, bool colour) {
    const WorldFigures &first = runs.front();
    std::cout << first.choice.scene << " at a density of " << first.choice.density << ", "
              << NameOf(first.choice.boundary) << ", " << first.choice.structure << ", "
              << first.choice.seconds << " units of time; in brackets: over the first row\n\n";
    Table table = {{"", "bodies"}};
    const char *const rates = "events for each body and unit of time";
    for (int kind = 0; kind < BMR_WORLD_EVENT_KIND_COUNT; ++kind)
        table.AddColumn(rates, bmr_world_event_name(static_cast<bmr_world_event_kind>(kind)));
    table.AddColumn(rates, "all");
    for (const char *name : {"pairs", "bytes"})
        table.AddColumn("a body", name);
    for (const char *name : {"us an event", "us a body and unit"})
        table.AddColumn("clock", name);
    const auto against = [](double value, double base, int decimals) {
        return Fixed(value, decimals) + (base > 0.0 ? " (" + Fixed(value / base, 2) + ")" : "");
    };
    const auto perBody = [](const WorldFigures &run, double value) {
        return value / static_cast<double>(run.choice.bodies);
    };
    const auto perUnit = [&](const WorldFigures &run) {
        return perBody(run, 1e6 * run.clock / run.choice.seconds);
    };
    for (const WorldFigures &run : runs) {
        std::vector<Table::Cell> row = {{std::to_string(run.choice.bodies)}};
        for (const uint64_t events : run.counts.events)
            row.push_back({Fixed(run.Rate(events), 3)});
        row.push_back({against(run.Rate(run.Events()), first.Rate(first.Events()), 3), Style::Strong});
        row.push_back({Fixed(perBody(run, static_cast<double>(run.counts.pairs)), 2)});
        row.push_back({against(perBody(run, static_cast<double>(run.counts.most_bytes)),
                               perBody(first, static_cast<double>(first.counts.most_bytes)), 0)});
        row.push_back({against(run.MicrosecondsAnEvent(), first.MicrosecondsAnEvent(), 2)});
        row.push_back({against(perUnit(run), perUnit(first), 1)});
        table.AddRow(std::move(row));
    }
    table.Print(std::cout, colour);
}

/// Steps of pictures in a unit of time. A run of more than kMostSteps takes hours and gigabytes.
constexpr double kStepsAUnit = 30.0, kMostSteps = 20000.0;

std::string Scientific(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", number);
    return text;
}

/// Steps after the first frame.
int StepsOf(const WorldChoice &choice) {
    return std::max(1, static_cast<int>(std::lround(choice.seconds * kStepsAUnit)));
}

void ListWorlds() {
    for (const WorldScene &scene : WorldScenes()) {
        std::cout << Padded("  " + scene.choice.scene, 14) << scene.description << " (" << scene.choice.bodies
                  << " bodies, " << NameOf(scene.choice.boundary) << ", " << NameOf(scene.choice.response)
                  << ")\n";
    }
}

void PrintHead(const WorldFigures &figures) {
    const WorldChoice &choice = figures.choice;
    std::cout << choice.scene << ": " << choice.bodies << " polygons of " << choice.fewestVertices;
    if (choice.mostVertices > choice.fewestVertices)
        std::cout << " to " << choice.mostVertices;
    std::cout << " vertices (" << choice.shape << "), sizes 1 : " << General(choice.sizes) << ", density "
              << General(choice.density) << ", " << NameOf(choice.boundary) << ", " << NameOf(choice.response)
              << "\n"
              << choice.structure << ", seed " << choice.seed << ", " << General(choice.seconds)
              << " units of time, side of the box " << General(figures.side)
              << (choice.allPairs ? ", all pairs" : "") << "\n\n";
}

void PrintEvents(const WorldFigures &figures, bool colour) {
    Table table = {{"", "events"}, {"", "in all"}, {"for each body", "and unit of time"}};
    const auto add = [&](const std::string &name, uint64_t events, Style style) {
        table.AddRow(
            {{name, style}, {std::to_string(events), style}, {Fixed(figures.Rate(events), 3), style}});
    };
    for (int kind = 0; kind < BMR_WORLD_EVENT_KIND_COUNT; ++kind)
        add(bmr_world_event_name(static_cast<bmr_world_event_kind>(kind)), figures.counts.events[kind],
            Style::Plain);
    add("all", figures.Events(), Style::Strong);
    table.Print(std::cout, colour);
}

void PrintConservation(const WorldFigures &figures) {
    std::cout << "conserved:  ";
    if (figures.energy)
        std::cout << "energy to " << Scientific(*figures.energy) << " of it";
    else
        std::cout << "not the energy (" << Fixed(100.0 * figures.energyLeft, 2) << " % are left)";
    if (figures.momentum)
        std::cout << ", momentum to " << Scientific(*figures.momentum);
    if (figures.angular)
        std::cout << ", angular momentum to " << Scientific(*figures.angular);
    std::cout << '\n';
}

void Print(const WorldFigures &figures, bool colour) {
    const bmr_world_counts &counts = figures.counts;
    const auto bodies = static_cast<double>(figures.choice.bodies);
    PrintHead(figures);
    PrintEvents(figures, colour);
    std::cout << "\nwatched:    " << counts.pairs << " pairs ("
              << Fixed(static_cast<double>(counts.pairs) / bodies, 2) << " a body), of which " << counts.near
              << " have a structure; " << counts.candidates
              << " were made in all\ncells:      " << counts.cells << " on " << counts.levels
              << (counts.levels == 1 ? " grid" : " grids") << "\nmemory:     " << counts.most_bytes
              << " bytes at most (" << Fixed(static_cast<double>(counts.most_bytes) / bodies, 0)
              << " a body)\ncomputed:   " << counts.disk_times << " times of disks and cells, "
              << counts.failure_times << " of structures' conditions, " << counts.continued
              << " searches that went on later\nclock:      " << Fixed(figures.clock, 3) << " s, "
              << Fixed(figures.MicrosecondsAnEvent(), 2) << " microseconds an event\n";
    if (figures.plans > 0)
        std::cout << "plans:      " << figures.plans
                  << " were given to bodies, a parabola and a straight line each; the event \"plan\" is the "
                     "change from one to the other, where no contact came before it\n";
    if (counts.softened > 0)
        std::cout << "softened:   " << counts.softened << " of " << counts.impulses
                  << " impulses, for slowness or in a jam; they kept " << Scientific(counts.softened_energy)
                  << " of energy\n";
    PrintConservation(figures);
    if (figures.check)
        std::cout << "check:      " << figures.check->pairs << " pairs of disks meet, "
                  << figures.check->overlaps << " of them overlap by more than "
                  << Scientific(kOverlapTolerance) << " (deepest: " << Scientific(figures.check->deepest)
                  << ")\n";
    if (figures.audits > 0)
        std::cout << "audits:     " << figures.audits << " passed\n";
}

MeasureOptions OptionsFor(const WorldCommand &command) {
    MeasureOptions options;
    options.check = command.check;
    options.audit = command.audit;
    return options;
}

/// The same density with each of these numbers of bodies, as a table: what grows, and what does not.
std::vector<WorldFigures> MeasureGrowth(const WorldCommand &command) {
    WorldChoice choice = command.choice;
    const std::vector<double> numbers =
        NumbersIn(command.growth, ',', 2.0, 1e7, "--growth", "number of bodies from 2 to 10000000", true);
    const double all = std::accumulate(numbers.begin(), numbers.end(), 0.0);
    double done = 0.0;
    Progress progress(1, command.quiet);
    std::vector<WorldFigures> runs;
    for (const double number : numbers) {
        choice.bodies = static_cast<size_t>(number);
        const WorldSetup setup = MakeWorld(choice);
        MeasureOptions options = OptionsFor(command);
        options.onSlice = [&](const WorldRun & /*run*/, double part) {
            progress.Show(std::to_string(choice.bodies) + " bodies", (done + part * number) / all);
        };
        runs.push_back(Measure(setup, options));
        done += number;
    }
    progress.Clear();
    if (!command.quiet)
        Print(runs, WantsColour(STDOUT_FILENO));
    return runs;
}

WorldFigures RunOne(const WorldCommand &command, const WorldSetup &setup) {
    Progress progress(1, command.quiet);
    MeasureOptions options = OptionsFor(command);
    std::optional<PictureSeries> series;
    WorldFrames frames(setup);
    if (!command.pictures.output.empty()) {
        options.slices = StepsOf(setup.choice);
        series.emplace(command.pictures, PictureSource::World);
        options.frames = &frames;
    }
    options.onSlice = [&](const WorldRun &run, double part) {
        if (series)
            series->Add(frames.Take(run));
        progress.Show(setup.choice.scene + ", time " + General(run.Time()), part);
    };
    const WorldFigures figures = Measure(setup, options);
    if (series) {
        series->Draw();
        progress.Clear();
        if (!command.quiet)
            std::cout << series->Said() << "\n\n";
    }
    return figures;
}

int Perform(const WorldCommand &command) {
    std::vector<WorldFigures> runs;
    if (!command.growth.empty()) {
        runs = MeasureGrowth(command);
    } else {
        const WorldSetup setup = MakeWorld(command.choice);
        runs.push_back(RunOne(command, setup));
        if (!command.quiet)
            Print(runs.front(), WantsColour(STDOUT_FILENO));
    }
    const bool overlap = std::any_of(runs.begin(), runs.end(), [](const WorldFigures &run) {
        return run.choice.response.kind != BMR_RESPONSE_PASS && run.check && run.check->overlaps > 0;
    });
    if (overlap)
        std::cerr << "boomerang-testbed: bodies overlap\n";
    return overlap ? kExitDifferent : kExitOk;
}

int Execute(const WorldCommand &command) {
    if (command.list) {
        ListWorlds();
        return kExitOk;
    }
    const WorldChoice &choice = command.choice;
    if (!command.pictures.output.empty()) {
        if (!(choice.seconds * kStepsAUnit < kMostSteps))
            throw UsageError("--seconds: a run that is drawn must have fewer than " + General(kMostSteps) +
                             " steps");
        // Before the work.
        PictureSeries(command.pictures, PictureSource::World).CheckLast(choice.scene, StepsOf(choice));
    }
    return Perform(command);
}

} // namespace

void AddWorld(CLI::App &app, Program &program) {
    const auto kept = std::make_shared<WorldCommand>();
    WorldCommand &command = *kept;
    CLI::App *world = app.add_subcommand(
        "world", "Run a kinetic world of many polygons, event by event: what happened, and what it cost");
    // Options are taken in this order: what follows the scene changes it.
    WorldChoice &choice = command.choice;
    const auto read = [&](const char *name, const char *description, auto &&reader) {
        return world->add_option_function<std::string>(
            name, [&choice, reader](const std::string &text) { reader(text, &choice); }, description);
    };
    constexpr double kMost = 1e6;
    read("scene", "A world that --list shows (default: gas)",
         [](const std::string &name, WorldChoice *its) { *its = SceneNamed(name); });
    world->add_option("--bodies", choice.bodies, "How many (default: the scene's own, as of all that follow)")
        ->check(Whole(2, 10000000));
    std::vector<std::string> shapes =
        NamesOf(BMR_NGON_COUNT, [](size_t i) { return bmr_ngon_name(static_cast<bmr_ngon>(i)); });
    shapes.insert(shapes.begin(), "mixed");
    world->add_option("--shape", choice.shape, "Shape of the polygons; mixed: all in turn")
        ->check(CLI::IsMember(shapes));
    read("--vertices", "N, or FEWEST:MOST, from which each body draws", ReadVertices);
    world
        ->add_option("--sizes", choice.sizes,
                     "Radius of the largest over that of the smallest, from 1 to 1000 (beyond, a contact's "
                     "margin, 1e-6 of the smallest, is too little for proofs about the largest)")
        ->check(Within(1.0, 1e3));
    world->add_option("--density", choice.density, "The polygons' area over the box's")
        ->check(Within(0.0, 1.0, true));
    world->add_option("--seconds", choice.seconds, "Units of time to simulate")
        ->check(Within(0.0, kMost, true));
    read("--boundary", "walls, periodic (what leaves on one side comes in on the other) or open",
         [](const std::string &name, WorldChoice *its) {
             its->boundary = name == "open" ? BMR_OPEN : name == "walls" ? BMR_WALLED : BMR_PERIODIC;
         })
        ->check(CLI::IsMember({"walls", "periodic", "open"}));
    read("--answer", "To contacts: elastic, pass, or a restitution", ReadAnswer);
    read("--zeno", "error or elastic", [](const std::string &name, WorldChoice *its) {
        its->zeno = name == "error" ? BMR_ZENO_ERROR : BMR_ZENO_ELASTIC;
    })->check(CLI::IsMember({"error", "elastic"}));
    world->add_option("--zeno-speed", choice.zenoSpeed, "Of --zeno elastic: slower than this is slow")
        ->check(Within(0.0, kMost, true))
        ->each([&choice](const std::string &) {
            if (choice.zeno == BMR_ZENO_ERROR)
                throw UsageError("--zeno-speed: there is none without --zeno elastic");
        });
    read("--structure", "Of near pairs; `events --list` shows all", ReadStructure);
    world->add_option("--seed", choice.seed, "Of all that is drawn")
        ->check(Whole(0, UINT64_MAX))
        ->capture_default_str();
    world->add_flag("--all-pairs", choice.allPairs, "No cells: every two bodies are watched, for comparison");
    world->add_flag("--check", command.check,
                    "At the end, look for overlaps of any two bodies by brute force");
    world->add_flag("--audit", command.audit, "Prove every certificate again, four times in the run");
    CLI::Option *growth = world->add_option(
        "--growth", command.growth,
        "Instead of one run: these numbers of bodies N1,N2,.. at the same density, as a table");
    growth->check(CLI::Validator(
        [](const std::string &text) {
            return text.empty() ? std::string("N1,N2,.. is wanted") : std::string();
        },
        "N1,N2,.."));
    CLI::Option *picture = world->add_option("--picture", command.pictures.output,
                                             "Draw the run into this file: .svg, .png or .pdf");
    AddPictureOptions(*world, command.pictures, picture);
    growth->excludes(picture);
    world->add_flag("--quiet", command.quiet, "No tables");
    world->add_flag("--list", command.list, "Show the scenes, and run nothing");
    world->footer(std::string(kNotes) + kLayersHelp);
    world->callback([kept, &program] { program.status = Execute(*kept); });
}

} // namespace testbed
