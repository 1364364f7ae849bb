// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cfloat>
#include <cmath>

#include <box2d/b2_body.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "body_pair.h"
#include "boomerang/box2d_glue.h"
#include "face_gap.h"
#include "pair_registry.h"
#include "solid_contact.h"

namespace bmr {

namespace {

/// Distance of two boxes, less what rounding their bounds to float may have added; 0 where they overlap.
double BoxGap(const b2AABB &a, const b2AABB &b) {
    const auto apart = [](float low, float high) {
        const double gap = static_cast<double>(low) - static_cast<double>(high);
        return gap - 4.0 * FLT_EPSILON *
                         (std::fabs(static_cast<double>(low)) + std::fabs(static_cast<double>(high)));
    };
    const double x =
        std::max({0.0, apart(a.lowerBound.x, b.upperBound.x), apart(b.lowerBound.x, a.upperBound.x)});
    const double y =
        std::max({0.0, apart(a.lowerBound.y, b.upperBound.y), apart(b.lowerBound.y, a.upperBound.y)});
    return std::hypot(x, y);
}

b2Contact *ContactOf(const b2Fixture &a, const b2Fixture &b) {
    for (const b2ContactEdge *edge = a.GetBody()->GetContactList(); edge != nullptr; edge = edge->next) {
        const b2Contact *contact = edge->contact;
        if ((contact->GetFixtureA() == &a && contact->GetFixtureB() == &b) ||
            (contact->GetFixtureA() == &b && contact->GetFixtureB() == &a))
            return edge->contact;
    }
    return nullptr;
}

/// What the kinetic structures that a contact shares prove; 0 without any.
double StructureGap(const b2Fixture &a, const b2Fixture &b) {
    b2Contact *contact = ContactOf(a, b);
    SolidContact *ours = contact != nullptr ? SolidContact::AsOurs(contact) : nullptr;
    if (ours == nullptr || ours->state.pair == nullptr ||
        ours->state.link.stamp != StampOf(*ours->state.pair) || ours->state.link.excluded)
        return 0.0;
    double gap = 0.0;
    for (const BodyPair *pair = ours->state.pair; pair != nullptr; pair = pair->parent) {
        const b2Fixture &first = pair->a->body == a.GetBody() ? a : b, &second = &first == &a ? b : a;
        gap = std::max(
            gap, CertifiedGap(*pair, first.GetBody()->GetTransform(), second.GetBody()->GetTransform()));
    }
    return gap;
}

/// Each of the three is a lower bound of the distance: the boxes hold the shapes and their skins, the face is
/// one direction of all.
double FixtureGap(const b2Fixture &a, const b2Fixture &b) {
    b2AABB boxA, boxB;
    a.GetShape()->ComputeAABB(&boxA, a.GetBody()->GetTransform(), 0);
    b.GetShape()->ComputeAABB(&boxB, b.GetBody()->GetTransform(), 0);
    return std::max(
        {BoxGap(boxA, boxB), LargestFaceGap(a, b).proved, LargestFaceGap(b, a).proved, StructureGap(a, b)});
}

bool IsSolidPolygon(const b2Fixture *fixture) {
    return fixture->GetType() == b2Shape::e_polygon && !fixture->IsSensor();
}

} // namespace

float CertifiedSlack(const b2Body *bodyA, const b2Body *bodyB) {
    if (bodyA == nullptr || bodyB == nullptr || bodyA == bodyB || bodyA->GetWorld() != bodyB->GetWorld())
        return 0.0f;
    double least = INFINITY;
    for (const b2Fixture *a = bodyA->GetFixtureList(); a != nullptr; a = a->GetNext()) {
        for (const b2Fixture *b = bodyB->GetFixtureList(); b != nullptr && IsSolidPolygon(a);
             b = b->GetNext()) {
            if (IsSolidPolygon(b))
                least = std::min(least, FixtureGap(*a, *b));
        }
    }
    return std::isfinite(least) ? std::nextafterf(static_cast<float>(least), 0.0f) : 0.0f;
}

void Invalidate(b2Body *body) {
    if (body != nullptr)
        InvalidateBody(body);
}

} // namespace bmr
