// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_MEMBERS_H
#define BOOMERANG_TESTBED_MEMBERS_H

#include <box2d/box2d.h>

/// @file
/// The state of bodies and contacts that has no accessor but decides what happens next, so that a comparison
/// must see it. Read only. Two ways, both legal C++ and neither dependent on the layout:
/// - b2Contact's members are protected: a derived class may name them, and the type of &Derived::m_flags is
///   that of a member of b2Contact.
/// - b2Body's are private: access rules do not apply to the arguments of an explicit instantiation
///   ([temp.spec.general]/6), which defines a friend that hands the member pointer out.

namespace testbed {

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

} // namespace testbed

#endif
