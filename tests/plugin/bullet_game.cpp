// SPDX-License-Identifier: MIT
//
//   bullet_game unheard FIRST COUNT
//   bullet_game heard FIRST COUNT
//   bullet_game swapped FIRST COUNT
//   bullet_game thrown|recentred
//
// Random worlds, one for each seed, where bodies become bullets, cease to be, change their types, sleep, are
// woken, moved, thrown, put out of the world, ended and made; impacts are had with all of them. Prints a line
// for each seed.
//
// `unheard`: nobody listens or filters, so that most pairs may be left out. `heard`: crowded, and a listener
// is told of begins and ends, as in most games; one call in a few it makes bullets, wakes, edits, disables;
// and a filter does, in every other world.
//
// `swapped`: as heard. But who listens and who filters is another one or nobody from time to time, changed
// between steps and in the midst of them, by listeners and filters themselves; and the world loses all of its
// bodies, and gets others.
//
// `thrown`: a listener throws as the first of many impacts of a step is told. What Box2D had found out of the
// others is to be forgotten, also where their bodies are no bullets any more and nobody listens.
//
// `recentred`: a listener gives bodies other centres of mass, and throws them, when they have been looked at.
#include <cfenv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include <box2d/box2d.h>

#include "small_world.h"

namespace {

class Crowd : private b2ContactListener, private b2ContactFilter {
public:
    Crowd(uint32_t seed, bool heard, bool swapped)
        : m_random(seed), m_world(b2Vec2(0.0f, seed % 3 == 0 ? 0.0f : -10.0f)), m_heard(heard),
          m_swapped(swapped) {
        if (heard) {
            m_world.SetContactListener(this);
            if (seed % 2 == 0)
                m_world.SetContactFilter(this);
        }
        m_world.SetContinuousPhysics(seed % 11 != 0);
        m_world.SetSubStepping(seed % 17 == 0);
        Fill();
    }

    void Play(int steps, Hash *hash) {
        for (int i = 0; i < steps; ++i) {
            for (int changes = Below(4); changes-- > 0;)
                Change();
            if (m_swapped && Below(4) == 0)
                Swap();
            if (m_swapped && Below(40) == 0)
                FillAgain();
            m_world.Step(Below(30) == 0 ? 0.0f : 1.0f / 60.0f, 8, 3);
            hash->Add(m_world);
        }
        hash->Add(m_told);
    }

private:
    /// The other listener and filter. Of a class without a PreSolve, which is seen by who calls it.
    class Other final : public b2ContactListener, public b2ContactFilter {
    public:
        explicit Other(Crowd *crowd) : m_crowd(crowd) {}
        void BeginContact(b2Contact *contact) override { m_crowd->EndContact(contact); }
        void EndContact(b2Contact *contact) override { m_crowd->BeginContact(contact); }
        bool ShouldCollide(b2Fixture *a, b2Fixture *b) override { return m_crowd->ShouldCollide(b, a); }

    private:
        Crowd *m_crowd;
    };

    void PreSolve(b2Contact *contact, const b2Manifold *) override {
        if (m_swapped && Below(9) == 0)
            contact->SetEnabled(false);
    }
    void BeginContact(b2Contact *contact) override { Hear(contact->GetFixtureA(), contact->GetFixtureB()); }
    void EndContact(b2Contact *contact) override { Hear(contact->GetFixtureB(), contact->GetFixtureA()); }
    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override {
        Hear(a, b);
        return b2ContactFilter::ShouldCollide(a, b);
    }

    /// Code of the game that runs in a step: what Box2D bears there. (It does not bear sensors that are made
    /// then.)
    void Hear(b2Fixture *fixture, b2Fixture *other) {
        ++m_told;
        if (m_swapped && Below(6) == 0)
            Swap();
        if (Below(9) != 0 || m_bodies.empty())
            return;
        b2Body *some = m_bodies[static_cast<size_t>(Below(static_cast<int>(m_bodies.size())))];
        switch (Below(9)) {
        case 0:
        case 1:
            SwitchBullet(some);
            break;
        case 2:
            ThrowAsBullet(fixture->GetBody());
            break;
        case 3:
            WakeOrNot(some);
            break;
        case 4:
            some->SetLinearVelocity({Between(-20.0f, 20.0f), 0.0f});
            break;
        case 5: { // a little smaller
            b2Shape *const shape = some->GetFixtureList()->GetShape();
            for (b2Vec2 &v : static_cast<b2PolygonShape *>(shape)->m_vertices)
                v *= 0.9375f;
            break;
        }
        case 6:
            some->ResetMassData();
            some->SetFixedRotation(!some->IsFixedRotation());
            break;
        case 7: {
            b2Filter filter = other->GetFilterData();
            filter.groupIndex = static_cast<int16>(Below(3) - 1);
            other->SetFilterData(filter);
            break;
        }
        default:
            DisableOne();
        }
    }
    void DisableOne() {
        int which = Below(40);
        for (b2Contact *contact = m_world.GetContactList(); contact != nullptr; contact = contact->GetNext())
            if (which-- == 0)
                contact->SetEnabled(false);
    }

