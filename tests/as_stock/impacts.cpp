// SPDX-License-Identifier: MIT
// Worlds that change while Box2D looks for impacts, or before it does: who is a bullet, whom a joint names,
// and where a centre of mass is.
#include "as_stock.h"
#include "boomerang/box2d_glue.h"

using namespace as_stock;

// A filter is asked about these.
AS_STOCK("geared: gear joints are made whose definitions name bodies that the joints do not join") {
    Game game(run);
    std::vector<b2Body *> crowd, turning;
    for (int i = 0; i < 24; ++i) // near each other
        crowd.push_back(game.Awake({1.05f * Real(i % 12), 40.0f + 1.05f * Real(i / 12)}));
    for (const float y : {0.0f, 4.0f})
        turning.push_back(game.Awake({0.0f, y}));
    game.Step(6);
    const b2BodyDef def;
    b2Body *const anchor = game.world.CreateBody(&def);
    b2GearJointDef gear;
    gear.joint1 = game.Hinge(anchor, turning[0], turning[0]->GetPosition());
    gear.joint2 = game.Hinge(anchor, turning[1], turning[1]->GetPosition());
    game.filter.refuses = true;
    game.Ask();
    for (size_t i = 0; i < 12; ++i) {
        gear.bodyA = crowd[i];
        gear.bodyB = crowd[i + 12];
        game.world.CreateJoint(&gear);
        game.Step();
    }
    game.TookPlace(game.filter.count, "the filter is asked about those that are named");
}

// Bars in front of plates that stand aslant. Each bar's centre of mass is near the plate, and then in its
// middle: it has moved towards the plate by less than the bar does.
AS_STOCK("recentred: a listener gives bodies other centres of mass, and throws them, when they have been "
         "looked at") {
    const b2Rot aslant(0.25f * b2_pi);
    Game game(run);
    std::vector<b2Body *> bars;
    for (int i = 0; i < 40; ++i) {
        const b2Vec2 at(6.0f * Real(i), 0.0f);
        game.Wall(at, {0.02f, 3.0f}, aslant.GetAngle());
        bars.push_back(game.Awake(at + 0.79f * aslant.GetXAxis(), {0.4f, 0.1f}, aslant.GetAngle()));
        b2MassData mass;
        bars.back()->GetMassData(&mass);
        mass.center.Set(-0.29f, 0.0f);
        mass.I = 2.0f * mass.mass;
        bars.back()->SetMassData(&mass);
    }
    game.Leaning({0.0f, 90.0f});
    game.Listen();
    game.Step(4);
    int thrown = 0;
    game.listener.preSolve.Once([&bars, &aslant, &thrown] {
        float speed = 20.0f;
        for (b2Body *bar : bars) {
            bar->ResetMassData();
            bar->SetLinearVelocity(-speed * aslant.GetXAxis());
            speed += 0.5f;
            ++thrown;
        }
    });
    game.Step(3);
    game.TookPlace(thrown, "bars get other centres of mass");
    game.TookPlace(game.Touching() - 1, "bars meet their plates");
}

namespace {

/// Nearly all pairs touch, so that impacts are searched for in Box2D's list: columns of boxes; shots that lie
/// ahead of posts, the first ahead of a wall.
struct Pile : Game {
    explicit Pile(Run &run) : Game(run, {0.0f, -10.0f}) {
        Wall({0.0f, -1.0f}, {60.0f, 1.0f});
        for (int i = 0; i < 12; ++i)
            for (int k = 0; k < 8; ++k)
                Awake({-9.0f + 1.3f * Real(i), 0.5f + Real(k)});
        for (int i = 0; i < 8; ++i) {
            const float y = 20.0f + 4.0f * Real(i);
            shots.push_back(Shot(i == 0 ? -1.0f : -1.5f, y));
            if (i == 0)
                Wall({0.0f, y}, {0.05f, 1.0f});
            else
                Awake({0.0f, y}, {0.05f, 1.0f})->SetGravityScale(0.0f);
        }
        Step(40);
    }
    b2Body *Shot(float x, float y) {
        b2Body *const shot = Awake({x, y}, {0.1f, 0.1f});
        shot->SetGravityScale(0.0f);
        return shot;
    }
    void Throw() {
        for (b2Body *shot : shots)
            shot->SetLinearVelocity({120.0f, 0.0f}); // Box2D's most
    }
    std::vector<b2Body *> shots;
};

} // namespace

