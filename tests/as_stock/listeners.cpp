// SPDX-License-Identifier: MIT
// Listeners that come and go while they are told, and that change the contact that they are told of.
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

namespace {

/// Boxes apart, and boxes, sensors or not, that are deep in each other, each beside another one that is near
/// and comes nearer once somebody listens. Box2D's solver asserts that a contact that lost its points, or
/// whose fixtures turn solid, is then disabled, or that the step takes no time.
struct Changing : Game {
    Changing(Run &run, bool sensors) : Game(run) {
        for (int i = 0; i < 40; ++i)
            for (const float y : {0.0f, 1.1f})
                Awake({3.0f * Real(i), y});
        for (int i = 0; i < 12; ++i) {
            Awake({3.0f * Real(i), 10.0f})->GetFixtureList()->SetSensor(sensors);
            coming.push_back(Awake({3.0f * Real(i) + 1.1f, 9.8f}));
        }
        Step();
        for (int i = 0; i < 12; ++i) { // later, so that their contacts are looked at earlier
            Awake({3.0f * Real(i), 11.1f})->GetFixtureList()->SetSensor(sensors);
            Awake({3.0f * Real(i) + 1.1f, 8.7f});
        }
        Step(3);
        Listen();
    }
    void Play(int still = 0) {
        for (b2Body *body : coming)
            body->SetTransform(body->GetPosition() - b2Vec2(0.3f, 0.0f), 0.0f);
        Step(still, 0.0f);
        isStill = false;
        Step(40 - still);
    }
    std::vector<b2Body *> coming;
    bool isStill = true; ///< the steps of no time are not over
};

void SetSensors(b2Contact *contact, bool sensors) {
    contact->GetFixtureA()->SetSensor(sensors);
    contact->GetFixtureB()->SetSensor(sensors);
}

} // namespace

AS_STOCK("solid: a sensor's contact begins, and turns solid; in a step of no time it stays enabled") {
    for (const bool still : {false, true}) {
        Changing game(run, true);
        int turned = 0;
        game.listener.begin = [&turned, still](b2Contact *contact) {
            turned += contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor();
            SetSensors(contact, false);
            contact->SetEnabled(still);
        };
        game.Play(still ? 2 : 0);
        game.TookPlace(turned, "a sensor's contact turns solid");
    }
}

AS_STOCK("emptied: a contact loses its points, and is disabled; in a step of no time it stays enabled") {
    for (const bool still : {false, true}) {
        Changing game(run, false);
        int emptied = 0;
        game.listener.preSolve = [&game, &emptied, still](b2Contact *contact) {
            if (game.listener.told % 2 != 0 || game.isStill != still)
                return;
            contact->SetEnabled(still);
            emptied += contact->GetManifold()->pointCount > 0;
            contact->GetManifold()->pointCount = 0;
        };
        game.Play(still ? 2 : 0);
        game.TookPlace(emptied, "a contact loses its points");
    }
}

AS_STOCK("there and back: a contact loses its points, and is a sensor's until the next one is told of") {
    for (const bool still : {false, true}) {
        Changing game(run, false);
        b2Contact *turned = nullptr;
        int back = 0;
        game.listener.preSolve = [&game, &turned, &back, still](b2Contact *contact) {
            contact->SetEnabled(still);
            if (turned != nullptr) {
                ++back;
                SetSensors(turned, false);
                turned = nullptr;
            } else if (game.listener.told % 2 == 0 && game.isStill == still) {
                contact->GetManifold()->pointCount = 0;
                SetSensors(contact, true);
                turned = contact;
            }
        };
        game.Play(still ? 2 : 0);
        game.TookPlace(back, "a contact is a sensor's, and back");
    }
}

AS_STOCK("roused: a listener that is told of an island wakes bodies that sleep side by side") {
    Game game(run);
    std::vector<b2Body *> sleepers;
    for (int i = 0; i < 4; ++i)
        sleepers.push_back(game.Box({0.98f * Real(i), 0.0f}));
    for (int i = 0; i < 60; ++i)
        game.Near({3.0f * Real(i), 10.0f});
    game.Step(60);
    game.Leaning({0.0f, -20.0f});
    game.Listen();
    game.Step();
    for (b2Body *body : sleepers)
        body->SetAwake(false);
    game.Step(2);
    int woken = 0;
    game.listener.postSolve.Once([&sleepers, &woken] {
        for (b2Body *body : sleepers) {
            woken += body->IsAwake() ? 0 : 1;
            body->SetAwake(true);
        }
        sleepers[0]->SetLinearVelocity({3.0f, 0.0f});
    });
    game.Step(5);
    game.TookPlace(woken, "sleepers are woken");
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
