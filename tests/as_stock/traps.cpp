// SPDX-License-Identifier: MIT
// The traps that Box2D lays for whoever keeps state about its bodies: shapes and poses that change
// unannounced.
#include <cfenv>

#include "debug/inspect.h"
#include "yard.h"

using namespace as_stock;

AS_STOCK("fixtures A and B may change places between two contacts of one body pair") {
    Heard game(run);
    // The second plank lies three beside its body's origin, so that no symmetry hides a mix-up.
    b2Body *a = Slanting(game, 0.0f), *b = Slanting(game, -2.2f);
    constexpr int kAll = Game::kPlankPieces, kHalf = kAll / 2;
    game.Plank(a, {0.0f, 0.0f}, 0, kHalf);
    game.Plank(b, {0.0f, 3.0f});
    game.Plank(a, {0.0f, 0.0f}, kHalf, kAll);
    b->SetLinearVelocity(Slanted(0.0f, -1.0f));
    game.Step(3);
    int first[2] = {0, 0};
    for (b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext())
        ++first[c->GetFixtureA()->GetBody() == b];
    game.Stage(first[0] > 0 && first[1] > 0, "both orders");
    game.StagePairs();
    game.Step(45);
    game.Stage(game.Touching() > 1, "a collision");
    game.Step(40);
}

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

AS_STOCK("a new fixture at the address of an old one is not the old one") {
    Heard game(run);
    TwoPlanks planks(game, 0.6f);
    b2Fixture *old = planks.b->GetFixtureList(); // the newest: the right end
    planks.b->DestroyFixture(old);
    b2Fixture *made = game.Box(planks.b, 0.1f, 0.7f, {1.0f, 0.0f});
    game.Stage(made == old, "the same address");
    game.Step();
    game.Stage(game.Touching() >= 1, "a collision");
    game.Step(20);
}

AS_STOCK("a hull that two pairs share is forgotten by both when it grows") {
    Heard game(run);
    b2Body *bodies[3];
    for (int i = 0; i < 3; ++i) {
        bodies[i] = Slanting(game, 0.6f * Real(i - 1));
        game.Plank(bodies[i]);
    }
    game.Step(5);
    game.Stage(game.world.GetContactCount() >= 4 && game.Touching() == 0, "two pairs, apart");
    game.StagePairs();
    game.Box(bodies[1], 0.1f, 0.8f, {-1.0f, 0.0f});
    game.Step();
    game.Stage(game.Touching() >= 2, "a collision on either side");
    game.Step(20);
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

AS_STOCK("no structure vouches for a body that is far from its own origin, be it the first or the second") {
    constexpr float kFar = 3000.0f;
    for (const bool farFirst : {false, true}) {
        Heard game(run);
        for (const bool far : {farFirst, !farFirst})
            game.Plank(Slanting(game, far ? kFar + 0.6f : 0.0f, far ? b2_kinematicBody : b2_dynamicBody),
                       {0.0f, far ? -kFar : 0.0f});
        game.Step(2);
        game.Stage(game.world.GetContactCount() >= 2 && game.Touching() == 0, "contacts, apart");
        int vouched = 0;
        for (const b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext())
            vouched += run.HasPlugin() && bmr::internal::Inspect(*c).structure != nullptr;
        run.Expect(vouched == 0, "edges at most");
    }
}

// Our proofs are of numbers that are rounded to the nearest.
AS_STOCK_HOW(kMayBeSilent, "Box2D answers for sensors in steps that round otherwise") {
    Heard game(run);
    game.Box(game.Body(b2_staticBody, {0.0f, 0.0f}), 1.0f, 1.0f)->SetSensor(true);
    b2Body *const guest = game.Box({-0.8f, 0.1f}, {0.4f, 0.3f});
    guest->SetSleepingAllowed(false);
    guest->SetLinearVelocity({1.0f, 0.0f});
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_TONEAREST, FE_DOWNWARD, FE_TOWARDZERO}) {
        const uint64_t before = bmr::internal::ReadCounts().overlapsAnswered;
        std::fesetround(mode);
        game.Step(8);
        std::fesetround(FE_TONEAREST);
        const bool answered = bmr::internal::ReadCounts().overlapsAnswered > before;
        run.ExpectCounted(answered == (mode == FE_TONEAREST), "who answers");
    }
    game.Stage(game.world.GetContactList()->IsTouching(), "the guest is inside");
}
