// SPDX-License-Identifier: MIT
// A Box2D program that knows nothing of Boomerang: boxes that fall on planks past a sensor, bullets between
// them. It prints what happened, to the last bit.
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <initializer_list>

#include <box2d/box2d.h>

namespace {

constexpr int kSteps = 240;

b2Body *AddBox(b2World &world, b2BodyType type, b2Vec2 at, b2Vec2 half, float angle, bool sensor = false) {
    b2BodyDef def;
    def.type = type;
    def.position = at;
    def.angle = angle;
    b2Body *body = world.CreateBody(&def);
    b2PolygonShape box;
    box.SetAsBox(half.x, half.y);
    b2FixtureDef fixture;
    fixture.shape = &box;
    fixture.density = 1.0f;
    fixture.isSensor = sensor;
    body->CreateFixture(&fixture);
    return body;
}

class Counter : public b2ContactListener {
public:
    void BeginContact(b2Contact *) override { ++begun; }
    void EndContact(b2Contact *) override { ++ended; }
    int begun = 0, ended = 0;
};

uint64_t Mix(uint64_t hash, float value) {
    uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return (hash ^ bits) * UINT64_C(1099511628211);
}

} // namespace

int main() {
    b2World world(b2Vec2(0.0f, -10.0f));
    Counter counter;
    world.SetContactListener(&counter);
    for (int i = 0; i < 6; ++i) {
        const float x = static_cast<float>(i);
        AddBox(world, b2_staticBody, {6.0f * (x - 2.5f), -x}, {3.5f, 0.2f}, 0.15f * (x - 2.5f));
    }
    AddBox(world, b2_staticBody, {0.0f, 6.0f}, {12.0f, 0.5f}, 0.0f, true);
    for (int i = 0; i < 60; ++i) {
        const float x = static_cast<float>(i % 10), y = static_cast<float>(i / 10);
        b2Body *box =
            AddBox(world, b2_dynamicBody, {2.3f * (x - 4.5f), 8.0f + 1.3f * y}, {0.4f, 0.3f}, 0.3f * x);
        if (i % 7 == 0) {
            box->SetBullet(true);
            box->SetLinearVelocity({0.0f, -60.0f});
        }
    }
    uint64_t hash = UINT64_C(14695981039346656037);
    for (int step = 0; step < kSteps; ++step) {
        world.Step(1.0f / 60.0f, 8, 3);
        for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
            for (const float value : {body->GetPosition().x, body->GetPosition().y, body->GetAngle(),
                                      body->GetLinearVelocity().x, body->GetAngularVelocity()})
                hash = Mix(hash, value);
    }
    std::printf("%016" PRIx64 " begun %d ended %d\n", hash, counter.begun, counter.ended);
    return 0;
}
