// SPDX-License-Identifier: MIT
// A game some of whose bodies are nowhere: their places, angles or vertices are no numbers, or infinite, or
// become so and are put right again.
#include <cmath>

#include "small_world.h"

namespace {

constexpr int kLost = 12;

void Lose(b2Body *body, int how) {
    const float none = std::nanf(""), infinite = INFINITY;
    auto *shape = static_cast<b2PolygonShape *>(body->GetFixtureList()->GetShape());
    switch (how) {
    case 0:
        body->SetTransform({none, 3.0f}, 0.0f);
        break;
    case 1:
        body->SetTransform({1.0f, infinite}, 0.5f);
        break;
    case 2:
        body->SetTransform({1.0f, 3.0f}, none);
        break;
    case 3:
        body->SetTransform({2.0f, 3.0f}, infinite);
        break;
    case 4:
        body->SetLinearVelocity({infinite, 0.0f});
        break;
    case 5:
        body->SetAngularVelocity(-none);
        break;
    case 6:
        shape->m_vertices[1].x = none;
        break;
    case 7:
        shape->m_vertices[2].y = -infinite;
        break;
    case 8:
        shape->m_radius = none;
        break;
    case 9: // numbers that are none are of two signs: which one is left shows the order of what was done
        body->SetTransform({none, -none}, infinite);
        break;
    case 10:
        body->SetTransform({-none, none}, none);
        break;
    default:
        shape->m_radius = none;
        body->SetTransform({-none, none}, -none);
    }
}

} // namespace

int main() {
    b2World world(b2Vec2(0.0f, -10.0f));
    world.SetContinuousPhysics(false); // its search for times of impact asserts where numbers are none
    FillWithBoxes(world);
    b2Body *lost[kLost];
    for (int i = 0; i < kLost; ++i)
        lost[i] =
            AddBox(world, b2_dynamicBody, {2.0f * static_cast<float>(i) - 8.0f, 12.0f}, {0.5f, 0.5f}, 0.0f);
    Hash hash;
    Step(world, 30, &hash);
    for (int i = 0; i < kLost; ++i) {
        Lose(lost[i], i);
        Step(world, 10, &hash);
    }
    for (b2Body *body : lost) {
        static_cast<b2PolygonShape *>(body->GetFixtureList()->GetShape())->SetAsBox(0.5f, 0.5f);
        body->GetFixtureList()->GetShape()->m_radius = b2_polygonRadius;
        body->SetTransform({0.0f, 9.0f}, 0.0f);
        body->SetLinearVelocity({0.0f, -1.0f});
        body->SetAngularVelocity(0.0f);
    }
    Step(world, 60, &hash);
    Print("nowhere", hash);
    return 0;
}
