// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_ORDERED_VELOCITIES_H
#define BOOMERANG_GLUE_ORDERED_VELOCITIES_H

#include <cstdint>

#include "passes/contact_solver.h"
#include "passes/joint_solver.h"
#include "passes/ordered_contacts.h"

namespace bmr {

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

} // namespace bmr

#endif
