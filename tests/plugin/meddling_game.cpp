// SPDX-License-Identifier: MIT
// Games whose listeners and filters change the world in the middle of a step, in ways that Box2D allows.
//
//   meddling_game disabling   a listener puts bodies out of the world while Box2D looks for impacts
//   meddling_game turning     a sensor whose vertices were changed turns solid in the middle of a step
//   meddling_game editing     a listener changes vertices of bodies that were asked for in the same step
//   meddling_game proxies     a filter puts a body out of the world that is about to get contacts
//   meddling_game ends        a filter, and a listener, end contacts that are still to be come by
//   meddling_game unknown     a listener steps the world while a contact ends that nobody was told of
#include <cfenv>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "small_world.h"

namespace {

b2Fixture *FixtureOf(b2Body *body, int index) {
    b2Fixture *fixture = body->GetFixtureList();
    for (; index > 0; --index)
        fixture = fixture->GetNext();
    return fixture;
}

/// A wheel's triangle in another size: its inner corner stays, the other two go out to `reach`.
void Resize(b2Fixture *fixture, float reach) {
    auto *shape = static_cast<b2PolygonShape *>(fixture->GetShape());
    const float radius = shape->m_radius;
    const float middle = std::atan2(shape->m_centroid.y, shape->m_centroid.x);
    const b2Vec2 corners[3] = {
        {0.0f, 0.0f}, reach * b2Rot(middle - 0.15f).GetXAxis(), reach * b2Rot(middle + 0.15f).GetXAxis()};
    shape->Set(corners, 3);
    shape->m_radius = radius;
}

/// A step of no time unlocks the world that is being stepped: from then on Box2D lets the listener do
/// whatever may be done between steps.
class Disabler : public b2ContactListener {
public:
    explicit Disabler(b2World *world) : m_world(world) { world->SetContactListener(this); }
    void BeginContact(b2Contact *contact) override {
        if (m_inside)
            return;
        m_inside = true;
        if (m_world->IsLocked())
            m_world->Step(0.0f, 1, 1);
        else if (++m_begun % 3 == 0)
            PutOut(*contact);
        m_inside = false;
    }
    int putOut = 0;

private:
    /// The next body in turn that touches nobody, and not one of the contact that begins: Box2D has a use for
    /// those.
    void PutOut(const b2Contact &contact) {
        int32 left = m_world->GetBodyCount();
        for (b2Body *body = m_next; left-- > 0; body = body->GetNext()) {
            if (body == nullptr)
                body = m_world->GetBodyList();
            if (!body->IsEnabled() || body->GetContactList() == nullptr ||
                body->GetType() != b2_dynamicBody || body == contact.GetFixtureA()->GetBody() ||
                body == contact.GetFixtureB()->GetBody() || TouchesAnybody(*body))
                continue;
            m_next = body->GetNext();
            body->SetEnabled(false);
            ++putOut;
            return;
        }
    }
    static bool TouchesAnybody(const b2Body &body) {
        for (const b2ContactEdge *edge = body.GetContactList(); edge != nullptr; edge = edge->next)
            if (edge->contact->IsTouching())
                return true;
        return false;
    }

