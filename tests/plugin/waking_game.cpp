// SPDX-License-Identifier: MIT
//
//   waking_game hit|joint|flags|first|last|empty|driven|slept|displaced|order|lapsed
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
//   driven  sleepers are woken while islands are built, by a joint or by who touches them, and moved so far
//           that they get contacts in that very step
//   slept   contacts are disabled until their bodies fall asleep; these are then driven at walls
//   displaced  bullets hit a floor in one step after the other; all else sleeps
//   lapsed  two that sleep come to touch when nobody looks, by an impact or in a step that is Box2D's alone;
//           islands come to them by a joint
//   order   bodies go, and as many come, at the places of those in memory: in another order
#include <cfenv>
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

b2Body *AddDisk(b2World *world, float x, float y) {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(x, y);
    b2Body *body = world->CreateBody(&def);
    b2CircleShape shape;
    shape.m_radius = 0.5f;
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

/// Far away: hundreds of boxes that sleep, and pairs that never do.
void AddOthers(b2World *world) {
    for (int i = 0; i < 600; ++i)
        AddBox(world, 3.0f * static_cast<float>(i), 300.0f)->SetAwake(false);
    for (int i = 0; i < 20; ++i)
        for (const float y : {400.0f, 401.05f})
            AddBox(world, 3.0f * static_cast<float>(i), y)->SetSleepingAllowed(false);
}

void Driven() {
    b2World world(b2Vec2(0.0f, 0.0f));
    AddOthers(&world);
    std::vector<b2Body *> drivers;
    for (int i = 0; i < 12; ++i) {
        const float y = 4.0f * static_cast<float>(i);
        const bool joined = i % 2 == 0;
        drivers.push_back(AddBox(&world, joined ? 8.0f : -0.99f, y));
        b2Body *const driven = AddBox(&world, 0.0f, y);
        AddBox(&world, b2_staticBody, 1.6f, y + 0.3f, 0.5f, 0.5f); // in its way
        if (!joined)
            continue;
        b2DistanceJointDef joint;
        joint.Initialize(drivers.back(), driven, drivers.back()->GetPosition(), driven->GetPosition());
        world.CreateJoint(&joint);
    }
    Run(&world, 90);
    for (b2Body *driver : drivers) {
        driver->SetAwake(true);
        driver->SetLinearVelocity(b2Vec2(60.0f, 0.0f));
        Run(&world, 1);
        for (b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
            if (body->IsSleepingAllowed())
                body->SetAwake(false);
    }
}

/// Box2D enables contacts of bodies that are awake, also in the step in which they fall asleep. Their joints
/// pull them at thin walls when they are woken.
void Slept(bool continuous) {
    b2World world(b2Vec2(0.0f, 0.0f));
    AddOthers(&world);
    std::vector<b2Body *> drivers, driven;
    for (int i = 0; i < 12; ++i) {
        const float y = 4.0f * static_cast<float>(i);
        drivers.push_back(AddBox(&world, 8.0f, y));
        driven.push_back(AddBox(&world, 0.0f, y));
        AddBox(&world, b2_staticBody, 0.6f, y, 0.02f, 1.0f);
        b2DistanceJointDef joint;
        joint.Initialize(drivers.back(), driven.back(), drivers.back()->GetPosition(),
                         driven.back()->GetPosition());
        world.CreateJoint(&joint);
    }
    Run(&world, 3);
    world.SetContinuousPhysics(continuous);
    while (driven.front()->IsAwake()) {
        for (b2Body *body : driven)
            for (b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
                edge->contact->SetEnabled(false);
        Run(&world, 1);
    }
    world.SetContinuousPhysics(true);
    for (b2Body *driver : drivers) {
        driver->SetAwake(true);
        driver->SetLinearVelocity(b2Vec2(60.0f, 0.0f));
        Run(&world, 1);
    }
}

/// `upward`: some of the steps are rounded so, and are Box2D's alone.
void Displaced(bool upward) {
    b2World world(b2Vec2(0.0f, 0.0f));
    AddOthers(&world);
    AddBox(&world, b2_staticBody, 0.0f, 0.0f, 60.0f, 0.02f);
    for (int i = 0; i < 16; ++i) { // two hit in steps that follow each other, the second one earlier in its
                                   // step; none in the next
        const float hit = static_cast<float>(3 * (i / 2) + 4) + (i % 2 == 0 ? 0.6f : 1.3f);
        b2Body *const bullet =
            AddBox(&world, b2_dynamicBody, 3.0f * static_cast<float>(i - 8), 0.12f + hit, 0.1f, 0.1f);
        bullet->SetBullet(true);
        bullet->SetLinearVelocity(b2Vec2(0.0f, -60.0f));
    }
    for (int i = 0; i < 32; ++i) {
        std::fesetround(upward && i % 3 == 1 ? FE_UPWARD : FE_TONEAREST);
        Run(&world, 1);
    }
    std::fesetround(FE_TONEAREST);
}

void Order() {
    b2World world(b2Vec2(0.0f, 0.0f));
    AddOthers(&world);
    for (int i = 0; i < 8; ++i)
        AddBox(&world, b2_staticBody, 4.0f * static_cast<float>(i), 0.0f, 0.5f, 0.5f);
    Run(&world, 3);
    for (int round = 0; round < 6; ++round) {
        // Each comes near a wall in the same step: every other one touches it.
        const auto add = [&world](int i) {
            b2Body *const body =
                AddBox(&world, 4.0f * static_cast<float>(i) + (i % 2 == 0 ? 0.0f : 0.9f), 1.5f);
            body->SetLinearVelocity(b2Vec2(0.0f, i % 2 == 0 ? -30.0f : -24.0f));
            return body;
        };
        std::vector<b2Body *> bodies;
        for (int i = 0; i < 8; ++i)
            bodies.push_back(add(i));
        for (b2Body *body : bodies)
            body->SetLinearVelocity(b2Vec2(0.0f, 0.0f));
        Run(&world, 1);
        for (const size_t i : {size_t{7}, size_t{2}})
            world.DestroyBody(bodies[i]);
        bodies[2] = add(2);
        bodies[7] = add(7);
        for (size_t i = 0; i < bodies.size(); ++i)
            bodies[i]->SetLinearVelocity(b2Vec2(0.0f, i % 2 == 0 ? -30.0f : -24.0f));
        Run(&world, 3);
        for (b2Body *body : bodies)
            world.DestroyBody(body);
    }
}

enum class Lapse { kRounded, kImpact, kRoundedImpact };

/// When nobody knows that the two touch, nobody takes their contact out of an island of an earlier step.
void Lapsed(Lapse lapse) {
    b2World world(b2Vec2(0.0f, 0.0f));
    world.SetContinuousPhysics(lapse != Lapse::kRounded);
    AddOthers(&world);
    b2Body *const bullet = AddBox(&world, b2_dynamicBody, -3.0f, 0.0f, 0.3f, 0.3f);
    b2Body *const pulling = AddBox(&world, 0.0f, 5.0f);
    b2Body *const one = AddDisk(&world, 0.0f, 0.0f), *const other = AddDisk(&world, 1.03f,
                                                                            0.0f); // (of boxes we are told)
    b2DistanceJointDef joint;
    joint.Initialize(pulling, one, pulling->GetPosition(), one->GetPosition());
    world.CreateJoint(&joint);
    for (const float x : {0.0f, 0.99f}) // touch, so that a listener is called ahead of impacts
        AddBox(&world, x, 200.0f)->SetSleepingAllowed(false);
    Listener listener;
    listener.afterIslands = [] { std::fesetround(FE_UPWARD); };
    const auto sleep = [&] {
        for (b2Body *body : {bullet, pulling, one, other})
            body->SetAwake(false);
    };
    Run(&world, 1);
    sleep();
    Run(&world, 4);
    if (lapse == Lapse::kRounded) {
        std::fesetround(FE_UPWARD);
        one->SetAwake(true);
        one->SetLinearVelocity(b2Vec2(3.0f, 0.0f));
        Run(&world, 4);
        std::fesetround(FE_TONEAREST);
    } else {
        if (lapse == Lapse::kRoundedImpact)
            world.SetContactListener(&listener);
        one->SetBullet(true);
        bullet->SetBullet(true);
        bullet->SetLinearVelocity(b2Vec2(100.0f, 0.0f));
        for (int i = 0; i < 2; ++i) {
            Run(&world, 1);
            std::fesetround(FE_TONEAREST);
        }
        world.SetContactListener(nullptr);
        one->SetBullet(false);
        bullet->SetTransform(b2Vec2(-50.0f, 0.0f), 0.0f);
    }
    for (int i = 0; i < 3; ++i) {
        sleep();
        if (lapse != Lapse::kRounded)
            Run(&world, 1);
        pulling->SetAwake(true);
        pulling->SetLinearVelocity(b2Vec2(0.0f, 20.0f));
        Run(&world, 1);
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
    } else if (what == "driven") {
        Driven();
    } else if (what == "slept") {
        Slept(true);
        Slept(false);
    } else if (what == "displaced") {
        Displaced(false);
        Displaced(true);
    } else if (what == "lapsed") {
        for (const Lapse lapse : {Lapse::kRounded, Lapse::kImpact, Lapse::kRoundedImpact})
            Lapsed(lapse);
    } else if (what == "order") {
        Order();
    } else {
        std::fputs(
            "usage: waking_game hit|joint|flags|first|last|empty|driven|slept|displaced|order|lapsed\n",
            stderr);
        return 2;
    }
    return 0;
}
