// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_ORDERED_VELOCITIES_H
#define BOOMERANG_GLUE_ORDERED_VELOCITIES_H

#include <cstdint>

#include "base/column.h"
#include "passes/contact_solver.h"

namespace bmr {

/// The velocity iterations of an island of contacts alone, with Box2D's bits: up to four contacts at once.
///
/// Box2D solves contacts one after the other. One reads and writes the velocities of its two bodies, and
/// waits for the one before it where the two share a moving body. All others may change places without
/// changing a bit, from one iteration to the next, too. So each contact of each iteration has a level, one
/// above the levels of those it waits for. The contacts of a level are solved in groups.
///
/// A body without mass and inertia carries no order: its velocity stays, as long as impulses are finite and
/// no coordinate is -0.0.
class OrderedVelocities {
public:
    /// Below this an order is not worth finding.
    static constexpr uint32_t kLeast = 8;

    bool Reserve(uint32_t bodies, uint32_t contacts);

    /// Finds the order, or keeps the last one where the same contacts follow each other, as in a pile from
    /// step to step. Returns false where Box2D's own order is needed, or as fast.
    bool Order(const VelocityConstraint *constraints, uint32_t count, const b2Velocity *velocities,
               uint32_t bodyCount, int32 iterations);
    /// All iterations. Returns false where a velocity became NaN: what was solved is worth nothing then.
    bool Solve(ContactSolver *solver, b2Velocity *velocities);

private:
    static constexpr uint32_t kOverlapping = 8; ///< so many iterations at most have one order
    static constexpr uint32_t kNone = 0xffffffffu;

    struct Place {
        uint32_t a, b; ///< bodies that carry order, or kNone
        int32 pointCount;
    };
    struct Group {
        uint32_t contacts[4];
        uint32_t count;
        uint32_t next; ///< of the same level and point count
    };
    /// The newest groups, the only ones that may have room.
    struct Level {
        uint32_t ofPoints[b2_maxManifoldPoints];
    };

    bool FindOrder();
    void Put(uint32_t contact, int32 pointCount, Level *level);

    Column<Place> m_places;
    Column<Group> m_groups;
    Column<Level> m_levels;
    Column<uint32_t> m_last; ///< of each body: the level of its last contact so far
    uint32_t m_count = 0, m_bodyCount = 0, m_groupCount = 0, m_levelCount = 0;
    uint32_t m_iterations = 0; ///< of the order
    uint32_t m_rounds = 0;     ///< so often the order is gone through
    uint32_t m_left = 0;       ///< iterations behind the last round
    bool m_pays = false;       ///< the order is complete, and has enough groups of several
};

} // namespace bmr

#endif
