// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PRIVATE_MEMBERS_H
#define BOOMERANG_GLUE_PRIVATE_MEMBERS_H

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

/// @file
/// What Box2D shows itself alone, and its stand-ins here need too.

namespace bmr {

// An explicit instantiation may name private members, and hands them out.
template <typename Tag, typename Type, Type Member> struct Naming {
    friend Type Named(Tag) { return Member; }
};

using ShouldCollideFcn = bool (b2Body::*)(const b2Body *other) const;
struct ShouldCollide {
    friend ShouldCollideFcn Named(ShouldCollide);
};
using ContactListOfBody = b2ContactEdge *b2Body::*;
struct ContactList {
    friend ContactListOfBody Named(ContactList);
};
using SweepOfBody = b2Sweep b2Body::*;
struct SweepMember {
    friend SweepOfBody Named(SweepMember);
};
using NextOfBody = b2Body *b2Body::*;
struct NextBody {
    friend NextOfBody Named(NextBody);
};
using FlagsOfBody = uint16 b2Body::*;
struct BodyFlags {
    friend FlagsOfBody Named(BodyFlags);
};
template struct Naming<NextBody, NextOfBody, &b2Body::m_next>;
template struct Naming<BodyFlags, FlagsOfBody, &b2Body::m_flags>;
template struct Naming<ShouldCollide, ShouldCollideFcn, &b2Body::ShouldCollide>;
template struct Naming<ContactList, ContactListOfBody, &b2Body::m_contactList>;
template struct Naming<SweepMember, SweepOfBody, &b2Body::m_sweep>;

inline const b2Sweep &SweepOf(const b2Body &body) {
    return body.*Named(SweepMember());
}

/// Is neither body of the contact dynamic?
inline bool IsWithoutDynamic(const b2Contact &contact) {
    return contact.GetFixtureA()->GetBody()->GetType() != b2_dynamicBody &&
           contact.GetFixtureB()->GetBody()->GetType() != b2_dynamicBody;
}

/// Names protected members of b2Fixture's.
struct FixtureAccess : b2Fixture {
    static int32 ProxyOf(const b2Fixture *fixture, int32 child) {
        return (fixture->*(&FixtureAccess::m_proxies))[child].proxyId;
    }
    static int32 ProxyCount(const b2Fixture *fixture) { return fixture->*(&FixtureAccess::m_proxyCount); }
};

} // namespace bmr

#endif
