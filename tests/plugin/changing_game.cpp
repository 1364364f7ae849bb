// SPDX-License-Identifier: MIT
// A game that changes polygons in place, through b2Fixture::GetShape, and tells nobody: other vertices, more
// or fewer of them, another radius. Its bodies have many fixtures. It also asks contacts for their manifolds
// between steps.
#include <cmath>

#include "small_world.h"

namespace {

constexpr int kBodies = 12, kFixtures = 16, kSteps = 300;

b2PolygonShape *PolygonOf(b2Body *body, int index) {
    b2Fixture *fixture = body->GetFixtureList();
    for (; index > 0; --index)
        fixture = fixture->GetNext();
    return static_cast<b2PolygonShape *>(fixture->GetShape());
}

/// Another polygon in its place, with `corners` corners: one in the middle of the wheel, the others out at
/// `reach`.
void Change(b2PolygonShape *shape, float reach, int corners) {
    const float radius = shape->m_radius;
    b2Rot turn(0.0f);
    const b2Vec2 middle = shape->m_centroid;
    turn.Set(std::atan2(middle.y, middle.x) - 0.06f * static_cast<float>(corners));
    b2Vec2 points[b2_maxPolygonVertices] = {{0.0f, 0.0f}};
    for (int i = 1; i < corners; ++i)
        points[i] = reach * b2Mul(turn, b2Rot(0.12f * static_cast<float>(i)).GetXAxis());
    shape->Set(points, corners);
    shape->m_radius = radius;
}

void AskForManifolds(b2World *world, Hash *hash) {
    for (b2Contact *contact = world->GetContactList(); contact != nullptr; contact = contact->GetNext()) {
        b2Manifold manifold;
        contact->Evaluate(&manifold, contact->GetFixtureA()->GetBody()->GetTransform(),
                          contact->GetFixtureB()->GetBody()->GetTransform());
        hash->Add(static_cast<uint32_t>(manifold.pointCount));
    }
}

} // namespace

int main() {
    b2World world(b2Vec2(0.0f, 0.0f));
    for (const float side : {-1.0f, 1.0f}) {
        AddBox(world, b2_staticBody, {3.1f + side * 5.0f, 2.06f}, {0.5f, 5.0f}, 0.0f);
        AddBox(world, b2_staticBody, {3.1f, 2.06f + side * 4.0f}, {5.0f, 0.5f}, 0.0f);
    }
    b2Body *bodies[kBodies];
    for (int i = 0; i < kBodies; ++i) {
        bodies[i] = AddWheel(world, {2.06f * static_cast<float>(i % 4), 2.06f * static_cast<float>(i / 4)},
                             kFixtures, 1.0f);
        bodies[i]->SetAngularVelocity(i % 2 == 0 ? 0.3f : -0.2f);
        bodies[i]->SetSleepingAllowed(false);
        for (b2Fixture *fixture = bodies[i]->GetFixtureList(); fixture != nullptr;
             fixture = fixture->GetNext())
            fixture->SetRestitution(1.0f);
    }
    Hash hash;
    for (int step = 0; step < kSteps; ++step) {
        b2Body *body = bodies[step % kBodies];
        b2PolygonShape *shape = PolygonOf(body, step * 5 % kFixtures);
        if (step % 3 == 0)
            Change(shape, step % 2 == 0 ? 1.2f : 0.9f, 3);
        else if (step % 7 == 1)
            Change(shape, 1.15f, 4 + step % 4);
        else if (step % 11 == 2)
            shape->m_radius = 20.0f * b2_polygonRadius;
        if (step % 4 == 0)
            AskForManifolds(&world, &hash);
        Step(world, 1, &hash);
    }
    Print("changed in place", hash);
    return 0;
}
