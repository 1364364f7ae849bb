// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_NEW_CONTACT_H
#define BOOMERANG_GLUE_NEW_CONTACT_H

#include <box2d/b2_broad_phase.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "base/private_members.h"

namespace bmr {

/// A contact that is being made.
struct NewContact : b2Contact {
    /// nullptr where Box2D has no contacts of these shapes.
    static b2Contact *Create(const b2FixtureProxy &a, const b2FixtureProxy &b, b2BlockAllocator *allocator) {
        return b2Contact::Create(a.fixture, a.childIndex, b.fixture, b.childIndex, allocator);
    }

    /// Is there one already? By a walk over the body's list, as Box2D does it.
    static bool ExistsInList(const b2FixtureProxy &a, const b2FixtureProxy &b) {
        const b2ContactEdge *edge = b.fixture->GetBody()->GetContactList();
        while (edge != nullptr && !Joins(*edge, a, b))
            edge = edge->next;
        return edge != nullptr;
    }

    /// Puts it at the head of the world's list.
    static void Link(b2Contact *contact, b2Contact **list) {
        contact->*(&NewContact::m_next) = *list;
        if (*list != nullptr)
            *list->*(&NewContact::m_prev) = contact;
        *list = contact;
    }

    /// Puts it at the head of its bodies' lists.
    static void Join(b2Contact *contact) {
        b2Body *bodyA = contact->GetFixtureA()->GetBody(), *bodyB = contact->GetFixtureB()->GetBody();
        Attach(&(contact->*(&NewContact::m_nodeA)), contact, bodyA, bodyB);
        Attach(&(contact->*(&NewContact::m_nodeB)), contact, bodyB, bodyA);
    }

private:
    static bool Joins(const b2ContactEdge &edge, const b2FixtureProxy &a, const b2FixtureProxy &b) {
        if (edge.other != a.fixture->GetBody())
            return false;
        const b2Contact &c = *edge.contact;
        return (c.GetFixtureA() == a.fixture && c.GetFixtureB() == b.fixture &&
                c.GetChildIndexA() == a.childIndex && c.GetChildIndexB() == b.childIndex) ||
               (c.GetFixtureA() == b.fixture && c.GetFixtureB() == a.fixture &&
                c.GetChildIndexA() == b.childIndex && c.GetChildIndexB() == a.childIndex);
    }

    static void Attach(b2ContactEdge *edge, b2Contact *contact, b2Body *body, b2Body *other) {
        b2ContactEdge *&list = body->*Named(ContactList());
        *edge = {other, contact, nullptr, list};
        if (list != nullptr)
            list->prev = edge;
        list = edge;
    }
};

} // namespace bmr

#endif