    /// Of listeners and filters each kind, and nobody.
    void Swap() {
        b2ContactListener *const listeners[] = {this, &m_other, nullptr};
        b2ContactFilter *const filters[] = {this, &m_other, nullptr};
        m_world.SetContactListener(listeners[Below(3)]);
        if (Below(3) == 0)
            m_world.SetContactFilter(filters[Below(3)]);
    }

    void Fill() {
        AddBox(m_world, b2_staticBody, {0.0f, -1.0f}, {40.0f, 0.3f}, 0.02f);
        AddBox(m_world, b2_kinematicBody, {5.0f, 3.0f}, {4.0f, 0.05f}, 0.3f)->SetAngularVelocity(0.5f);
        const int count = 40 + Below(120) + (m_heard ? 60 : 0);
        for (int i = 0; i < count; ++i)
            Add();
    }

    /// Stays empty for as many steps as may be, none among them.
    void FillAgain() {
        m_bodies.clear(); // whoever hears of their ends changes none of them
        while (b2Body *body = m_world.GetBodyList())
            m_world.DestroyBody(body);
        for (int steps = Below(3); steps-- > 0;)
            m_world.Step(1.0f / 60.0f, 8, 3);
        Fill();
    }

    int Below(int n) { return static_cast<int>(m_random() % static_cast<uint32_t>(n)); }
    float Between(float low, float high) {
        return low + (high - low) * static_cast<float>(Below(4096)) / 4096.0f;
    }

    void Add() {
        const float wide = m_heard ? 6.0f : 9.0f;
        const b2Vec2 at(Between(-wide, wide), Between(0.0f, wide));
        if (Below(8) == 0) {
            m_bodies.push_back(AddWheel(m_world, at, 3 + Below(6), Between(0.2f, 0.5f)));
            return;
        }
        const b2Vec2 half(Between(0.02f, 0.5f), Between(0.02f, 0.4f));
        m_bodies.push_back(AddBox(m_world, b2_dynamicBody, at, half, Between(0.0f, 3.0f), Below(12) == 0));
    }

    void Throw(b2Body *body) {
        body->SetLinearVelocity({Between(-90.0f, 90.0f), Between(-60.0f, 60.0f)});
        body->SetAngularVelocity(Between(-9.0f, 9.0f));
    }

    void ThrowAsBullet(b2Body *body) {
        body->SetBullet(true);
        Throw(body);
    }
    static void SwitchBullet(b2Body *body) { body->SetBullet(!body->IsBullet()); }
    void WakeOrNot(b2Body *body) { body->SetAwake(Below(2) == 0); }

    void Change() {
        if (m_bodies.empty()) {
            Add();
            return;
        }
        b2Body *&some = m_bodies[static_cast<size_t>(Below(static_cast<int>(m_bodies.size())))];
        switch (Below(12)) {
        case 0:
        case 1:
            SwitchBullet(some);
            break;
        case 2:
            ThrowAsBullet(some);
            break;
        case 3:
            Throw(some);
            break;
        case 4:
            some->SetType(some->GetType() == b2_dynamicBody ? b2_staticBody : b2_dynamicBody);
            break;
        case 5:
            some->SetType(b2_kinematicBody);
            Throw(some);
            break;
        case 6:
            WakeOrNot(some);
            break;
        case 7:
            some->SetTransform({Between(-9.0f, 9.0f), Between(0.0f, 9.0f)}, Between(0.0f, 6.0f));
            break;
        case 8:
            some->SetEnabled(!some->IsEnabled());
            break;
        case 9:
            m_world.DestroyBody(some);
            some = m_bodies.back();
            m_bodies.pop_back();
            break;
        case 10:
            Add();
            break;
        default:
            DisableOne();
        }
    }

