// SPDX-License-Identifier: MIT
#include <boomerang/box2d.h>

#include "plugin.h"

namespace fuzz {

void Invalidate(b2Body *body) {
    bmr::Invalidate(body);
}

void Look(b2World &world) {
    for (const b2Contact *contact = world.GetContactList(); contact != nullptr;
         contact = contact->GetNext()) {
        const bmr::Proof proof = bmr::Inspect(*contact);
        b2Vec2 corners[16];
        bmr::InspectHull(proof, false, 0, corners, 16);
        bmr::InspectHull(proof, true, bmr::kHullLevel, corners, 16);
        bmr::CertifiedSlack(contact->GetFixtureA()->GetBody(), contact->GetFixtureB()->GetBody());
    }
}

b2Fixture *CreateAnySize(b2Body *body, const b2FixtureDef &given, const AnySize &size) {
    bmr::ConvexShape shape;
    bmr_error error = BMR_OK;
    switch (size.kind % 4) {
    case 0:
        error = shape.SetRegular(size.vertices, size.width);
        break;
    case 1:
        error = shape.SetEllipse(size.vertices, size.width, size.height);
        break;
    case 2:
        error = shape.SetRounded(size.width, size.height, 0.5f * b2Min(size.width, size.height),
                                 2 + size.vertices / 4);
        break;
    default:
        error = shape.SetRegular(size.vertices, size.width);
        if (error == BMR_OK)
            error = shape.Simplify(0.02f * size.height);
    }
    if (error != BMR_OK)
        return nullptr;
    b2FixtureDef def = given;
    def.shape = &shape;
    return body->CreateFixture(&def);
}

} // namespace fuzz
