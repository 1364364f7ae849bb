// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_OUTLINE_WHOLE_H
#define BOOMERANG_GLUE_OUTLINE_WHOLE_H

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "shapes/outline_record.h"

namespace bmr {

/// The thing that touches as one: an outline, or a fixture that is no piece of one.
inline const void *WholeOf(const b2Fixture &fixture) {
    const OutlineRecord *record = OutlineRecordOf(*fixture.GetShape());
    return record != nullptr ? static_cast<const void *>(record) : &fixture;
}

/// Calls visit(b2Contact &other, b2Fixture &a, b2Fixture &b) with each other contact between the two wholes
/// that this contact is one of; `a` is of the body of its fixture A. Ends when `visit` returns false.
/// O(contacts of the one of the two bodies that is dynamic).
template <typename Visit> inline void ForEachOfWholes(const b2Contact &contact, Visit visit) {
    const b2Fixture &ofA = *contact.GetFixtureA(), &ofB = *contact.GetFixtureB();
    const b2Body *const bodyA = ofA.GetBody(), *const bodyB = ofB.GetBody();
    const void *const wholeA = WholeOf(ofA), *const wholeB = WholeOf(ofB);
    const b2Body *const mine = bodyA->GetType() == b2_dynamicBody ? bodyA : bodyB; // has less contacts
    const b2Body *const theirs = mine == bodyA ? bodyB : bodyA;
    for (const b2ContactEdge *edge = mine->GetContactList(); edge != nullptr; edge = edge->next) {
        b2Contact &other = *edge->contact;
        if (edge->other != theirs || &other == &contact)
            continue;
        const bool swapped = other.GetFixtureA()->GetBody() != bodyA;
        b2Fixture &a = swapped ? *other.GetFixtureB() : *other.GetFixtureA(),
                  &b = swapped ? *other.GetFixtureA() : *other.GetFixtureB();
        if (WholeOf(a) == wholeA && WholeOf(b) == wholeB && !visit(other, a, b))
            return;
    }
}

} // namespace bmr

#endif
