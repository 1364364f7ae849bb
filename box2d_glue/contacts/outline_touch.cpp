// SPDX-License-Identifier: MIT
#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "boomerang/outline_shape.h"
#include "shapes/outline_record.h"

namespace bmr {

namespace {

/// What touches as one: an outline, or a fixture that is no piece of one.
const void *WholeOf(const b2Fixture &fixture) {
    const OutlineRecord *record = OutlineRecordOf(*fixture.GetShape());
    return record != nullptr ? static_cast<const void *>(record) : &fixture;
}

} // namespace

bool TouchesAlone(const b2Contact &contact) {
    const b2Fixture &a = *contact.GetFixtureA(), &b = *contact.GetFixtureB();
    const bool ofA = a.GetBody()->GetType() == b2_dynamicBody; // else the other is: there are less contacts
    const b2Fixture &mine = ofA ? a : b, &theirs = ofA ? b : a;
    const void *const myWhole = WholeOf(mine), *const theirWhole = WholeOf(theirs);
    for (const b2ContactEdge *edge = mine.GetBody()->GetContactList(); edge != nullptr; edge = edge->next) {
        const b2Contact &other = *edge->contact;
        if (edge->other != theirs.GetBody() || &other == &contact || !other.IsTouching())
            continue;
        const bool swapped = other.GetFixtureA()->GetBody() != mine.GetBody();
        const b2Fixture &first = swapped ? *other.GetFixtureB() : *other.GetFixtureA(),
                        &second = swapped ? *other.GetFixtureA() : *other.GetFixtureB();
        if (WholeOf(first) == myWhole && WholeOf(second) == theirWhole)
            return false;
    }
    return true;
}

} // namespace bmr
