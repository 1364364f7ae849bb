// SPDX-License-Identifier: MIT
// Who is born and dies when: installation, contacts, worlds; callers of Evaluate; odd bodies and
// places.
#include "as_stock.h"
#include "boomerang/convex_shape.h"

#include <array>
#include <memory>
#include <vector>

using namespace as_stock;

namespace {

constexpr float kPi = 3.14159274f;

b2Vec2 OnCircle(int i, int count, float radius) {
    return b2Mul(b2Rot(2.0f * kPi * Real(i) / Real(count)), b2Vec2(radius, 0.0f));
}

/// A regular polygon of any size in fixtures of at most 8 vertices, which share one vertex.
void Coin(Game &game, b2Body *body, int count, float radius) {
    for (int first = 1; first + 1 < count; first += 6) {
        b2Vec2 corners[8] = {OnCircle(0, count, radius)};
        int corner = 1;
        for (int i = first; i < count && corner < 8; ++i)
            corners[corner++] = OnCircle(i, count, radius);
        b2PolygonShape shape;
        shape.Set(corners, corner);
        game.Fixture(body, shape);
    }
}

bmr::ConvexShape Big() {
    bmr::ConvexShape shape;
    REQUIRE(shape.SetRegular(64, 1.0f) == BMR_OK);
    return shape;
}

/// Two slanted planks, `across` apart, around a place.
void Planks(Game &game, b2Vec2 place, float across, b2Body *bodies[2]) {
    for (int i = 0; i < 2; ++i) {
        bodies[i] = Slanting(game, across * Real(i));
        bodies[i]->SetTransform(place + bodies[i]->GetPosition(), kSlant);
        game.Plank(bodies[i]);
    }
}

/// A heap of everything on a floor.
void Heap(Game &game) {
    b2Body *floor = game.Wall({0.0f, 0.0f}, {20.0f, 0.5f});
    game.Box(floor, 0.5f, 5.0f, {-8.0f, 4.0f});
    game.Box(floor, 0.5f, 5.0f, {8.0f, 4.0f});
    for (int i = 0; i < 12; ++i) {
        b2Body *body = game.Body(b2_dynamicBody, {Real(i % 4) - 2.0f, 1.5f + 0.8f * Real(i)}, 0.3f * Real(i));
        if (i % 3 == 0)
            Coin(game, body, 12 + 20 * (i % 2), 0.5f);
        else if (i % 3 == 1)
            game.Plank(body);
        else if (i % 2 == 0)
            game.Box(body, 0.4f, 0.3f);
        else
            game.Fixture(body, Big());
    }
}

} // namespace

AS_STOCK_HOW(kInstalls, "contacts born before Install keep working, and are destroyed by who made them") {
    Heard game(run, {0.0f, -10.0f});
    Heap(game);
    game.Step(60);
    game.Stage(game.Touching() > 5, "contacts are there");
    run.Install();
    game.Step(20);
    for (int i = 0; i < 6; ++i) {
        game.Plank(game.Body(b2_dynamicBody, {0.0f, 6.0f + 0.5f * Real(i)}, 0.2f));
        // New fixtures on old bodies: our contacts and stock's between the same two.
        game.Box(game.world.GetBodyList()->GetNext(), 0.3f, 0.3f, {0.4f, 0.2f});
        game.Step(10);
    }
    while (game.world.GetBodyCount() > 3) {
        game.world.DestroyBody(game.world.GetBodyList()->GetNext()->GetNext());
        game.Step(3);
    }
}

