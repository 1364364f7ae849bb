// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_ORDERED_VELOCITIES_H
#define BOOMERANG_GLUE_ORDERED_VELOCITIES_H

#include <cstdint>

#include "base/column.h"
#include "exact32/float4.h"
#include "passes/contact_solver.h"

namespace bmr {

/// The velocity iterations of an island of contacts alone, with Box2D's bits, in an order that a processor
/// runs faster.
///
/// Box2D solves contacts one after the other. One reads and writes the velocities of its two bodies, and
/// waits for the one before it where the two share a moving body. All others may change places without
/// changing a bit, from one iteration to the next, too. So each contact of each iteration has a level, one
/// above the levels of those it waits for, and contacts are solved level by level: neighbours wait for each
/// other rarely. (Half of a contact's time is spent waiting for its own results.)
///
/// A body that nothing moves carries no order: its velocity is zero and stays so, as long as impulses are
/// finite. Each of its contacts has a copy of it; where one is not zero in the end, nothing has been written.
class OrderedVelocities {
public:
    /// Below this an order is not worth finding.
    static constexpr uint32_t kLeast = 8;

    bool Reserve(uint32_t bodies, uint32_t contacts);

    /// Solves so many iterations: writes the impulses of `constraints`, and the velocities. Returns false,
    /// and has written nothing, where Box2D's own order is needed. Each constraint of two points is a block.
    bool Solve(VelocityConstraint *constraints, uint32_t count, int32 iterations, b2Velocity *velocities,
               uint32_t bodyCount);

private:
    static constexpr uint32_t kOverlapping = 8; ///< so many iterations have one order

    bool Pack(const VelocityConstraint *constraints, uint32_t count, const b2Velocity *velocities,
              uint32_t bodyCount);
    void FindOrder(uint32_t count, uint32_t iterations);
    bool AreCopiesZero(uint32_t bodyCount) const;

    struct Slots {
        uint32_t a, b;
    };
    struct Velocity {
        float x, y, w, alsoW;
    };
    struct alignas(16) Record {
        float arms[2][4];    ///< of each point: -rA.y rA.x -rB.y rB.x
        float invMass[4];    ///< A A B B
        float invI[4];       ///< A A B B
        float k[4], mass[4]; ///< K and its inverse, by columns
        float normal[2];
        float normalImpulse[2], tangentImpulse[2];
        float normalMass[2], tangentMass[2], bias[2];
        float friction, tangentSpeed;
        Slots slots;
        int32 pointCount;
    };

    struct Lanes;
    static void Solve(Record *record, Velocity *velocities);
    static void SolveFriction(float4 normal, float4 arms, int32 i, Record *record, Lanes *two);
    static void SolveOnePoint(float4 normal, float4 arms, Record *record, Lanes *two);
    static void SolveTwoPoints(float4 normal, float4 first, float4 second, Record *record, Lanes *two);
    static bool SolveOneOfTwo(const Record &record, float4 wanted, float4 *impulses);

    Column<Record> m_records;
    Column<Velocity> m_velocities; ///< of the bodies, then of the copies
    Column<uint32_t> m_last;       ///< of each of these: the level of its last contact so far
    Column<uint32_t> m_levels;     ///< of each contact in each iteration
    Column<uint32_t> m_starts;     ///< of each level in the order
    Column<uint32_t> m_order;      ///< records
    uint32_t m_count = 0, m_slotCount = 0, m_orderCount = 0;
    uint32_t m_orderedIterations = 0; ///< of the records' slots the order is known for so many; 0: for none
};

} // namespace bmr

#endif
