// SPDX-License-Identifier: MIT
// The operations of a lane are those of ContactSolver::Solve, in its order and with its signs.
#include "solver/ordered_contacts.h"

#include <cstddef>

#include <box2d/b2_joint.h>

#include "base/private_members.h"
#include "solver/contact_lanes.h"

namespace bmr {

namespace {

constexpr uint32_t kJoint = 2; ///< the kind; that of a contact is the number of its points, less one

struct Point4 {
    Vec4 rA, rB;
    float4 normalImpulse, tangentImpulse, normalMass, tangentMass, bias;
};

/// Four contacts of as many points, of which no two share a body that moves.
struct FourVelocities {
    VelocityConstraint *constraints[4];
    b2Velocity *velocities;
    Vec4 normal;
    float4 friction, tangentSpeed, invMassA, invMassB, invIA, invIB;
    Motion4 a, b;

    FourVelocities(VelocityConstraint *all, const OrderedContacts::Group &group, uint32_t count,
                   b2Velocity *ofBodies)
        : constraints{&all[group.contacts[0]], &all[group.Contact(1, count)], &all[group.Contact(2, count)],
                      &all[group.Contact(3, count)]},
          velocities(ofBodies) {
        const Rows rows = Read(&constraints[0]->bodies.invMassA), first = Read(&constraints[0]->normal.x);
        normal = {first.a, first.b};
        friction = first.c;
        tangentSpeed = first.d;
        invMassA = rows.a;
        invMassB = rows.b;
        invIA = rows.c;
        invIB = rows.d;
        a = ReadVelocities(&ContactBodies::indexA);
        b = ReadVelocities(&ContactBodies::indexB);
    }
    /// `row`: of the first constraint; and the same of the others.
    Rows Read(const float *row) const {
        const std::ptrdiff_t at = row - &constraints[0]->normal.x;
        return Transposed(load4(row), load4(&constraints[1]->normal.x + at),
                          load4(&constraints[2]->normal.x + at), load4(&constraints[3]->normal.x + at));
    }
    Point4 ReadPoint(int32 i) const {
        const Rows arms = Read(&constraints[0]->points[i].rA.x),
                   rest = Read(&constraints[0]->points[i].normalImpulse);
        const float4 bias =
            of4(constraints[0]->points[i].velocityBias, constraints[1]->points[i].velocityBias,
                constraints[2]->points[i].velocityBias, constraints[3]->points[i].velocityBias);
        return {{arms.a, arms.b}, {arms.c, arms.d}, rest.a, rest.b, rest.c, rest.d, bias};
    }
    Motion4 ReadVelocities(int32 ContactBodies::*index) const {
        const auto of = [&](int i) { return &velocities[constraints[i]->bodies.*index].v.x; };
        return ReadMotions(of(0), of(1), of(2), of(3));
    }
    void Write(const Motion4 &motions, int32 ContactBodies::*index, uint32_t count) const {
        float *of[4];
        for (int i = 0; i < 4; ++i)
            of[i] = &velocities[constraints[i]->bodies.*index].v.x;
        WriteMotions(motions, of, count);
    }
    void Write(int32 i, const Point4 &at, uint32_t count) const {
        const float4 low = zip_low4(at.normalImpulse, at.tangentImpulse),
                     high = zip_high4(at.normalImpulse, at.tangentImpulse);
        for (uint32_t j = 0; j < 4 && j < count; ++j) {
            float *const two = &constraints[j]->points[i].normalImpulse;
            if (j % 2 == 0)
                store_low4(two, j < 2 ? low : high);
            else
                store_high4(two, j < 2 ? low : high);
        }
    }

