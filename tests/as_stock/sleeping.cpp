// SPDX-License-Identifier: MIT
// Worlds in which hundreds of bodies sleep, and some are woken by what is easily overlooked.
#include "as_stock.h"

using namespace as_stock;

namespace {

/// Far away: hundreds of boxes that sleep, and pairs that never do.
void AddOthers(Game &game) {
    for (int i = 0; i < 600; ++i)
        game.Box({3.0f * Real(i), 300.0f})->SetAwake(false);
    for (int i = 0; i < 20; ++i)
        for (const float y : {400.0f, 401.05f})
            game.Awake({3.0f * Real(i), y});
}

void Drive(b2Body *body) {
    body->SetAwake(true);
    body->SetLinearVelocity({60.0f, 0.0f});
}

} // namespace

// The end of its contact wakes the rest, in the midst of the loop over contacts.
AS_STOCK("hit: the top of a stack is taken away in the step in which it wakes") {
    constexpr int kHigh = 3;
    Game game(run, {0.0f, -10.0f});
    game.Wall({0.0f, -1.0f}, {500.0f, 1.0f});
    std::vector<b2Body *> tops, below;
    int woken = 0;
    for (int i = 0; i < 150; ++i)
        for (int k = 0; k < kHigh; ++k) {
            b2Body *const box = game.Box({-200.0f + 1.06f * Real(i), 0.5f + Real(k)});
            if (k == kHigh - 1 && i % 5 == 3)
                tops.push_back(box);
            if (k == 0 && i % 5 == 3)
                below.push_back(box);
        }
    game.Awake({350.0f, 3.0f});
    game.Step(300);
    for (size_t i = 0; i < 12; ++i) {
        const bool slept = !below[i]->IsAwake();
        tops[i]->SetAwake(true);
        tops[i]->SetTransform({0.0f, 60.0f + 2.0f * Real(static_cast<int>(i))}, 0.0f);
        game.Step(5);
        woken += slept && below[i]->IsAwake();
    }
    game.TookPlace(woken, "the end of a contact wakes the rest of a stack");
}

AS_STOCK("joint: a sleeper is made a bullet, and is woken by a joint while islands are built") {
    Game game(run);
    for (int i = 0; i < 30; ++i)
        for (const float y : {50.0f, 50.9f})
            game.Awake({-100.0f + 3.0f * Real(i), y}, {0.4f, 0.4f});
    std::vector<b2Body *> pulling, pulled;
    for (int i = 0; i < 20; ++i) {
        const float y = -10.0f * Real(i);
        pulling.push_back(game.Box({-3.0f, y}, {0.2f, 0.2f}));
        pulled.push_back(game.Box({0.0f, y}, {0.05f, 0.05f}));
        game.Box({0.2f, y}, {0.02f, 1.0f}); // a thin plate
        game.Tie(pulling.back(), pulled.back());
    }
    game.Step(120);
    int woken = 0;
    for (size_t i = 0; i < pulling.size(); ++i) {
        const bool slept = !pulled[i]->IsAwake();
        pulled[i]->SetBullet(true);
        Drive(pulling[i]);
        game.Step(3);
        woken += slept && pulled[i]->IsAwake();
    }
    game.TookPlace(woken, "a joint wakes a sleeper");
}

// Box2D enables contacts of bodies that are awake, also in the step in which they fall asleep. Their joints
// pull them at thin walls when they are woken.
AS_STOCK("slept: contacts are disabled until their bodies fall asleep, which are then driven at walls") {
    for (const bool continuous : {true, false}) {
        Game game(run);
        AddOthers(game);
        std::vector<b2Body *> drivers, driven;
        for (int i = 0; i < 12; ++i) {
            const float y = 4.0f * Real(i);
            drivers.push_back(game.Box({8.0f, y}));
            driven.push_back(game.Box({0.0f, y}));
            game.Wall({0.6f, y}, {0.02f, 1.0f});
            game.Tie(drivers.back(), driven.back());
        }
        game.Step(3);
        game.world.SetContinuousPhysics(continuous);
        int disabled = 0, woken = 0;
        while (driven.front()->IsAwake()) {
            for (b2Body *body : driven)
                for (b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
                    edge->contact->SetEnabled(false);
                    ++disabled;
                }
            game.Step();
        }
        game.world.SetContinuousPhysics(true);
        for (size_t i = 0; i < drivers.size(); ++i) {
            const bool slept = !driven[i]->IsAwake();
            Drive(drivers[i]);
            game.Step();
            woken += slept && driven[i]->IsAwake();
        }
        game.TookPlace(disabled, "contacts are disabled");
        game.TookPlace(woken, "sleepers are driven");
    }
}