AS_STOCK_HOW(
    kMayBeSilent,
    "heaped: in an impact a listener makes bullets of other shots, or makes those no bullets that are "
    "about to hit") {
    for (const bool bullets : {true, false}) {
        Pile game(run);
        game.Listen();
        const auto make = [&game](bool areBullets) {
            for (b2Body *shot : game.shots)
                shot->SetBullet(areBullets);
        };
        make(!bullets);
        game.Throw();
        int made = 0;
        game.listener.begin.Once([&] {
            make(bullets);
            ++made;
        });
        game.Step(4);
        game.TookPlace(made, "there is an impact");
    }
}

AS_STOCK_HOW(
    kMayBeSilent,
    "heaped: a shot that bounces off a wall comes to the next one in the same step, and a filter that is "
    "asked makes bullets") {
    for (const bool asks : {false, true}) {
        Pile game(run);
        std::vector<b2Body *> shots;
        for (int i = 0; i < (asks ? 1 : 4); ++i) {
            const float y = 60.0f + 4.0f * Real(i);
            for (const float x : {-0.5f, 0.9f})
                game.Wall({x, y}, {0.05f, 1.0f})->GetFixtureList()->SetRestitution(1.0f);
            shots.push_back(game.Shot(0.5f, y));
        }
        game.Step(2);
        for (b2Body *shot : shots)
            shot->SetLinearVelocity({120.0f, 0.0f});
        game.Throw();
        if (asks)
            game.Ask();
        int bounced = 0;
        game.filter.asked = [&game, &bounced](b2Fixture *a, b2Fixture *b) {
            const b2Vec2 v = b2Min(a->GetBody()->GetLinearVelocity(), b->GetBody()->GetLinearVelocity());
            game.filter.refuses = v.x < 0.0f; // it has bounced
            bounced += game.filter.refuses ? 1 : 0;
            for (b2Body *shot : game.shots)
                shot->SetBullet(game.filter.refuses);
        };
        game.Step(8);
        bounced += asks ? 0 : Game::LeftOf(0.9f, shots) - Game::LeftOf(-0.5f, shots);
        game.TookPlace(bounced, "a shot bounces");
    }
}

namespace {

/// Pairs that are apart, two that lean on each other, and two shots and a box in front of posts. The contact
/// of the two that lean is older than the box's.
struct Posts : Game {
    explicit Posts(Run &run) : Game(run) {
        for (int i = 0; i < 60; ++i)
            apart.push_back(Near({3.0f * Real(i), 50.0f}));
        Leaning({0.0f, 90.0f});
        Step();
        box = InFront(0.0f, 0.2f);
        shot = InFront(10.0f, 0.1f);
        later = InFront(20.0f, 0.1f);
        Step(4);
    }
    b2Body *InFront(float y, float half) {
        Wall({0.0f, y}, {0.05f, 1.0f});
        return Awake({-0.05f - half - 0.15f, y}, {half, half});
    }
    /// The box's contact.
    b2Contact *OfBox() const { return box->GetContactList()->contact; }
    /// The shot's impact ends the next step half-way.
    void StopNextStep() {
        world.SetSubStepping(true);
        shot->SetLinearVelocity({120.0f, 0.0f});
        Step();
        Stage(shot->GetPosition().x < -0.1f && shot->GetLinearVelocity().x < 1.0f, "the shot is stopped");
    }
    std::vector<b2Body *> apart;
    b2Body *box, *shot, *later;
};

} // namespace

// Of a contact that was disabled while impacts were searched for Box2D knows no time, and asks in the next
// step. Of others it knows one, also where Boomerang did not read them and is made to forget the world.
AS_STOCK("stopped: between two halves of a step a box grows that did not reach its post") {
    for (const bool disables : {true, false}) {
        Posts game(run);
        if (disables)
            game.Listen();
        game.listener.preSolve.Once([&game] { game.OfBox()->SetEnabled(false); });
        game.box->SetLinearVelocity({1.5f, 0.0f});
        game.StopNextStep();
        game.Stage(game.OfBox()->IsEnabled() != disables, "the contact is disabled");
        PolygonOf(game.box)->SetAsBox(0.34f, 0.2f);
        if (!disables)
            bmr::Forget(&game.world);
        game.Step(4);
        game.TookPlace(game.Touching() - 1, "the box meets its post");
    }
}

