// SPDX-License-Identifier: MIT
// What may change between and within steps while others remember how it was: filters, the origin, listeners,
// odd steps. README.md has the whole list.
#include <cfenv>

#include "yard.h"

using namespace as_stock;

namespace {

/// Changes its mind, about some pairs.
class Moody : public b2ContactFilter {
public:
    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override {
        const auto sum = a->GetUserData().pointer + b->GetUserData().pointer;
        return mood == 0 || (sum % 3 != mood % 3 && b2ContactFilter::ShouldCollide(a, b));
    }
    unsigned mood = 0;
};

} // namespace

// ncollide #280, rapier #300: contacts outlived a filter that forbade them. box2d #31, box2dweb #53: setting
// a filter missed contacts, or never ended.
AS_STOCK("filters of fixtures change in the middle of contact") {
    Yard yard(run);
    yard.Begin();
    for (int round = 0; round < 8; ++round) {
        yard.Place(round % 4 < 2);
        for (const Yard::Couple &couple : yard.couples) {
            int number = 0;
            for (b2Fixture *f = couple.mover->GetFixtureList(); f != nullptr; f = f->GetNext()) {
                b2Filter filter = f->GetFilterData();
                filter.maskBits = (round + number++ / 5) % 2 == 0 ? 0xffff : 0;
                filter.groupIndex = static_cast<int16>(round == 5 ? 1 : 0);
                f->SetFilterData(filter);
            }
        }
        yard.game.Step();
        if (round == 0 || round == 4)
            yard.game.Stage(yard.TouchingCouples() >= 5, "those who may collide do");
        if (round == 3)
            yard.game.Stage(yard.Touching(Yard::kBoxes) == 0, "those who may not do not");
        yard.game.Step(3);
    }
}

// Jolt #1720, #109, bullet3 #871: a filter that is asked once goes on answering for all time.
AS_STOCK("a game's filter changes its mind, told to ask again or not") {
    Moody filter;
    Yard yard(run);
    yard.game.world.SetContactFilter(&filter);
    yard.Begin();
    for (unsigned round = 0; round < 9; ++round) {
        filter.mood = round % 4;
        yard.Place(round % 2 == 0);
        if (round % 3 != 1)
            yard.Refilter();
        yard.game.Step();
        if (round == 0 || round == 8)
            yard.game.Stage(yard.TouchingCouples() >= 5, "those who may collide do");
        yard.game.Step(4);
    }
}

// PhysX's and Box2D's own ShiftOrigin promise to keep what is cached (rapier #456): it must be moved along,
// or have no place in it.
AS_STOCK("the origin shifts under bullets, sensors, sleepers and what touches") {
    Yard yard(run);
    yard.Begin();
    for (int round = 0; round < 10; ++round) {
        yard.Drift(round % 2 == 0 ? -0.8f : 0.3f);
        if (round == 4)
            for (const Yard::Couple &couple : yard.couples)
                couple.mover->SetAwake(false);
        const b2Vec2 shift(round % 3 == 0 ? 64.0f : -17.3f, 0.77f * Real(round));
        yard.game.world.ShiftOrigin(shift);
        for (Yard::Couple &couple : yard.couples)
            couple.place -= shift;
        yard.game.Step(5);
        if (round == 6) {
            yard.Place(true);
            yard.game.Step();
            yard.game.Stage(yard.TouchingCouples() >= 5, "a collision");
        }
    }
}

namespace {

/// Switches contacts off in some steps, in others not.
class Doorman : public b2ContactListener {
public:
    explicit Doorman(Run &run) : m_run(run) {}
    void BeginContact(b2Contact *contact) override { Tell("begin", contact); }
    void EndContact(b2Contact *contact) override { Tell("end", contact); }
    void PreSolve(b2Contact *contact, const b2Manifold *old) override {
        Tell("presolve", contact);
        m_run.Print("%d points before", old->pointCount);
        if (step % 4 < 2)
            contact->SetEnabled(false);
    }
    int step = 0;
    int told = 0;

private:
    void Tell(const char *what, b2Contact *contact) {
        ++told;
        m_run.Print("%s %u %u, enabled %d", what,
                    static_cast<unsigned>(contact->GetFixtureA()->GetUserData().pointer),
                    static_cast<unsigned>(contact->GetFixtureB()->GetUserData().pointer),
                    contact->IsEnabled());
    }
    Run &m_run;
};

} // namespace

// box2d #17, #308, VelcroPhysics #60: is a contact that was switched off once still off in the next step?
AS_STOCK("a contact that a listener switched off is on again at its next update, and only then") {
    Doorman doorman(run);
    Yard yard(run);
    yard.Begin();
    yard.game.world.SetContactListener(&doorman);
    for (; doorman.step < 40; ++doorman.step) {
        if (doorman.step % 10 == 0)
            yard.Place(true);
        if (doorman.step % 10 == 5) // also by the game, between steps
            for (b2Contact *c = yard.game.world.GetContactList(); c != nullptr; c = c->GetNext())
                c->SetEnabled(false);
        yard.Drift(doorman.step % 3 == 0 ? -1.0f : 0.0f);
        yard.game.Step();
    }
    yard.game.Stage(doorman.told > 100, "the listener is told");
}

