// SPDX-License-Identifier: MIT
// Worlds that are rounded in another direction than to the nearest, as libraries for intervals leave a
// thread; and needles that turn by next to nothing.
#if defined(__SSE2__)
#    include <xmmintrin.h>
#endif

#include "as_stock.h"

using namespace as_stock;

namespace {

/// Boxes that are an ulp too wide are seen nowhere else.
void AddBounds(Game &game) {
    for (const b2Body *body = game.world.GetBodyList(); body != nullptr; body = body->GetNext())
        for (const b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
            for (const b2Vec2 &corner : {f->GetAABB(0).lowerBound, f->GetAABB(0).upperBound}) {
                game.hash.Add(corner.x);
                game.hash.Add(corner.y);
            }
}

/// An edge and a chain far from all else, and boxes that fall upon them.
void AddTerrain(Game &game) {
    b2EdgeShape edge;
    edge.SetTwoSided({200.0f, 0.0f}, {206.0f, 0.7f});
    const b2Vec2 bends[] = {{216.0f, 0.3f}, {213.0f, 0.0f}, {210.0f, 0.2f}, {207.0f, 0.1f}};
    b2ChainShape chain;
    chain.CreateChain(bends, 4, {219.0f, 0.0f}, {205.0f, 0.6f});
    b2Body *const ground = game.Body(b2_staticBody, {0.0f, 0.0f});
    game.Fixture(ground, edge);
    game.Fixture(ground, chain);
    for (int i = 0; i < 10; ++i)
        game.Box({201.3f + 1.4f * Real(i), 1.7f}, {0.3f, 0.2f});
}

/// Every third step is rounded otherwise, the first one among them; or those from each second call of a
/// listener's on.
void PlayRounded(Run &run, int mode, bool listens) {
    std::fesetround(listens ? FE_TONEAREST : mode);
    Game game(run, {0.0f, -10.0f});
    FillWithBoxes(game.world);
    game.Wheel({-3.0f, 20.0f}, 24, 1.5f);
    game.Wheel({-2.0f, 24.0f}, 24, 1.5f);
    AddTerrain(game);
    if (listens)
        game.Listen();
    int calls = 0, rounded = 0;
    game.listener.begin = [&run, &calls, mode] {
        run.ChangesRounding();
        std::fesetround(++calls % 2 == 0 ? mode : FE_TONEAREST);
    };
    for (int step = 0; step < 150; ++step) {
        if (!listens)
            std::fesetround(step % 3 == 0 ? mode : FE_TONEAREST);
        game.Step();
        AddBounds(game);
        rounded += std::fegetround() == mode;
    }
    std::fesetround(FE_TONEAREST);
    game.TookPlace(rounded, "steps are rounded otherwise");
    game.TookPlace(game.Touching(), "boxes touch");
}

} // namespace

TEST_CASE("rounded: every third step is rounded otherwise, or a listener changes how it is, and that stays") {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
        for (const bool listens : {false, true})
            AsStock([=](Run &run) { PlayRounded(run, mode, listens); });
}

// Rows of boxes that are too near each other, and turn.
AS_STOCK_HOW(kMayBeSilent, "turned: PostSolve changes how a thread is rounded, and that stays") {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        Game game(run);
        for (int i = 0; i < 60; ++i)
            game.Awake({0.93f * Real(i % 20), 4.0f * Real(i / 20)})->SetAngularVelocity(Real(i));
        game.Listen();
        game.listener.postSolve = [&run, mode] {
            run.ChangesRounding();
            std::fesetround(mode);
        };
        int turned = 0;
        for (int step = 0; step < 4; ++step) {
            game.Step();
            turned += std::fegetround() == mode;
            std::fesetround(FE_TONEAREST);
        }
        game.TookPlace(turned, "the other rounding stays");
    }
}

#if defined(__SSE2__)
// Box2D's answer for the sensor underflows nowhere. The square of its angle does.
AS_STOCK_HOW(kMayBeSilent,
             "trapped: an underflow ends the program while a sensor is asked, and from one call of a "
             "listener's to the next") {
    Game game(run);
    std::vector<b2Body *> moved;
    for (int i = 0; i < 60; ++i)
        game.Near({3.0f * Real(i), 50.0f});
    moved.push_back(game.Near({0.0f, 0.0f}));
    game.Step();
    b2PolygonShape square;
    square.SetAsBox(0.5f, 0.5f);
    game.Fixture(game.Body(b2_staticBody, {0.0f, 20.0f}, 1e-25f), square, true);
    game.Awake({0.6f, 20.0f});
    game.Step();
    moved.push_back(game.Near({0.0f, 10.0f}));
    game.Step(2);
    for (b2Body *body : moved)
        Place(body, body->GetPosition() - b2Vec2(0.105f, 0.0f));
    game.Listen();
    int calls = 0;
    game.listener.begin = [&run, &calls] {
        run.ChangesRounding();
        _mm_setcsr(++calls == 1 ? _mm_getcsr() & ~unsigned{_MM_MASK_UNDERFLOW}
                                : _mm_getcsr() | _MM_MASK_UNDERFLOW);
    };
    game.Step();
    game.TookPlace(calls - 1, "there is a call that sets it, and one that ends it");
}
#endif

// What is lost in each step is lost often.
AS_STOCK("slow: needles turn by next to nothing in each step, until they meet") {
    for (const float out : {0.0f, 600.0f}) {
        Game game(run);
        for (int i = 0; i < 12; ++i)
            for (const float side : {0.0f, 0.1f})
                game.Awake({out + 3.0f * Real(i), side}, {1.0f, 0.02f})
                    ->SetAngularVelocity((side > 0.0f ? -0.0006f : 0.0006f) * Real(i + 1));
        game.Step(4000);
        game.TookPlace(game.Touching(), "needles meet");
    }
}
