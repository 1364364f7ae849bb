// SPDX-License-Identifier: MIT
// b2Island::SolveTOI: the island of an impact.
#include "passes/island_solver.h"

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "base/private_members.h"
#include "start/box2d_asserts.h"

namespace bmr {

void IslandSolver::SolveToi() {
    const int32 first = m_bodies[0]->*Named(IslandIndex()), second = m_bodies[1]->*Named(IslandIndex());
    BMR_BOX2D_ASSERTS(first < static_cast<int32>(m_bodyCount), "toiIndexA < m_bodyCount");
    BMR_BOX2D_ASSERTS(second < static_cast<int32>(m_bodyCount), "toiIndexB < m_bodyCount");
    if (!AreAllHere(first, second))
        return Clear();
    const Island island = {0, m_bodyCount, 0, m_contactCount, 0, 0, false, false};
    for (uint32_t i = 0; i < m_bodyCount; ++i) {
        const b2Body &body = *m_bodies[i];
        m_positions[i] = {SweepOf(body).c, SweepOf(body).a};
        m_velocities[i] = {body.GetLinearVelocity(), body.GetAngularVelocity()};
    }
    m_solver.Begin(m_step, m_contacts.Data(), Data());
    m_solver.Read(island);
    m_solver.PlaceBodies(island);
    for (int32 i = 0; i < m_step.positionIterations; ++i)
        if (m_solver.SolveToiPositions(island, first, second))
            break;
    // The sweeps of the two that meet go on from here.
    for (const uint32_t i : {static_cast<uint32_t>(first), static_cast<uint32_t>(second)}) {
        b2Sweep &sweep = m_bodies[i]->*Named(SweepMember());
        sweep.c0 = m_positions[i].c;
        sweep.a0 = m_positions[i].a;
    }
    m_solver.InitializeVelocities(island);
    for (int32 i = 0; i < m_step.velocityIterations; ++i)
        m_solver.SolveVelocities(island);
    IntegratePositions(island);
    StoreBodies(island);
    Report(island);
    Clear();
}

/// Has the island's room a place for each body of its contacts? A step inside this one may have numbered them
/// anew; Box2D then reads memory that it has not written for this island.
bool IslandSolver::AreAllHere(int32 first, int32 second) const {
    const auto isHere = [this](int32 place) { return static_cast<uint32_t>(place) < m_mostBodies; };
    for (uint32_t i = 0; i < m_contactCount; ++i)
        if (!isHere(m_contacts[i]->GetFixtureA()->GetBody()->*Named(IslandIndex())) ||
            !isHere(m_contacts[i]->GetFixtureB()->GetBody()->*Named(IslandIndex())))
            return false;
    return static_cast<uint32_t>(b2Max(first, second)) < m_bodyCount;
}

} // namespace bmr
