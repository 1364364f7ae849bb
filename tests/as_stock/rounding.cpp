// SPDX-License-Identifier: MIT
// Worlds that are rounded in another direction than to the nearest, as libraries for intervals leave a
// thread; and worlds where little is left of what is rounded.
#include "as_stock.h"

using namespace as_stock;

namespace {

enum class When { kBefore, kLater, kInTurn, kListening };

/// Boxes that are an ulp too wide are seen nowhere else.
void AddBounds(Game &game) {
    for (const b2Body *body = game.world.GetBodyList(); body != nullptr; body = body->GetNext())
        for (const b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
            for (const b2Vec2 &corner : {f->GetAABB(0).lowerBound, f->GetAABB(0).upperBound}) {
                game.hash.Add(corner.x);
                game.hash.Add(corner.y);
            }
}

void PlayRounded(Run &run, int mode, When when) {
    if (when == When::kBefore)
        std::fesetround(mode);
    Game game(run, {0.0f, -10.0f});
    FillWithBoxes(game.world);
    game.Wheel({-3.0f, 20.0f}, 24, 1.5f);
    game.Wheel({-2.0f, 24.0f}, 24, 1.5f);
    if (when == When::kListening)
        game.Listen();
    int calls = 0, rounded = 0;
    game.listener.begin = [&calls, mode] { std::fesetround(++calls % 2 == 0 ? mode : FE_TONEAREST); };
    for (int step = 0; step < 150; ++step) {
        if (when == When::kLater && step == 40)
            std::fesetround(mode);
        if (when == When::kInTurn)
            std::fesetround(step % 3 == 2 ? mode : FE_TONEAREST);
        game.Step();
        AddBounds(game);
        rounded += std::fegetround() == mode;
    }
    std::fesetround(FE_TONEAREST);
    game.TookPlace(rounded, "steps are rounded otherwise");
    game.TookPlace(game.Touching(), "boxes touch");
}

void PlayAll(When when) {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
        AsStock([=](Run &run) { PlayRounded(run, mode, when); });
}

} // namespace

TEST_CASE("before: a thread is rounded otherwise before its first step") {
    PlayAll(When::kBefore);
}

TEST_CASE("later: a thread is rounded otherwise from some step on") {
    PlayAll(When::kLater);
}

TEST_CASE("in turn: every third step is rounded otherwise") {
    PlayAll(When::kInTurn);
}

TEST_CASE("listening: a listener changes how it is rounded, and that stays") {
    PlayAll(When::kListening);
}

// Rows of boxes that are too near each other, and turn.
AS_STOCK_HOW(kMayBeSilent, "turned: PostSolve changes how a thread is rounded, and that stays") {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        Game game(run);
        for (int i = 0; i < 60; ++i)
            game.Awake({0.93f * Real(i % 20), 4.0f * Real(i / 20)})->SetAngularVelocity(Real(i));
        game.Listen();
        game.listener.postSolve = [mode] { std::fesetround(mode); };
        int turned = 0;
        for (int step = 0; step < 4; ++step) {
            game.Step();
            turned += std::fegetround() == mode;
            std::fesetround(FE_TONEAREST);
        }
        game.TookPlace(turned, "the other rounding stays");
    }
}

// Nothing moves bodies without mass, whose impulses would be divided by zero.
AS_STOCK("trapped: a program sets traps, and bodies without mass are deep in each other") {
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    Game game(run, {0.0f, -10.0f});
    game.Wall({0.0f, -0.4f}, {20.0f, 0.5f});
    for (int i = 0; i < 16; ++i) {
        b2Body *const body = game.Awake({0.8f * Real(i) - 6.0f, 0.3f});
        body->GetFixtureList()->SetDensity(0.0f);
        body->ResetMassData();
    }
    game.Step(20);
    game.TookPlace(game.Touching(), "bodies without mass touch");
}

namespace {

/// With these numbers tips meet where proofs far from the origin are just good enough.
float Between(std::minstd_rand &random, float low, float high) {
    return low + (high - low) * Real(static_cast<int>(random() % 4096u)) / 4096.0f;
}

/// A triangle whose tip is at a place, and which lies in some direction of it, more or less.
b2Body *AddTip(Game &game, b2BodyType type, b2Vec2 at, float direction, std::minstd_rand &random) {
    const float width = Between(random, 0.05f, 1.2f), lies = direction + Between(random, -0.6f, 0.6f);
    const b2Vec2 corners[3] = {{0.0f, 0.0f},
                               Between(random, 0.3f, 0.9f) * b2Rot(lies - width).GetXAxis(),
                               Between(random, 0.3f, 0.9f) * b2Rot(lies + width).GetXAxis()};
    b2Body *body = game.Body(type, at);
    body->SetSleepingAllowed(false);
    b2PolygonShape triangle;
    triangle.Set(corners, 3);
    game.Fixture(body, triangle);
    return body;
}

/// One triangle of each pair is carried towards the tip of the other, tip first. Where two tips meet, two
/// touch that are as far apart as any can be that do, give or take what is rounded.
void PlayCorners(Run &run, float far) {
    constexpr int kSteps = 60;
    Game game(run);
    int met = 0;
    std::minstd_rand random(static_cast<uint32_t>(far));
    struct Pair {
        b2Body *moved;
        b2Vec2 tip, from;
    };
    std::vector<Pair> pairs;
    for (int i = 0; i < 150; ++i) {
        const b2Vec2 tip(far + 3.0f * Real(i % 12), far + 3.0f * Real(i / 12));
        const float direction = Between(random, 0.0f, 6.3f);
        AddTip(game, b2_staticBody, tip, direction + b2_pi, random);
        const b2Vec2 from = 0.09f * b2Rot(direction).GetXAxis();
        pairs.push_back({AddTip(game, b2_dynamicBody, tip + from, direction, random), tip, from});
    }
    for (int step = 0; step < kSteps; ++step) {
        for (const Pair &pair : pairs) {
            pair.moved->SetTransform(pair.tip + (1.0f - Real(step) / Real(kSteps)) * pair.from, 0.0f);
            pair.moved->SetLinearVelocity({0.0f, 0.0f});
            pair.moved->SetAngularVelocity(0.0f);
        }
        game.Step();
        met += game.Touching();
    }
    game.TookPlace(met, "tips meet");
}

} // namespace

AS_STOCK("corners: tips of triangles come near each other, also where nothing is exact to a millimetre") {
    for (const float far : {400.0f, 900.0f, 1800.0f, 3700.0f, 7500.0f, 30000.0f, 100000.0f})
        PlayCorners(run, far);
}

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
