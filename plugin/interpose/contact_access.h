// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_INTERPOSE_CONTACT_ACCESS_H
#define BOOMERANG_INTERPOSE_CONTACT_ACCESS_H

#include <box2d/b2_body.h>
#include <box2d/b2_contact_manager.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world_callbacks.h>

#include "recognise.h"

/// @file
/// What Box2D shows its contact manager alone, and its stand-ins here need too.

namespace bmr::interpose {

/// Names a protected member of b2Fixture's.
struct FixtureAccess : b2Fixture {
    static int32 ProxyOf(const b2Fixture *fixture, int32 child) {
        return (fixture->*(&FixtureAccess::m_proxies))[child].proxyId;
    }
};

// Private members of b2Body's. An explicit instantiation may name them all the same, and hands them out.
using ShouldCollideFcn = bool (b2Body::*)(const b2Body *other) const;
struct ShouldCollide {
    friend ShouldCollideFcn Named(ShouldCollide);
};
using ContactListOfBody = b2ContactEdge *b2Body::*;
struct ContactList {
    friend ContactListOfBody Named(ContactList);
};
template <typename Tag, typename Type, Type Member> struct Naming {
    friend Type Named(Tag) { return Member; }
};
template struct Naming<ShouldCollide, ShouldCollideFcn, &b2Body::ShouldCollide>;
template struct Naming<ContactList, ContactListOfBody, &b2Body::m_contactList>;

/// Is it a listener or a filter of the game's own? Those that worlds begin with are Box2D's, and run nobody's
/// code.
inline bool IsOfGame(const b2ContactListener *listener) {
    return listener != nullptr && listener != ListenerOfNewWorlds();
}
inline bool IsOfGame(const b2ContactFilter *filter) {
    return filter != nullptr && filter != FilterOfNewWorlds();
}

/// Do bodies, joints and the game's filter let the two collide?
inline bool PassesFilters(const b2ContactManager *manager, b2Fixture *fixtureA, b2Fixture *fixtureB) {
    const b2Body *bodyA = fixtureA->GetBody(), *bodyB = fixtureB->GetBody();
    return (bodyB->*Named(ShouldCollide()))(bodyA) &&
           (manager->m_contactFilter == nullptr ||
            manager->m_contactFilter->ShouldCollide(fixtureA, fixtureB));
}

} // namespace bmr::interpose

#endif
