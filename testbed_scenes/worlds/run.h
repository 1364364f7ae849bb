// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_WORLD_RUN_H
#define BOOMERANG_TESTBED_WORLD_RUN_H

#include <functional>
#include <memory>
#include <queue>
#include <stdexcept>

#include "worlds/setup.h"

namespace testbed {

/// The world stopped: what core says, and when.
class WorldStopped : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A kinetic world of a setup's bodies, whose numbers are their places in it. The setup must outlive it.
class WorldRun {
public:
    using ContactHandler = std::function<void(const bmr_contact &)>;
    using EventHandler = std::function<void(const bmr_world_event &)>;

    /// The handlers may be empty. `onContact` is told of each contact before it is answered.
    explicit WorldRun(const WorldSetup &setup, ContactHandler onContact = {}, EventHandler onEvent = {});
    WorldRun(const WorldRun &) = delete;
    WorldRun &operator=(const WorldRun &) = delete;

    /// Up to that time, with all changes of plan. Throws WorldStopped.
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
    /// bmr_world_audit; throws WorldStopped with what it says.
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
    ContactHandler m_onContact;
    EventHandler m_onEvent;
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
/// Knows nothing of the world's cells or certificates. O(bodies^2) looks at disks.
OverlapCheck CheckOverlaps(const WorldRun &run, const WorldSetup &setup);

} // namespace testbed

#endif