AS_STOCK("every way for a contact to die gives back all it held") {
    Heard game(run);
    b2Body *bodies[2];
    Planks(game, {0.0f, 0.0f}, 0.6f, bodies);
    b2Body *far = game.Body(b2_dynamicBody, {3.0f, -3.0f}, kSlant);
    Coin(game, far, 80, 1.0f);
    Coin(game, game.Body(b2_dynamicBody, {3.0f, -0.8f}), 80, 1.0f);
    const auto cycle = [&](int way) {
        b2Body *b = bodies[1];
        const b2Vec2 home = b->GetPosition();
        switch (way) {
        case 0: {
            game.world.DestroyBody(b);
            bodies[1] = game.Body(b2_dynamicBody, home, kSlant);
            bodies[1]->SetSleepingAllowed(false);
            game.Plank(bodies[1]);
            break;
        }
        case 1:
            while (b->GetFixtureList() != nullptr)
                b->DestroyFixture(b->GetFixtureList());
            game.Plank(b);
            break;
        case 2:
            b->SetType(b2_staticBody);
            game.world.Step(1.0f / 60.0f, 8, 3);
            b->SetType(b2_dynamicBody);
            break;
        case 3:
            b->SetEnabled(false);
            game.world.Step(1.0f / 60.0f, 8, 3);
            b->SetEnabled(true);
            break;
        case 4:
            b->SetTransform({100.0f, 100.0f}, 0.0f);
            game.world.Step(1.0f / 60.0f, 8, 3);
            b->SetTransform(home, kSlant);
            break;
        case 5: // the pair of coins, whose hulls take a run of blocks each
            far->SetTransform({100.0f, -100.0f}, 0.0f);
            game.world.Step(1.0f / 60.0f, 8, 3);
            far->SetTransform({3.0f, -3.0f}, kSlant);
            break;
        case 6: {
            b2Filter filter = b->GetFixtureList()->GetFilterData();
            filter.maskBits = static_cast<uint16>(~filter.maskBits);
            b->GetFixtureList()->SetFilterData(filter);
            break;
        }
        default: // a hull that is built again
            b->DestroyFixture(game.Box(b, 0.05f, 0.05f, {-1.0f, 0.2f}));
            b2Fixture *grown = game.Box(b, 0.05f, 0.05f, {-1.0f, -0.15f});
            game.world.Step(1.0f / 60.0f, 8, 3);
            b->DestroyFixture(grown);
            break;
        }
        game.world.Step(1.0f / 60.0f, 8, 3);
    };
    for (int way = 0; way < 8; ++way) {
        for (int i = 0; i < 60; ++i)
            cycle(way);
        // A pair alone has 240 bytes, a hull more. What Box2D itself takes on the way is a chunk or two.
        constexpr size_t kCycles = 300, kLeastLeak = 100;
        const size_t before = BytesInUse();
        for (size_t i = 0; i < kCycles; ++i)
            cycle(way);
        run.Print("way %d", way);
        game.Stage(BytesInUse() < before + kLeastLeak * kCycles, "no growth");
        game.WriteDown();
    }
}

TEST_CASE("control: one block that is not given back is seen") {
    const size_t before = BytesInUse();
    void *block = std::malloc(1000);
    CHECK(block != nullptr);
    CHECK(BytesInUse() >= before + 1000);
    std::free(block);
    std::vector<std::unique_ptr<std::array<char, 40>>> kept;
    kept.reserve(600);
    CHECK_FALSE(LeavesNothing(100, [&kept] {
        for (int i = 0; i < 100; ++i)
            kept.push_back(std::make_unique<std::array<char, 40>>());
    }));
#if defined(IN_CHILD_ASAN)
    const auto leak = [](Run &) {
        void *volatile lost = nullptr;
        for (int i = 0; i < 16; ++i) // some may still be seen, in a register or below the stack
            lost = std::malloc(1000);
        lost = nullptr;
        (void)lost;
    };
    CHECK(InChild(leak) != "");
#endif
}

