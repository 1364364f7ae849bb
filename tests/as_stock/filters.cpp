// SPDX-License-Identifier: MIT
// Filters, and listeners, that change, move, put out or end those that they are asked about.
#include "as_stock.h"

using namespace as_stock;

namespace {

/// Puts a body out of the world as soon as it is asked about, asleep: Box2D makes its other contacts all the
/// same.
void PutOutWhenAsked(Game &game, b2Body *victim) {
    game.Ask();
    game.filter.asked = [&game, victim](b2Fixture *a, b2Fixture *b) {
        if (a->GetBody() != victim && b->GetBody() != victim)
            return;
        victim->SetAwake(false);
        victim->SetEnabled(false);
        game.filter.asked = nullptr;
    };
}

} // namespace

// The floor is a long bar aslant. What comes lies in the corner of its box, metres away from the bar itself.
AS_STOCK("returning: a filter puts a body out of the world that is about to get contacts; it comes back with "
         "them") {
    Game game(run);
    for (int i = 0; i < 60; ++i)
        game.Near({3.0f * Real(i), 50.0f});
    game.Wall({0.0f, 0.0f}, {10.0f, 0.1f}, 0.25f * b2_pi);
    game.Step(3);
    for (int round = 0; round < 4; ++round) {
        b2Body *wheel = game.Wheel({5.0f, -5.0f}, 7, 0.4f);
        wheel->SetSleepingAllowed(false);
        PutOutWhenAsked(game, wheel);
        game.Step();
        game.Stage(!wheel->IsEnabled(), "the filter puts it out");
        wheel->SetEnabled(true);
        if (round % 2 == 0) // asleep: what was there is not to be made once more
            game.Step();
        wheel->SetAwake(true);
        game.Step(3);
        wheel->SetLinearVelocity({6.0f, 0.0f}); // out of the bar's box
        game.Step(30);
        game.world.DestroyBody(wheel);
    }
}

// Box2D enables what it updates, and that is nothing that sleeps when its turn comes. Nobody listens, but
// somebody filters.
AS_STOCK("disabled: contacts are disabled whose bodies sleep, and are woken when the loop has passed them") {
    Game game(run);
    game.Ask();
    std::vector<b2Body *> sleepers;
    for (int i = 0; i < 40; ++i) {
        sleepers.push_back(game.Box({4.0f * Real(i), 0.0f}));
        game.Awake({4.0f * Real(i) - 1.1f, 0.0f})->SetLinearVelocity({0.3f + 0.05f * Real(i), 0.0f});
    }
    game.Step(); // who comes has the older contact
    for (int i = 0; i < 40; ++i)
        sleepers.push_back(game.Box({4.0f * Real(i) + 0.995f, 0.0f}));
    game.Step();
    for (b2Body *body : sleepers) {
        body->SetLinearVelocity({0.0f, 0.0f});
        body->SetAwake(false);
    }
    int disabled = 0;
    for (int step = 0; step < 20; ++step) {
        for (b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext())
            if (c->IsTouching()) {
                disabled +=
                    !c->GetFixtureA()->GetBody()->IsAwake() && !c->GetFixtureB()->GetBody()->IsAwake();
                c->SetEnabled(false);
            }
        game.Step();
    }
    game.TookPlace(disabled, "contacts of sleepers are disabled");
}

namespace {

/// Pairs of boxes, of which every fifth touches, and one box of each.
struct Pairs : Game {
    explicit Pairs(Run &run) : Game(run) {
        for (int i = 0; i < 60; ++i)
            ones.push_back(Near({3.0f * Real(i), 0.0f}, i % 5 == 0 ? -0.005f : 0.1f));
        Ask();
        Step(10);
    }
    /// Has all of them filtered, or every other one.
    void Refilter(size_t from = 0, size_t step = 1) {
        for (size_t i = from; i < ones.size(); i += step)
            ones[i]->GetFixtureList()->Refilter();
    }
    std::vector<b2Body *> ones;
};

} // namespace

// That ends their contact. Box2D goes on with it, whose memory is as it was, and finds that nobody moves.
AS_STOCK("ended: a filter makes the two static that it is asked about, and lets them collide") {
    Pairs game(run);
    int asked = 0;
    game.filter.asked = [&game, &asked](b2Fixture *a, b2Fixture *b) {
        if (asked++ == 0) {
            game.StepWithin(); // unlocks it, and asks for all of them
            game.Refilter();
        }
        if (asked % 3 != 0 || game.world.IsLocked())
            return;
        a->GetBody()->SetType(b2_staticBody);
        b->GetBody()->SetType(b2_staticBody);
    };
    for (size_t step = 0; step < 4; ++step) {
        game.Refilter(step % 2, 2);
        asked = 0;
        game.Step(2);
    }
    game.filter.asked = nullptr;
    for (int i = 0; i < 40; ++i) // others in their place
        game.Near({3.0f * Real(i), 9.0f});
    game.Step(2);
    for (b2Body *body : game.ones)
        body->SetLinearVelocity({-1.5f, 0.0f});
    game.Step(10);
}

// Another type of body ends its contacts. Those whose boxes were found to overlap before are made anew.
AS_STOCK("ends: a filter ends contacts that the loop is still to come by") {
    Game game(run);
    game.Ask();
    game.Listen();
    std::vector<b2Body *> ones;
    for (int i = 0; i < 80; ++i)
        for (const float y : {0.0f, i % 4 == 0 ? 0.79f : 0.9f})
            ones.push_back(game.Awake({3.0f * Real(i), y}, {0.4f, 0.4f}));
    game.Step(4);
    // The step begins with a search for new contacts, ahead of all that locks the world.
    for (const float x : {0.0f, 0.9f})
        game.Awake({x, 50.0f}, {0.4f, 0.4f});
    game.filter.asked.Once([&game, &ones] {
        for (size_t i = 0; i < ones.size(); i += 8)
            ones[i]->SetType(b2_kinematicBody);
        game.filter.refuses = true;
        game.filter.asked.Once([&game] { game.filter.refuses = false; });
    });
    for (size_t i = 0; i < ones.size(); i += 4)
        ones[i]->SetTransform(ones[i]->GetPosition() + b2Vec2(0.4f, 0.0f), 0.0f);
    const int before = game.listener.calls;
    game.Step(3);
    game.TookPlace(game.listener.calls - before, "contacts end");
}
