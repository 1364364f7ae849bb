// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_ISLAND_SOLVER_H
#define BOOMERANG_GLUE_ISLAND_SOLVER_H

#include <cstdint>

#include <box2d/b2_time_step.h>
#include <box2d/b2_timer.h>

#include "base/columns.h"
#include "base/memory.h"
#include "base/private_members.h"
#include "solver/contact_solver.h"
#include "solver/ordered_contacts.h"

class b2Body;
class b2Contact;
class b2ContactListener;
class b2Joint;

namespace bmr {

/// Where a pass writes down what it builds islands from. Kept from step to step with the solver.
struct IslandScratch {
    /// A contact that touches, in the list of one of its bodies.
    struct Link {
        b2Contact *contact;
        const b2Body *body;
        b2Body *other;
        uint32_t next;
        int32 place; ///< of the body in its last island
    };
    Column<b2Body *> stack;    ///< bodies of an island that are to be taken
    Column<uint32_t> touching; ///< numbers of contacts
    Column<Link> links;
    Column<b2Contact *> toiCandidates; ///< glue/impacts.h
};

/// Solves islands with the bits of Box2D's b2Island.
///
/// A step takes the thread's. A pass begins. It then adds an island's bodies, contacts and
/// joints in Box2D's order, and solves it; Solve and SolveToi leave the island empty for the next one.
///
///     Begin(step, listener)
///         Add(body) Add(contact) Add(joint) ... Solve(gravity, allowSleep)      once for each island
///     Finish(profile)
class IslandSolver {
public:
    /// This thread's only one; nullptr as the thread ends.
    static IslandSolver *OfThread() { return PerThread<IslandSolver>(); }
    bool isTaken = false; ///< by a step

    /// Begins a pass. `listener` gets PostSolve, unless it is nullptr. `mayWait`: islands may be solved
    /// together with others, and PostSolve called behind them.
    void Begin(const b2TimeStep &step, b2ContactListener *listener, bool mayWait);

    /// Writes the body's m_islandIndex: its place among those that are solved together. Once they are solved
    /// it is the place in Box2D's island.
    void Add(b2Body *body) {
        body->*Named(IslandIndex()) = static_cast<int32>(m_bodyCount);
        m_bodies.Reserve(m_bodyCount + 1);
        m_bodies[m_bodyCount++] = body;
    }
    void Add(b2Contact *contact) {
        m_contacts.Reserve(m_contactCount + 1);
        m_contacts[m_contactCount++] = contact;
    }
    void Add(b2Joint *joint) {
        m_joints.Reserve(m_jointCount + 1);
        m_jointSolver.Reserve(m_jointCount + 1);
        m_joints[m_jointCount++] = joint;
    }
    uint32_t BodyCount() const { return m_bodyCount - m_waiting.endBody; }
    uint32_t ContactCount() const { return m_contactCount - m_waiting.endContact; }
    uint32_t JointCount() const { return m_jointCount - m_waiting.endJoint; }
    b2Body *Body(uint32_t i) const { return m_bodies[m_waiting.endBody + i]; }
    b2Contact *Contact(uint32_t i) const { return m_contacts[m_waiting.endContact + i]; }
    IslandScratch &Scratch() { return m_scratch; }

    /// b2Island::Solve. If Begin allows it, the island may wait to be solved together with others, as late
    /// as in Finish: they share no body that moves.
    void Solve(const b2Vec2 &gravity, bool allowSleep);
    /// b2Island::SolveTOI, by the step that Begin was given. The first two bodies are those that meet. A body
    /// may be in the island twice, where a listener stepped the world while the island grew. Its
    /// m_islandIndex then says which of its places counts.
    void SolveToi();

    /// Ends a pass. Adds what its parts took to the profile, if there is one: solveInit, solveVelocity and
    /// solvePosition.
    void Finish(b2Profile *profile);

private:
    void Clear();
    /// Bodies, or contacts and joints.
    uint32_t Most() const { return b2Max(m_bodyCount, m_contactCount + m_jointCount); }
    void Reserve();
    b2SolverData Data() { return {m_step, m_positions.Data(), m_velocities.Data()}; }
    bool IsWhole(const Island &island) const;
    bool MayWait(const Island &island) const;
    void SolveWaiting();
    bool SolveTogether(Island *islands, uint32_t count);
    void IntegrateVelocities(const Island &island);
    void IntegratePositions(const Island &island);
    void Prepare(const Island &island);
    void SolveVelocities(const Island &island);
    void SolvePositions(Island *islands, uint32_t count);
    bool SolvePositions(const Island &island);
    void StoreBodies(const Island &island);
    void StorePlaces(const Island &island);
    void Report(const Island &island);
    void Sleep(const Island &island);

    IslandScratch m_scratch;
    Column<b2Body *> m_bodies;
    Column<b2Contact *> m_contacts;
    Column<b2Joint *> m_joints;
    Column<b2Position> m_positions;
    Column<b2Velocity> m_velocities;
    ContactSolver m_solver;
    JointSolver m_jointSolver;
    OrderedVelocities m_orderedVelocities;
    OrderedPositions m_orderedPositions;
    Column<Island> m_islands; ///< those that wait
    uint32_t m_islandCount = 0;
    Island m_waiting = {}; ///< all of them
    uint32_t m_bodyCount = 0, m_contactCount = 0, m_jointCount = 0;
    uint32_t m_reserved = 0; ///< Most may be this
    b2Vec2 m_gravity = {0.0f, 0.0f};
    bool m_allowSleep = false;
    bool m_mayReorder = false, m_mayWait = false; ///< in this pass
    b2TimeStep m_step = {};
    b2ContactListener *m_listener = nullptr;
    b2Profile m_profile = {};
    b2Timer m_timer; ///< of islands that are solved together
};

} // namespace bmr

#endif
