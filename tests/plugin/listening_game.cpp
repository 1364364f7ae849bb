// SPDX-License-Identifier: MIT
// Games whose contact filter puts another contact listener into the world while b2World::SolveTOI looks for
// new contacts, and one whose listeners do, or take themselves away, in the midst of being told. Each
// listener tells what it is told, and what the world's list of contacts then is.
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

/// Disables all contacts when one begins, and is not there in the next two steps.
class Disabling final : public b2ContactListener {
public:
    explicit Disabling(b2World *world) : m_world(world) {}
    void BeginContact(b2Contact *) override {
        for (b2Contact *contact = m_world->GetContactList(); contact != nullptr; contact = contact->GetNext())
            contact->SetEnabled(false);
    }

private:
    b2World *m_world;
};

void PlayDisabling() {
    b2World world(b2Vec2(0.0f, -10.0f));
    Hash hash;
    Disabling listener(&world);
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

} // namespace

int main() {
    PlayDisabling();
    for (const uint32_t givesWayAt : {1u, 2u, 3u, 4u})
        PlayTurns(givesWayAt);
    Play("a filter changes the listener", true);
    Play("a filter brings one", false);
    return 0;
}
