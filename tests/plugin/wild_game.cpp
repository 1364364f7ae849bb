// SPDX-License-Identifier: MIT
//
//   wild_game FIRST COUNT
//
// Random worlds, two for each seed, each of which may be stepped in the midst of the other's step. What flies
// in them is fast; it has turned by thousands of rounds, and turns about centres of mass that lie metres
// away; it is joined to what sleeps, filtered in, filtered out, made static and ended: between steps, and by
// listeners and filters. Prints a line for each seed. A plain program of Box2D's: with the plugin preloaded
// it prints the same.
#include <cstdlib>
#include <random>
#include <vector>

#include "small_world.h"

namespace {

/// What a seed's worlds are like.
struct Kind {
    bool heard, filtered, unlocked, nested, sleepy, turned, offCentre, shot;
};

class Wild : private b2ContactListener, private b2ContactFilter {
public:
    Wild(uint32_t seed, const Kind &kind) : m_random(seed), m_kind(kind), m_world(b2Vec2(0.0f, 0.0f)) {
        m_last = AddTouching(0.0f); // the oldest contact: the loop over contacts ends with its PreSolve
        for (int i = 0; i < 4; ++i) {
            AddBox(m_world, b2_staticBody, {Place(), Place()}, {Between(0.02f, 0.2f), Between(1.0f, 6.0f)},
                   Between(0.0f, 3.0f));
            AddBox(m_world, b2_kinematicBody, {Place(), Place()}, {Between(0.02f, 0.2f), Between(0.5f, 3.0f)},
                   Between(0.0f, 3.0f))
                ->SetAngularVelocity(Between(-0.5f, 0.5f));
        }
        const int count = kind.sleepy ? 300 + Below(60) : 40 + Below(60);
        for (int i = 0; i < count; ++i) {
            if (i == count / 2)
                m_middle = AddTouching(20.0f);
            Add();
        }
        m_newest = AddTouching(40.0f);
        if (kind.heard)
            m_world.SetContactListener(this);
        if (kind.filtered)
            m_world.SetContactFilter(this);
        m_world.SetContinuousPhysics(Below(12) != 0);
    }
    void SetOther(Wild *other) { m_other = other; }

    void Step(Hash *hash) {
        m_stepping = true; // not by the other one
        for (int changes = Below(4); changes-- > 0;)
            Change();
        m_stepping = false;
        StepOnce();
        hash->Add(m_world);
        hash->Add(m_told);
    }

private:
    void StepOnce() {
        if (m_stepping)
            return;
        m_stepping = m_inLoop = true;
        m_world.Step(Below(20) == 0 ? 0.0f : 1.0f / 60.0f, 4, 2);
        m_stepping = m_inLoop = false;
    }

    /// Two boxes that touch and never sleep, and that nobody changes: their contact has a PreSolve in each
    /// step.
    b2Body *AddTouching(float x) {
        for (const float at : {x, x + 0.995f})
            AddBox(m_world, b2_dynamicBody, {at, 300.0f}, {0.5f, 0.5f}, 0.0f)->SetSleepingAllowed(false);
        m_world.Step(0.0f, 1, 1);
        return m_world.GetBodyList();
    }

    void BeginContact(b2Contact *) override { Hear(); }
    void EndContact(b2Contact *) override { Hear(); }
    void PreSolve(b2Contact *contact, const b2Manifold *) override {
        const b2Body *const a = contact->GetFixtureA()->GetBody(), *const b =
                                                                       contact->GetFixtureB()->GetBody();
        for (const b2Body *stays : {m_newest, m_middle, m_last}) {
            if (a != stays && b != stays)
                continue;
            Hear();
            if (m_kind.unlocked && m_inLoop && !m_inside && Below(4) == 0)
                Unlock();
            m_inLoop = m_inLoop && stays != m_last;
            return;
        }
        if (Below(30) == 0)
            contact->SetEnabled(false);
    }
    void PostSolve(b2Contact *, const b2ContactImpulse *) override {
        if (Below(8) == 0)
            Hear();
    }
    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override {
        ++m_told;
        if (Below(9) == 0)
            ChangeLocked();
        if (m_kind.nested && m_other != nullptr && Below(30) == 0)
            m_other->StepOnce();
        return Below(9) != 0 && b2ContactFilter::ShouldCollide(a, b);
    }

    void Hear() {
        ++m_told;
        if (m_inside)
            return;
        m_inside = true;
        if (m_kind.nested && m_other != nullptr && Below(4) == 0)
            m_other->StepOnce();
        for (int changes = Below(3); changes-- > 0;)
            ChangeLocked();
        m_inside = false;
    }

