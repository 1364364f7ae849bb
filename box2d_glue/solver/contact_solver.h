// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONTACT_SOLVER_H
#define BOOMERANG_GLUE_CONTACT_SOLVER_H

#include <cstdint>
#include <cstring>

#include <box2d/b2_collision.h>
#include <box2d/b2_math.h>
#include <box2d/b2_time_step.h>

#include "base/columns.h"

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

/// OrderedPositions reads rows of four floats from it.
struct PositionConstraint {
    b2Vec2 localNormal, localPoint, localPoints[b2_maxManifoldPoints];
    b2Vec2 localCenterA, localCenterB;
    float radiusA, radiusB;
    float side;       ///< -1: the face is B's
    float separation; ///< the smallest of a point of a face, or NaN; before the step
    ContactBodies bodies;
    b2Manifold::Type type;
    int32 pointCount;
};

/// Bodies, contacts and joints of one island, or of several that follow each other.
struct Island {
    uint32_t firstBody, endBody, firstContact, endContact, firstJoint, endJoint;
    bool isDone, isSolved; ///< its position iterations: all are done; the last one was enough
};

/// Is a coordinate of one of the bodies NaN? `coordinates`: three of each, as b2Position and b2Velocity have.
inline bool HasNan(const float *coordinates, const Island &island) {
    bool hasNan = false;
    for (uint32_t i = 3 * island.firstBody; i < 3 * island.endBody; ++i)
        hasNan = hasNan || coordinates[i] != coordinates[i];
    return hasNan;
}

/// Sines and cosines of the angles of an island's bodies: computed once for as long as an angle has the same
/// bits. (A contact that is not corrected does not turn its bodies, and statics never turn.)
class Rotations {
public:
    void Reserve(uint32_t bodies) { m_known.Reserve(bodies); }
    void Begin(const b2Position *positions, uint32_t first, uint32_t end) {
        for (uint32_t i = first; i < end; ++i)
            Compute(positions[i].a, &m_known[i]);
    }
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
    static void Compute(float angle, Known *known) {
        std::memcpy(&known->bits, &angle, sizeof known->bits);
        known->rotation.Set(angle);
    }
    Column<Known> m_known;
};

/// The contacts of islands, one after the other, with the bits of Box2D's b2ContactSolver.
class ContactSolver {
public:
    /// An island is solved once no point is deeper.
    static constexpr float kLeastSeparation = -3.0f * b2_linearSlop;

    /// Room for so many.
    void Reserve(uint32_t bodies, uint32_t contacts);

    /// `contacts` and the arrays of bodies stay until all is solved.
    void Begin(const b2TimeStep &step, b2Contact *const *contacts, const b2SolverData &bodies);
    /// Reads what does not depend on where the bodies are. (A static body has a place in each island.)
    void Read(const Island &island);
    /// Once bodies are where the iterations begin.
    void PlaceBodies(const Island &island) {
        m_rotations.Begin(m_positions, island.firstBody, island.endBody);
    }
    /// Impulses become those of the step before, or none.
    void InitializeVelocities(const Island &island);
    void WarmStart(const Island &island);
    void SolveVelocities(const Island &island);
    void SolveVelocity(uint32_t i) { Solve(&m_velocityConstraints[i]); }
    bool SolvesBlocks() const { return m_solvesBlocks; }
    const PositionConstraint *PositionConstraints() const { return m_positionConstraints.Data(); }
    Rotations &GetRotations() { return m_rotations; }
    VelocityConstraint *VelocityConstraints() { return m_velocityConstraints.Data(); }
    void StoreImpulses(const Island &island) const;
    /// Are all contacts solved as well as Box2D asks?
    bool SolvePositions(const Island &island);
    /// One of them. Returns its smallest separation, or 0 if that is less.
    float SolvePosition(uint32_t i) {
        const PositionConstraint &constraint = m_positionConstraints[i];
        float least = 0.0f;
        Solve(constraint, b2_baumgarte, constraint.bodies, &least);
        return least;
    }
    /// The same after an impact of the bodies `first` and `second`: no other body is moved.
    bool SolveToiPositions(const Island &island, int32 first, int32 second);

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
    bool m_warmStarts = false;
    float m_dtRatio = 0.0f;
    b2Position *m_positions = nullptr;
    b2Velocity *m_velocities = nullptr;
    bool m_solvesBlocks = true; ///< g_blockSolve
};

} // namespace bmr

#endif
