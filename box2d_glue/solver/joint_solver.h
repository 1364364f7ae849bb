// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_JOINT_SOLVER_H
#define BOOMERANG_GLUE_JOINT_SOLVER_H

#include <cstdint>

#include <box2d/b2_joint.h>
#include <box2d/b2_time_step.h>

#include "base/column.h"
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

} // namespace bmr

#endif
