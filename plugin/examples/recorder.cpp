// SPDX-License-Identifier: MIT
// Three deeds of games that need no listener of their own: pickups, damage by impulse, a one-way platform.
// The recorder is read after the step. Build it on an installed Boomerang with
//
//     libraries=$(pkg-config --cflags --libs boomerang-recorder boomerang-box2d)
//     c++ -std=c++17 recorder.cpp -o recorder $libraries
//
// It prints the same with BOOMERANG=off, and where boomerang-box2d is left out, but for the call of Install.
#include <cstdint>
#include <cstdio>

#include <boomerang/box2d.h>
#include <boomerang/contact_recorder.h>
#include <box2d/box2d.h>

namespace {

enum Category : uint16 { kWorld = 1, kPlayer = 2, kPlatform = 4 };

b2Body *Add(b2World &world, b2BodyType type, b2Vec2 at, b2Vec2 half, Category category, bool sensor = false) {
    b2BodyDef def;
    def.type = type;
    def.position = at;
    def.fixedRotation = true;
    b2PolygonShape box;
    box.SetAsBox(half.x, half.y);
    b2FixtureDef fixture;
    fixture.shape = &box;
    fixture.density = 1.0f;
    fixture.isSensor = sensor;
    fixture.filter.categoryBits = category;
    b2Body *body = world.CreateBody(&def);
    body->CreateFixture(&fixture);
    return body;
}

// docs/contact-recorder.md shows these three.

struct Coin {
    int value;
    bool isTaken;
};

/// A coin's body has the address of its Coin for user data. Two players may touch it in one step.
int TakePickups(const bmr::ContactEvents &events, b2World &world) {
    int score = 0;
    for (const bmr::SensorTouchEvent &event : events.sensorBegins) {
        Coin *coin = reinterpret_cast<Coin *>(event.sensor.bodyUserData.pointer);
        if (coin == nullptr || coin->isTaken)
            continue;
        coin->isTaken = true;
        score += coin->value;
        world.DestroyBody(event.sensor.body);
    }
    return score;
}

/// Damage is the part of each impulse above the threshold.
float DamageTo(const b2Body *body, const bmr::ContactEvents &events, float threshold) {
    float damage = 0.0f;
    for (const bmr::ContactHitEvent &hit : events.hits)
        if (hit.a.body == body || hit.b.body == body)
            damage += hit.impulse - threshold;
    return damage;
}

/// Ahead of the step: the player collides with platforms once its feet are above them and it is not rising.
void LetThrough(b2Body *player, float feet, float platformTop) {
    const bool above = player->GetPosition().y - feet >= platformTop - b2_linearSlop;
    const bool lands = above && player->GetLinearVelocity().y <= 0.01f;
    b2Fixture *fixture = player->GetFixtureList();
    b2Filter filter = fixture->GetFilterData();
    const auto mask = static_cast<uint16>(lands ? filter.maskBits | kPlatform : filter.maskBits & ~kPlatform);
    if (mask == filter.maskBits)
        return; // SetFilterData visits each contact
    filter.maskBits = mask;
    fixture->SetFilterData(filter);
}

} // namespace

int main() {
    bmr::Install();
    constexpr float kThreshold = 4.0f, kFeet = 0.5f, kTop = 3.2f;
    bmr::ContactRecorder recorder; // declared before the world, so that it is destroyed after it
    recorder.SetHitThreshold(kThreshold);
    b2World world({0.0f, -10.0f});
    world.SetContactListener(&recorder);
    Add(world, b2_staticBody, {0.0f, -0.5f}, {20.0f, 0.5f}, kWorld);
    Add(world, b2_staticBody, {0.0f, kTop - 0.2f}, {3.0f, 0.2f}, kPlatform);
    b2Body *player = Add(world, b2_dynamicBody, {0.0f, kFeet}, {0.4f, kFeet}, kPlayer);
    Coin coins[] = {{10, false}, {20, false}};
    for (int i = 0; i < 2; ++i)
        Add(world, b2_staticBody, {0.0f, 2.0f + 2.2f * static_cast<float>(i)}, {0.2f, 0.2f}, kWorld, true)
            ->GetUserData()
            .pointer = reinterpret_cast<uintptr_t>(&coins[i]);
    Add(world, b2_dynamicBody, {0.0f, 12.0f}, {0.5f, 0.5f}, kWorld); // a crate

    int score = 0;
    float health = 100.0f;
    for (int frame = 0; frame < 300; ++frame) {
        if (frame == 10)
            player->SetLinearVelocity({0.0f, 10.0f}); // jumps
        LetThrough(player, kFeet, kTop);
        world.Step(1.0f / 60.0f, 8, 3);
        const bmr::ContactEvents events = recorder.Take();
        health -= DamageTo(player, events, kThreshold);
        score += TakePickups(events, world);
    }
    std::printf("score %d, health %.0f, %s the platform\n", score, static_cast<double>(health),
                player->GetPosition().y > kTop ? "on" : "below");
}
