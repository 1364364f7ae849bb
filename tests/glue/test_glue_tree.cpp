// SPDX-License-Identifier: MIT
// Proxies that go down the tree together find what Box2D's own query finds for each, in its order.
#include <box2d/box2d.h>

#include "box2d_shapes.h"
#include "cases.h"
#include "tree/pair_descent.h"

namespace {

using shapes::Below;

struct Found {
    int32 proxy, leaf;
    bool operator==(const Found &other) const { return proxy == other.proxy && leaf == other.leaf; }
};

/// Bodies of up to 100 fixtures, whose boxes are in a tree that is not their world's.
class Bodies {
public:
    explicit Bodies(shapes::Engine &engine) : m_engine(engine), m_withOdd(Below(engine, 3) == 0) {
        const int32 bodies = 2 + Below(engine, 60);
        b2CircleShape circle;
        for (int32 i = 0; i < bodies; ++i) {
            b2BodyDef def;
            def.userData.pointer = static_cast<uintptr_t>(i);
            b2Body *const body = m_world.CreateBody(&def);
            const int32 most[] = {1, 4, 12, 100};
            for (int32 left = 1 + Below(engine, most[Below(engine, 4)]); left > 0; --left)
                m_proxies.push_back({{}, body->CreateFixture(&circle, 0.0f), 0, 0});
        }
        for (b2FixtureProxy &proxy : m_proxies)
            proxy.proxyId = m_tree.CreateProxy(Box(proxy), &proxy);
    }

    /// Moves some, body by body, and some of them twice; the buffer has places that were taken back.
    std::vector<int32> Move() {
        std::vector<int32> moves;
        const int32 part = 1 + Below(m_engine, 20);
        for (const b2FixtureProxy &proxy : m_proxies) {
            m_tree.ClearMoved(proxy.proxyId);
            if (Below(m_engine, part) != 0)
                continue;
            if (m_tree.MoveProxy(proxy.proxyId, Box(proxy), b2Vec2_zero))
                moves.push_back(proxy.proxyId);
            if (Below(m_engine, 30) == 0)
                moves.push_back(b2BroadPhase::e_nullProxy);
            if (Below(m_engine, 30) == 0 && !moves.empty())
                moves.push_back(
                    moves[static_cast<size_t>(Below(m_engine, static_cast<int32>(moves.size())))]);
        }
        return moves;
    }

    const b2DynamicTree &Tree() const { return m_tree; }

private:
    /// Near the place of its body.
    b2AABB Box(const b2FixtureProxy &proxy) {
        const uintptr_t place = proxy.fixture->GetBody()->GetUserData().pointer;
        const b2Vec2 middle(static_cast<float>(place % 7) + shapes::UniformF(m_engine, -1.0f, 1.0f),
                            static_cast<float>(place % 5) + shapes::UniformF(m_engine, -1.0f, 1.0f));
        b2AABB box = {middle - b2Vec2(0.2f, 0.1f), middle + b2Vec2(0.1f, 0.3f)};
        if (m_withOdd && Below(m_engine, 100) == 0) {
            const float odd[] = {std::numeric_limits<float>::quiet_NaN(),
                                 std::numeric_limits<float>::infinity(), 1e30f};
            (Below(m_engine, 2) == 0 ? box.lowerBound.x : box.upperBound.y) = odd[Below(m_engine, 3)];
        }
        return box;
    }

    shapes::Engine &m_engine;
    bool m_withOdd;
    b2World m_world{b2Vec2_zero};
    std::vector<b2FixtureProxy> m_proxies;
    b2DynamicTree m_tree;
};

struct Alone {
    const b2DynamicTree &tree;
    int32 proxy;
    std::vector<Found> *found;

    bool QueryCallback(int32 leaf) const {
        const bool own =
            bmr::tree::BodyOf(tree.GetUserData(leaf)) == bmr::tree::BodyOf(tree.GetUserData(proxy));
        if (bmr::tree::Reports(proxy, leaf, tree.WasMoved(leaf)) && !own)
            found->push_back({proxy, leaf});
        return true;
    }
};

} // namespace

TEST_CASE("proxies that go down the tree together find what each finds alone, in its order") {
    shapes::Engine engine(1);
    size_t found = 0, most = 0;
    for (size_t round = test_scaled(2000); round > 0; --round) {
        Bodies bodies(engine);
        bmr::tree::DescentRoom room;
        for (int step = 0; step < 4; ++step) {
            const std::vector<int32> moves = bodies.Move();
            std::vector<Found> alone, together;
            for (const int32 proxy : moves) {
                Alone query = {bodies.Tree(), proxy, &alone};
                if (proxy != b2BroadPhase::e_nullProxy)
                    bodies.Tree().Query(&query, bodies.Tree().GetFatAABB(proxy));
            }
            const auto keep = [&together](int32 proxy, int32 leaf) { together.push_back({proxy, leaf}); };
            bmr::tree::PairDescent(bodies.Tree(), &room, keep)
                .Run(moves.data(), static_cast<int32>(moves.size()));
            REQUIRE(together == alone);
            found += alone.size();
            most = std::max(most, moves.size());
        }
    }
    CHECK(found > 0);
    CHECK(most > 1024); // the proxies of one step, which go down in two parts
}
