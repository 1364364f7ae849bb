// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_ORDERED_POSITIONS_H
#define BOOMERANG_GLUE_ORDERED_POSITIONS_H

#include <cstdint>

#include <box2d/b2_time_step.h>

#include "base/column.h"
#include "passes/contact_solver.h"
#include "passes/ordered_contacts.h"

namespace bmr {

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
