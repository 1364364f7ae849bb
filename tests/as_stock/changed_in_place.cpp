// SPDX-License-Identifier: MIT
// Links of a long chain that fall on one place of a table. Shapes of more than 8 vertices and pieces of
// outlines, changed between steps, on a ground of merged tiles and beside repaired outlines.
#if defined(WITH_REPAIR)
#    include <boomerang/repair.h>
#endif

#include "as_stock.h"
#include "boomerang/convex_shape.h"
#include "boomerang/outline_shape.h"

using namespace as_stock;

AS_STOCK_HOW(kMayBeSilent, "linked: shots hit links of a long chain in one step") {
    // Links that are a number of Fibonacci's apart fall on one place of a table that multiplies by the
    // golden ratio: of these pairs some do, wherever the chain's memory is.
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

// Box2D then takes the far sides of the two for those that face each other, and the two to touch.
AS_STOCK("tilted: normals are written to of bars and of boxes that pass above them") {
    const b2Vec2 tilted = b2Rot(b2_pi / 36.0f).GetXAxis();
    Game game(run);
    std::vector<b2Body *> boxes;
    for (int i = 0; i < 60; ++i) {
        const float x = 10.0f * Real(i);
        PolygonOf(game.Wall({x, 0.0f}, {3.0f, 0.02f}))->m_normals[2] = tilted;
        boxes.push_back(game.Awake({x + 3.14f, 0.19f}, {0.1f, 0.02f}));
        PolygonOf(boxes.back())->m_normals[0] = -tilted;
        boxes.back()->SetLinearVelocity({-1.0f, 0.0f});
    }
    int touched = 0;
    for (int step = 0; step < 25; ++step) {
        game.Step();
        touched += game.Touching();
    }
    game.TookPlace(touched, "boxes are taken to touch");
}

// --- big shapes ---

namespace {

void Scale(b2PolygonShape *shape, float by) {
    for (int32 i = 0; i < shape->m_count; ++i)
        shape->m_vertices[i] = shape->m_centroid + by * (shape->m_vertices[i] - shape->m_centroid);
}

/// Makes boxes of shapes, moves one vertex, makes all smaller, and puts another polygon in the place of a
/// coin's, by turns.
void Edit(b2Body *body, int kind) {
    for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        auto *shape = static_cast<b2PolygonShape *>(f->GetShape());
        if (kind % 4 == 3) {
            bmr::ConvexShape other;
            if (body->GetFixtureList()->GetNext() == nullptr && other.SetRegular(9 + kind, 0.7f) == BMR_OK)
                *static_cast<bmr::ConvexShape *>(shape) = other;
        } else if (kind % 4 == 0) {
            shape->SetAsBox(0.6f, 0.2f, shape->m_centroid, 0.3f);
        } else if (kind % 4 == 1) {
            shape->m_vertices[0] = shape->m_centroid + 1.25f * (shape->m_vertices[0] - shape->m_centroid);
            shape->Set(shape->m_vertices, shape->m_count);
        } else {
            Scale(shape, 0.7f);
        }
    }
    body->SetAwake(true);
}

#if defined(WITH_REPAIR)
void AddOutlines(b2Body *body, const std::vector<bmr::Outline> &outlines) {
    for (const bmr::Outline &outline : outlines) {
        bmr::OutlineShape shape;
        if (shape.Set(outline.GetRings()) == BMR_OK)
            shape.CreateFixtures(body, 1.0f);
    }
}

/// Steps of tiles on the ground, and a bow that crosses itself above them.
void AddRepaired(b2World &world, b2Body *ground, float away, std::vector<b2Body *> *bodies) {
    std::vector<bmr::Outline> tiles(30), merged;
    for (int i = 0; i < 30; ++i) {
        const float left = 0.5f * Real(i) - 7.0f, top = 0.1f * Real(i / 5 % 3);
        const b2Vec2 tile[] = {{left, -0.1f}, {left + 0.499f, -0.1f}, {left + 0.499f, top}, {left, top}};
        tiles[static_cast<size_t>(i)].AddRing(tile, 4);
    }
    if (MergeOutlines(tiles.data(), tiles.size(), bmr::FillRule::NonZero, 0.01, &merged) == BMR_OK)
        AddOutlines(ground, merged);
    const b2Vec2 bow[] = {{-0.5f, -0.5f}, {0.5f, 0.5f}, {0.5f, -0.5f}, {-0.5f, 0.5f}};
    bmr::Outline drawn;
    drawn.AddRing(bow, 4);
    if (RepairOutline(drawn, bmr::FillRule::EvenOdd, 0.01, &merged) != BMR_OK)
        return;
    b2BodyDef def;
    def.type = b2_dynamicBody;
    for (int i = 0; i < 4; ++i) {
        def.position.Set(away + 1.5f * Real(i) - 3.0f, 6.0f);
        bodies->push_back(world.CreateBody(&def));
        AddOutlines(bodies->back(), merged);
    }
}
#endif

/// The hash of all that happened. `edited`: between steps and, in some, at the first body that is told of.
uint64_t PlayBig(Run &run, float away, bool edited) {
    Game game(run, {0.0f, -10.0f});
    b2BodyDef def;
    def.position.Set(away, 0.0f);
    b2Body *ground = game.world.CreateBody(&def);
    game.Box(ground, 30.0f, 1.0f, {0.0f, -1.0f});
    bmr::ConvexShape coin;
    coin.SetRegular(64, 0.4f);
    const b2Vec2 elbow[] = {{-0.6f, -0.6f}, {0.6f, -0.6f}, {0.6f, 0.0f},
                            {0.0f, 0.0f},   {0.0f, 0.6f},  {-0.6f, 0.6f}};
    bmr::OutlineShape outline;
    outline.Set(elbow, 6);
    std::vector<b2Body *> bodies;
    def.type = b2_dynamicBody;
    for (int i = 0; i < 24; ++i) {
        def.position.Set(away + 1.3f * Real(i % 8) - 5.0f, 1.0f + 1.5f * Real(i / 8));
        def.bullet = i % 5 == 0;
        bodies.push_back(game.world.CreateBody(&def));
        if (i % 2 == 0)
            bodies.back()->CreateFixture(&coin, 1.0f);
        else
            outline.CreateFixtures(bodies.back(), 1.0f);
    }
#if defined(WITH_REPAIR)
    AddRepaired(game.world, ground, away, &bodies);
#endif
    bool mayEdit = false;
    game.listener.preSolve = [&mayEdit](b2Contact *contact) {
        if (!mayEdit || contact->GetFixtureB()->GetBody()->GetType() != b2_dynamicBody)
            return;
        mayEdit = false;
        Scale(static_cast<b2PolygonShape *>(contact->GetFixtureB()->GetShape()), 0.9f);
    };
    if (edited)
        game.Listen();
    for (int step = 0; step < 240; ++step) {
        mayEdit = step % 40 == 25;
        if (edited && step % 20 == 10)
            Edit(bodies[static_cast<size_t>(step / 10 * 7) % bodies.size()], step / 20);
        game.Step();
    }
    Hash bits;
    for (const b2Body *body : bodies)
        for (const float value : {body->GetPosition().x, body->GetPosition().y, body->GetAngle()})
            bits.Add(value);
    return bits.Value();
}

} // namespace

AS_STOCK("big: shapes and outlines are changed between steps and in their midst, near the origin and far "
         "away") {
    for (const float away : {10.0f, 1000.0f, 8000.0f})
        run.Stage(PlayBig(run, away, false) != PlayBig(run, away, true), "an edit changes what happens");
}
