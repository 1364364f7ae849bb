// SPDX-License-Identifier: MIT
#include "commands.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <sstream>

#include <unistd.h>

#include "progress.h"
#include "table.h"
#include "worlds/world.h"

namespace testbed {
namespace {

std::vector<size_t> NumbersIn(const std::string &text) {
    std::vector<size_t> numbers;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        char *end = nullptr;
        const long long number = std::strtoll(word.c_str(), &end, 10);
        if (word.empty() || *end != '\0' || number < 2 || number > 10000000)
            throw UsageError("--growth: \"" + word + "\" is no number of bodies from 2 to 10000000");
        numbers.push_back(static_cast<size_t>(number));
    }
    if (numbers.empty())
        throw UsageError("--growth: N1,N2,.. is wanted");
    return numbers;
}

void Print(const std::vector<WorldFigures> &runs, bool colour) {
    const WorldFigures &first = runs.front();
    std::cout << first.choice.scene << " at a density of " << first.choice.density << ", "
              << NameOf(first.choice.boundary) << ", " << first.choice.structure << ", "
              << first.choice.seconds << " units of time; in brackets: over the first row\n\n";
    Table table;
    table.AddColumn("", "bodies");
    for (int kind = 0; kind < BMR_WORLD_EVENT_KIND_COUNT; ++kind)
        table.AddColumn("events for each body and unit of time",
                        bmr_world_event_name(static_cast<bmr_world_event_kind>(kind)));
    table.AddColumn("events for each body and unit of time", "all");
    table.AddColumn("a body", "pairs");
    table.AddColumn("a body", "bytes");
    table.AddColumn("clock", "us an event");
    table.AddColumn("clock", "us a body and unit");
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

} // namespace

std::vector<WorldFigures> MeasureGrowth(const WorldCommand &command) {
    WorldChoice choice = ChoiceFor(command);
    const std::vector<size_t> numbers = NumbersIn(command.growth);
    double all = 0.0, done = 0.0;
    for (const size_t number : numbers)
        all += static_cast<double>(number);
    constexpr int kUnits = 1000;
    Progress progress(kUnits, command.quiet);
    std::vector<WorldFigures> runs;
    for (const size_t number : numbers) {
        choice.bodies = number;
        const WorldSetup setup = MakeWorld(choice);
        MeasureOptions options;
        options.check = command.check;
        options.audit = command.audit;
        options.onSlice = [&](const WorldRun & /*run*/, double part) {
            progress.FinishUpTo(static_cast<int>(kUnits * (done + part * static_cast<double>(number)) / all));
            progress.Show(std::to_string(number) + " bodies", 0.0);
        };
        runs.push_back(Measure(setup, options));
        done += static_cast<double>(number);
    }
    progress.Clear();
    if (!command.quiet)
        Print(runs, WantsColour(STDOUT_FILENO));
    return runs;
}

namespace {

/// A run of more takes hours and gigabytes.
constexpr double kMostSteps = 20000.0;
/// Of the progress line.
constexpr int kProgressUnits = 1000;

std::string Scientific(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", number);
    return text;
}

/// Steps after the first frame.
int StepsOf(const WorldCommand &command, const WorldChoice &choice) {
    return std::max(1, static_cast<int>(std::lround(choice.seconds * command.rate)));
}

void List() {
    for (const WorldScene &scene : WorldScenes()) {
        std::string line = "  " + scene.choice.scene;
        line.resize(14, ' ');
        std::cout << line << scene.description << " (" << scene.choice.bodies << " bodies, "
                  << NameOf(scene.choice.boundary) << ", " << NameOf(scene.choice.response) << ")\n";
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
    Table table;
    table.AddColumn("", "events");
    table.AddColumn("", "in all");
    table.AddColumn("for each body", "and unit of time");
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
    if (figures.choice.speed == 0.0)
        std::cout << "nothing, for nobody began to move";
    else if (figures.energy)
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
              << counts.failure_times << " of structures' conditions, " << counts.looks
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

WorldFigures RunOne(const WorldCommand &command, const WorldSetup &setup) {
    Progress progress(kProgressUnits, command.quiet);
    MeasureOptions options;
    options.check = command.check;
    options.audit = command.audit;
    std::optional<PictureSeries> series;
    WorldFrames frames(setup);
    if (!command.pictures.output.empty()) {
        options.slices = StepsOf(command, setup.choice);
        series.emplace(command.pictures, PictureSource::World);
        options.onContact = [&](const bmr_contact &contact) { frames.Add(contact); };
        options.onEvent = [&](const bmr_world_event &event) { frames.Add(event); };
    }
    options.onSlice = [&](const WorldRun &run, double part) {
        if (series)
            series->Add(frames.Take(run));
        progress.FinishUpTo(static_cast<int>(kProgressUnits * part));
        progress.Show(setup.choice.scene + ", time " + General(run.Time()), 0.0);
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
        const WorldSetup setup = MakeWorld(ChoiceFor(command));
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

} // namespace

int Execute(const WorldCommand &command) {
    if (command.list) {
        List();
        return kExitOk;
    }
    const WorldChoice choice = ChoiceFor(command);
    if (!command.pictures.output.empty()) {
        if (!(command.rate > 0.0) || !(choice.seconds * command.rate < kMostSteps))
            throw UsageError("--rate: it must be above 0, and the run must have fewer than " +
                             General(kMostSteps) + " steps");
        // Before the work.
        PictureSeries(command.pictures, PictureSource::World)
            .CheckLast(choice.scene, StepsOf(command, choice));
    }
    try {
        return Perform(command);
    } catch (const WorldChoiceError &error) {
        throw UsageError(error.what());
    }
}

} // namespace testbed