AS_STOCK(
    "beside: a joint wakes a sleeper while islands are built; of the next island a listener is told, and "
    "wakes one of two that lean on each other") {
    Game game(run);
    b2Body *const leaning = game.Box({0.0f, 0.0f}), *const leant = game.Box({0.98f, 0.0f});
    AddOthers(game);
    game.Leaning({0.0f, -20.0f});
    b2Body *const pulled = game.Box({0.0f, 40.0f}), *const pulling = game.Box({8.0f, 40.0f});
    game.Tie(pulling, pulled);
    game.Listen();
    game.Step();
    for (b2Body *body : {leaning, leant, pulled, pulling})
        body->SetAwake(false);
    game.Step(40); // until Bodies finds that few are awake
    pulling->SetAwake(true);
    int woken = 0;
    game.listener.postSolve.Once([leaning, &woken] {
        woken += leaning->IsAwake() ? 0 : 1;
        leaning->SetAwake(true);
    });
    game.Step(5);
    game.TookPlace(woken, "the listener wakes one that leans");
}

// While the boxes that touch are awake, a step by the table costs more than one by the list, and the table
// rests. Before Box2D looks for impacts it puts each body, a sleeper too, back to where its sweep begins.
AS_STOCK("displaced: a shot meets a post, in a step by Box2D's list or not, and is hit in its sleep in the "
         "next one") {
    for (const bool byList : {true, false}) {
        Game game(run);
        for (int i = 0; i < 150; ++i)
            for (const float y : {50.0f, 50.9f})
                game.Box({3.0f * Real(i), y}, {0.4f, 0.4f})->SetAwake(false);
        std::vector<b2Body *> touching;
        for (int i = 0; i < 30; ++i) {
            touching.push_back(game.Awake({0.995f * Real(i % 6), -50.0f + 0.995f * Real(i / 6)}));
            touching.back()->SetAwake(byList);
        }
        game.Wall({0.0f, 0.0f}, {0.05f, 1.0f});
        b2Body *const first = game.Awake({-0.3f, 0.0f}, {0.1f, 0.1f});
        b2Body *const second = game.Awake({-0.6f, 0.0f}, {0.1f, 0.1f});
        second->SetBullet(true);
        game.Step(12);
        for (b2Body *body : touching)
            body->SetAwake(false);
        first->SetLinearVelocity({120.0f, 0.0f});
        game.Step();
        game.Stage(Game::LeftOf(0.0f, {first}) == 1, "the post stops the first");
        first->SetAwake(false);
        second->SetLinearVelocity({60.0f, 0.0f});
        game.Step();
        game.TookPlace(first->IsAwake(), "the second hits it");
        game.Step(3);
    }
}

// Box2D clears the forces of all bodies, also in a step that solves no island.
AS_STOCK("no time: a sleeper is pushed ahead of a step of no time, which forgets the push") {
    Game game(run);
    AddOthers(game);
    b2Body *const pushed = game.Box({0.0f, 40.0f});
    game.Step();
    pushed->SetAwake(false);
    game.Step(40); // until Bodies finds that few are awake
    const bool slept = !pushed->IsAwake();
    pushed->ApplyForceToCenter({50.0f, 0.0f}, true);
    game.Step(1, 0.0f);
    game.Step(5);
    game.TookPlace(slept, "a sleeper is pushed");
}

AS_STOCK("pushed: a listener pushes a sleeper in an impact, and the step forgets the push") {
    Game game(run);
    AddOthers(game);
    game.Wall({0.0f, 0.0f}, {0.05f, 1.0f});
    b2Body *const shot = game.Awake({-0.3f, 0.0f}, {0.1f, 0.1f}), *const pushed = game.Box({0.0f, 40.0f});
    pushed->SetAwake(false);
    game.Listen();
    game.Step(40); // until Bodies finds that few are awake
    int woken = 0;
    game.listener.begin.Once([pushed, &woken] {
        woken += pushed->IsAwake() ? 0 : 1;
        pushed->ApplyForceToCenter({50.0f, 0.0f}, true);
    });
    shot->SetLinearVelocity({120.0f, 0.0f});
    game.Step(5);
    game.TookPlace(woken, "a sleeper is pushed");
}

AS_STOCK("a body that nothing touches falls asleep after one position iteration, and not without any") {
    Game game(run);
    for (int i = 0; i < 30; ++i)
        for (const float y : {50.0f, 50.9f})
            game.Awake({-100.0f + 3.0f * Real(i), y}, {0.4f, 0.4f});
    b2Body *const alone = game.Box({0.0f, -50.0f});
    int slept[2] = {};
    for (const int iterations : {0, 1})
        for (int i = 0; i < 60; ++i) {
            game.world.Step(1.0f / 60.0f, 8, iterations);
            game.WriteDown();
            slept[iterations] += !alone->IsAwake();
        }
    game.TookPlace(slept[1], "a body falls asleep");
}
