// SPDX-License-Identifier: MIT
//
// `boomerang-testbed world --growth`: what grows with the number of bodies, and what does not.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <sstream>

#include <unistd.h>

#include "commands.h"
#include "progress.h"
#include "table.h"

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

} // namespace testbed
