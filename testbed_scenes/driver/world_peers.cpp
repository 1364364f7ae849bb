// SPDX-License-Identifier: MIT
//
// `boomerang-testbed world --peers`: the same bodies, in this one run, by all pairs, by steps in time, and by
// Box2D.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <map>
#include <set>

#include <unistd.h>

#include "boomerang/simulation.h"
#include "box2d_gas.h"
#include "commands.h"
#include "progress.h"
#include "table.h"
#include "theory/files.h"
#include "world_command.h"
#include "worlds/stepping.h"

namespace testbed {
namespace {

/// Seconds of the processor that this process has taken: what else the machine does is not in them.
double Seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Peers that cost the square of the bodies run for a part of the time, where there are more than these.
constexpr double kFullPairs = 1000.0, kFullStructures = 100.0;
/// A structure for every pair is a kilobyte each: of more bodies than these the first ones stand for all.
constexpr size_t kMostStructured = 2000;
/// Steps that are timed, at most.
constexpr int kTimedSteps = 2000;
/// Shares of contacts that steps in time may miss, of which the steps are told.
constexpr double kMissedShares[] = {0.1, 0.01, 0.001};
/// Box2D begins anew at so many moments of the kinetic run, and is watched for this many contacts a body, or
/// steps.
constexpr int kMoments = 20;
constexpr double kContactsABody = 1.0, kLeastSteps = 8.0;
/// What is timed runs again while all of it took less than this, and the fastest counts.
constexpr double kEnoughSeconds = 1.0;
constexpr int kMostTimes = 5;

/// The kinetic run that all are held against.
struct Reference {
    std::vector<bmr_contact> contacts;
    std::vector<Noticed> noticed;
    std::vector<GasMoment> moments;
    double clock = 0.0, momentSpan = 0.0;
};

/// Seconds to make a setup's world and to run it: of a part of the time, as long as all of it would take.
double TimeRun(const WorldSetup &setup, double part = 1.0) {
    double best = HUGE_VAL, all = 0.0;
    for (int i = 0; i < kMostTimes && all < kEnoughSeconds; ++i) {
        const double start = Seconds();
        WorldRun run(setup);
        const double making = Seconds() - start;
        run.Advance(setup.choice.seconds);
        const double seconds = Seconds() - start;
        all += seconds;
        best = std::min(best, making + (seconds - making) / part);
    }
    return best;
}

struct Row {
    std::string name, note;
    double clock = 0.0; ///< for all of the time, extrapolated where the note says so
};

Reference RunReference(const WorldSetup &setup, Paths *paths) {
    Reference reference;
    const double seconds = setup.choice.seconds;
    reference.clock = TimeRun(setup);
    // Again, and this time everything is kept.
    const WorldRun *world = nullptr;
    WorldRun run(
        setup,
        [&](const bmr_contact &contact) {
            reference.contacts.push_back(contact);
            reference.noticed.push_back({contact.time, TimeToNotice(contact, *world, setup)});
        },
        [&](const bmr_world_event &event) {
            if (event.kind != BMR_WORLD_CONTACT)
                return;
            for (const bmr_body body : {event.a, event.b})
                if (!bmr_is_wall(body))
                    paths->Change(static_cast<size_t>(body), event.time, world->StateOf(body).piece);
        });
    world = &run;
    run.Advance(seconds);
    const double rate = 2.0 * static_cast<double>(reference.contacts.size()) /
                        (static_cast<double>(setup.bodies.size()) * seconds);
    reference.momentSpan = std::min(
        seconds, std::max(rate > 0.0 ? kContactsABody / rate : 0.0, kLeastSteps * Box2DTimeStep(setup)));
    WorldRun again(setup);
    for (int moment = 0; moment < kMoments; ++moment) {
        again.Advance((seconds - reference.momentSpan) * moment / kMoments);
        reference.moments.push_back(MomentOf(again, setup));
    }
    return reference;
}

bool AreSame(const bmr_contact &a, const bmr_contact &b) {
    return a.time == b.time && a.a == b.a && a.b == b.b;
}

Row RunAllPairs(const WorldSetup &setup, const Reference &reference, nlohmann::json *json) {
    WorldSetup all = MakeWorld(setup.choice);
    all.choice.allPairs = true;
    const double bodies = static_cast<double>(setup.bodies.size());
    const double part = std::min(1.0, kFullPairs * kFullPairs / (bodies * bodies));
    all.choice.seconds *= part;
    std::vector<bmr_contact> contacts;
    const double clock = TimeRun(all, part);
    WorldRun run(all, [&](const bmr_contact &contact) { contacts.push_back(contact); });
    run.Advance(all.choice.seconds);
    const bool same = contacts.size() <= reference.contacts.size() &&
                      std::equal(contacts.begin(), contacts.end(), reference.contacts.begin(), AreSame) &&
                      (part < 1.0 || contacts.size() == reference.contacts.size());
    (*json)["all_pairs"] = {
        {"clock", clock}, {"part", part}, {"contacts", contacts.size()}, {"same_contacts", same}};
    return {"all pairs, disks first",
            std::to_string(contacts.size()) +
                (same ? " contacts, the same to the bit" : " contacts, NOT THE SAME") +
                (part < 1.0 ? "; extrapolated" : ""),
            clock};
}

/// A structure for every pair, as bmr_simulation keeps: it answers no contact, so bodies pass through each
/// other.
Row RunStructures(const WorldSetup &setup, nlohmann::json *json) {
    const size_t count = std::min(setup.bodies.size(), kMostStructured);
    const double bodies = static_cast<double>(count);
    const double time = std::min(1.0, kFullStructures * kFullStructures / (bodies * bodies));
    const double all = static_cast<double>(setup.bodies.size());
    const double part = time * bodies * bodies / (all * all); // of the time and of the pairs
    std::vector<bmr_shape> shapes;
    std::vector<MotionPointer> owners;
    std::vector<bmr_motion *> motions;
    for (size_t i = 0; i < count; ++i) {
        const WorldBody &body = setup.bodies[i];
        const bmr_motion_piece piece = bmr_piece_screw(0.0, body.pose, body.velocity, body.spin);
        bmr_motion *motion = nullptr;
        Require(bmr_motion_create(&piece, nullptr, &motion), "a motion");
        owners.emplace_back(motion);
        motions.push_back(motion);
        shapes.push_back(body.polygon->Shape());
    }
    bmr_simulation_def def = bmr_default_simulation_def();
    Require(bmr_kds_find(setup.choice.structure.c_str(), &def.structure), setup.choice.structure);
    def.kds.hysteresis = 1e-6;
    bmr_simulation *simulation = nullptr;
    Require(bmr_simulation_create(&def, shapes.data(), motions.data(), shapes.size(), 0.0, nullptr, nullptr,
                                  nullptr, &simulation),
            "the simulation");
    const std::unique_ptr<bmr_simulation, decltype(&bmr_simulation_destroy)> owner(simulation,
                                                                                   bmr_simulation_destroy);
    const double start = Seconds();
    const bmr_error error = bmr_simulation_run(simulation, setup.choice.seconds * time);
    const double clock = (Seconds() - start) / part;
    (*json)["structures"] = {{"clock", clock}, {"part", part}};
    if (error != BMR_OK)
        return {"a structure for every pair", bmr_error_describe(error), HUGE_VAL};
    return {"a structure for every pair",
            part < 1.0 ? "no contact answered; extrapolated" : "no contact answered", clock};
}

/// The step of which, at any phase, this share is missed on average.
double StepFor(const std::vector<Noticed> &contacts, double share) {
    double low = 0.0, high = 1e9;
    for (int i = 0; i < 200; ++i) {
        const double h = 0.5 * (low + high);
        double missed = 0.0;
        for (const Noticed &contact : contacts)
            missed += std::max(0.0, 1.0 - contact.window / h);
        (missed > share * static_cast<double>(contacts.size()) ? high : low) = h;
    }
    return low;
}

/// The step in which two bodies that meet fly as far towards each other, on average, as a contact of the
/// kinetic world may be away from touching: its margin.
double ExactStep(const Reference &reference) {
    double approach = 0.0;
    for (const bmr_contact &contact : reference.contacts)
        approach += std::fabs(contact.approach[0]) / static_cast<double>(reference.contacts.size());
    return bmr_default_kds_def().margin / approach;
}

Row RunSteps(const WorldSetup &setup, const Paths &paths, const Reference &reference, double h,
             const std::string &name, nlohmann::json *json) {
    const double steps = std::ceil(setup.choice.seconds / h);
    const int timed = static_cast<int>(std::min(steps, static_cast<double>(kTimedSteps)));
    Stepper stepper(setup, paths);
    const double start = Seconds();
    for (int step = 1; step <= timed; ++step)
        stepper.StepTo(step * h);
    const double each = (Seconds() - start) / timed;
    const size_t missed = CountMissed(reference.noticed, h);
    (*json)["steps"].push_back({{"h", h},
                                {"steps", steps},
                                {"missed", missed},
                                {"microseconds_a_step", 1e6 * each},
                                {"clock", each * steps},
                                {"list", stepper.ListSize()}});
    char note[160];
    std::snprintf(note, sizeof note, "%.3g steps of %.2e, %.1f us each; misses %zu of %zu%s", steps, h,
                  1e6 * each, missed, reference.noticed.size(), timed < steps ? "; extrapolated" : "");
    return {name, note, each * steps};
}

/// Contacts of two bodies that have met nobody since the moment, in either world: until then both fly alike,
/// so that Box2D must see them.
struct Seen {
    size_t fresh = 0, missed = 0;
};

Seen CompareFresh(const WorldSetup &setup, const Reference &reference, const GasMoment &from,
                  const std::vector<GasContact> &begins) {
    const int walls = static_cast<int>(setup.bodies.size());
    const double until = from.time + reference.momentSpan, patience = 2.0 * Box2DTimeStep(setup);
    std::map<int, double> metInBox2D; // whom first, by body
    std::map<std::pair<int, int>, double> begun;
    for (const GasContact &begin : begins) {
        begun.try_emplace({begin.a, begin.b}, begin.time);
        for (const int body : {begin.a, begin.b})
            if (body != walls)
                metInBox2D.try_emplace(body, begin.time);
    }
    Seen seen;
    std::set<int> met;
    for (const bmr_contact &contact : reference.contacts) {
        if (contact.time <= from.time || contact.time + patience > until)
            continue;
        const int a = static_cast<int>(contact.a),
                  b = bmr_is_wall(contact.b) ? walls : static_cast<int>(contact.b);
        const std::pair<int, int> key = std::minmax(a, b);
        const auto mine = begun.find(key);
        bool fresh = true;
        for (const int body : {a, b}) {
            if (body == walls)
                continue;
            fresh = fresh && met.count(body) == 0;
            const auto other = metInBox2D.find(body);
            // Met somebody else before this contact.
            fresh = fresh && (other == metInBox2D.end() || other->second > contact.time + patience ||
                              (mine != begun.end() && mine->second == other->second));
            met.insert(body);
        }
        if (!fresh)
            continue;
        ++seen.fresh;
        seen.missed += mine == begun.end() || mine->second > contact.time + patience ? 1 : 0;
    }
    return seen;
}

Row RunBox2D(const WorldSetup &setup, const Reference &reference, const Workers &workers,
             nlohmann::json *json) {
    const Box2DGas gas = RunGas(setup, reference.moments.front(), setup.choice.seconds, workers);
    Seen seen;
    for (const GasMoment &moment : reference.moments) {
        const Seen here =
            CompareFresh(setup, reference, moment, FindBegins(setup, moment, reference.momentSpan, workers));
        seen.fresh += here.fresh;
        seen.missed += here.missed;
    }
    (*json)["box2d"] = {
        {"steps", gas.steps},          {"h", gas.timeStep},           {"clock", gas.clock},
        {"begins", gas.begins.size()}, {"fresh", seen.fresh},         {"missed", seen.missed},
        {"energy", gas.energyChange},  {"energy_most", gas.mostGain}, {"deepest", gas.deepest}};
    char note[200];
    std::snprintf(note, sizeof note,
                  "%lld steps of %.2e; misses %zu of %zu fresh contacts; energy %+.2f %%, at most %+.2f %%",
                  static_cast<long long>(gas.steps), gas.timeStep, seen.missed, seen.fresh,
                  100.0 * gas.energyChange, 100.0 * gas.mostGain);
    return {"Box2D, bullets", note, gas.clock};
}

void Print(const WorldSetup &setup, const Reference &reference, const std::vector<Row> &rows, bool colour) {
    std::cout << setup.choice.scene << ": " << setup.choice.bodies << " polygons at a density of "
              << setup.choice.density << ", " << setup.choice.seconds << " units of time, "
              << reference.contacts.size() << " contacts\n\n";
    Table table;
    table.AddColumn("", "by");
    table.AddColumn("", "seconds");
    table.AddColumn("", "over kinetic");
    for (const Row &row : rows)
        table.AddRow({{row.name},
                      {Fixed(row.clock, row.clock < 1000.0 ? 3 : 0)},
                      {Fixed(row.clock / reference.clock, 2),
                       row.clock < reference.clock ? Style::Bad : Style::Good}});
    table.Print(std::cout, colour);
    std::cout << '\n';
    for (const Row &row : rows)
        std::cout << row.name << ": " << row.note << '\n';
}

} // namespace

nlohmann::json MeasurePeers(const WorldCommand &command, const Workers &workers) {
    const WorldChoice choice = ChoiceFor(command);
    if (choice.boundary == BMR_PERIODIC)
        throw UsageError("--peers: Box2D has no periodic box; --boundary walls or open");
    if (choice.response.kind != BMR_RESPONSE_IMPULSE || choice.response.restitution != 1.0)
        throw UsageError("--peers: of elastic answers alone");
    if (choice.scene == "swarm" || !(choice.speed > 0.0))
        throw UsageError("--peers: of bodies that fly freely from contact to contact");
    if (choice.allPairs)
        throw UsageError("--peers: --all-pairs is one of them");
    const WorldSetup setup = MakeWorld(choice);
    constexpr int kUnits = 9;
    Progress progress(kUnits, command.quiet);
    nlohmann::json json;
    std::vector<Row> rows;
    const auto next = [&](const char *what) {
        progress.Finish();
        progress.Show(what, 0.0);
    };
    progress.Show("the kinetic world", 0.0);
    Paths paths(setup);
    const Reference reference = RunReference(setup, &paths);
    if (reference.contacts.empty())
        throw UsageError("--peers: nothing touches in this time");
    rows.push_back({"kinetic", "every contact at its own time", reference.clock});
    json["kinetic"] = {{"clock", reference.clock}, {"contacts", reference.contacts.size()}};
    next("all pairs");
    rows.push_back(RunAllPairs(setup, reference, &json));
    next("a structure for every pair");
    rows.push_back(RunStructures(setup, &json));
    for (const double share : kMissedShares) {
        next("steps in time");
        char name[64];
        std::snprintf(name, sizeof name, "steps, 1 in %g missed", std::round(1.0 / share));
        rows.push_back(RunSteps(setup, paths, reference, StepFor(reference.noticed, share), name, &json));
    }
    next("steps in time");
    rows.push_back(RunSteps(setup, paths, reference,
                            FaithfulStep(reference.noticed, StepFor(reference.noticed, kMissedShares[0])),
                            "steps, none missed", &json));
    next("steps in time");
    rows.push_back(RunSteps(setup, paths, reference, ExactStep(reference), "steps, as exact", &json));
    next("Box2D");
    rows.push_back(RunBox2D(setup, reference, workers, &json));
    progress.Clear();
    if (!command.quiet)
        Print(setup, reference, rows, WantsColour(STDOUT_FILENO));
    return json;
}

} // namespace testbed