    b2World *m_world;
    b2Body *m_next = nullptr;
    int m_begun = 0;
    bool m_inside = false;
};

/// Bullets and boxes in a crowd over planks; every few steps, all that were put out come back.
void PlayDisabling() {
    b2World world(b2Vec2(0.0f, -10.0f));
    for (int i = 0; i < 6; ++i)
        AddBox(world, b2_staticBody, {3.0f * static_cast<float>(i) - 8.0f, 0.0f}, {1.2f, 0.1f},
               0.2f * static_cast<float>(i));
    for (int i = 0; i < 120; ++i) {
        const float x = static_cast<float>(i % 20), y = static_cast<float>(i / 20);
        b2Body *box =
            AddBox(world, b2_dynamicBody, {0.8f * x - 8.0f, 2.0f + 0.8f * y}, {0.3f, 0.2f}, 0.3f * x);
        box->SetBullet(i % 2 == 0);
        box->SetLinearVelocity({5.0f * static_cast<float>(i % 7) - 15.0f, -60.0f});
    }
    Disabler listener(&world);
    Hash hash;
    for (int step = 0; step < 200; ++step) {
        Step(world, 1, &hash);
        if (step % 10 != 9)
            continue;
        Print("disabling", hash);
        for (b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
            if (!body->IsEnabled())
                body->SetEnabled(true);
            if (body->GetType() == b2_dynamicBody && body->GetPosition().y < -3.0f) {
                body->SetTransform({body->GetPosition().x, 8.0f}, body->GetAngle());
                body->SetLinearVelocity({10.0f, -80.0f});
            }
        }
    }
    std::printf("%d put out\n", listener.putOut);
}

/// Wheels of many fixtures side by side, so that the contacts of two of them share their hulls, and a pair of
/// boxes apart from them whose contact is new in every step: it is the first to be updated, and begins.
class Wheels {
public:
    Wheels() : world(b2Vec2(0.0f, 0.0f)) {
        for (int i = 0; i < kWheels; ++i) {
            wheels[i] =
                AddWheel(world, {2.12f * static_cast<float>(i % 3), 2.12f * static_cast<float>(i / 3)},
                         kFixtures, 1.0f);
            wheels[i]->SetAngularVelocity(i % 2 == 0 ? 0.4f : -0.3f);
            wheels[i]->SetSleepingAllowed(false);
            for (b2Fixture *f = wheels[i]->GetFixtureList(); f != nullptr; f = f->GetNext())
                f->SetRestitution(1.0f);
        }
        for (const float side : {-1.0f, 1.0f}) {
            AddBox(world, b2_staticBody, {2.12f + 3.6f * side, 2.12f}, {0.5f, 4.0f}, 0.0f);
            AddBox(world, b2_staticBody, {2.12f, 2.12f + 3.6f * side}, {4.0f, 0.5f}, 0.0f);
        }
    }
    void RingFirst() {
        if (m_bell != nullptr)
            world.DestroyBody(m_bell);
        m_bell = AddBox(world, b2_dynamicBody, {30.0f, 0.0f}, {0.5f, 0.5f}, 0.0f);
        if (m_anvil == nullptr)
            m_anvil = AddBox(world, b2_staticBody, {30.2f, 0.3f}, {0.5f, 0.5f}, 0.0f);
    }
    bool IsBell(const b2Contact &contact) const {
        return contact.GetFixtureA()->GetBody() == m_bell || contact.GetFixtureB()->GetBody() == m_bell;
    }

