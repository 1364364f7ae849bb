// SPDX-License-Identifier: MIT
// The glue alone, with no hook ahead of Box2D: Install refuses in one sentence, and Box2D is untouched.
// Polygons of any size have their contacts all the same.
#include "as_stock.h"
#include "boomerang/convex_shape.h"

using namespace as_stock;

namespace {

constexpr char kRefusal[] =
    "boomerang: not at work, Box2D runs as it is: Box2D does not call Boomerang's "
    "b2World::Step. Link boomerang::box2d ahead of it, or use boomerang_accelerate()\n";

void Fall(Run &run) {
    Heard game(run, {0.0f, -10.0f});
    game.Wall({0.0f, -1.0f}, {20.0f, 1.0f});
    for (int i = 0; i < 30; ++i)
        game.Box({Real(i % 6) - 3.0f, 1.0f + 1.1f * Real(i / 6)}, {0.5f, 0.5f}, 0.1f * Real(i));
    game.Step(90);
    game.Stage(game.Touching() > 20, "boxes lie on each other");
}

/// Says with ! what is not as it is to be.
void Refuse(Run &run) {
    bool done = true;
    const std::string said = StderrOf([&done] { done = bmr::Install(); });
    if (done || bmr::IsInstalled() || said != kRefusal)
        run.Print("!%d %s", done, said.c_str());
    if (StderrOf([&done] { done = bmr::Install(); }) != "" || done)
        run.Print("!said twice, or installed");
}

} // namespace

TEST_CASE("Install refuses without hooks, says why once, and the game plays as stock") {
    const std::string stock = InChild(Fall);
    REQUIRE(stock != "");
    CHECK(Difference(stock, InChild([](Run &run) {
                         Refuse(run);
                         Fall(run);
                         if (bmr::internal::ReadCounts().steps != 0)
                             run.Print("!steps are counted");
                     })) == "");
}

TEST_CASE("a wheel of 64 sides rests on its rim where Install was refused") {
    CHECK(InChild([](Run &run) {
              Refuse(run);
              Game game(run, {0.0f, -10.0f});
              game.Wall({0.0f, -1.0f}, {20.0f, 1.0f});
              bmr::ConvexShape shape;
              run.Stage(shape.SetRegular(64, 0.5f) == BMR_OK, "a big polygon");
              b2Body *const wheel = game.Body(b2_dynamicBody, {0.0f, 2.0f});
              game.Fixture(wheel, shape);
              wheel->SetAngularVelocity(3.0f);
              game.Step(120);
              // (The octagon inside it has corners at the rim, and sides that are 0.038 nearer.)
              float lowest = wheel->GetPosition().y;
              for (int i = 0; i < 120; ++i) {
                  game.Step();
                  lowest = b2Min(lowest, wheel->GetPosition().y);
              }
              game.Stage(wheel->GetPosition().x != 0.0f && lowest > 0.48f, "it rolls on its rim");
          }).find('!') == std::string::npos);
}
