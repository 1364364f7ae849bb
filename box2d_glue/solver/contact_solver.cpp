// SPDX-License-Identifier: MIT
// Box2D's order of operations, which is the contract: each sum, product and comparison stands as it stands
// there, and each sign where it has it. (-(p + q) is not (-p) + (-q); -x of a zero is another zero.)
#include "solver/contact_solver.h"

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_shape.h>
#include <box2d/b2_world_callbacks.h>

#include "base/private_members.h"

/// Box2D's switch, which no header of its declares: are the two points of a contact solved together?
extern B2_API bool g_blockSolve;

namespace bmr {

namespace {

/// The normal from A to B, and the points half way between the two surfaces: b2WorldManifold.
struct WorldPoints {
    b2Vec2 normal, points[b2_maxManifoldPoints];
    float separation = b2_maxFloat; ///< the smallest of a face's, or NaN

    WorldPoints(const PositionConstraint &c, const b2Transform &poseA, const b2Transform &poseB) {
        if (c.type == b2Manifold::e_circles) {
            OfCircles(c, b2Mul(poseA, c.localPoint), b2Mul(poseB, c.localPoints[0]));
        } else if (c.type == b2Manifold::e_faceA) {
            OfFace(c, poseA, c.radiusA, poseB, c.radiusB);
        } else {
            OfFace(c, poseB, c.radiusB, poseA, c.radiusA);
            normal = -normal;
        }
    }

private:
    void OfCircles(const PositionConstraint &c, const b2Vec2 &centerA, const b2Vec2 &centerB) {
        normal.Set(1.0f, 0.0f);
        if (b2DistanceSquared(centerA, centerB) > b2_epsilon * b2_epsilon) {
            normal = centerB - centerA;
            normal.Normalize();
        }
        const b2Vec2 onA = centerA + c.radiusA * normal, onB = centerB - c.radiusB * normal;
        points[0] = 0.5f * (onA + onB);
    }
    void OfFace(const PositionConstraint &c, const b2Transform &face, float faceRadius,
                const b2Transform &incident, float radius) {
        normal = b2Mul(face.q, c.localNormal);
        const b2Vec2 plane = b2Mul(face, c.localPoint);
        for (int32 i = 0; i < c.pointCount; ++i) {
            const b2Vec2 clip = b2Mul(incident, c.localPoints[i]);
            const float along = b2Dot(clip - plane, normal);
            const float apart = along - c.radiusA - c.radiusB;
            if (apart < separation || apart != apart)
                separation = apart;
            const b2Vec2 onFace = clip + (faceRadius - along) * normal;
            const b2Vec2 onOther = clip - radius * normal;
            points[i] = 0.5f * (onFace + onOther); // the sum of two is the same in either order
        }
    }
};

/// One point of a contact as the position solver sees it.
struct PositionPoint {
    b2Vec2 normal, point;
    float separation;

    PositionPoint(const PositionConstraint &c, const b2Transform &poseA, const b2Transform &poseB, int32 i) {
        if (c.type == b2Manifold::e_circles) {
            const b2Vec2 centerA = b2Mul(poseA, c.localPoint), centerB = b2Mul(poseB, c.localPoints[0]);
            normal = centerB - centerA;
            normal.Normalize();
            point = 0.5f * (centerA + centerB);
            separation = b2Dot(centerB - centerA, normal) - c.radiusA - c.radiusB;
            return;
        }
        const bool isFaceA = c.type == b2Manifold::e_faceA;
        const b2Transform &face = isFaceA ? poseA : poseB, &incident = isFaceA ? poseB : poseA;
        normal = b2Mul(face.q, c.localNormal);
        point = b2Mul(incident, c.localPoints[i]);
        separation = b2Dot(point - b2Mul(face, c.localPoint), normal) - c.radiusA - c.radiusB;
        if (!isFaceA)
            normal = -normal;
    }
};

/// The velocities of a contact's two bodies while it is solved.
struct TwoBodies {
    b2Vec2 vA, vB;
    float wA, wB;