    static constexpr int kWheels = 9, kFixtures = 16;
    b2World world;
    b2Body *wheels[kWheels];

private:
    b2Body *m_bell = nullptr, *m_anvil = nullptr;
};

class TurnsSolid : public b2ContactListener {
public:
    void PreSolve(b2Contact *, const b2Manifold *) override {
        if (sensor != nullptr)
            sensor->SetSensor(false);
    }
    b2Fixture *sensor = nullptr;
};

b2Fixture *AddTooth(b2Body *body, int place, float height) {
    b2PolygonShape tooth;
    tooth.SetAsBox(0.2f, 0.5f * height, {0.5f * static_cast<float>(place), 0.0f}, 0.0f);
    return body->CreateFixture(&tooth, 1.0f);
}

/// Two combs, apart from each other. The contacts of the first teeth are the oldest, so they are updated
/// last; then come those of two boxes that touch; then those of the other teeth, which the hulls of the combs
/// answer for. In between, the touching boxes' listener makes a tooth solid that was a sensor, in no hull,
/// when the hulls were looked at, and that has grown since it was in one.
void PlayTurning(float grown) {
    b2World world(b2Vec2(0.0f, 0.0f));
    TurnsSolid listener;
    world.SetContactListener(&listener);
    Hash hash;
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.allowSleep = false;
    b2Body *lower = world.CreateBody(&def);
    def.position.Set(0.0f, 1.1f);
    b2Body *upper = world.CreateBody(&def);
    b2Fixture *growing = AddTooth(lower, 0, 1.0f);
    for (int i = 0; i < 12; ++i)
        AddTooth(upper, i, 1.0f);
    Step(world, 1, &hash);
    AddBox(world, b2_staticBody, {-30.0f, 0.0f}, {1.0f, 1.0f}, 0.0f);
    AddBox(world, b2_dynamicBody, {-30.0f, 1.99f}, {1.0f, 1.0f}, 0.0f)->SetSleepingAllowed(false);
    Step(world, 1, &hash);
    for (int i = 1; i < 12; ++i)
        AddTooth(lower, i, 1.0f);
    Step(world, 3, &hash);
    growing->SetSensor(true);
    static_cast<b2PolygonShape *>(growing->GetShape())->SetAsBox(0.2f, 0.5f * grown);
    listener.sensor = growing;
    for (int step = 0; step < 5; ++step) {
        Step(world, 1, &hash);
        Print("turning", hash);
    }
}

class Editor : public b2ContactListener {
public:
    explicit Editor(Wheels *wheels) : m_wheels(wheels) {}
    void PreSolve(b2Contact *, const b2Manifold *) override {
        if (++m_told % 5 == 0)
            Resize(FixtureOf(m_wheels->wheels[m_told % Wheels::kWheels], m_told * 3 % Wheels::kFixtures),
                   m_told % 2 == 0 ? 1.2f : 0.95f);
    }

private:
    Wheels *m_wheels;
    int m_told = 0;
};

void PlayEditing() {
    Wheels wheels;
    Editor listener(&wheels);
    wheels.world.SetContactListener(&listener);
    Hash hash;
    for (int step = 0; step < 300; ++step) {
        wheels.RingFirst();
        Step(wheels.world, 1, &hash);
        if (step % 30 == 29)
            Print("editing", hash);
    }
}

void PlayProxies() {
    b2World world(b2Vec2(0.0f, 0.0f));
    PutsOut filter;
    world.SetContactFilter(&filter);
    // Their places in the tree are given again to what comes later, which so has lower numbers than the
    // floor.
    b2Body *first[300];
    for (int i = 0; i < 300; ++i)
        first[i] =
            AddBox(world, b2_dynamicBody, {100.0f + 3.0f * static_cast<float>(i), 0.0f}, {0.1f, 0.1f}, 0.0f);
    b2Body *floor = AddBox(world, b2_staticBody, {0.0f, 0.0f}, {40.0f, 1.0f}, 0.0f);
    for (b2Body *body : first)
        world.DestroyBody(body);
    Hash hash;
    Step(world, 1, &hash);
    for (int round = 0; round < 6; ++round) {
        for (int i = 0; i < 40; ++i)
            AddBox(world, b2_dynamicBody,
                   {2.0f * static_cast<float>(i) - 39.0f, 0.5f + 0.1f * static_cast<float>(round)},
                   {0.05f, 0.05f}, 0.0f);
        b2Body *wheel = AddWheel(world, {4.0f * static_cast<float>(round) - 12.0f, 0.5f}, 7, 0.4f);
        filter.victim = wheel;
        Step(world, 1, &hash);
        int32 contacts = 0;
        for (const b2ContactEdge *edge = wheel->GetContactList(); edge != nullptr; edge = edge->next)
            contacts += edge->other == floor ? 1 : 0;
        std::printf("%d contacts of a body that is out of the world\n", static_cast<int>(contacts));
        Print("proxies", hash);
        world.DestroyBody(wheel);
    }
}

/// Does once, in a filter, which then refuses, or in a PreSolve, what is to be done.
class Once final : public b2ContactFilter, public b2ContactListener {
public:
    std::function<void()> inFilter, inPreSolve;
    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override {
        return !Call(&inFilter) && b2ContactFilter::ShouldCollide(a, b);
    }
    void PreSolve(b2Contact *, const b2Manifold *) override { Call(&inPreSolve); }

private:
    static bool Call(std::function<void()> *what) {
        if (!*what)
            return false;
        std::exchange(*what, nullptr)();
        return true;
    }
};

/// Another type of body ends its contacts. Those whose boxes were found to overlap before are made anew.
void PlayEnds() {
    b2World world(b2Vec2(0.0f, 0.0f));
    Once once;
    world.SetContactFilter(&once);
    world.SetContactListener(&once);
    Hash hash;
    std::vector<b2Body *> ones;
    for (int i = 0; i < 80; ++i)
        for (const float y : {0.0f, i % 4 == 0 ? 0.79f : 0.9f}) {
            ones.push_back(
                AddBox(world, b2_dynamicBody, {3.0f * static_cast<float>(i), y}, {0.4f, 0.4f}, 0.0f));
            ones.back()->SetSleepingAllowed(false);
        }
    Step(world, 4, &hash);
    Print("ends", hash);
    // The step begins with a search for new contacts, ahead of all that locks the world.
    for (const float x : {0.0f, 0.9f})
        AddBox(world, b2_dynamicBody, {x, 50.0f}, {0.4f, 0.4f}, 0.0f)->SetSleepingAllowed(false);
    once.inFilter = [&ones] {
        for (size_t i = 0; i < ones.size(); i += 8)
            ones[i]->SetType(b2_kinematicBody);
    };
    for (size_t i = 0; i < ones.size(); i += 4)
        ones[i]->SetTransform(ones[i]->GetPosition() + b2Vec2(0.4f, 0.0f), 0.0f);
    Step(world, 3, &hash);
    Print("ends", hash);
    for (const bool again : {false, true}) { // as many as end are made, before the loop goes on
        once.inPreSolve = [&world, &ones, again] {
            world.Step(0.0f, 1, 1); // unlocks it
            for (size_t i = again ? 42 : 2; i < (again ? 80 : 40); i += 2)
                ones[i]->SetType(ones[i]->GetType() == b2_kinematicBody ? b2_dynamicBody : b2_kinematicBody);
            if (again)
                world.Step(1.0f / 240.0f, 1, 1);
        };
        for (int i = 0; i < 5; ++i) {
            Step(world, 1, &hash);
            Print("ends", hash);
        }
    }
}

/// Is told of an end.
class AtEnd final : public b2ContactListener {
public:
    std::function<void()> what;
    void EndContact(b2Contact *) override {
        if (what)
            std::exchange(what, nullptr)();
    }
};

/// Two come to touch in a step that is rounded upward. Their contact, which was made in that step, ends by a
/// change of type. The next contact gets its place in memory.
void PlayUnknown() {
    b2World world(b2Vec2(0.0f, 0.0f));
    AtEnd listener;
    Hash hash;
    const auto add = [&world](float x, float y) {
        b2Body *const body = AddBox(world, b2_dynamicBody, {x, y}, {0.4f, 0.4f}, 0.0f);
        body->SetSleepingAllowed(false);
        return body;
    };
    for (int i = 0; i < 80; ++i)
        add(3.0f * static_cast<float>(i / 2), 0.9f * static_cast<float>(i % 2));
    Step(world, 3, &hash);
    b2Body *const one = add(-50.0f, 0.0f);
    add(-50.79f, 0.0f);
    std::fesetround(FE_UPWARD);
    world.Step(0.0f, 1, 1);
    std::fesetround(FE_TONEAREST);
    world.SetContactListener(&listener);
    listener.what = [&world] { world.Step(0.0f, 1, 1); };
    one->SetType(b2_kinematicBody);
    one->SetTransform({-60.0f, 0.0f}, 0.0f);
    add(-70.0f, 0.0f);
    b2Body *const comes = add(-70.9f, 0.0f);
    Step(world, 3, &hash);
    Print("unknown", hash);
    comes->SetLinearVelocity({1.5f, 0.0f});
    for (int i = 0; i < 8; ++i) {
        Step(world, 1, &hash);
        Print("unknown", hash);
    }
}

} // namespace

int main(int argc, char **argv) {
    const std::string what = argc == 2 ? argv[1] : "";
    if (what == "disabling")
        PlayDisabling();
    else if (what == "turning")
        for (const float grown : {1.0f, 1.3f, 1.6f})
            PlayTurning(grown);
    else if (what == "editing")
        PlayEditing();
    else if (what == "proxies")
        PlayProxies();
    else if (what == "ends")
        PlayEnds();
    else if (what == "unknown")
        PlayUnknown();
    else
        return 2;
    return 0;
}
