// SPDX-License-Identifier: MIT
// A plain Box2D game in which the plugin asks for memory in all of its ways: hulls of bodies of many fixtures
// that come and go and change, bodies with so many contacts that they are worth a table, also one that grows
// while pairs are found twice, a big hull, several worlds, two threads.
#include <thread>

#include "../kit/small_world.h"

namespace {

/// A body of many small boxes, as wide as it is asked for.
b2Body *AddComb(b2World &world, b2BodyType type, b2Vec2 at, int teeth) {
    b2BodyDef def;
    def.type = type;
    def.position = at;
    b2Body *body = world.CreateBody(&def);
    for (int i = 0; i < teeth; ++i) {
        b2PolygonShape box;
        box.SetAsBox(0.12f, 0.1f, {0.25f * static_cast<float>(i) - 0.125f * static_cast<float>(teeth), 0.0f},
                     0.1f * static_cast<float>(i));
        body->CreateFixture(&box, 1.0f);
    }
    return body;
}

/// More new contacts in one step than a table has room for at first. What is moved after it was made is asked
/// twice for its pairs.
void PlayCrowd(Hash *hash) {
    b2World world(b2Vec2(0.0f, -10.0f));
    AddComb(world, b2_staticBody, {0.0f, 0.0f}, 60);
    AddComb(world, b2_dynamicBody, {0.0f, 5.0f}, 60)->SetTransform({0.0f, 0.1f}, 0.0f);
    Step(world, 2, hash);
}

void Play(Hash *hash) {
    PlayCrowd(hash);
    b2World world(b2Vec2(0.0f, -10.0f));
    AddComb(world, b2_staticBody, {0.0f, 0.0f}, 90); // more contacts than a list is for
    b2Body *comb = AddComb(world, b2_dynamicBody, {0.0f, 2.0f}, 12);
    AddComb(world, b2_dynamicBody, {0.5f, 3.0f}, 12);
    AddBox(world, b2_staticBody, {0.0f, 1.5f}, {12.0f, 0.5f}, 0.0f, true);
    b2Body *wheel = AddWheel(world, {3.0f, 2.0f}, 14, 0.8f);
    for (int i = 0; i < 16; ++i)
        AddBox(world, b2_dynamicBody, {0.6f * static_cast<float>(i - 8), 4.0f}, {0.2f, 0.2f}, 0.0f)
            ->SetBullet(i % 5 == 0);
    Step(world, 25, hash);
    // A hull that is built anew, and one that is new.
    static_cast<b2PolygonShape *>(comb->GetFixtureList()->GetShape())->m_vertices[0] *= 1.05f;
    Step(world, 10, hash);
    wheel->DestroyFixture(wheel->GetFixtureList());
    AddComb(world, b2_dynamicBody, {-2.0f, 2.5f}, 10);
    Step(world, 25, hash);
}

} // namespace

int main() {
    Hash hash, ofThread;
    Play(&hash);
    std::thread(Play, &ofThread).join();
    Print("played", hash);
    Print("played by another thread", ofThread);
    return 0;
}
