// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_WORLD_H
#define BOOMERANG_TESTBED_WORLD_H

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <queue>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "boomerang/world.h"
#include "picture/frame.h"
#include "theory/course.h"

/// @file
/// Kinetic worlds of many bodies: made, run, measured and shown.

namespace testbed {

// --- What a world of many bodies begins with: a scene's name, what may be chosen about it, and the bodies
// that come of that, placed so that no two disks meet.

/// A choice that no world can be made of; says what would do.
class WorldChoiceError : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

/// What may be chosen. Lengths are in radii of the smallest body's disk.
struct WorldChoice {
    std::string scene;
    size_t bodies = 0;
    /// A name of bmr_ngon, or "mixed": all of them in turn.
    std::string shape;
    size_t fewestVertices = 0, mostVertices = 0; ///< each body's number is drawn from between them
    double sizes = 1.0;                          ///< radius of the largest disk over the smallest; >= 1
    double density = 0.0;                        ///< the polygons' area over the box's
    double seconds = 0.0;
    std::string structure;
    uint64_t seed = 1;
    bmr_boundary boundary = BMR_WALLED;
    bmr_response response = {BMR_RESPONSE_IMPULSE, 1.0};
    bmr_zeno_policy zeno = BMR_ZENO_ERROR;
    double zenoSpeed = 1e-2;
    bool allPairs = false;
};

/// A scene, with its own choice. Options replace parts of that.
struct WorldScene {
    const char *description;
    WorldChoice choice;
};
const std::vector<WorldScene> &WorldScenes();

struct WorldBody {
    std::unique_ptr<Body> polygon; ///< its centre of mass is the origin of its frame
    double radius = 0.0;           ///< of its disk about that
    double area = 0.0;
    bmr_pose pose = bmr_pose_identity();
    bmr_vec2 velocity = {0.0, 0.0};
    double spin = 0.0;
};

/// Everything at time 0. The same choice gives the same bits.
struct WorldSetup {
    WorldChoice choice;
    bmr_vec2 low = {0.0, 0.0}, high = {0.0, 0.0}; ///< the box; of an open world: where the bodies begin
    std::vector<WorldBody> bodies;
    /// Every body gets a new plan about so often; 0: never.
    double planEvery = 0.0;
};

/// Makes the bodies of a choice. Throws WorldChoiceError where they cannot be placed so densely, or the box
/// is too small for a periodic one. O(bodies * vertices).
WorldSetup MakeWorld(const WorldChoice &choice);

/// Numbers from a seed, the same everywhere.
class Dice {
public:
    explicit Dice(uint64_t seed);
    double Uniform(double low, double high);
    size_t Index(size_t count);
    /// A unit vector.
    bmr_vec2 Direction();

private:
    uint64_t Next();
    uint64_t m_state[4];
};

class WorldFrames;

/// A kinetic world of a setup's bodies, whose numbers are their places in it. The setup must outlive it.
class WorldRun {
public:
    /// The frames, if any, get each contact, before it is answered, and each event.
    explicit WorldRun(const WorldSetup &setup, WorldFrames *frames = nullptr);
    WorldRun(const WorldRun &) = delete;
    WorldRun &operator=(const WorldRun &) = delete;

    /// Up to that time, with all changes of plan. Throws std::runtime_error where the world stops.
    void Advance(double until);

    const bmr_world *World() const { return m_world.get(); }
    double Time() const { return bmr_world_time(World()); }
    bmr_body_state StateOf(bmr_body body) const;
    bmr_world_counts Counts() const { return bmr_world_get_counts(World()); }
    bmr_world_totals Totals() const { return bmr_world_get_totals(World()); }
    bmr_world_totals TotalsAtStart() const { return m_atStart; }
    /// Sum of mass * speed at the start: what a change of momentum is held against.
    double MomentumScale() const { return m_momentumScale; }
    /// New plans that bodies got so far.
    uint64_t Plans() const { return m_given; }
    /// bmr_world_audit; throws std::runtime_error with what it says.
    void Audit() const;

private:
    struct Deleter {
        void operator()(bmr_world *world) const { bmr_world_destroy(world); }
    };
    struct Plan {
        double time;
        bmr_body body;
        bool operator<(const Plan &other) const {
            return time != other.time ? time > other.time : body > other.body;
        }
    };
    static bmr_response Answer(void *context, bmr_world *world, const bmr_contact *contact);
    static void Observe(void *context, bmr_world *world, const bmr_world_event *event);
    void AddBodies();
    void AdvancePlain(double until);
    void ChangePlan(bmr_body body);

