// SPDX-License-Identifier: MIT
// Games whose contact filter puts another contact listener into the world while b2World::SolveTOI looks for
// new contacts, and one whose listeners do, or take themselves away, in the midst of being told. Each
// listener tells what it is told, and what the world's list of contacts then is. And games whose listeners
// change the contact that they are told of, or step the world while it ends.
#include <vector>

#include "small_world.h"

namespace {

class Teller : public b2ContactListener {
public:
    Teller(uint32_t who, b2World *world, Hash *hash) : m_who(who), m_world(world), m_hash(hash) {}
    void BeginContact(b2Contact *) override { Tell(1); }
    void EndContact(b2Contact *) override { Tell(2); }
    void PreSolve(b2Contact *, const b2Manifold *) override { Tell(3); }
    void PostSolve(b2Contact *, const b2ContactImpulse *) override { Tell(4); }
    uint32_t Told() const { return m_told; }
    /// To be put in its own place, or nobody in one of three calls, whenever it is told of this (1 to 4).
    void GivesWayAt(uint32_t what, b2ContactListener *to) {
        m_givesWayAt = what;
        m_to = to;
    }

private:
    void Tell(uint32_t what) {
        ++m_told;
        if (what == m_givesWayAt)
            m_world->SetContactListener(m_told % 3 == 0 ? nullptr : m_to);
        m_hash->Add(16 * m_who + what);
        uint32_t count = 0;
        for (const b2Contact *contact = m_world->GetContactList(); contact != nullptr;
             contact = contact->GetNext())
            ++count;
        m_hash->Add(count);
    }

