// SPDX-License-Identifier: MIT
// The traps that Box2D lays for a program that keeps state about its bodies: shapes that are changed in
// place, and fixtures that change unannounced. README.md has the list.
#include "as_stock.h"

using namespace as_stock;

AS_STOCK("an edge that was edited away separates nothing") {
    constexpr float kEighth = 0.785398185f;
    Heard game(run);
    b2Body *middle = game.Body(b2_dynamicBody, {0.0f, 0.0f});
    b2Vec2 corners[8];
    for (int i = 0; i < 8; ++i)
        corners[i] = b2Mul(b2Rot((Real(i) + 0.5f) * kEighth), b2Vec2(0.5f, 0.0f));
    b2PolygonShape octagon;
    octagon.Set(corners, 8);
    auto *shape = static_cast<b2PolygonShape *>(game.Fixture(middle, octagon)->GetShape());
    // A corner of a box towards each face, so that the octagon's edge is the one to remember.
    for (int i = 0; i < 8; ++i) {
        const b2Rot there(Real(i) * kEighth);
        game.Box(b2Mul(there, b2Vec2(0.78f, 0.0f)), {0.12f, 0.12f}, (Real(i) + 1.0f) * kEighth);
    }
    game.Step(3);
    game.Stage(game.Touching() == 0 && game.world.GetContactCount() >= 8, "a ring, apart");
    shape->SetAsBox(0.75f, 0.75f);
    game.Step();
    game.Stage(game.Touching() >= 4, "the box reaches into the ring");
    game.Step(10);
}

// --- What else changes unannounced: fixtures, hulls, places.

AS_STOCK("a fixture that is added outside the hull collides at once") {
    Heard game(run);
    TwoPlanks planks(game, 0.6f);
    const uint64_t before = bmr::internal::ReadCounts().hulls;
    game.Box(planks.b, 0.1f, 0.1f, {-1.0f, -0.6f});
    game.Step();
    run.ExpectCounted(run.RemembersEdges() || bmr::internal::ReadCounts().hulls > before,
                      "the hull is built anew");
    game.Stage(game.Touching() >= 1, "a collision");
    game.Step(20);
}

AS_STOCK("remembered edges are counted where they are asked, and nowhere else") {
    Heard game(run);
    b2Body *a = Slanting(game, 0.0f), *b = Slanting(game, 0.6f);
    game.Box(a, 2.0f, 0.1f);
    game.Box(b, 2.0f, 0.1f);
    game.Step(5);
    game.Stage(game.world.GetContactCount() == 1 && game.Touching() == 0, "a contact, apart");
    const bmr::Counted s = bmr::internal::ReadCounts();
    run.ExpectCounted(s.provedApart > 0, "it is answered");
    run.ExpectCounted(s.edgeChecks == (run.RemembersEdges() ? s.provedApart : 0), "by an edge, if any");
}

AS_STOCK("a sensor's polygon does not enter its body's hull") {
    Heard game(run);
    b2Body *a = Slanting(game, 0.0f), *b = Slanting(game, 0.6f);
    game.Plank(a);
    b2PolygonShape wide;
    wide.SetAsBox(5.0f, 5.0f);
    game.Fixture(b, wide, true);
    game.Plank(b);
    b->SetLinearVelocity(Slanted(0.01f, 0.0f));
    game.Step(100);
    game.Stage(game.world.GetContactCount() > 1 && game.Touching() == 0, "planks near each other");
    const bmr::Counted s = bmr::internal::ReadCounts();
    run.ExpectCounted(run.RemembersEdges() || (s.provedApart > 0 && s.handedOver == 0),
                      "the bodies' structure answers for the planks");
}

AS_STOCK("the hull of a level does not swallow what is inside") {
    Heard game(run);
    b2Body *level = game.Body(b2_staticBody, {0.0f, 0.0f}, kSlant);
    for (const float side : {-4.0f, 4.0f}) {
        game.Box(level, 8.0f, 0.1f, {0.0f, side});
        game.Box(level, 0.1f, 8.0f, {side, 0.0f});
    }
    b2Body *plank = Slanting(game, -3.5f);
    game.Plank(plank);
    plank->SetLinearVelocity(Slanted(0.01f, 0.0f));
    game.Step(100);
    const bmr::Counted s = bmr::internal::ReadCounts();
    game.Stage(game.world.GetContactCount() >= 2, "contacts with the level");
    run.ExpectCounted(run.RemembersEdges() || (s.provedApart > 0 && s.handedOver == 0),
                      "the structure of wall and plank answers");
    plank->SetLinearVelocity(Slanted(0.1f, -1.0f));
    game.Step(60);
    game.Stage(game.Touching() > 0, "a collision with the level");
}