    std::minstd_rand m_random;
    b2World m_world;
    bool m_heard, m_swapped;
    Other m_other{this};
    uint32_t m_told = 0;
    std::vector<b2Body *> m_bodies;
};

struct Told {};

class Throwing final : public b2ContactListener {
public:
    bool armed = false;
    void BeginContact(b2Contact *) override {
        if (armed)
            throw Told();
    }
};

/// `rounded`: the step that is thrown out of is rounded upward, and so was one before; between them an impact
/// is had.
void PlayThrown(bool rounded) {
    constexpr int kResting = 700, kShots = 40; // more at rest than a short list has room for
    b2World world(b2Vec2(0.0f, -10.0f));
    AddBox(world, b2_staticBody, {0.0f, -0.5f}, {400.0f, 0.5f}, 0.0f);
    for (int i = 0; i < kResting; ++i)
        AddBox(world, b2_dynamicBody, {-350.0f + static_cast<float>(i), 0.25f}, {0.25f, 0.25f}, 0.0f)
            ->SetSleepingAllowed(false);
    std::vector<b2Body *> bullets;
    for (int i = 0; i < kShots; ++i) {
        const float x = 6.0f * static_cast<float>(i - kShots / 2);
        AddBox(world, b2_dynamicBody, {x, 20.0f}, {0.01f, 0.5f}, 0.0f)->SetGravityScale(0.0f);
        bullets.push_back(AddBox(world, b2_dynamicBody, {x - 0.2f, 20.0f}, {0.03f, 0.03f}, 0.0f));
        bullets.back()->SetGravityScale(0.0f);
    }
    Hash hash;
    Step(world, 60, &hash);
    if (rounded) {
        std::fesetround(FE_UPWARD);
        Step(world, 1, &hash);
        std::fesetround(FE_TONEAREST);
        bullets.back()->SetBullet(true);
        bullets.back()->SetLinearVelocity({30.0f, 0.0f});
        bullets.pop_back();
        for (b2Body *bullet : bullets) // so that they are looked at
            bullet->SetAwake(true);
        Step(world, 1, &hash);
        std::fesetround(FE_UPWARD);
    }
    Throwing listener;
    listener.armed = true;
    world.SetContactListener(&listener);
    for (b2Body *bullet : bullets) {
        bullet->SetBullet(true);
        bullet->SetLinearVelocity({30.0f, 0.0f});
    }
    try {
        world.Step(1.0f / 60.0f, 8, 3);
        Print("nothing was thrown", hash);
    } catch (const Told &) {
        Print("thrown", hash);
    }
    std::fesetround(FE_TONEAREST);
    world.SetContactListener(nullptr);
    for (b2Body *bullet : bullets) {
        bullet->SetBullet(false);
        bullet->SetLinearVelocity({0.0f, 0.0f});
    }
    Step(world, 3, &hash);
    Print("three steps on", hash);
}

/// Does once, in a PreSolve, what is to be done.
class Once final : public b2ContactListener {
public:
    std::function<void()> what;
    void PreSolve(b2Contact *, const b2Manifold *) override {
        if (what)
            std::exchange(what, nullptr)();
    }
};

/// Bars in front of plates that stand aslant. Each bar's centre of mass is near the plate, and then in
/// its middle: it has moved towards the plate by less than the bar does.
void PlayRecentred() {
    constexpr int kPairs = 40;
    const b2Rot aslant(0.25f * b2_pi);
    b2World world(b2Vec2(0.0f, 0.0f));
    Once listener;
    Hash hash;
    std::vector<b2Body *> bars;
    for (int i = 0; i < kPairs; ++i) {
        const b2Vec2 at(6.0f * static_cast<float>(i), 0.0f);
        AddBox(world, b2_staticBody, at, {0.02f, 3.0f}, aslant.GetAngle());
        bars.push_back(
            AddBox(world, b2_dynamicBody, at + 0.79f * aslant.GetXAxis(), {0.4f, 0.1f}, aslant.GetAngle()));
        bars.back()->SetSleepingAllowed(false);
        b2MassData mass;
        bars.back()->GetMassData(&mass);
        mass.center.Set(-0.29f, 0.0f);
        mass.I = 2.0f * mass.mass;
        bars.back()->SetMassData(&mass);
    }
    for (const float x : {0.0f, 0.995f}) // who touch
        AddBox(world, b2_dynamicBody, {x, 90.0f}, {0.5f, 0.5f}, 0.0f)->SetSleepingAllowed(false);
    world.SetContactListener(&listener);
    Step(world, 4, &hash);
    Print("recentred", hash);
    listener.what = [&] {
        float speed = 20.0f;
        for (b2Body *bar : bars) {
            bar->ResetMassData();
            bar->SetLinearVelocity(-speed * aslant.GetXAxis());
            speed += 0.5f;
        }
    };
    for (int i = 0; i < 3; ++i) {
        Step(world, 1, &hash);
        Print("recentred", hash);
    }
}

} // namespace

int main(int argc, char **argv) {
    if (argc == 2 && std::strcmp(argv[1], "thrown") == 0) {
        PlayThrown(false);
        PlayThrown(true);
        return 0;
    }
    if (argc == 2 && std::strcmp(argv[1], "recentred") == 0) {
        PlayRecentred();
        return 0;
    }
    const bool swapped = argc == 4 && std::strcmp(argv[1], "swapped") == 0;
    const bool heard = swapped || (argc == 4 && std::strcmp(argv[1], "heard") == 0);
    if (argc != 4 || (!heard && std::strcmp(argv[1], "unheard") != 0)) {
        std::fputs("usage: bullet_game unheard|heard|swapped FIRST COUNT | thrown|recentred\n", stderr);
        return 2;
    }
    const auto first = static_cast<uint32_t>(std::atoi(argv[2])),
               count = static_cast<uint32_t>(std::atoi(argv[3]));
    for (uint32_t seed = first; seed != first + count; ++seed) {
        Hash hash;
        Crowd(seed, heard, swapped).Play(90, &hash);
        std::printf("seed %u ", seed);
        Print("ends with", hash);
    }
    return 0;
}
