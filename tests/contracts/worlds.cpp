// SPDX-License-Identifier: MIT
// Worlds to which bad things happen: as stock Box2D, and with the plugin in front of it in each of its ways.
//
// The programs and libraries are given by the build: BAD_WORLD (a plain Box2D program), BAD_WORLD_LINKED (the
// same, linked ahead) and BAD_WORLD_PLUGIN (the shared library).
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include <unistd.h>

#include "contracts.h"
#include "process.h"

using namespace contracts;

namespace {

/// One way of playing; a preloaded one where no variable says otherwise.
struct Way {
    const char *name;
    bool linked;
    std::vector<std::string> environment;
};

const std::vector<Way> kWays = {
    {"linked ahead", true, {"BOOMERANG=on"}},
    {"preloaded", false, {}},
    {"`BOOMERANG=verify`", false, {"BOOMERANG=verify"}},
};

std::vector<std::string> BadThings() {
    std::istringstream lines(RunProgram({BAD_WORLD}).output);
    std::vector<std::string> names;
    for (std::string name; std::getline(lines, name);)
        names.push_back(name);
    return names;
}

Ended Play(size_t thing, const std::string &program, std::vector<std::string> environment) {
    return RunProgram({program, std::to_string(thing)}, std::move(environment));
}

/// Once for all ways.
const Ended &PlayStock(size_t thing) {
    static std::map<size_t, Ended> played;
    const auto known = played.find(thing);
    return known != played.end() ? known->second : played[thing] = Play(thing, BAD_WORLD, {});
}

std::string HowItEnds(const Ended &ended) {
    if (ended.signal == SIGABRT)
        return "aborts";
    if (ended.signal != 0)
        return "signal " + std::to_string(ended.signal);
    return ended.status == 0 ? "runs" : "status " + std::to_string(ended.status);
}

std::string PlayedBy(size_t thing, const Way &way) {
    const Ended &stock = PlayStock(thing);
    char file[] = "/tmp/boomerang_bad_world_XXXXXX";
    const int descriptor = mkstemp(file);
    if (descriptor < 0)
        return "no file for what is counted";
    close(descriptor);
    std::vector<std::string> environment = way.environment;
    environment.push_back("BOOMERANG_COUNTS=" + std::string(file));
    if (!way.linked)
        environment.push_back(std::string("LD_PRELOAD=") + BAD_WORLD_PLUGIN);
    Ended ours = Play(thing, way.linked ? BAD_WORLD_LINKED : BAD_WORLD, environment);
    std::map<std::string, uint64_t> counted;
    std::ifstream counts(file);
    uint64_t count = 0;
    for (std::string name; counts >> name >> count;)
        counted[name] = count;
    std::remove(file);

    if (ours.signal != stock.signal || ours.status != stock.status)
        return HowItEnds(ours) + ", stock " + HowItEnds(stock);
    if (ours.output != stock.output)
        return "other steps than stock's";
    if (stock.signal == 0 && counted["evaluations"] == 0)
        return "as stock, but the plugin is not at work";
    if (stock.signal == 0 && counted["differences"] != 0)
        return std::to_string(counted["differences"]) + " answers are not Box2D's";
    // Mode verify ends with a line where all is well.
    if (std::regex_match(ours.errors, std::regex("boomerang: verified [0-9,]+ answers, 0 differ\n")) &&
        way.environment == std::vector<std::string>{"BOOMERANG=verify"})
        ours.errors.clear();
    // What is said besides is Box2D's assertion.
    if (stock.signal == 0 && !ours.errors.empty())
        return "as stock, but says " + ours.errors;
    return stock.signal == 0 ? "as stock" : "as stock: " + HowItEnds(stock);
}

/// The control: two things that happen are two outputs.
bool OutputsTell() {
    return PlayStock(0).output != PlayStock(1).output && !PlayStock(0).output.empty();
}

const Table kWorlds("worlds", [] {
    for (const char *name :
         {"BOOMERANG", "BOOMERANG_PAIRS_BY", "BOOMERANG_COUNTS", "BOOMERANG_VERBOSE", "LD_PRELOAD"})
        unsetenv(name);
    Matrix matrix;
    matrix.alone = false; // the games have processes of their own
    matrix.rows = BadThings();
    matrix.columns = {"Box2D"};
    for (const Way &way : kWays)
        matrix.columns.emplace_back(way.name);
    matrix.answer = [](size_t row, size_t column) {
        return !OutputsTell() ? "what happens does not show in the output"
               : column == 0  ? HowItEnds(PlayStock(row))
                              : PlayedBy(row, kWays[column - 1]);
    };
    return matrix;
});

} // namespace