    Vec4 Relative(const Point4 &at) const {
        const Vec4 ofB = {sub4(b.v.x, mul4(b.w, at.rB.y)), add4(b.v.y, mul4(b.w, at.rB.x))};
        const Vec4 more = Minus(ofB, a.v);
        return {add4(more.x, mul4(a.w, at.rA.y)), sub4(more.y, mul4(a.w, at.rA.x))};
    }
    void Apply(const Vec4 &p, float4 turnA, float4 turnB) {
        a.v = Minus(a.v, Times(invMassA, p));
        a.w = sub4(a.w, mul4(invIA, turnA));
        b.v = Plus(b.v, Times(invMassB, p));
        b.w = add4(b.w, mul4(invIB, turnB));
    }
    void SolveFriction(Point4 *at) {
        const Vec4 tangent = {normal.y, Negative(normal.x)};
        const float4 speed = sub4(Dot(Relative(*at), tangent), tangentSpeed);
        const float4 wanted = sub4(at->tangentImpulse, mul4(at->tangentMass, speed));
        const float4 most = mul4(friction, at->normalImpulse);
        const float4 impulse = max4(Negative(most), min4(wanted, most));
        const Vec4 p = Times(sub4(impulse, at->tangentImpulse), tangent);
        at->tangentImpulse = impulse;
        Apply(p, Cross(at->rA, p), Cross(at->rB, p));
    }
    void SolveOnePoint(Point4 *at) {
        const float4 speed = sub4(Dot(Relative(*at), normal), at->bias);
        const float4 impulse = max4(sub4(at->normalImpulse, mul4(at->normalMass, speed)), zero4());
        const Vec4 p = Times(sub4(impulse, at->normalImpulse), normal);
        at->normalImpulse = impulse;
        Apply(p, Cross(at->rA, p), Cross(at->rB, p));
    }
    void SolveTwoPoints(Point4 *first, Point4 *second) {
        const Rows k = Read(&constraints[0]->K.ex.x), inverse = Read(&constraints[0]->normalMass.ex.x);
        const float4 zero = zero4(), beforeFirst = first->normalImpulse, beforeSecond = second->normalImpulse;
        const float4 x = sub4(sub4(Dot(Relative(*first), normal), first->bias),
                              Dot({k.a, k.c}, {beforeFirst, beforeSecond}));
        const float4 y = sub4(sub4(Dot(Relative(*second), normal), second->bias),
                              Dot({k.b, k.d}, {beforeFirst, beforeSecond}));
        const float4 bothX = Negative(Dot({inverse.a, inverse.c}, {x, y})),
                     bothY = Negative(Dot({inverse.b, inverse.d}, {x, y}));
        const float4 oneX = Negative(mul4(first->normalMass, x)),
                     oneY = Negative(mul4(second->normalMass, y));
        const mask4 both = both4(at_most4(zero, bothX), at_most4(zero, bothY));
        const mask4 isFirst = both4(at_most4(zero, oneX), at_most4(zero, add4(mul4(k.b, oneX), y)));
        const mask4 isSecond = both4(at_most4(zero, oneY), at_most4(zero, add4(mul4(k.c, oneY), x)));
        const mask4 none = both4(at_most4(zero, x), at_most4(zero, y));
        const mask4 solved = either4(either4(both, isFirst), either4(isSecond, none));
        const float4 toX = select4(both, bothX, keep4(isFirst, oneX)),
                     toY = select4(both, bothY, select4(isFirst, zero, keep4(isSecond, oneY)));
        const Vec4 p = Times(sub4(toX, beforeFirst), normal), q = Times(sub4(toY, beforeSecond), normal);
        const Motion4 wasA = a, wasB = b;
        Apply(Plus(p, q), add4(Cross(first->rA, p), Cross(second->rA, q)),
              add4(Cross(first->rB, p), Cross(second->rB, q)));
        first->normalImpulse = toX;
        second->normalImpulse = toY;
        if (every4(solved))
            return;
        first->normalImpulse = select4(solved, toX, beforeFirst); // no solution: nothing changes
        second->normalImpulse = select4(solved, toY, beforeSecond);
        a = {Select(solved, a.v, wasA.v), select4(solved, a.w, wasA.w)};
        b = {Select(solved, b.v, wasB.v), select4(solved, b.w, wasB.w)};
    }
    /// Returns where a velocity is NaN.
    mask4 Solve(uint32_t count, bool two) {
        Point4 first = ReadPoint(0);
        SolveFriction(&first);
        if (two) {
            Point4 second = ReadPoint(1);
            SolveFriction(&second);
            SolveTwoPoints(&first, &second);
            Write(1, second, count);
        } else {
            SolveOnePoint(&first);
        }
        Write(0, first, count);
        Write(a, &ContactBodies::indexA, count);
        Write(b, &ContactBodies::indexB, count);
        return either4(a.IsNan(), b.IsNan());
    }
};

} // namespace

bool OrderedVelocities::Order(const VelocityConstraint *constraints, const JointSolver &joints,
                              const Island &island, const b2Velocity *velocities, int32 iterations) {
    if (island.endContact - island.firstContact < OrderedContacts::kLeast || iterations <= 0 ||
        !joints.HaveTwoBodies(island))
        return false;
    const auto carries = [velocities](int32 body, float invMass, float invI) {
        return CarriesNoOrder(invMass, invI, &velocities[body].v.x) ? OrderedContacts::kNone
                                                                    : static_cast<uint32_t>(body);
    };
    const auto isTurned = [&carries](const b2Body *body) {
        return carries(body->*Named(IslandIndex()), body->*Named(InverseMass()),
                       body->*Named(InverseInertia()));
    };
    m_order.Begin();
    for (uint32_t i = island.firstJoint; i < island.endJoint; ++i)
        m_order.Add(
            {i, kJoint, isTurned(joints.Joint(i)->GetBodyA()), isTurned(joints.Joint(i)->GetBodyB())});
    for (uint32_t i = island.firstContact; i < island.endContact; ++i) {
        const VelocityConstraint &c = constraints[i];
        const ContactBodies &of = c.bodies;
        // A contact of no points has no place here. Of two, Box2D may assert.
        if (c.pointCount == 0 || (c.pointCount == 2 && !(c.points[0].normalImpulse >= 0.0f &&
                                                         c.points[1].normalImpulse >= 0.0f))) {
            m_order.Forget();
            return false;
        }
        m_order.Add({i, static_cast<uint32_t>(c.pointCount - 1), carries(of.indexA, of.invMassA, of.invIA),
                     carries(of.indexB, of.invMassB, of.invIB)});
    }
    return m_order.Find(island.endBody, static_cast<uint32_t>(iterations));
}

bool OrderedVelocities::Solve(ContactSolver *solver, const JointSolver &joints, const Island &island,
                              b2Velocity *velocities) const {
    VelocityConstraint *const all = solver->VelocityConstraints();
    mask4 nans = less4(zero4(), zero4());
    const uint32_t left =
        m_order.ForEach([&](const OrderedContacts::Group &group, uint32_t count, uint32_t kind, uint32_t) {
            if (kind == kJoint) {
                for (uint32_t i = 0; i < count; ++i)
                    joints.SolveVelocity(group.contacts[i]);
                return;
            }
            if (count == 1 || !BMR_FLOAT4_NATIVE) {
                for (uint32_t i = 0; i < count; ++i)
                    solver->SolveVelocity(group.contacts[i]);
                return;
            }
            FourVelocities four(all, group, count, velocities);
            nans = either4(nans, four.Solve(count, kind == 1));
        });
    for (uint32_t i = 0; i < left; ++i) {
        joints.SolveVelocities(island);
        solver->SolveVelocities(island);
    }
    return !any4(nans) && !HasNan(&velocities->v.x, island);
}

} // namespace bmr
