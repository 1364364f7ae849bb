// SPDX-License-Identifier: MIT
// A game changes polygons and places, between steps or inside one, and does not tell the library.
#include "as_stock.h"

using namespace as_stock;

// Two combs, apart from each other. The contacts of the first teeth are the oldest, so they are updated last;
// then come those of two boxes that touch; then those of the other teeth, which the hulls of the combs answer
// for. In between, the touching boxes' listener makes a tooth solid that was a sensor, in no hull, when the
// hulls were looked at, and that has grown since it was in one.
AS_STOCK("turning: a sensor whose vertices were changed turns solid in the midst of a step") {
    for (const float grown : {1.0f, 1.3f, 1.6f}) {
        Game game(run);
        game.Listen();
        const auto comb = [&game](float y) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.allowSleep = false;
            def.position.Set(0.0f, y);
            return game.world.CreateBody(&def);
        };
        const auto addTooth = [&game](b2Body *body, int place) {
            game.Box(body, 0.2f, 0.5f, {0.5f * Real(place), 0.0f});
        };
        b2Body *lower = comb(0.0f), *upper = comb(1.1f);
        addTooth(lower, 0);
        b2Fixture *growing = lower->GetFixtureList();
        for (int i = 0; i < 12; ++i)
            addTooth(upper, i);
        game.Step();
        game.Wall({-30.0f, 0.0f}, {1.0f, 1.0f});
        game.Awake({-30.0f, 1.99f}, {1.0f, 1.0f});
        game.Step();
        for (int i = 1; i < 12; ++i)
            addTooth(lower, i);
        game.Step(3);
        growing->SetSensor(true);
        static_cast<b2PolygonShape *>(growing->GetShape())->SetAsBox(0.2f, 0.5f * grown);
        int turned = 0;
        game.listener.preSolve = [growing, &turned] {
            turned += growing->IsSensor() ? 1 : 0;
            growing->SetSensor(false);
        };
        game.Step(5);
        game.TookPlace(turned, "a sensor turns solid in a step");
    }
}

namespace {

void TakeNormalsOfSides(b2PolygonShape *shape) {
    for (int32 i = 0; i < shape->m_count; ++i) {
        const b2Vec2 &next = shape->m_vertices[i + 1 < shape->m_count ? i + 1 : 0];
        shape->m_normals[i] = b2Cross(next - shape->m_vertices[i], 1.0f);
        shape->m_normals[i].Normalize();
    }
}

} // namespace

// The shots lie still for a step, and then pass the walls, or hit them once these are changed.
AS_STOCK("resting: walls have another vertex, one more, another skin, place or angle when shots come again") {
    const std::function<void(b2Body *, b2PolygonShape *)> changes[] = {
        [](b2Body *, b2PolygonShape *shape) { shape->m_vertices[0].x = -0.8f; },
        [](b2Body *, b2PolygonShape *shape) { shape->m_vertices[shape->m_count++].Set(-0.8f, 0.0f); },
        [](b2Body *, b2PolygonShape *shape) { shape->m_radius = 0.16f; },
        [](b2Body *wall, b2PolygonShape *) {
            wall->SetTransform(wall->GetPosition() - b2Vec2(0.2f, 0.0f), 0.0f);
        },
        [](b2Body *wall, b2PolygonShape *) { wall->SetTransform(wall->GetPosition(), 0.25f * b2_pi); },
    };
    Game game(run);
    std::vector<b2Body *> walls, shots;
    for (const auto &change : changes) {
        static_cast<void>(change);
        walls.push_back(game.Wall({6.0f * Real(static_cast<int>(walls.size())), 0.0f}));
        shots.push_back(game.Awake({0.0f, -6.0f}, {0.05f, 0.05f}));
    }
    for (const bool changed : {false, true}) {
        for (size_t i = 0; i < walls.size(); ++i) {
            shots[i]->SetTransform(walls[i]->GetPosition() + b2Vec2(-0.67f, -0.74f), 0.0f);
            shots[i]->SetLinearVelocity({0.0f, 0.0f});
            shots[i]->SetAngularVelocity(0.0f);
        }
        game.Step();
        for (size_t i = 0; i < walls.size(); ++i) {
            shots[i]->SetLinearVelocity({0.0f, 100.0f});
            if (!changed)
                continue;
            changes[i](walls[i], PolygonOf(walls[i]));
            TakeNormalsOfSides(PolygonOf(walls[i]));
        }
        game.Step();
        size_t hits = 0;
        for (const b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext())
            hits += c->IsTouching();
        game.Stage(hits == (changed ? walls.size() : 0), "walls are hit once they are changed");
    }
}

AS_STOCK_HOW(kMayBeSilent, "linked: shots hit links of a long chain in one step") {
    // Links that are a number of Fibonacci's apart fall on one place of a table that multiplies by the
    // golden ratio: of these couples some do, wherever the chain's memory is.
    constexpr int kShots = 16, kApart = 987, kLinks = kApart + kShots;
    const b2Vec2 link(-0.4f, 0.0f); // proofs end 500 m from the origin
    std::vector<b2Vec2> points;
    for (int i = 0; i <= kLinks; ++i)
        points.push_back(Real(i) * link);
    b2ChainShape chain;
    chain.CreateChain(points.data(), kLinks + 1, -link, points.back() + link);
    Game game(run);
    const b2BodyDef def;
    game.world.CreateBody(&def)->CreateFixture(&chain, 0.0f);
    for (int i = 0; i < kShots; ++i)
        for (const int number : {i, i + kApart}) {
            const b2Vec2 above = (Real(number) + 0.5f) * link + b2Vec2(0.0f, 0.2f);
            game.Awake(above, {0.05f, 0.05f})->SetLinearVelocity({0.0f, -100.0f});
        }
    game.Step();
    int through = 0;
    for (const b2Body *body = game.world.GetBodyList(); body != nullptr; body = body->GetNext())
        through += body->GetPosition().y < 0.0f;
    game.Stage(through == 0, "no shot goes through");
    game.TookPlace(game.Touching(), "shots hit links");
}
