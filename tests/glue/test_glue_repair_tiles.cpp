// SPDX-License-Identifier: MIT
// A ball that slides over tiles loses speed at their seams where each tile is an outline, and none where they
// are merged into one: near the origin, at 1 km and at 8 km.
#include <box2d/box2d.h>

#include "boomerang/outline_shape.h"
#include "boomerang/repair.h"
#include "cases.h"

namespace {

constexpr int kTiles = 60;
constexpr double kSnap = 0.01;

/// A row of boxes whose tops are at y = 0, drawn a little apart.
std::vector<bmr::Outline> DrawTiles(double away, double gap) {
    std::vector<bmr::Outline> tiles(kTiles);
    for (int i = 0; i < kTiles; ++i) {
        const double left = away + i, right = away + i + 1 - gap;
        const b2Vec2 corners[] = {{static_cast<float>(left), -1.0f},
                                  {static_cast<float>(right), -1.0f},
                                  {static_cast<float>(right), 0.0f},
                                  {static_cast<float>(left), 0.0f}};
        tiles[static_cast<size_t>(i)].AddRing(corners, 4);
    }
    return tiles;
}

/// The speed that a ball without friction loses on the way over all tiles, thrown down on them by and by.
float LostOn(const std::vector<bmr::Outline> &outlines, double away) {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    def.position.Set(static_cast<float>(away), 0.0f);
    b2Body *ground = world.CreateBody(&def);
    for (const bmr::Outline &outline : outlines) {
        std::vector<b2Vec2> points; // about the body's origin
        for (const bmr_vec2 &point : outline.points)
            points.emplace_back(static_cast<float>(point.x - away), static_cast<float>(point.y));
        bmr::OutlineShape shape;
        REQUIRE(shape.Set(points.data(), static_cast<int32>(points.size())) == BMR_OK);
        REQUIRE(shape.CreateFixtures(ground, 0.0f) == BMR_OK);
    }
    def.type = b2_dynamicBody;
    def.position.Set(static_cast<float>(away + 2.0), 0.35f);
    def.linearVelocity.Set(10.0f, 0.0f);
    b2Body *ball = world.CreateBody(&def);
    b2CircleShape circle;
    circle.m_radius = 0.3f;
    b2FixtureDef fixture;
    fixture.shape = &circle;
    fixture.density = 1.0f;
    fixture.friction = 0.0f;
    ball->CreateFixture(&fixture);
    float slowest = 10.0f;
    for (int step = 0; step < 330; ++step) {
        if (step % 40 == 39) // pressed into the ground, as by a jump that ends
            ball->SetLinearVelocity(b2Vec2(ball->GetLinearVelocity().x, -8.0f));
        world.Step(1.0f / 60.0f, 8, 3);
        slowest = std::min(slowest, ball->GetLinearVelocity().x);
    }
    CHECK(ball->GetPosition().y > 0.2f);
    return 10.0f - slowest;
}

} // namespace

TEST_CASE("a ball loses nothing at the seams of tiles that are merged") {
    float before = 0.0f;
    for (const double away : {0.0, 1000.0, 8000.0})
        for (const double gap : {0.0, 0.001}) {
            CAPTURE(away);
            CAPTURE(gap);
            const std::vector<bmr::Outline> tiles = DrawTiles(away, gap);
            std::vector<bmr::Outline> merged;
            REQUIRE(MergeOutlines(tiles.data(), tiles.size(), bmr::FillRule::NonZero, kSnap, &merged) ==
                    BMR_OK);
            REQUIRE(merged.size() == 1);
            CHECK(merged[0].points.size() == 4);
            const float lost = LostOn(merged, away), onTiles = LostOn(tiles, away);
            MESSAGE("at ", away, " m, gaps of ", gap, " m: ", before, " m/s lost on tiles, ", lost,
                    " on their union");
            CHECK(lost <= 0.0f);
            before += onTiles;
        }
    CHECK(before > 1.0f); // the control
}
