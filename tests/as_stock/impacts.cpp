// SPDX-License-Identifier: MIT
// Worlds that change while Box2D looks for impacts, or before it does: who is a bullet, whom a joint names,
// and where a centre of mass is.
#include "as_stock.h"

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