    /// In the midst of the loop over contacts, when a step of its own has unlocked the world.
    void Unlock() {
        m_inside = true;
        m_world.Step(Below(3) == 0 ? 1.0f / 240.0f : 0.0f, 1, 1);
        for (int changes = Below(6); changes-- > 0;)
            ChangeUnlocked();
        m_inside = false;
        m_inLoop = true;
    }

    int Below(int n) { return static_cast<int>(m_random() % static_cast<uint32_t>(n)); }
    float Between(float low, float high) {
        return low + (high - low) * static_cast<float>(Below(4096)) / 4096.0f;
    }
    float Place() {
        const float wide = m_kind.sleepy ? 14.0f : 7.0f;
        return Between(-wide, wide);
    }
    b2Body *Some() { return m_bodies[static_cast<size_t>(Below(static_cast<int>(m_bodies.size())))]; }

    b2Body *Add() {
        const b2Vec2 half(Between(0.02f, 0.6f), Between(0.02f, 0.3f));
        b2Body *const body = Below(10) == 0
                                 ? AddWheel(m_world, {Place(), Place()}, 3 + Below(5), Between(0.2f, 0.6f))
                                 : AddBox(m_world, b2_dynamicBody, {Place(), Place()}, half,
                                          Between(0.0f, 3.0f), Below(12) == 0);
        if (Below(3) == 0) { // a corner of it alone
            auto *const shape = static_cast<b2PolygonShape *>(body->GetFixtureList()->GetShape());
            if (shape->m_count == 4)
                shape->Set(shape->m_vertices, 3);
            body->ResetMassData();
        }
        m_bodies.push_back(body);
        if (m_kind.turned && Below(3) == 0)
            TurnOften(body);
        if (m_kind.offCentre && Below(3) == 0)
            MoveCentre(body);
        if (m_kind.sleepy && Below(30) != 0)
            body->SetAwake(false);
        else
            Push(body);
        return body;
    }

    void Push(b2Body *body) {
        body->SetLinearVelocity({Between(-2.0f, 2.0f), Between(-2.0f, 2.0f)});
        body->SetAngularVelocity(Between(-1.0f, 1.0f));
    }
    void Throw(b2Body *body) {
        body->SetLinearVelocity({Between(-90.0f, 90.0f), Between(-60.0f, 60.0f)});
        body->SetAngularVelocity(Below(3) == 0 ? Between(-60.0f, 60.0f) : Between(-3.0f, 3.0f));
    }
    void TurnOften(b2Body *body) {
        const float rounds[] = {100.0f, 1e3f, 1e5f, 1e6f, -3e6f};
        body->SetTransform(body->GetPosition(), Between(0.5f, 1.0f) * rounds[Below(5)]);
    }
    void MoveCentre(b2Body *body) {
        b2MassData mass;
        body->GetMassData(&mass);
        mass.center = Below(3) == 0 ? b2Vec2(Between(-20.0f, 20.0f), Between(-20.0f, 20.0f))
                                    : b2Vec2(Between(-0.3f, 0.3f), Between(-0.3f, 0.3f));
        mass.I = mass.mass * (b2Dot(mass.center, mass.center) + 1.0f);
        body->SetMassData(&mass);
    }
    void Refilter(b2Body *body) {
        for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
            f->Refilter();
    }

    /// What may be done at any time.
    void ChangeLocked() {
        if (m_bodies.empty())
            return;
        b2Body *const some = Some();
        switch (Below(11)) {
        case 0:
            some->SetBullet(!some->IsBullet());
            break;
        case 1:
            some->SetBullet(true);
            Throw(some);
            break;
        case 2:
            Throw(some);
            break;
        case 3:
            some->SetAwake(Below(2) == 0);
            break;
        case 4:
            if (m_kind.offCentre) {
                b2Fixture *const fixture = some->GetFixtureList();
                fixture->SetDensity(Between(0.5f, 60.0f));
                some->ResetMassData();
                if (Below(2) == 0)
                    Throw(some);
            }
            break;
        case 5:
            Refilter(some);
            break;
        case 6:
            some->GetFixtureList()->GetShape()->m_radius = Between(0.01f, 0.1f);
            break;
        case 7: {
            b2Filter filter = some->GetFixtureList()->GetFilterData();
            filter.groupIndex = static_cast<int16>(Below(3) - 1);
            some->GetFixtureList()->SetFilterData(filter);
            break;
        }
        case 8: {
            int which = Below(60);
            for (b2Contact *c = m_world.GetContactList(); c != nullptr; c = c->GetNext())
                if (which-- == 0)
                    c->SetEnabled(false);
            break;
        }
        default:
            Push(some);
        }
    }

