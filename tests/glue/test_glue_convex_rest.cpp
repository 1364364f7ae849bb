// SPDX-License-Identifier: MIT
// Big ConvexShapes at rest: on every kind of shape, and under what is smaller.
#include "boomerang/convex_shape.h"
#include "convex_ground.h"

using bmr::ConvexShape;
using namespace as_stock;
using namespace ground;

namespace {

b2PolygonShape Box() {
    b2PolygonShape box;
    box.SetAsBox(5.0f, 1.0f, {0.0f, -1.0f}, 0.0f);
    return box;
}

b2CircleShape Circle() {
    b2CircleShape circle;
    circle.m_radius = 40.0f;
    circle.m_p.Set(0.0f, -40.0f);
    return circle;
}

/// Whose upper side is at 0.
template <typename Visit> void WithEveryGround(Visit visit) {
    visit("box", Box());
    visit("circle", Circle());
    visit("edge", Edge(false));
    visit("one-sided edge", Edge(true));
    visit("chain", Chain());
    ConvexShape big;
    const b2Vec2 side[] = {{5.0f, 0.0f},   {-5.0f, 0.0f}, {-5.2f, -0.1f}, {-5.3f, -0.2f}, {-5.2f, -1.8f},
                           {-5.0f, -2.0f}, {5.0f, -2.0f}, {5.2f, -1.8f},  {5.3f, -0.2f},  {5.2f, -0.1f}};
    REQUIRE(big.Set(side, 10) == BMR_OK);
    REQUIRE(big.GetVertexCount() == 10);
    visit("big", big);
}

/// How far the lowest vertex is above 0, skins left out.
float Gap(const b2Body *body) {
    const ConvexShape *shape = ConvexShape::From(body->GetFixtureList()->GetShape());
    float lowest = INFINITY;
    for (int32 i = 0; i < shape->GetVertexCount(); ++i)
        lowest = std::min(lowest, body->GetWorldPoint(shape->GetVertex(i)).y);
    return lowest;
}

} // namespace

AS_STOCK("a big shape rests with its own edge on every kind of shape, in either order") {
    for (const int32 count : {9, 64, 1024}) {
        for (const bool groundFirst : {true, false}) {
            WithEveryGround([&](const char *name, const b2Shape &ground) {
                Heard game(run, {0.0f, -10.0f});
                run.Print("%s, %d", name, count);
                b2Body *below = game.Body(b2_staticBody, {0.0f, 0.0f});
                if (groundFirst)
                    game.Fixture(below, ground);
                b2Body *coin = Falling(game, {0.3f, kRadius + 0.1f});
                game.Fixture(coin, Coin(count));
                if (!groundFirst)
                    game.Fixture(below, ground);
                game.Step(90);
                game.Stage(game.Touching() == 1, "one contact that touches");
                // The octagon that Box2D is shown would sink in until its own lowest vertex is here:
                // 0.038 deeper.
                const float gap = Gap(coin), middle = coin->GetPosition().y;
                const float skins = ground.m_radius + b2_polygonRadius;
                const float skin = ground.GetType() == b2Shape::e_circle ? b2_polygonRadius : skins;
                game.Stage(gap > skin - 4.0f * b2_linearSlop && gap < skin + 2.0f * b2_linearSlop,
                           "it lies on its lowest edge or vertex");
                game.Stage(middle > kRadius * std::cos(kPi / Real(count)) - 0.02f,
                           "its middle is as high as the real polygon holds it");
            });
        }
    }
}

AS_STOCK("what is smaller lies and rolls on a big shape as on any") {
    ConvexShape plate;
    REQUIRE(plate.SetRounded(4.0f, 0.5f, 0.3f, 20) == BMR_OK);
    Heard game(run, {0.0f, -10.0f});
    game.Fixture(game.Body(b2_staticBody, {0.0f, -0.5f}), plate);
    b2CircleShape ball;
    ball.m_radius = 0.3f;
    b2PolygonShape box;
    box.SetAsBox(0.3f, 0.2f);
    ConvexShape small;
    REQUIRE(small.SetRegular(6, 0.3f) == BMR_OK);
    game.Fixture(Falling(game, {-2.0f, 0.4f}), ball);
    game.Fixture(Falling(game, {-1.0f, 0.4f}), box);
    game.Fixture(Falling(game, {0.0f, 0.4f}), small);
    b2Body *coin = Falling(game, {1.0f, 0.4f});
    game.Fixture(coin, Coin(200, 0.3f));
    game.Step(40);
    game.Stage(game.Touching() == 4, "four contacts that touch");
    coin->SetLinearVelocity({-3.0f, 0.0f}); // into the others
    game.Step(60);
}