    const WorldSetup &m_setup;
    WorldFrames *m_frames;
    std::unique_ptr<bmr_world, Deleter> m_world;
    std::priority_queue<Plan> m_plans;
    uint64_t m_given = 0; ///< of them
    Dice m_dice;
    bmr_world_totals m_atStart = {};
    double m_momentumScale = 0.0;
};

/// The deepest overlap of any two bodies at the world's present time, by asking every two whose disks meet;
/// and that of a body and a wall.
struct OverlapCheck {
    size_t pairs = 0;    ///< whose disks meet
    size_t overlaps = 0; ///< deeper than the tolerance
    double deepest = 0.0;
};
/// What rounding may do to a contact that is answered at a distance of the margin: nothing near this.
constexpr double kOverlapTolerance = 1e-7;
/// Knows nothing of the world's cells or certificates. Compares disks, O(bodies^2) pairs.
OverlapCheck CheckOverlaps(const WorldRun &run, const WorldSetup &setup);

/// Options of Measure that do not change the world.
struct MeasureOptions {
    bool check = false; ///< CheckOverlaps at the end
    bool audit = false; ///< bmr_world_audit some times in the run, and at the end
    int slices = 100;   ///< equally long parts of the run
    /// Called at the beginning and after each slice with how much is done, from 0 to 1. It is not part of
    /// what is timed.
    std::function<void(const WorldRun &, double part)> onSlice;
    WorldFrames *frames = nullptr;
};

/// What a run came to.
struct WorldFigures {
    WorldChoice choice;
    double side = 0.0; ///< of the box
    bmr_world_counts counts = {};
    uint64_t plans = 0; ///< that bodies got; beside the events, of which the plan's pieces are some
    double clock = 0.0; ///< seconds of the processor, without making the bodies
    /// Changes since the start: of energy as a share of it; of momentum, as a share of the sum of mass *
    /// speed; of angular momentum, as a share of that times the box's side. None where something takes it
    /// from outside: a plan, a wall, an answer that is not elastic.
    std::optional<double> energy, momentum, angular;
    double energyLeft = 1.0; ///< as a share of that at the start
    std::optional<OverlapCheck> check;
    size_t audits = 0;

    uint64_t Events() const;
    /// Of one kind, or of all: for each body and unit of time.
    double Rate(uint64_t events) const;
    double MicrosecondsAnEvent() const;
};

/// Runs a setup's world for the choice's time. Throws std::runtime_error where the world stops.
WorldFigures Measure(const WorldSetup &setup, const MeasureOptions &options);

const char *NameOf(bmr_boundary boundary);
/// "elastic", "restitution 0.9" or "pass".
std::string NameOf(const bmr_response &response);

/// A kinetic world as frames for pictures, one at each time that is shown. Of a frame
///   - bodies are the world's, and four static ones after them, the walls; in a periodic box they are taken
///     back into it;
///   - boxes are the cells that bodies live in;
///   - pairs are those of two bodies that the world watches. Those whose bodies are neighbours across a side
///     of a periodic box have no proof here, for nothing can be drawn between them;
///   - touching are the contacts since the frame before, at their own times;
///   - events are those of such pairs, in the words of structures (near: "start"), and "part".
class WorldFrames {
public:
    explicit WorldFrames(const WorldSetup &setup) : m_setup(setup) {}

    /// All that happens between frames, as the run reports it.
    void Add(const bmr_contact &contact);
    void Add(const bmr_world_event &event);
    shown::Frame Take(const WorldRun &run);

private:
    int NumberOf(bmr_body body) const;
    /// How often the box lies between where the world has a body and where it is shown.
    bmr_vec2 Wrapped(bmr_vec2 position) const;
    void AddBodies(const WorldRun &run);
    void AddWalls();
    void AddPair(const bmr_world_pair &pair, const WorldRun &run);
    void SetClosest(const bmr_world_pair &pair, const WorldRun &run, shown::Pair *record) const;
    bmr_pose OtherPose(const bmr_world_pair &pair, const WorldRun &run) const;
    shown::Proof DisksProof(const bmr_world_pair &pair, const WorldRun &run) const;
    shown::Proof LineProof(const bmr_world_pair &pair, const WorldRun &run) const;
    shown::Proof ProofOf(const bmr_world_pair &pair, const WorldRun &run) const;

    const WorldSetup &m_setup;
    int64_t m_step = 0;
    shown::Frame m_frame; ///< the next
};

} // namespace testbed

#endif