AS_STOCK("enabled: a listener disables a contact ahead of its impact, and enables it in another one") {
    for (const bool isKnown : {false, true}) {
        Posts game(run);
        game.Listen();
        int begun = 0, enabled = 0;
        if (!isKnown)
            game.listener.preSolve.Once([&game] { game.OfBox()->SetEnabled(false); });
        game.listener.begin = [&] {
            ++begun;
            if (isKnown && begun == 1)
                game.OfBox()->SetEnabled(false);
            if (begun != (isKnown ? 2 : 1))
                return;
            enabled += game.OfBox()->IsEnabled() ? 0 : 1;
            game.OfBox()->SetEnabled(true);
        };
        game.shot->SetLinearVelocity({120.0f, 0.0f});
        game.box->SetLinearVelocity({60.0f, 0.0f});
        game.later->SetLinearVelocity({10.0f, 0.0f});
        game.Step(2);
        game.TookPlace(enabled, "a contact is enabled");
        game.TookPlace(Game::LeftOf(0.0f, {game.box}), "the box meets its post");
    }
}

// Neither the shot nor the post was a bullet in the steps before: no search for impacts asked about them.
// Box2D asks the filter after the islands, about the shot and a box that the shot comes to in this step.
AS_STOCK(
    "bullet: a listener in the loop over contacts, or a filter, makes a bullet of a box that is thrown") {
    for (const bool asks : {false, true}) {
        Game game(run);
        for (int i = 0; i < 60; ++i)
            game.Near({3.0f * Real(i), 50.0f});
        game.Leaning({0.0f, 90.0f});
        const b2Body *const post = game.Awake({0.0f, 0.0f}, {0.05f, 1.0f});
        b2Body *const shot = game.Awake({-0.3f, 0.0f}, {0.1f, 0.1f});
        game.Awake({1.0f, 0.0f}, {0.1f, 0.1f});
        game.Step(6);
        game.listener.preSolve.Once([shot] {
            shot->SetBullet(true);
            shot->SetLinearVelocity({120.0f, 0.0f});
        });
        game.filter.asked = [shot] { shot->SetBullet(true); };
        if (asks) {
            shot->SetLinearVelocity({120.0f, 0.0f});
            game.Ask();
        } else {
            game.Listen();
        }
        game.Step();
        game.TookPlace(Game::LeftOf(post->GetPosition().x, {shot}), "the other box stops it");
        game.Step(3);
    }
}

// At an impact Box2D disables the contact if its shapes do not touch. It calls no listener before that.
AS_STOCK(
    "passed over: two without skins impact and do not touch, and a listener is told of the next impact") {
    Heard game(run);
    for (int i = 0; i < 60; ++i)
        game.Near({3.0f * Real(i), 50.0f});
    std::vector<b2Body *> shots;
    for (const float y : {0.0f, 10.0f}) {
        b2Body *const post = game.Wall({0.0f, y}, {0.05f, 1.0f});
        shots.push_back(game.Awake({-0.3f, y}, {0.1f, 0.1f}));
        if (y == 0.0f)
            PolygonOf(post)->m_radius = PolygonOf(shots[0])->m_radius = 0.0f;
    }
    game.Step(6);
    game.Stage(game.listener.calls == 0, "nobody is called");
    int disabled = 0;
    game.listener.begin = [&] { disabled += shots[0]->GetContactList()->contact->IsEnabled() ? 0 : 1; };
    shots[0]->SetLinearVelocity({120.0f, 0.0f});
    shots[1]->SetLinearVelocity({30.0f, 0.0f});
    game.Step();
    game.TookPlace(disabled, "a contact is disabled");
    game.Step(2);
}

