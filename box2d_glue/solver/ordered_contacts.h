// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_ORDERED_CONTACTS_H
#define BOOMERANG_GLUE_ORDERED_CONTACTS_H

#include <cstdint>

#include <box2d/b2_joint.h>
#include <box2d/b2_time_step.h>

#include "base/columns.h"
#include "base/private_members.h"
#include "solver/contact_solver.h"

namespace bmr {

/// The joints of islands, one after the other: Box2D's own functions solve them.
class JointSolver {
public:
    static constexpr uint32_t kMostBytes = 256; ///< of a joint, behind what all types have

    /// Room for so many.
    void Reserve(uint32_t joints) { m_before.Reserve(kMostBytes * joints); }

    /// `joints` and the arrays of bodies stay until all is solved.
    void Begin(b2Joint *const *joints, const b2SolverData &data) {
        m_joints = joints;
        m_data = data;
    }
    b2Joint *Joint(uint32_t i) const { return m_joints[i]; }
    /// Does each read and write its own two bodies alone? (A gear has four.)
    bool HaveTwoBodies(const Island &island) const;

    /// Impulses become those of the step before, which move the bodies, or none.
    void InitializeVelocities(const Island &island);
    void SolveVelocity(uint32_t i) const { (m_joints[i]->*Named(SolveVelocityConstraints()))(m_data); }
    void SolveVelocities(const Island &island) const {
        for (uint32_t i = island.firstJoint; i < island.endJoint; ++i)
            SolveVelocity(i);
    }
    /// Are all joints solved as well as Box2D asks?
    bool SolvePositions(const Island &island) const;
    /// Joints of two bodies are again as they were ahead of InitializeVelocities.
    void PutBack(const Island &island) const;

private:
    b2Joint *const *m_joints = nullptr;
    b2SolverData m_data = {};
    Column<unsigned char> m_before; ///< kMostBytes of each
};

/// An order of several iterations over joints and contacts, up to four contacts at once, that changes no bit.
///
/// Box2D solves contacts one after the other. One reads and writes its two bodies, and waits for the one
/// before it where the two share a moving body. All others may change places, from one iteration to the next,
/// too. So each contact of each iteration has a level, one above the levels of those it waits for. The
/// contacts of a level are solved in groups of one kind.
///
/// A body without mass and inertia carries no order: it stays as it is, as long as impulses are finite and no
/// coordinate is -0.0 (CarriesNoOrder).
class OrderedContacts {
public:
    static constexpr uint32_t kLeast = 8;       ///< contacts; below this an order is not worth finding
    static constexpr uint32_t kOverlapping = 8; ///< so many iterations at most have levels in common
    static constexpr uint32_t kKinds = 3;
    static constexpr uint32_t kNone = 0xffffffffu;

    struct Place {
        uint32_t contact, kind;
        uint32_t a, b; ///< bodies that carry order, or kNone
    };
    struct Group {
        uint32_t contacts[4];
        uint8_t iterations[4];
        uint32_t next; ///< as in Level, of the same level and kind
    };

    void Reserve(uint32_t bodies, uint32_t contacts);
    void Begin() {
        m_count = 0;
        m_isKnown = true;
    }
    void Add(const Place &place) {
        Place &last = m_places[m_count];
        m_isKnown = m_isKnown && m_count < m_ordered && last.contact == place.contact &&
                    last.kind == place.kind && last.a == place.a && last.b == place.b;
        ++m_count;
        last = place;
    }
    /// Finds the order of those that were added, or keeps the last one where it is of the same contacts, as
    /// in a pile from step to step. False where Box2D's own order is as fast.
    bool Find(uint32_t bodies, uint32_t iterations);
    /// The next Find finds the order anew.
    void Forget() { m_ordered = 0; }

    /// Calls solve(group, count, kind, iterations) for each group, in order; `iterations`: to be added to the
    /// group's own. Returns how many iterations are left to Box2D's order.
    template <typename Solve> uint32_t ForEach(const Solve &solve) const {
        uint32_t done = 0;
        for (; done + m_overlapping <= m_iterations; done += m_overlapping)
            for (uint32_t level = 0; level < m_levelCount; ++level)
                for (uint32_t kind = 0; kind < kKinds; ++kind)
                    for (uint32_t at = m_levels[level].ofKinds[kind]; at != kNone; at = m_groups[at / 4].next)
                        solve(m_groups[at / 4], at % 4 + 1, kind, done);
        return m_iterations - done;
    }

private:
    /// The newest groups, the only ones that may have room: four times its number, and its last contact.
    struct Level {
        uint32_t ofKinds[kKinds];
    };
    // With so many contacts in four groups, on the average, overlapping further iterations costs what it
    // saves.
    static constexpr uint32_t kEnoughInFour = 9;

    bool FindAnew();
    void FindLevels(uint32_t iteration);

    Column<Place> m_places;
    Column<Group> m_groups;
    Column<Level> m_levels;
    Column<uint32_t> m_last; ///< of each body: the level of its last contact so far
    uint32_t m_count = 0, m_groupCount = 0, m_levelCount = 0;
    uint32_t m_ordered = 0, m_bodies = 0, m_iterations = 0; ///< of the order
    uint32_t m_overlapping = 1; ///< so many iterations have levels in common, then as many more
    bool m_isKnown = false;     ///< those added so far are those of the order
    bool m_pays = false;        ///< the order is complete, and has enough groups of several
};

/// `at`: the three coordinates of the body that its contacts write.
bool CarriesNoOrder(float invMass, float invI, const float *at);

/// The velocity iterations, with Box2D's bits: in an order of their own, four contacts at once.
class OrderedVelocities {
public:
    void Reserve(uint32_t bodies, uint32_t contacts) { m_order.Reserve(bodies, contacts); }

    /// False where Box2D's own order is needed, or as fast.
    bool Order(const VelocityConstraint *constraints, const JointSolver &joints, const Island &island,
               const b2Velocity *velocities, int32 iterations);
    /// All iterations. Returns false where a velocity became NaN: what was solved is worth nothing then.
    bool Solve(ContactSolver *solver, const JointSolver &joints, const Island &island,
               b2Velocity *velocities) const;

private:
    OrderedContacts m_order;
};

/// The position iterations of contacts alone, with Box2D's bits: in an order of their own, four at once.
///
/// Box2D ends an island's iterations with the first that finds all points apart enough. Here all iterations
/// overlap, so none may end. An island whose points were apart enough before the step mostly ends with the
/// first, and is left to Box2D's order. The others mostly use all. Where one does not, its bodies are put
/// back, and Box2D's order solves it.
class OrderedPositions {
public:
    void Reserve(uint32_t bodies, uint32_t contacts) {
        m_order.Reserve(bodies, contacts);
        m_unsolved.Reserve(contacts);
        m_before.Reserve(bodies);
    }
    /// Says which of the islands are done. The others are as they were: they need Box2D's own order, or are
    /// as fast in it.
    void Solve(ContactSolver *solver, Island *islands, uint32_t count, b2Position *positions,
               int32 iterations);

private:
    static bool IsDeep(const PositionConstraint *constraints, const Island &island);
    void Add(const PositionConstraint *constraints, const Island &island, const b2Position *positions);
    bool SolveAll(ContactSolver *solver, b2Position *positions);
    bool Settle(uint32_t iterations, bool isNumber, b2Position *positions, Island *island) const;

    OrderedContacts m_order;
    Column<uint8_t> m_unsolved; ///< of each contact: a bit for each iteration that left it too deep
    Column<b2Position> m_before;
};

} // namespace bmr

#endif
