// SPDX-License-Identifier: MIT
// Listeners that come and go while they are called, disable contacts, and wake bodies.
#include "as_stock.h"
#include "base/private_members.h"

using namespace as_stock;

namespace {

void AddEnabled(Game &game) {
    for (const b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext())
        game.hash.Add(static_cast<uint32_t>(c->IsEnabled()));
}

/// Boxes that fall on planks, and two listeners.
struct Falling : Game {
    explicit Falling(Run &run) : Game(run, {0.0f, -10.0f}), other(world, &hash) { FillWithBoxes(world); }
    Listener other;
};

/// Bullets among boxes at rest on planks. Between the solving of velocities and the end of a step, pairs come
/// up in SolveTOI alone, once bodies have moved: there the filter puts one listener in the other's place.
void PlaySwitches(Run &run, bool listens) {
    Falling game(run);
    if (listens)
        game.Listen();
    game.Ask();
    b2ContactListener *first = nullptr, *second = nullptr;
    b2Body *bullet = nullptr;
    b2Vec2 before(0.0f, 0.0f);
    int switches = 0;
    game.filter.asked = [&] {
        if (bullet == nullptr || bullet->GetPosition() == before)
            return;
        std::swap(first, second);
        game.world.SetContactListener(first);
        ++switches;
    };
    for (int step = 0; step < 200; ++step) {
        if (step % 10 == 0) {
            bullet = game.Box({0.1f * Real(step) - 10.0f, 14.0f}, {0.2f, 0.2f}, 0.4f);
            bullet->SetBullet(true);
            bullet->SetLinearVelocity({30.0f, -120.0f});
            first = &game.listener;
            second = &game.other;
        }
        before = bullet->GetPosition();
        game.Step();
    }
    game.TookPlace(switches, "listeners change places");
}

} // namespace

AS_STOCK("switched: a filter puts another listener into the world while Box2D looks for impacts") {
    PlaySwitches(run, true);
}

AS_STOCK("brought: a filter brings the first listener while Box2D looks for impacts") {
    PlaySwitches(run, false);
}

AS_STOCK("disables: a listener disables all contacts when one begins, and leaves, or is taken away after the "
         "step") {
    for (const bool leaves : {false, true}) {
        Falling game(run);
        int disabled = 0;
        game.listener.begin = [&game, &disabled, leaves] {
            for (b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext()) {
                c->SetEnabled(false);
                ++disabled;
            }
            if (leaves)
                game.world.SetContactListener(nullptr);
        };
        for (int step = 0; step < 150; ++step) {
            game.world.SetContactListener(step % 3 == 0 ? &game.listener : nullptr);
            game.Step();
            AddEnabled(game);
        }
        game.TookPlace(disabled, "contacts are disabled");
    }
}

AS_STOCK("woken: a listener wakes, in an impact, who fell asleep in the same step") {
    Game game(run, {0.0f, -10.0f});
    game.Box(game.Wall({0.0f, -1.0f}, {60.0f, 1.0f}), 1.0f, 5.0f, {10.0f, 6.0f});
    b2Body *const rests = game.Box({0.0f, 0.5f}), *const shot = game.Box({8.0f, 5.0f}, {0.1f, 0.1f});
    shot->SetBullet(true);
    for (int i = 0; i < 60; ++i)
        game.Near({30.0f, 1.0f + 1.5f * Real(i)});
    game.Listen();
    int woken = 0;
    game.listener.begin = [rests, &woken](b2Contact *) {
        woken += rests->IsAwake() ? 0 : 1;
        if (!rests->IsAwake())
            rests->SetAwake(true);
    };
    for (int i = 0; i < 150; ++i) {
        shot->SetTransform({8.0f, 5.0f}, 0.0f);
        shot->SetLinearVelocity({100.0f, 0.0f});
        game.Step(1);
        game.hash.Add(bmr::SweepOf(*rests).alpha0);
    }
    game.Step(1);
    game.TookPlace(woken, "the listener wakes one");
}
