// SPDX-License-Identifier: MIT
// A game whose contact filter puts another contact listener into the world while b2World::SolveTOI looks for
// new contacts, and one whose listener does. Each listener tells what it is told, and what the world's list
// of contacts then is.
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

private:
    void Tell(uint32_t what) {
        ++m_told;
        m_hash->Add(16 * m_who + what);
        uint32_t count = 0;
        for (const b2Contact *contact = m_world->GetContactList(); contact != nullptr;
             contact = contact->GetNext())
            ++count;
        m_hash->Add(count);
    }

    uint32_t m_who, m_told = 0;
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

} // namespace

int main() {
    Play("a filter changes the listener", true);
    Play("a filter brings one", false);
    return 0;
}
