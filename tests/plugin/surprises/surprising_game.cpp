// SPDX-License-Identifier: MIT
// A game that does to pairs that have long been apart what changes the answer they are known to have: see
// changes.cpp for what, and watching.h for where in a step.
//
//   surprising_game list                 the names of all scenarios: change@place, change@place@how-far-out
//   surprising_game all                  plays them; a line for each: bodies and events, hashed
//   surprising_game power                plays them with the change and without; a line for each tells the
//                                        step of the change and the first one in which events differ
//   surprising_game NAME [steps|tell]    one of them: hashes of each step, or every callback
//   surprising_game random SEED COUNT    worlds in which changes come one after the other at random places
#include <cstdlib>
#include <map>
#include <memory>
#include <random>
#include <string>

#include "changes.h"
#include "own_worlds.h"

using namespace surprises;

namespace {

/// Steps before anything happens, after it, and until Change::later.
constexpr int kQuiet = 14, kAfter = 8, kLater = 4;

struct Scenario {
    const Change *change;
    Place place;
    float out;
};

const float kOut[] = {600.0f, 40000.0f};

std::string NameOf(const Scenario &scenario) {
    std::string name = std::string(scenario.change->name) + "@" + kPlaceNames[scenario.place];
    if (scenario.out > 0.0f)
        name += "@" + std::to_string(static_cast<int>(scenario.out));
    return name;
}

/// Pairs come behind the first drum in Box2D's list, and are updated after it.
bool UpdatesFollow(Place place) {
    return place == kBetween || place == kBeginFirst || place == kEndFirst || place == kPreFirst ||
           place == kFilterFirst || place == kFilterNew || place == kUnlocked;
}

std::vector<Scenario> AllScenarios() {
    std::vector<Scenario> all;
    for (const Change &change : AllChanges())
        for (int place = 0; place < kPlaces; ++place)
            if ((change.whileLocked || place == kBetween || place == kUnlocked) &&
                (change.before != kInside || UpdatesFollow(static_cast<Place>(place))))
                all.push_back({&change, static_cast<Place>(place), 0.0f});
    for (const Change &change : AllChanges())
        for (const float out : kOut)
            all.push_back({&change, kBetween, out});
    return all;
}

struct StepHashes {
    uint64_t bodies, events;
};

struct Played {
    std::vector<StepHashes> steps;
    int changed = -1;
};

/// A world, who watches it, and the crowd in it.
struct Game {
    explicit Game(float out)
        : world({10.0f, 0.0f}), watching(&world),
          crowd(&world, {out, out}), around{world, crowd, watching, 1.0f / 60.0f, true} {}
    StepHashes Step(int step) {
        crowd.Tick(step);
        return JustStep();
    }
    StepHashes JustStep() {
        world.Step(around.timeStep, 4, 2);
        Hash bodies;
        bodies.Add(world);
        const StepHashes hashes = {bodies.Value(), watching.hash.Value()};
        watching.hash = Hash();
        return hashes;
    }
    void ForVictims(void (*what)(Surroundings &, Pair &)) {
        for (Pair &pair : crowd.pairs)
            if (pair.copy == kVictim && pair.a != nullptr && pair.b != nullptr)
                what(around, pair);
    }