    uint32_t m_who, m_told = 0, m_givesWayAt = 0;
    b2ContactListener *m_to = nullptr;
    b2World *m_world;
    Hash *m_hash;
};

/// Between the solving of velocities and the end of a step, pairs come up in SolveTOI alone, once bodies have
/// moved.
class Switch : public b2ContactFilter {
public:
    explicit Switch(b2World *world) : m_world(world) {}
    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override {
        if (first != nullptr && watched->GetPosition() != before) {
            std::swap(first, second);
            m_world->SetContactListener(first);
            ++switches;
        }
        return b2ContactFilter::ShouldCollide(a, b);
    }
    b2ContactListener *first = nullptr, *second = nullptr;
    const b2Body *watched = nullptr;
    b2Vec2 before = {0.0f, 0.0f};
    int switches = 0;

private:
    b2World *m_world;
};

/// Bullets among boxes at rest on planks. `listens`: with a listener from the start.
void Play(const char *name, bool listens) {
    b2World world(b2Vec2(0.0f, -10.0f));
    Hash hash;
    Teller one(1, &world, &hash), two(2, &world, &hash);
    Switch filter(&world);
    world.SetContactFilter(&filter);
    FillWithBoxes(world);
    if (listens)
        world.SetContactListener(&one);
    for (int step = 0; step < 200; ++step) {
        if (step % 10 == 0) {
            b2Body *bullet = AddBox(world, b2_dynamicBody, {0.1f * static_cast<float>(step) - 10.0f, 14.0f},
                                    {0.2f, 0.2f}, 0.4f);
            bullet->SetBullet(true);
            bullet->SetLinearVelocity({30.0f, -120.0f});
            filter.watched = bullet;
            filter.first = listens ? &one : nullptr;
            filter.second = &two;
            if (!listens)
                filter.first = &one;
        }
        filter.before = filter.watched->GetPosition();
        Step(world, 1, &hash);
    }
    Print(name, hash);
    std::printf("%u and %u told, %d switches\n", one.Told(), two.Told(), filter.switches);
}

/// Boxes fall, and listeners take turns: what a contact's update told one of them it tells to its end.
void PlayTurns(uint32_t givesWayAt) {
    b2World world(b2Vec2(0.0f, -10.0f));
    Hash hash;
    Teller one(1, &world, &hash), two(2, &world, &hash);
    one.GivesWayAt(givesWayAt, &two);
    two.GivesWayAt(givesWayAt, &one);
    FillWithBoxes(world);
    for (int step = 0; step < 150; ++step) {
        if (step % 3 == 0) // some have left nobody
            world.SetContactListener(&one);
        Step(world, 1, &hash);
    }
    Print("listeners take turns", hash);
    std::printf("%u and %u told\n", one.Told(), two.Told());
}

/// Disables all contacts when one begins. Then it leaves, or is taken away after the step, for two steps.
class Disabling final : public b2ContactListener {
public:
    Disabling(b2World *world, bool leaves) : m_world(world), m_leaves(leaves) {}
    void BeginContact(b2Contact *) override {
        for (b2Contact *contact = m_world->GetContactList(); contact != nullptr; contact = contact->GetNext())
            contact->SetEnabled(false);
        if (m_leaves)
            m_world->SetContactListener(nullptr);
    }

private:
    b2World *m_world;
    bool m_leaves;
};

void PlayDisabling(bool leaves) {
    b2World world(b2Vec2(0.0f, -10.0f));
    Hash hash;
    Disabling listener(&world, leaves);
    FillWithBoxes(world);
    int disabled = 0;
    for (int step = 0; step < 150; ++step) {
        world.SetContactListener(step % 3 == 0 ? &listener : nullptr);
        Step(world, 1, &hash);
        for (const b2Contact *contact = world.GetContactList(); contact != nullptr;
             contact = contact->GetNext()) {
            hash.Add(static_cast<uint32_t>(contact->IsEnabled()));
            disabled += contact->IsEnabled() ? 0 : 1;
        }
    }
    Print("what a listener disabled", hash);
    std::printf("%d times\n", disabled);
}

/// What the listener does to a contact that touches; Box2D's solver asserts that it is then disabled, or that
/// the step takes no time.
enum class Change {
    kSolid,       ///< it begins, and turns solid
    kStill,       ///< the same, in a step of no time, and stays enabled
    kEmptied,     ///< it loses its points
    kThereAndBack ///< that, and it is a sensor's until the next one is told of; nothing moves
};

class Changing final : public b2ContactListener {
public:
    explicit Changing(Change change) : m_change(change) {}
    void BeginContact(b2Contact *contact) override {
        ++told;
        if (m_change != Change::kSolid && m_change != Change::kStill)
            return;
        SetSensors(contact, false);
        contact->SetEnabled(m_change == Change::kStill);
    }
    void EndContact(b2Contact *) override { ++told; }
    void PreSolve(b2Contact *contact, const b2Manifold *old) override {
        told += 1 + static_cast<uint32_t>(old->pointCount);
        if (m_change == Change::kSolid || m_change == Change::kStill)
            return;
        if (m_change == Change::kThereAndBack)
            contact->SetEnabled(false);
        if (m_turned != nullptr) {
            SetSensors(m_turned, false);
            m_turned = nullptr;
        } else if (told % 2 == 0) {
            contact->SetEnabled(false);
            contact->GetManifold()->pointCount = 0;
            if (m_change == Change::kThereAndBack) {
                SetSensors(contact, true);
                m_turned = contact;
            }
        }
    }
    uint32_t told = 0;

private:
    static void SetSensors(b2Contact *contact, bool sensors) {
        contact->GetFixtureA()->SetSensor(sensors);
        contact->GetFixtureB()->SetSensor(sensors);
    }
    Change m_change;
    b2Contact *m_turned = nullptr;
};

b2Body *AddAwake(b2World &world, b2Vec2 at, b2Vec2 half, bool sensor = false) {
    b2Body *body = AddBox(world, b2_dynamicBody, at, half, 0.0f, sensor);
    body->SetSleepingAllowed(false);
    return body;
}

/// Boxes apart, and boxes that are deep in each other, each beside another one that is near.
void PlayChanging(Change change) {
    const bool sensors = change == Change::kSolid || change == Change::kStill;
    b2World world(b2Vec2(0.0f, 0.0f));
    Changing listener(change);
    Hash hash;
    const auto add = [&world](float x, float y, bool sensor) {
        return AddAwake(world, {x, y}, {0.5f, 0.5f}, sensor);
    };
    for (int i = 0; i < 40; ++i)
        for (const float y : {0.0f, 1.1f})
            add(3.0f * static_cast<float>(i), y, false);
    std::vector<b2Body *> coming;
    for (int i = 0; i < 12; ++i) {
        add(3.0f * static_cast<float>(i), 10.0f, sensors);
        coming.push_back(add(3.0f * static_cast<float>(i) + 1.1f, 9.8f, false));
    }
    Step(world, 1, &hash);
    for (int i = 0; i < 12; ++i) { // later, so that their contacts are looked at earlier
        add(3.0f * static_cast<float>(i), 11.1f, sensors);
        add(3.0f * static_cast<float>(i) + 1.1f, 8.7f, false);
    }
    Step(world, 3, &hash);
    world.SetContactListener(&listener);
    for (b2Body *body : coming)
        body->SetTransform(body->GetPosition() - b2Vec2(0.3f, 0.0f), 0.0f);
    for (int step = 0; step < 40; ++step) {
        world.Step(change == Change::kStill && step < 2 ? 0.0f : 1.0f / 60.0f, 8, 3);
        hash.Add(world);
        hash.Add(listener.told);
    }
    Print("what a listener changed", hash);
    std::printf("%u told\n", listener.told);
}

/// Steps the world when it is told of an end.
class Stepping final : public b2ContactListener {
public:
    explicit Stepping(b2World *world) : m_world(world) {}
    void EndContact(b2Contact *) override {
        if (!m_world->IsLocked())
            m_world->Step(1.0f / 60.0f, 8, 3);
    }

private:
    b2World *m_world;
};

/// Two boxes touch. A third one is thrown at the first, whose type then changes: that ends the contact of the
/// two. In the step that the listener makes of it the thrown one gets its contact, and then Box2D empties the
/// list of the one that changed: it will make the same contact again.
void PlayUnlisted() {
    b2World world(b2Vec2(0.0f, 0.0f));
    Stepping listener(&world);
    Hash hash;
    std::vector<b2Body *> thrown, changed;
    for (int i = 0; i < 80; ++i) {
        const float x = 5.0f * static_cast<float>(i);
        thrown.push_back(AddAwake(world, {x, 3.0f}, {0.5f, 0.5f}));
        changed.push_back(AddAwake(world, {x, 0.0f}, {0.5f, 0.5f}));
        AddAwake(world, {x + (i % 8 == 0 ? 0.995f : 1.1f), 0.0f}, {0.5f, 0.5f});
    }
    Step(world, 4, &hash);
    world.SetContactListener(&listener);
    for (size_t i = 0; i < changed.size(); i += 8) {
        thrown[i]->SetLinearVelocity({0.0f, -30.0f});
        changed[i]->SetType(b2_kinematicBody);
        for (int step = 0; step < 3; ++step) {
            Step(world, 1, &hash);
            std::printf("%d contacts, ", static_cast<int>(world.GetContactCount()));
            Print("unlisted", hash);
        }
    }
}

} // namespace

int main() {
    PlayDisabling(false);
    PlayDisabling(true);
    for (const Change change : {Change::kSolid, Change::kStill, Change::kEmptied, Change::kThereAndBack})
        PlayChanging(change);
    PlayUnlisted();
    for (const uint32_t givesWayAt : {1u, 2u, 3u, 4u})
        PlayTurns(givesWayAt);
    Play("a filter changes the listener", true);
    Play("a filter brings one", false);
    return 0;
}
