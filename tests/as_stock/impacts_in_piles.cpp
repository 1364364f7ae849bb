// SPDX-License-Identifier: MIT
// Worlds in which nearly all pairs touch, so that impacts are searched for in Box2D's list.
#include "as_stock.h"

using namespace as_stock;

namespace {

/// Columns of boxes; shots that lie ahead of posts, the first ahead of a wall.
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
    "about to hit, or steps the world") {
    for (const int way : {0, 1, 2}) {
        Pile game(run);
        game.Listen();
        const auto make = [&game](bool bullets) {
            for (b2Body *shot : game.shots)
                shot->SetBullet(bullets);
        };
        make(way > 0);
        game.Throw();
        game.listener.begin.Once([&game, &make, way] {
            if (way < 2)
                make(way == 0);
            else
                game.StepWithin(1.0f / 60.0f, 8);
        });
        game.Step(4);
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
        game.filter.asked = [&game](b2Fixture *a, b2Fixture *b) {
            const b2Vec2 v = b2Min(a->GetBody()->GetLinearVelocity(), b->GetBody()->GetLinearVelocity());
            game.filter.refuses = v.x < 0.0f; // it has bounced
            for (b2Body *shot : game.shots)
                shot->SetBullet(game.filter.refuses);
        };
        game.Step(8);
    }
}