AS_STOCK("two hundred worlds at once are not mixed up, in whatever order they end, and leave nothing") {
    Game game(run);
    b2PolygonShape square;
    square.SetAsBox(0.5f, 0.5f);
    bool tells = true; // of the first two times: how often they live may differ
    const auto live = [&game, &square, &tells] {
        std::vector<std::unique_ptr<b2World>> worlds;
        for (int i = 0; i < 200; ++i) {
            worlds.push_back(std::make_unique<b2World>(b2Vec2(0.0f, -10.0f)));
            for (int body = 0; body < 12; ++body) {
                b2BodyDef def;
                def.type = body == 0 ? b2_staticBody : b2_dynamicBody;
                def.position.Set(0.01f * Real(i % 7), 1.02f * Real(body));
                worlds.back()->CreateBody(&def)->CreateFixture(&square, 1.0f);
            }
        }
        for (int left = 200; left > 0; left -= 40) {
            for (const auto &world : worlds) {
                world->Step(1.0f / 60.0f, 8, 3);
                if (!tells)
                    continue;
                game.hash.Begin("world", static_cast<uint64_t>(world->GetContactCount()));
                game.hash.Field("height", world->GetBodyList()->GetPosition().y);
            }
            for (int i = 0; i < 40; ++i)
                worlds.erase(worlds.begin() + (i * 37) % (left - i));
        }
    };
    live();
    live(); // at addresses of worlds that have ended
    tells = false;
    game.Stage(LeavesNothing(200, live), "no growth");
    game.WriteDown();
}

AS_STOCK("a world that dies with contacts alive leaks nothing") {
    const auto live = [&run] {
        Heard game(run);
        for (int i = 0; i < 4; ++i)
            Coin(game, game.Body(b2_dynamicBody, {1.9f * Real(i), 1.8f * Real(i % 2)}), 100, 1.0f);
        b2Body *bodies[2];
        Planks(game, {0.0f, 10.0f}, 0.6f, bodies);
        for (const float x : {0.0f, 1.9f, 4.1f})
            game.Fixture(game.Body(b2_dynamicBody, {x, 20.0f}), Big());
        for (int i = 0; i < 2; ++i)
            game.world.Step(1.0f / 60.0f, 8, 3);
        game.Stage(game.world.GetContactCount() > 5, "contacts alive");
    };
    for (int i = 0; i < 200; ++i)
        live();
    const int rounds = static_cast<int>(test_scaled(250));
    const auto liveAgain = [&] {
        for (int i = rounds; i > 0; --i)
            live();
    };
    run.Stage(LeavesNothing(rounds, liveAgain), "no growth");
    run.Print("dead");
}

AS_STOCK("Evaluate may be called by anybody, with an uninitialised manifold and any poses") {
    Heard game(run, {0.0f, -10.0f});
    Heap(game);
    b2Body *bodies[2];
    Planks(game, {0.0f, 30.0f}, 0.6f, bodies);
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    int asked = 0;
    for (int round = 0; round < 20; ++round) {
        game.Step(5);
        for (b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext()) {
            if (c->GetFixtureA()->GetType() != b2Shape::e_polygon)
                continue;
            const b2Transform &xfA = c->GetFixtureA()->GetBody()->GetTransform();
            b2Transform xfB = c->GetFixtureB()->GetBody()->GetTransform();
            for (const float moved : {0.0f, 0.01f, -0.3f, 7.0f, 5000.0f, nan, inf}) {
                for (const int garbage : {0x00, 0x7f, 0xff}) {
                    b2Manifold manifold;
                    std::memset(static_cast<void *>(&manifold), garbage, sizeof manifold);
                    const bmr::Counted before = bmr::internal::ReadCounts();
                    ++asked;
                    b2Transform there = xfB;
                    there.p.y += moved;
                    c->Evaluate(&manifold, xfA, there);
                    testbed::VisitManifold(game.hash, manifold);
                    const bmr::Counted after = bmr::internal::ReadCounts();
                    if (run.Counts()) {
                        const bool touched = c->GetManifold()->pointCount > 0;
                        run.Expect(after.handedOverTouching == before.handedOverTouching + touched,
                                   "its own manifold decides, not the caller's");
                    }
                }
            }
        }
    }
    game.TookPlace(asked, "contacts are asked");
}