    b2World world;
    Watching watching;
    Crowd crowd;
    Surroundings around;
};

/// The first step from kQuiet on with a callback of this place. The drums know nothing of the pairs.
int StepOf(Place place, float out) {
    static std::map<float, std::map<Place, int>> known;
    std::map<Place, int> &first = known[out];
    if (first.empty()) {
        Game game(out);
        for (int step = 0; step < kQuiet + 12; ++step) {
            game.watching.places.clear();
            game.Step(step);
            for (const Place come : game.watching.places)
                if (step >= kQuiet)
                    first.insert({come, step});
        }
        first[kBetween] = kQuiet;
    }
    const auto found = first.find(place);
    return found == first.end() ? -1 : found->second;
}

Played Play(const Scenario &scenario, bool changes, bool tells = false) {
    const Change &change = *scenario.change;
    const int when = StepOf(scenario.place, scenario.out);
    Played played;
    if (when < 0)
        return played;
    Game game(scenario.out);
    game.watching.tells = tells;
    for (int step = 0; step < when + kAfter; ++step) {
        if (tells)
            std::printf("  step %d\n", step);
        if (step == when && change.before != kNothing)
            for (Pair &pair : game.crowd.pairs)
                if (pair.copy == kVictim)
                    Prepare(game.around, pair, change.before);
        const auto act = [&] {
            played.changed = step;
            game.around.updatesFollow = UpdatesFollow(scenario.place);
            if (changes && change.ofPair != nullptr)
                game.ForVictims(change.ofPair);
            if (changes && change.ofWorld != nullptr)
                change.ofWorld(game.around);
        };
        game.crowd.Tick(step);
        game.around.updatesFollow = true;
        game.watching.looks = step >= when - 1;
        if (step == when && scenario.place == kBetween)
            act();
        else if (step == when)
            game.watching.At(scenario.place, act);
        if (step == when + kLater && changes && change.later != nullptr)
            game.ForVictims(change.later);
        if (step == when + kLater && changes && change.ofWorld != nullptr)
            change.ofWorld(game.around);
        played.steps.push_back(game.JustStep());
    }
    return played;
}

uint64_t Together(const Played &played, uint64_t StepHashes::*which) {
    Hash hash;
    for (const StepHashes &step : played.steps) {
        hash.Add(static_cast<uint32_t>(step.*which));
        hash.Add(static_cast<uint32_t>(step.*which >> 32));
    }
    return hash.Value();
}

void PrintWhole(const std::string &name, const Played &played) {
    std::printf("%s changed in %d: bodies %016" PRIx64 " events %016" PRIx64 "\n", name.c_str(),
                played.changed, Together(played, &StepHashes::bodies), Together(played, &StepHashes::events));
    std::fflush(stdout);
}

void PrintPower(const Scenario &scenario) {
    const Played with = Play(scenario, true), without = Play(scenario, false);
    size_t step = 0;
    while (step < with.steps.size() && with.steps[step].events == without.steps[step].events)
        ++step;
    std::printf("%s %d %d\n", NameOf(scenario).c_str(), with.changed,
                step < with.steps.size() ? static_cast<int>(step) : -1);
    std::fflush(stdout);
}

/// Changes of all kinds at random places, to random pairs.
void PlayRandom(unsigned seed) {
    std::mt19937 numbers(seed);
    const auto below = [&numbers](size_t limit) { return static_cast<size_t>(numbers() % limit); };
    const float outs[] = {0.0f, 0.0f, 0.0f, 300.0f, 600.0f, 40000.0f};
    Game game(outs[below(6)]);
    Played played;
    const std::vector<Change> &changes = AllChanges();
    for (int step = 0; step < 150; ++step) {
        game.crowd.Tick(step);
        while (step > 6 && below(3) == 0) {
            const Change &change = changes[below(changes.size())];
            // Where a body is nowhere Box2D asserts as soon as it looks for impacts. Edited normals are on
            // the list of what differs (test_surprises.sh), which has a scenario for each place.
            const std::string name = change.name;
            if (name == "nowhere" || name == "infinitely-far" || name == "normals")
                continue;
            const size_t first = below(game.crowd.pairs.size()), count = 1 + below(3);
            const auto place = change.whileLocked ? static_cast<Place>(below(kUnlocked)) : kBetween;
            const auto act = [&game, &change, first, count] {
                game.around.updatesFollow = false;
                for (size_t i = first; i < first + count && i < game.crowd.pairs.size(); ++i) {
                    Pair &pair = game.crowd.pairs[i];
                    if (pair.a != nullptr && pair.b != nullptr && change.ofPair != nullptr &&
                        pair.a->GetFixtureList() != nullptr && pair.b->GetFixtureList() != nullptr)
                        change.ofPair(game.around, pair);
                }
                if (change.ofWorld != nullptr)
                    change.ofWorld(game.around);
            };
            if (change.before != kNothing)
                for (size_t i = first; i < first + count && i < game.crowd.pairs.size(); ++i)
                    if (game.crowd.pairs[i].a != nullptr)
                        Prepare(game.around, game.crowd.pairs[i], change.before);
            if (place == kBetween)
                act();
            else
                game.watching.At(place, act);
        }
        played.steps.push_back(game.JustStep());
        played.changed = step;
        if (step % 5 == 4) // what comes to an assertion is compared up to there
            PrintWhole("random " + std::to_string(seed), played);
    }
}

int PlayOne(const std::string &name, const std::string &how) {
    for (const Scenario &scenario : AllScenarios()) {
        if (NameOf(scenario) != name)
            continue;
        const Played played = Play(scenario, true, how == "tell");
        if (how == "steps")
            for (size_t i = 0; i < played.steps.size(); ++i)
                std::printf("step %zu: bodies %016" PRIx64 " events %016" PRIx64 "\n", i,
                            played.steps[i].bodies, played.steps[i].events);
        PrintWhole(name, played);
        return 0;
    }
    return PlayOwnWorld(name) ? 0 : 2;
}

} // namespace

int main(int argc, char **argv) {
    const std::string what = argc > 1 ? argv[1] : "";
    if (what == "random" && argc == 4) {
        const auto first = static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)),
                   count = static_cast<unsigned>(std::strtoul(argv[3], nullptr, 10));
        for (unsigned seed = first; seed < first + count; ++seed)
            PlayRandom(seed);
        return 0;
    }
    if (what != "list" && what != "all" && what != "power")
        return PlayOne(what, argc > 2 ? argv[2] : "");
    for (const Scenario &scenario : AllScenarios()) {
        if (what == "list")
            std::printf("%s\n", NameOf(scenario).c_str());
        else if (what == "power")
            PrintPower(scenario);
        else
            PrintWhole(NameOf(scenario), Play(scenario, true));
    }
    for (const std::string &name : OwnWorlds()) {
        if (what == "list")
            std::printf("%s\n", name.c_str());
        else if (what == "all")
            PlayOwnWorld(name);
    }
    return 0;
}
