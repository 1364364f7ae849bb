// SPDX-License-Identifier: MIT
// A thread that rounds otherwise than to nearest has Box2D's own answers, and what is made meanwhile is made
// as always.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cfenv>

#include "../../box2d_glue/rounding_mode.h"
#include "forked_world.h"

namespace {

constexpr int kModes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

/// Two planks, which have a structure, and boxes that fall on them.
void Fill(forked::Game *game) {
    b2Body *ground = game->Body(b2_staticBody, {0.0f, 0.0f}, 0.1f);
    game->Plank(ground);
    b2Body *plank = game->Body(b2_dynamicBody, {0.1f, 0.5f}, 0.15f);
    game->Plank(plank);
    for (int i = 0; i < 4; ++i)
        game->Box(game->Body(b2_dynamicBody,
                             {static_cast<float>(i) - 1.5f, 1.3f + 0.3f * static_cast<float>(i)}, 0.3f),
                  0.2f, 0.15f);
}

template <int kMode> void AlwaysIn(forked::Run &run) {
    std::fesetround(kMode);
    forked::Game game(run, {0.0f, -10.0f});
    Fill(&game);
    game.Step(60);
    game.Stage(game.Touching() > 0, "a collision");
}

/// What is remembered from steps of one mode is used in steps of another.
template <int kMode> void InTurn(forked::Run &run) {
    forked::Game game(run, {0.0f, -10.0f});
    Fill(&game);
    for (int step = 0; step < 90; ++step) {
        std::fesetround(step % 5 == 3 ? kMode : FE_TONEAREST);
        game.Step();
    }
    game.Stage(game.Touching() > 0, "a collision");
}

} // namespace

TEST_CASE("steps that round otherwise are stock's") {
    forked::CheckSameAsStock(AlwaysIn<FE_UPWARD>);
    forked::CheckSameAsStock(AlwaysIn<FE_DOWNWARD>);
    forked::CheckSameAsStock(AlwaysIn<FE_TOWARDZERO>);
}

TEST_CASE("steps that round now so, now otherwise, are stock's") {
    forked::CheckSameAsStock(InTurn<FE_UPWARD>);
    forked::CheckSameAsStock(InTurn<FE_TOWARDZERO>);
}

TEST_CASE("the mode decides what a step gives: what these tests compare can differ") {
    const std::string nearest = forked::InChild(AlwaysIn<FE_TONEAREST>, nullptr, forked::When::kByScenario);
    CHECK(forked::Difference(nearest, nearest) == "");
    const std::string upward = forked::InChild(AlwaysIn<FE_UPWARD>, nullptr, forked::When::kByScenario);
    CHECK(forked::Difference(nearest, upward) != "");
}

TEST_CASE("what rounds to nearest for a while gives the mode back") {
    for (const int mode : kModes) {
        std::fesetround(mode);
        const bool before = bmr::RoundsToNearest();
        bool within = false;
        {
            const bmr::NearestRounding nearest;
            within = bmr::RoundsToNearest();
        }
        const int after = std::fegetround();
        const bool still = !bmr::RoundsToNearest();
        std::fesetround(FE_TONEAREST);
        CHECK_FALSE(before);
        CHECK(within);
        CHECK(after == mode);
        CHECK(still);
    }
    CHECK(bmr::RoundsToNearest());
}