// A sleeper's sweep is that of its last step. This one's leads through the platform.
AS_STOCK("woken: a shot wakes a platform, or a box that leans on it, and what has gone through it asleep is "
         "put back") {
    for (const int way : {0, 1, 2, 3}) {
        const bool leans = way % 2 == 1, isOldest = way / 2 == 1; // of a contact the older one is the first
        Game game(run);
        for (int i = 0; i < 60; ++i)
            game.Near({3.0f * Real(i), 50.0f});
        b2Body *shot = nullptr;
        const auto make = [&] { shot = game.Awake({leans ? -0.595f : -0.2f, 0.5f}, {0.1f, 0.1f}); };
        if (isOldest)
            make();
        b2Body *const platform = game.Body(b2_kinematicBody, {0.0f, 0.0f});
        game.Box(platform, 0.05f, 1.0f);
        b2Body *const through = game.Box({-0.5f, -0.6f}, {0.2f, 0.2f});
        b2Body *const leaning = leans ? game.Box({-0.245f, 0.5f}, {0.2f, 0.2f}) : platform;
        if (!isOldest)
            make();
        shot->SetBullet(true);
        game.Step(2);
        game.world.SetContinuousPhysics(false);
        through->SetLinearVelocity({60.0f, 0.0f});
        game.Step();
        game.Stage(through->GetPosition().x > 0.4f, "a box goes through the platform");
        game.world.SetContinuousPhysics(true);
        for (b2Body *body : {platform, through, leaning})
            body->SetAwake(false);
        shot->SetLinearVelocity({60.0f, 0.0f});
        game.Step();
        game.TookPlace(Game::LeftOf(0.0f, {through}), "it is put back");
        game.Step(3);
    }
}

AS_STOCK("half: in the second half of a step two come to touch that sleep again when the next one begins") {
    Posts game(run);
    b2Body *const left = game.Box({0.0f, -20.0f}), *const right = game.Box({1.05f, -20.0f});
    game.Step(2);
    for (b2Body *body : {left, right})
        body->SetAwake(false);
    game.Step();
    game.StopNextStep();
    Place(left, {0.055f, -20.0f});
    left->SetAwake(true);
    game.Step();
    for (b2Body *body : {left, right})
        body->SetAwake(false);
    game.Step(2);
    game.Listen();
    game.listener.preSolve.Once([left] {
        left->SetAwake(true);
        left->SetLinearVelocity({1.0f, 0.0f});
    });
    const bool slept = !right->IsAwake();
    game.Step();
    game.TookPlace(slept && right->IsAwake(), "one wakes the other");
}

// `Place` moves the body by so little that its fixture keeps its fat box.
AS_STOCK("half: in the second half of a step two come to touch that are back when the next one begins") {
    Posts game(run);
    b2Body *const right = game.Near({0.0f, -20.0f}, 0.05f);
    game.Step(2);
    game.StopNextStep();
    const b2Vec2 apart = right->GetPosition();
    Place(right, apart - b2Vec2(0.06f, 0.0f));
    game.Step();
    const int before = game.Touching();
    Place(right, apart);
    game.Step();
    game.TookPlace(before - game.Touching(), "the two touch, and part again");
}

AS_STOCK(
    "half: a listener disables a contact in the second half of a step, and a filter is asked ahead of the "
    "next one") {
    Posts game(run);
    game.StopNextStep();
    Place(game.apart[5], {15.79f, 50.0f});
    game.Listen();
    int disabled = 0;
    game.listener.preSolve = [&disabled](b2Contact *contact) {
        contact->SetEnabled(false);
        ++disabled;
    };
    game.Step();
    game.Ask();
    game.Awake({15.0f, 51.0f}, {0.4f, 0.4f});
    game.filter.asked = [&game] {
        for (const b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext())
            game.hash.Field("enabled", static_cast<uint32_t>(c->IsEnabled()));
    };
    game.Step();
    game.TookPlace(disabled - 1, "contacts are disabled");
    game.TookPlace(game.filter.count, "the filter is asked");
}

// Of its contacts the newest is updated ahead of the listener's call, the oldest behind it.
AS_STOCK("half: in the second half of a step a listener has a box grow that was looked at") {
    Posts game(run);
    b2Body *const box = game.Awake({0.0f, -20.0f}, {0.2f, 0.2f});
    game.Wall({0.4f, -20.0f}, {0.1f, 1.0f});
    game.Step();
    game.Leaning({0.0f, 120.0f});
    game.Step();
    game.Wall({-0.4f, -20.0f}, {0.1f, 1.0f});
    game.Step(3);
    game.StopNextStep();
    game.Listen();
    const int before = game.Touching();
    game.listener.preSolve.Once([box] { PolygonOf(box)->SetAsBox(0.35f, 0.2f); });
    game.Step();
    game.TookPlace(game.Touching() - before, "the box meets a wall");
}
