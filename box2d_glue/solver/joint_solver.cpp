// SPDX-License-Identifier: MIT
#include "solver/joint_solver.h"

#include <algorithm>
#include <cstring>
#include <iterator>

#include <box2d/box2d.h>

namespace bmr {

namespace {

/// Bytes that a joint of two bodies has of its own.
template <typename Joint> constexpr std::size_t kOf = sizeof(Joint) - sizeof(b2Joint);
/// By b2JointType.
constexpr std::size_t kSizes[] = {0,
                                  kOf<b2RevoluteJoint>,
                                  kOf<b2PrismaticJoint>,
                                  kOf<b2DistanceJoint>,
                                  kOf<b2PulleyJoint>,
                                  kOf<b2MouseJoint>,
                                  0,
                                  kOf<b2WheelJoint>,
                                  kOf<b2WeldJoint>,
                                  kOf<b2FrictionJoint>,
                                  0,
                                  kOf<b2MotorJoint>};
static_assert(std::size(kSizes) == e_motorJoint + 1);
static_assert(*std::max_element(std::begin(kSizes), std::end(kSizes)) <= JointSolver::kMostBytes);

} // namespace

bool JointSolver::HaveTwoBodies(const Island &island) const {
    for (uint32_t i = island.firstJoint; i < island.endJoint; ++i)
        if (kSizes[m_joints[i]->GetType()] == 0)
            return false;
    return true;
}

void JointSolver::InitializeVelocities(const Island &island) {
    for (uint32_t i = island.firstJoint; i < island.endJoint; ++i) {
        std::memcpy(&m_before[kMostBytes * i], static_cast<const void *>(m_joints[i] + 1),
                    kSizes[m_joints[i]->GetType()]);
        (m_joints[i]->*Named(InitVelocityConstraints()))(m_data);
    }
}

bool JointSolver::SolvePositions(const Island &island) const {
    bool solved = true;
    for (uint32_t i = island.firstJoint; i < island.endJoint; ++i) {
        const bool isSolved = (m_joints[i]->*Named(SolvePositionConstraints()))(m_data);
        solved = solved && isSolved;
    }
    return solved;
}

void JointSolver::PutBack(const Island &island) const {
    for (uint32_t i = island.firstJoint; i < island.endJoint; ++i)
        std::memcpy(static_cast<void *>(m_joints[i] + 1), &m_before[kMostBytes * i],
                    kSizes[m_joints[i]->GetType()]);
}

} // namespace bmr