    /// Of B against A, at a point.
    b2Vec2 Relative(const VelocityPoint &at) const {
        return vB + b2Cross(wB, at.rB) - vA - b2Cross(wA, at.rA);
    }
    void Apply(const ContactBodies &bodies, const VelocityPoint &at, const b2Vec2 &impulse) {
        vA -= bodies.invMassA * impulse;
        wA -= bodies.invIA * b2Cross(at.rA, impulse);
        vB += bodies.invMassB * impulse;
        wB += bodies.invIB * b2Cross(at.rB, impulse);
    }
};

void SolveFriction(VelocityConstraint *constraint, TwoBodies *pair) {
    const b2Vec2 tangent = b2Cross(constraint->normal, 1.0f);
    for (int32 i = 0; i < constraint->pointCount; ++i) {
        VelocityPoint &at = constraint->points[i];
        const float speed = b2Dot(pair->Relative(at), tangent) - constraint->tangentSpeed;
        const float wanted = at.tangentImpulse + at.tangentMass * (-speed);
        const float most = constraint->friction * at.normalImpulse;
        const float impulse = b2Clamp(wanted, -most, most);
        const float more = impulse - at.tangentImpulse;
        at.tangentImpulse = impulse;
        pair->Apply(constraint->bodies, at, more * tangent);
    }
}

void SolveEachPoint(VelocityConstraint *constraint, TwoBodies *pair) {
    for (int32 i = 0; i < constraint->pointCount; ++i) {
        VelocityPoint &at = constraint->points[i];
        const float speed = b2Dot(pair->Relative(at), constraint->normal);
        const float more = -at.normalMass * (speed - at.velocityBias);
        const float impulse = b2Max(at.normalImpulse + more, 0.0f);
        const float applied = impulse - at.normalImpulse;
        at.normalImpulse = impulse;
        pair->Apply(constraint->bodies, at, applied * constraint->normal);
    }
}

/// The impulses of two points that leave both with the velocity they are to have, or one with none: the first
/// of four cases that holds. False where none does.
bool SolveBlock(const VelocityConstraint &constraint, const b2Vec2 &b, b2Vec2 *impulses) {
    const VelocityPoint &first = constraint.points[0], &second = constraint.points[1];
    const b2Vec2 both = -b2Mul(constraint.normalMass, b);
    if (both.x >= 0.0f && both.y >= 0.0f) {
        *impulses = both;
        return true;
    }
    const float firstAlone = -first.normalMass * b.x;
    if (firstAlone >= 0.0f && constraint.K.ex.y * firstAlone + b.y >= 0.0f) {
        impulses->Set(firstAlone, 0.0f);
        return true;
    }
    const float secondAlone = -second.normalMass * b.y;
    if (secondAlone >= 0.0f && constraint.K.ey.x * secondAlone + b.x >= 0.0f) {
        impulses->Set(0.0f, secondAlone);
        return true;
    }
    impulses->SetZero();
    return b.x >= 0.0f && b.y >= 0.0f;
}

void SolveTwoPoints(VelocityConstraint *constraint, TwoBodies *pair) {
    VelocityPoint &first = constraint->points[0], &second = constraint->points[1];
    const b2Vec2 &normal = constraint->normal;
    const b2Vec2 before(first.normalImpulse, second.normalImpulse);
    b2Vec2 b(b2Dot(pair->Relative(first), normal) - first.velocityBias,
             b2Dot(pair->Relative(second), normal) - second.velocityBias);
    b -= b2Mul(constraint->K, before);
    b2Vec2 impulses;
    if (!SolveBlock(*constraint, b, &impulses))
        return;
    const b2Vec2 more = impulses - before;
    const b2Vec2 p = more.x * normal, q = more.y * normal;
    const ContactBodies &bodies = constraint->bodies;
    pair->vA -= bodies.invMassA * (p + q);
    pair->wA -= bodies.invIA * (b2Cross(first.rA, p) + b2Cross(second.rA, q));
    pair->vB += bodies.invMassB * (p + q);
    pair->wB += bodies.invIB * (b2Cross(first.rB, p) + b2Cross(second.rB, q));
    first.normalImpulse = impulses.x;
    second.normalImpulse = impulses.y;
}

/// How hard the two bodies are to move apart at two places of theirs, along two directions; or at one place.
float Stiffness(const ContactBodies &bodies, float rA, float sA, float rB, float sB) {
    return bodies.invMassA + bodies.invMassB + bodies.invIA * rA * sA + bodies.invIB * rB * sB;
}

float InverseOf(float stiffness) {
    return stiffness > 0.0f ? 1.0f / stiffness : 0.0f;
}

void InitializePoint(const VelocityConstraint &constraint, const TwoBodies &pair, VelocityPoint *at) {
    const b2Vec2 &normal = constraint.normal, tangent = b2Cross(normal, 1.0f);
    const float rnA = b2Cross(at->rA, normal), rnB = b2Cross(at->rB, normal);
    at->normalMass = InverseOf(Stiffness(constraint.bodies, rnA, rnA, rnB, rnB));
    const float rtA = b2Cross(at->rA, tangent), rtB = b2Cross(at->rB, tangent);
    at->tangentMass = InverseOf(Stiffness(constraint.bodies, rtA, rtA, rtB, rtB));
    const float speed = b2Dot(normal, pair.Relative(*at));
    at->velocityBias = speed < -constraint.threshold ? -constraint.restitution * speed : 0.0f;
}

/// K of the two points and its inverse; one point is left where K is as good as singular.
void InitializeBlock(VelocityConstraint *constraint) {
    constexpr float kMaxConditionNumber = 1000.0f; // Box2D's
    const VelocityPoint &first = constraint->points[0], &second = constraint->points[1];
    const b2Vec2 &normal = constraint->normal;
    const float firstA = b2Cross(first.rA, normal), firstB = b2Cross(first.rB, normal);
    const float secondA = b2Cross(second.rA, normal), secondB = b2Cross(second.rB, normal);
    const float k11 = Stiffness(constraint->bodies, firstA, firstA, firstB, firstB);
    const float k22 = Stiffness(constraint->bodies, secondA, secondA, secondB, secondB);
    const float k12 = Stiffness(constraint->bodies, firstA, secondA, firstB, secondB);
    if (!(k11 * k11 < kMaxConditionNumber * (k11 * k22 - k12 * k12))) {
        constraint->pointCount = 1;
        return;
    }
    constraint->K.ex.Set(k11, k12);
    constraint->K.ey.Set(k12, k22);
    constraint->normalMass = constraint->K.GetInverse();
}

/// What does not depend on where the bodies are.
void Read(const b2Contact &contact, VelocityConstraint *velocity, PositionConstraint *position) {
    const b2Fixture *const fixtureA = contact.GetFixtureA(), *const fixtureB = contact.GetFixtureB();
    const b2Body *const bodyA = fixtureA->GetBody(), *const bodyB = fixtureB->GetBody();
    const b2Manifold &manifold = *contact.GetManifold();
    const ContactBodies bodies = {bodyA->*Named(IslandIndex()),    bodyB->*Named(IslandIndex()),
                                  bodyA->*Named(InverseMass()),    bodyB->*Named(InverseMass()),
                                  bodyA->*Named(InverseInertia()), bodyB->*Named(InverseInertia())};
    velocity->bodies = bodies;
    velocity->friction = contact.GetFriction();
    velocity->restitution = contact.GetRestitution();
    velocity->threshold = contact.GetRestitutionThreshold();
    velocity->tangentSpeed = contact.GetTangentSpeed();
    position->bodies = bodies;
    position->localCenterA = bodyA->GetLocalCenter();
    position->localCenterB = bodyB->GetLocalCenter();
    position->localNormal = manifold.localNormal;
    position->localPoint = manifold.localPoint;
    position->radiusA = fixtureA->GetShape()->m_radius;
    position->radiusB = fixtureB->GetShape()->m_radius;
    position->type = manifold.type;
    position->side = manifold.type == b2Manifold::e_faceB ? -1.0f : 1.0f;
    position->pointCount = manifold.pointCount;
    for (int32 i = 0; i < manifold.pointCount; ++i)
        position->localPoints[i] = manifold.points[i].localPoint;
}

} // namespace

void ContactSolver::Reserve(uint32_t bodies, uint32_t contacts) {
    m_rotations.Reserve(bodies);
    m_velocityConstraints.Reserve(contacts);
    m_positionConstraints.Reserve(contacts);
}

void ContactSolver::Begin(const b2TimeStep &step, b2Contact *const *contacts, const b2SolverData &bodies) {
    m_contacts = contacts;
    m_positions = bodies.positions;
    m_velocities = bodies.velocities;
    m_warmStarts = step.warmStarting;
    m_dtRatio = step.dtRatio;
}

void ContactSolver::Read(const Island &island) {
    m_solvesBlocks = g_blockSolve;
    for (uint32_t i = island.firstContact; i < island.endContact; ++i)
        bmr::Read(*m_contacts[i], &m_velocityConstraints[i], &m_positionConstraints[i]);
}

void ContactSolver::InitializeVelocities(const Island &island) {
    for (uint32_t i = island.firstContact; i < island.endContact; ++i) {
        VelocityConstraint &constraint = m_velocityConstraints[i];
        PositionConstraint &position = m_positionConstraints[i];
        const b2Manifold &manifold = *m_contacts[i]->GetManifold();
        constraint.pointCount = manifold.pointCount;
        if (constraint.pointCount == 0) { // a listener took them, or made a sensor solid
            constraint.points[0] = constraint.points[1] = VelocityPoint{};
            constraint.K.SetZero();
            constraint.normalMass.SetZero();
        }
        const b2Position &a = m_positions[constraint.bodies.indexA],
                         &b = m_positions[constraint.bodies.indexB];
        const b2Velocity &va = m_velocities[constraint.bodies.indexA],
                         &vb = m_velocities[constraint.bodies.indexB];
        const TwoBodies pair = {va.v, vb.v, va.w, vb.w};
        const ContactBodies &bodies = constraint.bodies;
        const WorldPoints world(position, PoseOf(bodies.indexA, a, position.localCenterA),
                                PoseOf(bodies.indexB, b, position.localCenterB));
        constraint.normal = world.normal;
        position.separation = world.separation;
        for (int32 j = 0; j < constraint.pointCount; ++j) {
            VelocityPoint &at = constraint.points[j];
            at.normalImpulse = m_warmStarts ? m_dtRatio * manifold.points[j].normalImpulse : 0.0f;
            at.tangentImpulse = m_warmStarts ? m_dtRatio * manifold.points[j].tangentImpulse : 0.0f;
            at.rA = world.points[j] - a.c;
            at.rB = world.points[j] - b.c;
            InitializePoint(constraint, pair, &at);
        }
        if (constraint.pointCount == 2 && m_solvesBlocks)
            InitializeBlock(&constraint);
    }
}

void ContactSolver::WarmStart(const Island &island) {
    for (uint32_t i = island.firstContact; i < island.endContact; ++i) {
        const VelocityConstraint &constraint = m_velocityConstraints[i];
        b2Velocity &a = m_velocities[constraint.bodies.indexA], &b = m_velocities[constraint.bodies.indexB];
        TwoBodies pair = {a.v, b.v, a.w, b.w};
        const b2Vec2 tangent = b2Cross(constraint.normal, 1.0f);
        for (int32 j = 0; j < constraint.pointCount; ++j) {
            const VelocityPoint &at = constraint.points[j];
            pair.Apply(constraint.bodies, at,
                       at.normalImpulse * constraint.normal + at.tangentImpulse * tangent);
        }
        a = {pair.vA, pair.wA};
        b = {pair.vB, pair.wB};
    }
}

void ContactSolver::Solve(VelocityConstraint *constraint) const {
    b2Velocity &a = m_velocities[constraint->bodies.indexA], &b = m_velocities[constraint->bodies.indexB];
    TwoBodies pair = {a.v, b.v, a.w, b.w};
    SolveFriction(constraint, &pair);
    if (constraint->pointCount == 1 || !m_solvesBlocks)
        SolveEachPoint(constraint, &pair);
    else
        SolveTwoPoints(constraint, &pair);
    a = {pair.vA, pair.wA};
    b = {pair.vB, pair.wB};
}

void ContactSolver::SolveVelocities(const Island &island) {
    for (uint32_t i = island.firstContact; i < island.endContact; ++i)
        Solve(&m_velocityConstraints[i]);
}

void ContactSolver::StoreImpulses(const Island &island) const {
    for (uint32_t i = island.firstContact; i < island.endContact; ++i) {
        const VelocityConstraint &constraint = m_velocityConstraints[i];
        b2Manifold &manifold = *m_contacts[i]->GetManifold();
        for (int32 j = 0; j < constraint.pointCount; ++j) {
            manifold.points[j].normalImpulse = constraint.points[j].normalImpulse;
            manifold.points[j].tangentImpulse = constraint.points[j].tangentImpulse;
        }
    }
}

void ContactSolver::Solve(const PositionConstraint &constraint, float baumgarte, const ContactBodies &bodies,
                          float *least) {
    b2Position a = m_positions[bodies.indexA], b = m_positions[bodies.indexB];
    for (int32 i = 0; i < constraint.pointCount; ++i) {
        const PositionPoint at(constraint, PoseOf(bodies.indexA, a, constraint.localCenterA),
                               PoseOf(bodies.indexB, b, constraint.localCenterB), i);
        const b2Vec2 rA = at.point - a.c, rB = at.point - b.c;
        *least = b2Min(*least, at.separation); // keeps no NaN longer than Box2D does
        const float correction =
            b2Clamp(baumgarte * (at.separation + b2_linearSlop), -b2_maxLinearCorrection, 0.0f);
        const float rnA = b2Cross(rA, at.normal), rnB = b2Cross(rB, at.normal);
        const float stiffness = Stiffness(bodies, rnA, rnA, rnB, rnB);
        const float impulse = stiffness > 0.0f ? -correction / stiffness : 0.0f;
        const b2Vec2 p = impulse * at.normal;
        a.c -= bodies.invMassA * p;
        a.a -= bodies.invIA * b2Cross(rA, p);
        b.c += bodies.invMassB * p;
        b.a += bodies.invIB * b2Cross(rB, p);
    }
    m_positions[bodies.indexA] = a;
    m_positions[bodies.indexB] = b;
}

bool ContactSolver::SolvePositions(const Island &island) {
    float least = 0.0f;
    for (uint32_t i = island.firstContact; i < island.endContact; ++i) {
        const PositionConstraint &constraint = m_positionConstraints[i];
        Solve(constraint, b2_baumgarte, constraint.bodies, &least);
    }
    return least >= kLeastSeparation;
}

bool ContactSolver::SolveToiPositions(const Island &island, int32 first, int32 second) {
    const auto meets = [=](int32 body) { return body == first || body == second; };
    float least = 0.0f;
    for (uint32_t i = island.firstContact; i < island.endContact; ++i) {
        ContactBodies bodies = m_positionConstraints[i].bodies;
        if (!meets(bodies.indexA))
            bodies.invMassA = bodies.invIA = 0.0f;
        if (!meets(bodies.indexB))
            bodies.invMassB = bodies.invIB = 0.0f;
        Solve(m_positionConstraints[i], b2_toiBaumgarte, bodies, &least);
    }
    return least >= -1.5f * b2_linearSlop;
}

void ContactSolver::GetImpulse(uint32_t i, b2ContactImpulse *impulse) const {
    const VelocityConstraint &constraint = m_velocityConstraints[i];
    impulse->count = constraint.pointCount;
    for (int32 j = 0; j < constraint.pointCount; ++j) {
        impulse->normalImpulses[j] = constraint.points[j].normalImpulse;
        impulse->tangentImpulses[j] = constraint.points[j].tangentImpulse;
    }
}

} // namespace bmr
