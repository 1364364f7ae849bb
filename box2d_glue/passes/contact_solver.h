// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONTACT_SOLVER_H
#define BOOMERANG_GLUE_CONTACT_SOLVER_H

#include <cstdint>
#include <cstring>

#include <box2d/b2_collision.h>
#include <box2d/b2_math.h>
#include <box2d/b2_time_step.h>

#include "base/column.h"

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

/// OrderedVelocities reads rows of four floats from it.
struct VelocityConstraint {
    VelocityPoint points[b2_maxManifoldPoints];
    b2Vec2 normal;
    float friction, tangentSpeed;
    b2Mat22 K, normalMass;
    ContactBodies bodies;
    float restitution, threshold;
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

/// Sines and cosines of the angles of an island's bodies: computed once for as long as an angle has the same
/// bits. (A contact that is not corrected does not turn its bodies, and statics never turn.)
class Rotations {
public:
    bool Reserve(uint32_t bodies) { return m_known.Reserve(bodies); }
    void Begin(const b2Position *positions, uint32_t bodies);
    const b2Rot &Of(int32 body, float angle) {
        Known &known = m_known[static_cast<uint32_t>(body)];
        uint32_t bits;
        std::memcpy(&bits, &angle, sizeof bits);
        if (bits != known.bits)
            Compute(angle, &known);
        return known.rotation;
    }

private:
    struct Known {
        uint32_t bits; ///< of the angle
        b2Rot rotation;
    };
    static void Compute(float angle, Known *known);
    Column<Known> m_known;
};

/// The contacts of one island, one after the other, with the bits of Box2D's b2ContactSolver.
class ContactSolver {
public:
    /// Room for so many. False without memory, and nothing has changed.
    bool Reserve(uint32_t bodies, uint32_t contacts);

    /// Reads the contacts and their bodies. `contacts` and the arrays of bodies stay until the island is
    /// solved.
    void Begin(const b2TimeStep &step, b2Contact *const *contacts, uint32_t count, const b2SolverData &bodies,
               uint32_t bodyCount);
    void InitializeVelocities();
    void WarmStart();
    void SolveVelocities();
    void SolveVelocity(uint32_t i) { Solve(&m_velocityConstraints[i]); }
    bool SolvesBlocks() const { return m_solvesBlocks; }
    VelocityConstraint *VelocityConstraints() { return m_velocityConstraints.Data(); }
    void StoreImpulses() const;
    /// Are all contacts solved as well as Box2D asks?
    bool SolvePositions();
    /// The same after an impact of the bodies 0 and 1: no other body is moved.
    bool SolveToiPositions();

    /// Where the body is, now that it is solved.
    b2Transform PoseOf(int32 body, const b2Vec2 &localCenter) {
        return PoseOf(body, m_positions[body], localCenter);
    }
    void GetImpulse(uint32_t i, b2ContactImpulse *impulse) const;

private:
    void Solve(VelocityConstraint *constraint) const;
    /// Moves the two bodies. `least`: the smallest separation of a point so far.
    void Solve(const PositionConstraint &constraint, float baumgarte, const ContactBodies &bodies,
               float *least);
    b2Transform PoseOf(int32 body, const b2Position &position, const b2Vec2 &localCenter) {
        b2Transform pose;
        pose.q = m_rotations.Of(body, position.a);
        pose.p = position.c - b2Mul(pose.q, localCenter);
        return pose;
    }

    Column<VelocityConstraint> m_velocityConstraints;
    Column<PositionConstraint> m_positionConstraints;
    Rotations m_rotations;
    b2Contact *const *m_contacts = nullptr;
    uint32_t m_count = 0;
    b2Position *m_positions = nullptr;
    b2Velocity *m_velocities = nullptr;
    bool m_solvesBlocks = true; ///< g_blockSolve
};

} // namespace bmr

#endif
