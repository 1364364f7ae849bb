// SPDX-License-Identifier: MIT
//
//   waking_game hit|joint|flags|first|last|empty
//
// Worlds in which hundreds of bodies sleep, and some are woken by what is easily overlooked. Prints a line
// for each step: how many bodies are awake, how many contacts touch, and a hash of all bodies and contacts. A
// plain program of Box2D's: with the plugin preloaded it prints the same.
//
//   hit     the top of a stack is taken away in the step in which it wakes: the end of its contact
//           wakes the rest, in the midst of the loop over contacts
//   joint   a sleeper is made a bullet, and is woken by a joint while islands are built
//   flags   PostSolve wakes pairs that had been in an island when they fell asleep
//   first   BeginContact and PreSolve of the newest contact wake pairs that are older: the loop is
//           still to come by
//   last    those of the oldest contact do: the loop has come by
//   empty   the world loses its contacts, its moving bodies, all of its bodies; and gets others
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include <box2d/box2d.h>

namespace {

class Hash {
public:
    void Add(float value) {
        uint32_t word;
        std::memcpy(&word, &value, sizeof word);
        m_value = (m_value ^ word) * 1099511628211u;
    }
    void Add(bool value) { m_value = (m_value ^ (value ? 1u : 2u)) * 1099511628211u; }
    uint64_t Value() const { return m_value; }

private:
    uint64_t m_value = 1469598103934665603u;
};

b2Body *AddBox(b2World *world, b2BodyType type, float x, float y, float halfWidth, float halfHeight) {
    b2BodyDef def;
    def.type = type;
    def.position.Set(x, y);
    b2Body *body = world->CreateBody(&def);
    b2PolygonShape shape;
    shape.SetAsBox(halfWidth, halfHeight);
    body->CreateFixture(&shape, 1.0f);
    return body;
}

b2Body *AddBox(b2World *world, float x, float y) {
    return AddBox(world, b2_dynamicBody, x, y, 0.5f, 0.5f);
}

void Run(b2World *world, int steps) {
    for (int i = 0; i < steps; ++i) {
        world->Step(1.0f / 60.0f, 8, 3);
        Hash hash;
        int awake = 0, touching = 0;
        for (const b2Body *body = world->GetBodyList(); body != nullptr; body = body->GetNext()) {
            awake += body->IsAwake() ? 1 : 0;
            hash.Add(body->IsAwake());
            for (const float value :
                 {body->GetPosition().x, body->GetPosition().y, body->GetAngle(), body->GetLinearVelocity().x,
                  body->GetLinearVelocity().y, body->GetAngularVelocity()})
                hash.Add(value);
        }
        for (const b2Contact *c = world->GetContactList(); c != nullptr; c = c->GetNext()) {
            touching += c->IsTouching() ? 1 : 0;
            hash.Add(c->IsTouching());
        }
        std::printf("%d awake, %d touch, %016" PRIx64 "\n", awake, touching, hash.Value());
    }
}

void Hit() {
    constexpr int kStacks = 150, kHigh = 3;
    b2World world(b2Vec2(0.0f, -10.0f));
    AddBox(&world, b2_staticBody, 0.0f, -1.0f, 500.0f, 1.0f);
    std::vector<b2Body *> boxes;
    for (int i = 0; i < kStacks; ++i)
        for (int k = 0; k < kHigh; ++k)
            boxes.push_back(
                AddBox(&world, -200.0f + 1.06f * static_cast<float>(i), 0.5f + static_cast<float>(k)));
    AddBox(&world, 350.0f, 3.0f)->SetSleepingAllowed(false);
    Run(&world, 300);
    for (int i = 0; i < 12; ++i) {
        b2Body *const top = boxes[static_cast<size_t>(kHigh * (5 * i + 3) + kHigh - 1)];
        top->SetAwake(true);
        top->SetTransform(b2Vec2(0.0f, 60.0f + 2.0f * static_cast<float>(i)), 0.0f);
        Run(&world, 5);
    }
}

void Joint() {
    constexpr int kTrios = 20;
    b2World world(b2Vec2(0.0f, 0.0f));
    for (int i = 0; i < 30; ++i)
        for (int j = 0; j < 2; ++j)
            AddBox(&world, b2_dynamicBody, -100.0f + 3.0f * static_cast<float>(i),
                   50.0f + 0.9f * static_cast<float>(j), 0.4f, 0.4f)
                ->SetSleepingAllowed(false);
    std::vector<b2Body *> pulling, pulled;
    for (int i = 0; i < kTrios; ++i) {
        const float y = -10.0f * static_cast<float>(i);
        pulling.push_back(AddBox(&world, b2_dynamicBody, -3.0f, y, 0.2f, 0.2f));
        pulled.push_back(AddBox(&world, b2_dynamicBody, 0.0f, y, 0.05f, 0.05f));
        AddBox(&world, b2_dynamicBody, 0.2f, y, 0.02f, 1.0f); // a thin plate
        b2DistanceJointDef joint;
        joint.Initialize(pulling.back(), pulled.back(), pulling.back()->GetPosition(),
                         pulled.back()->GetPosition());
        world.CreateJoint(&joint);
    }
    Run(&world, 120);
    for (size_t i = 0; i < pulling.size(); ++i) {
        pulled[i]->SetBullet(true);
        pulling[i]->SetAwake(true);
        pulling[i]->SetLinearVelocity(b2Vec2(60.0f, 0.0f));
        Run(&world, 3);
    }
}

class Listener final : public b2ContactListener {
public:
    std::function<void()> inLoop, afterIslands;
    void BeginContact(b2Contact *) override { Call(inLoop); }
    void PreSolve(b2Contact *, const b2Manifold *) override { Call(inLoop); }
    void PostSolve(b2Contact *, const b2ContactImpulse *) override { Call(afterIslands); }

private:
    static void Call(const std::function<void()> &what) {
        if (what)
            what();
    }
};

/// Pairs of boxes that touch and sleep, and two more that are thrown at each other again and again: what
/// their contact calls wakes the pairs, one after another.
void WakePairs(bool driversFirst, bool again, bool inLoop) {
    constexpr int kPairs = 200, kWoken = 100;
    b2World world(b2Vec2(0.0f, 0.0f));
    b2Body *drivers[2] = {nullptr, nullptr};
    const auto addDrivers = [&world, &drivers] {
        drivers[0] = AddBox(&world, -400.0f, 0.0f);
        drivers[1] = AddBox(&world, -399.1f, 0.0f);
    };
    if (driversFirst)
        addDrivers();
    std::vector<b2Body *> pairs;
    for (int i = 0; i < kPairs; ++i)
        for (const float x : {0.0f, 0.99f})
            pairs.push_back(AddBox(&world, -300.0f + 3.0f * static_cast<float>(i) + x, 0.0f));
    if (!driversFirst)
        addDrivers();
    Run(&world, 150);
    if (again) { // in an island of few that are awake, and asleep once more
        for (size_t i = 0; i < 30; ++i)
            pairs[i]->SetAwake(true);
        Run(&world, 90);
    }
    Listener listener;
    world.SetContactListener(&listener);
    size_t woken = 0;
    const auto wake = [&woken, &pairs] {
        if (woken == 2 * kWoken)
            return;
        pairs[woken]->SetAwake(true);
        pairs[woken]->SetLinearVelocity(b2Vec2(3.0f, 0.5f));
        if (woken % 4 == 0) {
            pairs[woken + 1]->SetAwake(true);
            pairs[woken + 1]->SetLinearVelocity(b2Vec2(-3.0f, 0.0f));
        }
        woken += 2;
    };
    (inLoop ? listener.inLoop : listener.afterIslands) = wake;
    for (int i = 0; i < 20; ++i) {
        for (const int side : {0, 1}) {
            drivers[side]->SetAwake(true);
            drivers[side]->SetTransform(b2Vec2(side == 0    ? -400.0f
                                               : i % 2 != 0 ? -398.7f
                                                            : -399.1f,
                                               0.0f),
                                        0.0f);
            drivers[side]->SetLinearVelocity(b2Vec2(side == 0 ? 1.0f : -1.0f, 0.0f));
        }
        Run(&world, i % 4 == 0 ? 4 : 1);
    }
}

/// A field of boxes of which every other pair touches.
void AddField(b2World *world, int count) {
    for (int i = 0; i < count; ++i)
        AddBox(world, 1.8f * static_cast<float>(i) - (i % 4 == 1 ? 0.85f : 0.0f), 0.0f);
}

void DestroyBodies(b2World *world, bool staticToo) {
    for (b2Body *body = world->GetBodyList(); body != nullptr;) {
        b2Body *const next = body->GetNext();
        if (staticToo || body->GetType() != b2_staticBody)
            world->DestroyBody(body);
        body = next;
    }
}

void Empty() {
    b2World world(b2Vec2(0.0f, -10.0f));
    for (const int count : {40, 300, 40}) {
        AddBox(&world, b2_staticBody, 0.0f, -1.0f, 900.0f, 0.5f);
        AddField(&world, count);
        Run(&world, 100);
        for (b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
            if (body->GetType() != b2_staticBody) // out of reach of each other
                body->SetTransform(b2Vec2(3.0f * body->GetPosition().x, 50.0f), 0.0f);
        Run(&world, 3);
        DestroyBodies(&world, false);
        Run(&world, 2);
        AddField(&world, count);
        Run(&world, 20);
        DestroyBodies(&world, true);
        Run(&world, 3);
    }
    // Ended in the midst of a step: one of no time unlocks the world for a listener.
    Listener listener;
    world.SetContactListener(&listener);
    for (const bool inLoop : {false, true}) {
        AddBox(&world, b2_staticBody, 0.0f, -1.0f, 900.0f, 0.5f);
        AddField(&world, 300);
        Run(&world, 60);
        int calls = 0;
        (inLoop ? listener.inLoop : listener.afterIslands) = [&world, &calls] {
            if (++calls == 1)
                world.Step(0.0f, 0, 0);
        };
        Run(&world, 2);
        listener.inLoop = listener.afterIslands = nullptr;
        DestroyBodies(&world, true);
        Run(&world, 3);
    }
}

} // namespace

int main(int argc, char **argv) {
    const std::string what = argc == 2 ? argv[1] : "";
    if (what == "hit") {
        Hit();
    } else if (what == "joint") {
        Joint();
    } else if (what == "flags") {
        WakePairs(false, true, false);
    } else if (what == "first") {
        WakePairs(false, false, true);
    } else if (what == "last") {
        WakePairs(true, false, true);
    } else if (what == "empty") {
        Empty();
    } else {
        std::fputs("usage: waking_game hit|joint|flags|first|last|empty\n", stderr);
        return 2;
    }
    return 0;
}
