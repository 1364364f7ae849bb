// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_VISIT_H
#define BOOMERANG_TESTBED_VISIT_H

#include <box2d/box2d.h>

#include "numbers.h"
#include "sinks.h"

/// @file
/// Which fields make up the state of a world and the arguments of its events. Objects go by their stage's
/// numbers, never by address. What Box2D leaves unset is left out: a manifold without points. So is what a
/// step keeps in contacts for itself, which no game can see and every step begins anew: times of impact and
/// their counts, who is in an island.

namespace testbed {

// The state of bodies and contacts that has no accessor but decides what happens next, so that a comparison
// must see it. Read only. Two ways, both legal C++ and neither dependent on the layout:
// - b2Contact's members are protected: a derived class may name them, and the type of &Derived::m_flags is
//   that of a member of b2Contact.
// - b2Body's are private: access rules do not apply to the arguments of an explicit instantiation
//   ([temp.spec.general]/6), which defines a friend that hands the member pointer out.

struct ContactMembers : b2Contact {
    static uint32 Flags(const b2Contact &contact) { return contact.*&ContactMembers::m_flags; }
    static const b2Contact *Previous(const b2Contact &contact) { return contact.*&ContactMembers::m_prev; }
    /// Without those that b2World::Solve and SolveTOI keep for themselves during a step: the next one clears
    /// them before it reads them. Bits that Box2D gives no meaning are not compared.
    static uint32 FlagsThatLast(const b2Contact &contact) {
        return Flags(contact) &
               static_cast<uint32>(e_touchingFlag | e_enabledFlag | e_filterFlag | e_bulletHitFlag);
    }
};

namespace body_members {

template <typename Member, typename Member::Type Pointer> struct HandOut {
    friend typename Member::Type Locate(Member) { return Pointer; }
};

// BMR_BODY_MEMBER(Flags, uint16, m_flags) defines `uint16 Flags(const b2Body &)`.
#define BMR_BODY_MEMBER(Name, MemberType, member)                                                            \
    struct Name##Member {                                                                                    \
        using Type = MemberType b2Body::*;                                                                   \
        friend Type Locate(Name##Member);                                                                    \
    };                                                                                                       \
    template struct HandOut<Name##Member, &b2Body::member>;                                                  \
    inline const MemberType &Name(const b2Body &body) {                                                      \
        return body.*Locate(Name##Member());                                                                 \
    }

BMR_BODY_MEMBER(Flags, uint16, m_flags)
BMR_BODY_MEMBER(Sweep, b2Sweep, m_sweep)
BMR_BODY_MEMBER(Force, b2Vec2, m_force)
BMR_BODY_MEMBER(Torque, float, m_torque)
BMR_BODY_MEMBER(SleepTime, float, m_sleepTime)
#undef BMR_BODY_MEMBER

} // namespace body_members

template <typename Sink> void VisitVector(Sink &sink, const char *x, const char *y, const b2Vec2 &value) {
    sink.Field(x, value.x);
    sink.Field(y, value.y);
}

/// The order of a body's contacts decides the order in which islands are built. One hash for the whole list:
/// a line each would say again what the world's list says.
inline uint64_t HashContactOrder(const b2Body &body) {
    HashSink order;
    for (const b2ContactEdge *edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
        const b2Contact &contact = *edge->contact;
        order.Key("other", NumberOf(*edge->other));
        order.Key("fixtureA", NumberOf(*contact.GetFixtureA()));
        order.Key("fixtureB", NumberOf(*contact.GetFixtureB()));
        order.Field("childA", contact.GetChildIndexA());
        order.Field("childB", contact.GetChildIndexB());
    }
    return order.Value();
}

template <typename Sink> void VisitBody(Sink &sink, const b2Body &body) {
    sink.Begin("body", NumberOf(body));
    sink.Field("type", static_cast<uint32_t>(body.GetType()));
    sink.Field("flags", static_cast<uint32_t>(body_members::Flags(body)));
    const b2Transform &transform = body.GetTransform();
    VisitVector(sink, "position.x", "position.y", transform.p);
    sink.Field("rotation.s", transform.q.s);
    sink.Field("rotation.c", transform.q.c);
    const b2Sweep &sweep = body_members::Sweep(body);
    VisitVector(sink, "sweep.localCenter.x", "sweep.localCenter.y", sweep.localCenter);
    VisitVector(sink, "sweep.c0.x", "sweep.c0.y", sweep.c0);
    VisitVector(sink, "sweep.c.x", "sweep.c.y", sweep.c);
    sink.Field("sweep.a0", sweep.a0);
    sink.Field("sweep.a", sweep.a);
    sink.Field("sweep.alpha0", sweep.alpha0);
    VisitVector(sink, "linearVelocity.x", "linearVelocity.y", body.GetLinearVelocity());
    sink.Field("angularVelocity", body.GetAngularVelocity());
    VisitVector(sink, "force.x", "force.y", body_members::Force(body));
    sink.Field("torque", body_members::Torque(body));
    sink.Field("sleepTime", body_members::SleepTime(body));
    sink.Field("contactOrder", HashContactOrder(body));
}

template <typename Sink> void VisitManifold(Sink &sink, const b2Manifold &manifold) {
    sink.Field("pointCount", manifold.pointCount);
    if (manifold.pointCount == 0)
        return;
    sink.Field("type", static_cast<uint32_t>(manifold.type));
    VisitVector(sink, "localNormal.x", "localNormal.y", manifold.localNormal);
    VisitVector(sink, "localPoint.x", "localPoint.y", manifold.localPoint);
    static constexpr const char *names[2][5] = {
        {"point0.x", "point0.y", "point0.normalImpulse", "point0.tangentImpulse", "point0.id"},
        {"point1.x", "point1.y", "point1.normalImpulse", "point1.tangentImpulse", "point1.id"}};
    for (int32 i = 0; i < manifold.pointCount; ++i) {
        const b2ManifoldPoint &point = manifold.points[i];
        VisitVector(sink, names[i][0], names[i][1], point.localPoint);
        sink.Field(names[i][2], point.normalImpulse);
        sink.Field(names[i][3], point.tangentImpulse);
        sink.Field(names[i][4], static_cast<uint32_t>(point.id.key));
    }
}

/// Names a contact by its fixtures; children tell the segments of a chain apart.
template <typename Sink> void NameContact(Sink &sink, const b2Contact &contact) {
    const b2Fixture &a = *contact.GetFixtureA();
    const b2Fixture &b = *contact.GetFixtureB();
    sink.Key("bodyA", NumberOf(*a.GetBody()));
    sink.Key("fixture", NumberOf(a));
    if (a.GetType() == b2Shape::e_chain)
        sink.Key("child", static_cast<uint64_t>(contact.GetChildIndexA()));
    sink.Key("bodyB", NumberOf(*b.GetBody()));
    sink.Key("fixture", NumberOf(b));
    if (b.GetType() == b2Shape::e_chain)
        sink.Key("child", static_cast<uint64_t>(contact.GetChildIndexB()));
}

template <typename Sink> void VisitContact(Sink &sink, uint64_t number, const b2Contact &contact) {
    sink.Begin("contact", number);
    NameContact(sink, contact);
    sink.Field("flags", ContactMembers::FlagsThatLast(contact));
    sink.Field("friction", contact.GetFriction());
    sink.Field("restitution", contact.GetRestitution());
    sink.Field("restitutionThreshold", contact.GetRestitutionThreshold());
    sink.Field("tangentSpeed", contact.GetTangentSpeed());
    VisitManifold(sink, *contact.GetManifold());
}

} // namespace testbed

#endif