namespace {

/// Changes what Box2D lets a listener change while the world is locked.
class Meddler : public b2ContactListener {
public:
    Meddler(Run &run, b2World *world) : m_run(run), m_world(world) {}
    void BeginContact(b2Contact *contact) override { Meddle(contact->GetFixtureB(), 0.12f); }
    void EndContact(b2Contact *contact) override { Meddle(contact->GetFixtureA(), 0.3f); }
    int meddled = 0;

private:
    void Meddle(b2Fixture *fixture, float thickness) {
        ++meddled;
        b2Body *body = fixture->GetBody();
        m_run.Print("meddles, locked %d", m_world->IsLocked());
        if (b2PolygonShape *polygon = PolygonOf(fixture))
            polygon->SetAsBox(0.5f, thickness); // nobody is told
        body->SetBullet(!body->IsBullet());
        body->SetLinearVelocity(-0.5f * body->GetLinearVelocity());
        b2Filter filter = fixture->GetFilterData();
        filter.groupIndex = static_cast<int16>(1 - filter.groupIndex);
        fixture->SetFilterData(filter);
    }

    Run &m_run;
    b2World *m_world;
};

} // namespace

// Jolt #430, box2d #828: shapes, filters and flags that a callback changes.
AS_STOCK("listeners change shapes, filters, bullets and velocities of a locked world") {
    Yard yard(run);
    yard.Begin();
    Meddler meddler(run, &yard.game.world);
    yard.game.world.SetContactListener(&meddler);
    for (int round = 0; round < 3;
         ++round) { // what is changed in a step begins and ends contacts, which change more
        yard.Place(round % 2 == 0);
        yard.Drift(-3.0f);
        yard.game.Step(4);
    }
    yard.game.Stage(meddler.meddled > 20, "something is changed");
}

// box2d #463, #636: a step of no time, to have contacts looked for.
// Our proofs are of numbers that are rounded to the nearest.
AS_STOCK_HOW(kMayBeSilent, "Box2D answers for sensors in steps that round otherwise") {
    Heard game(run);
    game.Box(game.Body(b2_staticBody, {0.0f, 0.0f}), 1.0f, 1.0f)->SetSensor(true);
    b2Body *const guest = game.Box({-0.8f, 0.1f}, {0.4f, 0.3f});
    guest->SetSleepingAllowed(false);
    guest->SetLinearVelocity({1.0f, 0.0f});
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_TONEAREST, FE_DOWNWARD, FE_TOWARDZERO}) {
        const uint64_t before = bmr::internal::ReadCounts().overlapsAnswered;
        std::fesetround(mode);
        game.Step(8);
        std::fesetround(FE_TONEAREST);
        const bool answered = bmr::internal::ReadCounts().overlapsAnswered > before;
        run.ExpectCounted(answered == (mode == FE_TONEAREST), "who answers");
    }
    game.Stage(game.world.GetContactList()->IsTouching(), "the guest is inside");
}

AS_STOCK("steps of no time at changed poses") {
    Yard yard(run);
    yard.Begin();
    for (int round = 0; round < 10; ++round) {
        yard.Place(round % 2 == 0);
        yard.game.Step(1 + round % 2, 0.0f);
        yard.game.Stage((yard.TouchingCouples() >= 5) == (round % 2 == 0), "the poses decide");
        if (round % 3 == 0)
            for (const Yard::Couple &couple : yard.couples)
                yard.Thicken(couple.mover, round % 2 == 0 ? 0.1f : 0.3f);
        yard.Drift(-1.0f);
        yard.game.Step(round % 4);
    }
}

// box2d #541: what SolveTOI keeps of a contact between sub-steps is that of the bodies as they were.
AS_STOCK("between sub-steps bodies are moved, turned into bullets and changed") {
    Yard yard(run, {0.0f, -10.0f});
    yard.Begin();
    yard.game.world.SetSubStepping(true);
    for (int round = 0; round < 40; ++round) {
        Yard::Couple &couple = yard.couples[round % Yard::kCount];
        if (round % 4 == 0)
            couple.mover->SetTransform(Yard::Away(couple) + b2Vec2(0.0f, 0.2f), kSlant + 0.1f);
        if (round % 5 == 1)
            couple.mover->SetLinearVelocity(Slanted(1.0f, -40.0f));
        if (round % 7 == 2)
            couple.mover->SetBullet(!couple.mover->IsBullet());
        if (round % 9 == 3)
            yard.Thicken(couple.mover, 0.05f + 0.01f * Real(round));
        if (round % 11 == 4)
            couple.mover->ResetMassData();
        if (round == 20)
            yard.game.world.SetSubStepping(false);
        if (round == 30)
            yard.game.world.SetSubStepping(true);
        yard.game.Step();
    }
    yard.game.Stage(yard.game.world.GetContactCount() > 0, "contacts");
}
