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

AS_STOCK("driven: sleepers are woken while islands are built, by a joint or by who touches them, and get "
         "contacts in that very step") {
    Game game(run);
    AddOthers(game);
    std::vector<b2Body *> drivers, sleepers;
    for (int i = 0; i < 12; ++i) {
        const float y = 4.0f * Real(i);
        const bool joined = i % 2 == 0;
        drivers.push_back(game.Box({joined ? 8.0f : -0.99f, y}));
        b2Body *const driven = game.Box({0.0f, y});
        sleepers.push_back(driven);
        game.Wall({1.6f, y + 0.3f}); // in its way
        if (joined)
            game.Tie(drivers.back(), driven);
    }
    game.Step(90);
    int woken = 0;
    for (b2Body *driver : drivers) {
        Drive(driver);
        game.Step();
        for (const b2Body *sleeper : sleepers)
            woken += sleeper->IsAwake() && sleeper->GetContactList() != nullptr;
        for (b2Body *body = game.world.GetBodyList(); body != nullptr; body = body->GetNext())
            if (body->IsSleepingAllowed())
                body->SetAwake(false);
    }
    game.TookPlace(woken, "a sleeper is woken, and has a contact");
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

AS_STOCK("displaced: bullets hit a floor in one step after the other, some of them rounded upward; all else "
         "sleeps") {
    for (const bool upward : {false, true}) {
        Game game(run);
        std::vector<b2Body *> bullets;
        AddOthers(game);
        game.Wall({0.0f, 0.0f}, {60.0f, 0.02f});
        for (int i = 0; i < 16; ++i) { // two hit in steps that follow each other, the second one earlier
                                       // in its step; none in the next
            const float hit = Real(3 * (i / 2) + 4) + (i % 2 == 0 ? 0.6f : 1.3f);
            b2Body *const bullet = game.Box({3.0f * Real(i - 8), 0.12f + hit}, {0.1f, 0.1f});
            bullet->SetBullet(true);
            bullet->SetLinearVelocity({0.0f, -60.0f});
            bullets.push_back(bullet);
        }
        for (int i = 0; i < 32; ++i) {
            std::fesetround(upward && i % 3 == 1 ? FE_UPWARD : FE_TONEAREST);
            game.Step();
        }
        std::fesetround(FE_TONEAREST);
        int stopped = 0;
        for (const b2Body *bullet : bullets)
            stopped += bullet->GetPosition().y > 0.0f;
        game.TookPlace(stopped, "the floor stops bullets");
    }
}

AS_STOCK("order: bodies go, and as many come at the places of those in memory, in another order") {
    Game game(run);
    AddOthers(game);
    for (int i = 0; i < 8; ++i)
        game.Wall({4.0f * Real(i), 0.0f});
    game.Step(3);
    for (int round = 0; round < 6; ++round) {
        // Each comes near a wall in the same step: every other one touches it.
        const auto add = [&game](int i) {
            return game.Box({4.0f * Real(i) + (i % 2 == 0 ? 0.0f : 0.9f), 1.5f});
        };
        std::vector<b2Body *> bodies;
        for (int i = 0; i < 8; ++i)
            bodies.push_back(add(i));
        game.Step();
        const b2Body *const places[] = {bodies[7], bodies[2]};
        for (const size_t i : {size_t{7}, size_t{2}})
            game.world.DestroyBody(bodies[i]);
        bodies[2] = add(2);
        bodies[7] = add(7);
        for (const b2Body *place : places)
            game.TookPlace((bodies[2] == place) + (bodies[7] == place),
                           "a body comes at the place of another");
        for (size_t i = 0; i < bodies.size(); ++i)
            bodies[i]->SetLinearVelocity({0.0f, i % 2 == 0 ? -30.0f : -24.0f});
        game.Step(3);
        for (b2Body *body : bodies)
            game.world.DestroyBody(body);
    }
}

namespace {

enum class Lapse { kRounded, kImpact, kRoundedImpact };

/// When nobody knows that the two touch, nobody takes their contact out of an island of an earlier step.
void PlayLapse(Run &run, Lapse lapse) {
    Game game(run);
    b2World &world = game.world;
    world.SetContinuousPhysics(lapse != Lapse::kRounded);
    AddOthers(game);
    b2Body *const bullet = game.Box({-3.0f, 0.0f}, {0.3f, 0.3f}), *const pulling = game.Box({0.0f, 5.0f});
    // (Of boxes the library is told.)
    b2Body *const one = game.Disk({0.0f, 0.0f}, 0.5f), *const other = game.Disk({1.03f, 0.0f}, 0.5f);
    game.Tie(pulling, one);
    int met = 0;
    for (const float x : {0.0f, 0.99f}) // touch, so that a listener is called ahead of impacts
        game.Awake({x, 200.0f});
    game.listener.postSolve = [&run] {
        run.ChangesRounding();
        std::fesetround(FE_UPWARD);
    };
    const auto sleep = [&] {
        for (b2Body *body : {bullet, pulling, one, other})
            body->SetAwake(false);
    };
    game.Step();
    sleep();
    game.Step(4);
    if (lapse == Lapse::kRounded) {
        std::fesetround(FE_UPWARD);
        one->SetAwake(true);
        one->SetLinearVelocity({3.0f, 0.0f});
        game.Step(4);
        met += game.Touching() > 1;
        std::fesetround(FE_TONEAREST);
    } else {
        if (lapse == Lapse::kRoundedImpact)
            game.Listen();
        one->SetBullet(true);
        bullet->SetBullet(true);
        bullet->SetLinearVelocity({100.0f, 0.0f});
        for (int i = 0; i < 2; ++i) {
            game.Step();
            std::fesetround(FE_TONEAREST);
        }
        met += one->GetContactList() != nullptr && game.Touching() > 1;
        world.SetContactListener(nullptr);
        one->SetBullet(false);
        bullet->SetTransform({-50.0f, 0.0f}, 0.0f);
    }
    for (int i = 0; i < 3; ++i) {
        sleep();
        if (lapse != Lapse::kRounded)
            game.Step();
        pulling->SetAwake(true);
        pulling->SetLinearVelocity({0.0f, 20.0f});
        game.Step();
    }
    game.TookPlace(met, "two that slept come to touch");
}

} // namespace

AS_STOCK("lapsed: two that sleep come to touch when the library does not look, and islands come to them by a "
         "joint") {
    for (const Lapse lapse : {Lapse::kRounded, Lapse::kImpact, Lapse::kRoundedImpact})
        PlayLapse(run, lapse);
}