    void ChangeUnlocked() {
        if (m_bodies.size() < 2 || m_world.IsLocked())
            return;
        const size_t at = static_cast<size_t>(Below(static_cast<int>(m_bodies.size())));
        b2Body *const some = m_bodies[at];
        switch (Below(6)) {
        case 0:
        case 1:
            some->SetTransform(some->GetPosition() + b2Vec2(Between(-0.4f, 0.4f), Between(-0.4f, 0.4f)),
                               some->GetAngle() + (Below(2) == 0 ? b2_pi : Between(-1.0f, 1.0f)));
            break;
        case 2:
            some->SetTransform(some->GetPosition(), some->GetAngle() + b2_pi);
            Throw(some);
            break;
        case 3:
            m_world.DestroyBody(some);
            m_bodies.erase(m_bodies.begin() + static_cast<std::ptrdiff_t>(at));
            break;
        case 4:
            some->SetType(some->GetType() == b2_dynamicBody ? b2_staticBody : b2_dynamicBody);
            break;
        default:
            Add();
        }
    }

    void Change() {
        if (m_bodies.size() < 2) {
            Add();
            return;
        }
        const size_t at = static_cast<size_t>(Below(static_cast<int>(m_bodies.size())));
        b2Body *const some = m_bodies[at];
        switch (Below(12)) {
        case 0:
            m_world.DestroyBody(some);
            m_bodies.erase(m_bodies.begin() + static_cast<std::ptrdiff_t>(at));
            break;
        case 1: // the newest ones and another one go, as many come
            for (int k = 0; k < 2; ++k) {
                const size_t which = k == 0 ? m_bodies.size() - 1 : at % m_bodies.size();
                m_world.DestroyBody(m_bodies[which]);
                m_bodies.erase(m_bodies.begin() + static_cast<std::ptrdiff_t>(which));
            }
            Add();
            Add();
            break;
        case 2: {
            b2Body *const other = Some();
            if (other != some && some->GetJointList() == nullptr) {
                b2DistanceJointDef def;
                def.Initialize(some, other, some->GetPosition(), other->GetPosition());
                def.collideConnected = Below(2) == 0;
                m_world.CreateJoint(&def);
            }
            break;
        }
        case 3:
            if (some->GetJointList() != nullptr)
                m_world.DestroyJoint(some->GetJointList()->joint);
            break;
        case 4:
            if (m_kind.turned)
                TurnOften(some);
            break;
        case 5:
            if (m_kind.offCentre)
                MoveCentre(some);
            break;
        case 6:
            some->SetTransform({Place(), Place()}, some->GetAngle());
            break;
        case 7:
            some->SetEnabled(!some->IsEnabled());
            break;
        case 8:
            if (m_kind.shot) {
                some->SetBullet(true);
                Throw(some);
            }
            break;
        case 9: // joined, and pulled
            if (some->GetJointList() != nullptr)
                Throw(some);
            break;
        default:
            ChangeLocked();
        }
    }

    std::minstd_rand m_random;
    Kind m_kind;
    b2World m_world;
    Wild *m_other = nullptr;
    b2Body *m_last = nullptr, *m_middle = nullptr, *m_newest = nullptr;
    bool m_stepping = false, m_inLoop = false, m_inside = false;
    uint32_t m_told = 0;
    std::vector<b2Body *> m_bodies;
};

} // namespace

int main(int argc, char **argv) {
    if (argc != 3) {
        std::fputs("usage: wild_game FIRST COUNT\n", stderr);
        return 2;
    }
    const auto first = static_cast<uint32_t>(std::atoi(argv[1])),
               count = static_cast<uint32_t>(std::atoi(argv[2]));
    for (uint32_t seed = first; seed != first + count; ++seed) {
        std::minstd_rand kinds(seed * 2654435761u + 1u);
        const auto one = [&kinds](uint32_t of) { return (kinds() >> 8) % of == 0; };
        kinds();
        Hash hash;
        const Kind kind = {!one(4), one(3), one(2), one(3), one(3), one(2), one(2), !one(4)};
        Wild wild(seed, kind), other(seed + 1000003u, kind);
        wild.SetOther(&other);
        other.SetOther(&wild);
        for (int step = 0; step < 60; ++step) {
            wild.Step(&hash);
            if (step % 2 == 0)
                other.Step(&hash);
        }
        std::printf("seed %u ", seed);
        Print("ends with", hash);
    }
    return 0;
}
