// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <box2d/b2_body.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "body_pair.h"
#include "boomerang/box2d_glue.h"
#include "pair_registry.h"
#include "polygon_contact.h"

namespace bmr {

namespace {

/// Distance of two boxes, 0 where they overlap.
double BoxGap(const b2AABB &a, const b2AABB &b) {
    const double x = std::max({0.0, static_cast<double>(a.lowerBound.x) - static_cast<double>(b.upperBound.x),
                               static_cast<double>(b.lowerBound.x) - static_cast<double>(a.upperBound.x)});
    const double y = std::max({0.0, static_cast<double>(a.lowerBound.y) - static_cast<double>(b.upperBound.y),
                               static_cast<double>(b.lowerBound.y) - static_cast<double>(a.upperBound.y)});
    return std::hypot(x, y);
}

double PairGap(const BodyPair &pair, const b2Contact &contact) {
    const b2Transform &a = contact.GetFixtureA()->GetBody()->GetTransform();
    const b2Transform &b = contact.GetFixtureB()->GetBody()->GetTransform();
    return pair.a->body == contact.GetFixtureA()->GetBody() ? CertifiedGap(pair, a, b)
                                                            : CertifiedGap(pair, b, a);
}

/// What is proved for the two fixtures of a contact.
double ContactGap(b2Contact *contact) {
    PolygonContact *ours = PolygonContact::AsOurs(contact);
    if (ours == nullptr)
        return 0.0;
    double gap = ours->EdgeGap(contact->GetFixtureA()->GetBody()->GetTransform(),
                               contact->GetFixtureB()->GetBody()->GetTransform());
    const ContactState &state = ours->state;
    if (state.pair != nullptr && state.stamp == StampOf(*state.pair) && !state.excluded) {
        for (const BodyPair *pair = state.pair; pair != nullptr; pair = pair->parent)
            gap = std::max(gap, PairGap(*pair, *contact));
    }
    return gap;
}

b2Contact *ContactOf(const b2Fixture *a, const b2Fixture *b) {
    for (const b2ContactEdge *edge = a->GetBody()->GetContactList(); edge != nullptr; edge = edge->next) {
        const b2Contact *contact = edge->contact;
        if ((contact->GetFixtureA() == a && contact->GetFixtureB() == b) ||
            (contact->GetFixtureA() == b && contact->GetFixtureB() == a))
            return edge->contact;
    }
    return nullptr;
}

/// No contact: the fixtures' boxes, where Box2D keeps any.
double FixtureGap(const b2Fixture *a, const b2Fixture *b) {
    b2Contact *contact = ContactOf(a, b);
    if (contact != nullptr)
        return ContactGap(contact);
    b2AABB boxA, boxB;
    a->GetShape()->ComputeAABB(&boxA, a->GetBody()->GetTransform(), 0);
    b->GetShape()->ComputeAABB(&boxB, b->GetBody()->GetTransform(), 0);
    return BoxGap(boxA, boxB); // they hold the skin too: smaller than the core polygons' distance
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
                least = std::min(least, FixtureGap(a, b));
        }
    }
    return std::isfinite(least) ? std::nextafterf(static_cast<float>(least), 0.0f) : 0.0f;
}

void Invalidate(b2Body *body) {
    if (body != nullptr)
        InvalidateBody(body);
}

} // namespace bmr
