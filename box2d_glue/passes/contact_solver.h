// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONTACT_SOLVER_H
#define BOOMERANG_GLUE_CONTACT_SOLVER_H

#include <cstdint>

#include <box2d/b2_collision.h>
#include <box2d/b2_math.h>
#include <box2d/b2_time_step.h>

#include "ledger/column.h"

class b2Contact;
struct b2ContactImpulse;

namespace bmr {

/// What the two bodies of a contact bring to it, A first.
struct ContactBodies {
    int32 indexA, indexB; ///< their places in the island
    float invMassA, invMassB;
    float invIA, invIB;
};

struct VelocityPoint {
    b2Vec2 rA, rB; ///< from the centres of mass
    float normalImpulse, tangentImpulse;
    float normalMass, tangentMass;
    float velocityBias;
};

struct VelocityConstraint {
    VelocityPoint points[b2_maxManifoldPoints];
    b2Vec2 normal;
    b2Mat22 K, normalMass;
    ContactBodies bodies;
    float friction, restitution, threshold, tangentSpeed;
    int32 pointCount; ///< 1 also where two points are too near each other for a block of two
};

struct PositionConstraint {
    ContactBodies bodies;
    b2Vec2 localCenterA, localCenterB;
    b2Vec2 localNormal, localPoint, localPoints[b2_maxManifoldPoints];
    float radiusA, radiusB;
    b2Manifold::Type type;
    int32 pointCount;
};

/// The contacts of one island, one after the other, with the bits of Box2D's b2ContactSolver.
class ContactSolver {
public:
    /// Room for so many contacts. False without memory, and nothing has changed.
    bool Reserve(uint32_t contacts);

    /// Reads the contacts and their bodies. `contacts` and the arrays of bodies stay until the island is
    /// solved.
    void Begin(const b2TimeStep &step, b2Contact *const *contacts, uint32_t count, b2Position *positions,
               b2Velocity *velocities);
    void InitializeVelocities();
    void WarmStart();
    void SolveVelocities();
    void StoreImpulses() const;
    /// Are all contacts solved as well as Box2D asks?
    bool SolvePositions();
    /// The same after an impact of the bodies 0 and 1: no other body is moved.
    bool SolveToiPositions();

    void GetImpulse(uint32_t i, b2ContactImpulse *impulse) const;

private:
    void Solve(VelocityConstraint *constraint) const;
    /// Moves the two bodies. `least`: the smallest separation of a point so far.
    void Solve(const PositionConstraint &constraint, float baumgarte, const ContactBodies &bodies,
               float *least) const;

    Column<VelocityConstraint> m_velocityConstraints;
    Column<PositionConstraint> m_positionConstraints;
    b2Contact *const *m_contacts = nullptr;
    uint32_t m_count = 0;
    b2Position *m_positions = nullptr;
    b2Velocity *m_velocities = nullptr;
    bool m_solvesBlocks = true; ///< g_blockSolve
};

} // namespace bmr

#endif
