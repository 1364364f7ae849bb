// SPDX-License-Identifier: MIT
// Leaves of a tree of boxes moved by the plugin's code, and by Box2D's: after each operation the two trees
// are the same to the bit, and so are their lists of free nodes.
#include <box2d/box2d.h>

#include "box2d_shapes.h"
#include "cases.h"
#include "random.h"
#include "tree/edit.h"
#if !defined(BMR_FLOAT4_PLAIN)
#    include "tree/pair_descent.h"
#endif

// --- Random operations on trees of boxes, and all that is in a tree.

/// What private_members.h does not name.
struct MembersOfNodes {
    int32 count, freeList;
};

template <> inline void b2DynamicTree::Query(MembersOfNodes *out, const b2AABB &) const {
    *out = {m_nodeCount, m_freeList};
}

namespace {

using namespace bmr::tree;

/// All bits of a tree: members, and every field of every node in use, and the list of those that are not.
/// (Box2D leaves the other fields of nodes that it never handed out as malloc gave them.)
std::vector<uint32_t> BitsOf(const b2DynamicTree &tree) {
    MembersOfNodes more;
    tree.Query(&more, b2AABB());
    const int32 capacity = tree.*Named(bmr::TreeCapacity());
    std::vector<uint32_t> bits;
    const auto take = [&bits](auto value) { bits.push_back(static_cast<uint32_t>(value)); };
    for (const int32 member : {tree.*Named(bmr::TreeRoot()), more.count, capacity, more.freeList,
                               tree.*Named(bmr::TreeInsertions())})
        take(member);
    for (int32 id = 0; id < capacity; ++id) {
        const b2TreeNode &node = (tree.*Named(bmr::TreeNodes()))[id];
        take(node.next);
        take(node.height);
        if (node.height < 0)
            continue;
        uint32_t words[sizeof node.aabb / sizeof(uint32_t)];
        std::memcpy(words, &node.aabb, sizeof words);
        for (const uint32_t word : words)
            take(word);
        take(node.child1);
        take(node.child2);
        take(reinterpret_cast<uintptr_t>(node.userData));
        take(node.moved);
    }
    return bits;
}

/// What boxes a tree is played with.
enum class Boxes {
    kScattered,  ///< small boxes in a square
    kGrid,       ///< whole numbers: costs tie, zeros are bounds
    kClusters,   ///< many over each other, as of the fixtures of one body
    kSorted,     ///< each to the right of the one before: trees that must be turned
    kDegenerate, ///< points, lines, and boxes whose lower bound is the upper
    kExtreme,    ///< denormals, zeros of both signs, and numbers whose perimeters overflow
    kNumberless, ///< small boxes; now and then a bound is no number
    kWild        ///< any bits: infinities and numbers that are none among them
};
constexpr Boxes kAllBoxes[] = {Boxes::kScattered,  Boxes::kGrid,    Boxes::kClusters,   Boxes::kSorted,
                               Boxes::kDegenerate, Boxes::kExtreme, Boxes::kNumberless, Boxes::kWild};

class Player {
public:
    Player(uint32_t seed, Boxes boxes, int32 mostLeaves)
        : m_random{seed}, m_boxes(boxes), m_mostLeaves(mostLeaves) {}

    /// One random operation: leaves are moved by `move`.
    template <typename Move> void Play(b2DynamicTree *tree, Move *move) {
        const uint32_t what = Random() % 100;
        const auto count = static_cast<int32>(m_leaves.size());
        // It grows for a while, and shrinks for a while.
        const uint32_t creates = m_growing ? 40 : 5;
        if (count == 0 || (what < creates && count < m_mostLeaves)) {
            m_leaves.push_back(
                tree->CreateProxy(Box(), reinterpret_cast<void *>(static_cast<uintptr_t>(++m_made))));
        } else if (what < 45) {
            const size_t place = Random() % m_leaves.size();
            tree->DestroyProxy(m_leaves[place]);
            m_leaves[place] = m_leaves.back();
            m_leaves.pop_back();
        } else if (what < 99) {
            MoveOne(tree, move);
        } else {
            Rare(tree);
        }
        if (count >= m_mostLeaves)
            m_growing = false;
        else if (count == 0)
            m_growing = true;
    }

private:
    /// To anywhere, or a little away from where it is.
    template <typename Move> void MoveOne(b2DynamicTree *tree, Move *move) {
        const int32 leaf = m_leaves[Random() % m_leaves.size()];
        b2AABB box = Box();
        if (Random() % 4 != 0) {
            const b2Vec2 by(Uniform(-0.4f, 0.4f), Uniform(-0.4f, 0.4f));
            box = tree->GetFatAABB(leaf);
            box.lowerBound += by + b2Vec2(0.1f, 0.1f);
            box.upperBound += by - b2Vec2(0.1f, 0.1f);
        }
        const b2Vec2 displacement(Number(0.5f), Number(0.5f));
        (*move)(tree, leaf, box, displacement);
        if (Random() % 3 == 0)
            tree->ClearMoved(leaf);
    }

    void Rare(b2DynamicTree *tree) {
        const bool finite =
            m_boxes != Boxes::kWild && m_boxes != Boxes::kNumberless && m_boxes != Boxes::kExtreme;
        if (Random() % 2 == 0)
            tree->ShiftOrigin({Number(3.0f), Number(3.0f)});
        else if (finite && m_leaves.size() <= 40) // (cubic, and for finite costs)
            tree->RebuildBottomUp();
    }

    uint32_t Random() { return static_cast<uint32_t>(test_random_next(&m_random)); }

    float Uniform(float least, float most) {
        return least + (most - least) * (static_cast<float>(Random() >> 8) * 0x1p-24f);
    }

    /// A coordinate about so far from zero.
    float Number(float size) {
        constexpr float kExtremes[] = {0.0f,   -0.0f,   1e-40f, -1e-42f, 1e-30f, 3e38f,
                                       -3e38f, 1.5e38f, -1e38f, 1.0f,    -2.0f,  0.1f};
        if (m_boxes == Boxes::kWild && Random() % 12 == 0) {
            const uint32_t bits = Random() % 3 == 0 ? 0x7f800000u | (Random() & 0x80000000u) : Random();
            float number;
            std::memcpy(&number, &bits, sizeof number);
            return number;
        }
        if (m_boxes == Boxes::kNumberless && Random() % 60 == 0)
            return std::nanf("");
        if (m_boxes == Boxes::kExtreme && Random() % 3 == 0)
            return kExtremes[Random() % (sizeof kExtremes / sizeof *kExtremes)];
        const float number = Uniform(-size, size);
        return m_boxes == Boxes::kGrid ? std::floor(number) : number;
    }

    b2AABB Box() {
        b2Vec2 at(Number(20.0f), Number(20.0f)), size(std::abs(Number(1.5f)), std::abs(Number(1.5f)));
        if (m_boxes == Boxes::kClusters) {
            const auto cluster = static_cast<float>(Random() % 5);
            at = b2Vec2(8.0f * cluster, 3.0f * cluster) + 0.05f * at;
        } else if (m_boxes == Boxes::kSorted) {
            at.Set(static_cast<float>(m_made), 0.0f);
        } else if (m_boxes == Boxes::kDegenerate) {
            const uint32_t how = Random() % 4;
            size.Set(how == 0 ? 0.0f : size.x, how <= 1 ? 0.0f : how == 2 ? -size.y : size.y);
        }
        b2AABB box;
        box.lowerBound = at;
        box.upperBound = at + size;
        return box;
    }

    test_random m_random;
    const Boxes m_boxes;
    const int32 m_mostLeaves;
    std::vector<int32> m_leaves;
    uint32_t m_made = 0;
    bool m_growing = true;
};

/// As a step does it: what is not done here is Box2D's.
struct Ours {
    size_t here = 0, moved = 0, box2d = 0; ///< calls; of those here, the ones that moved the leaf

    void operator()(b2DynamicTree *tree, int32 leaf, const b2AABB &box, const b2Vec2 &displacement) {
        bool isMoved = false;
        const bool isDone = MoveHere(tree, leaf, box, displacement, &isMoved);
        ++(isDone ? here : box2d);
        moved += isDone && isMoved ? 1 : 0;
        if (!isDone)
            tree->MoveProxy(leaf, box, displacement);
    }
};

struct Round {
    Boxes boxes;
    int32 mostLeaves;
    size_t operations;
};

/// Small trees, whose every shape comes up, and larger ones.
template <typename Play> void EachRound(const Play &play) {
    for (const Boxes boxes : kAllBoxes) {
        for (const Round &round : {Round{boxes, 5, 2000}, Round{boxes, 40, 4000}, Round{boxes, 300, 4000}}) {
            for (uint32_t seed = 1; seed <= test_scaled(3); ++seed) {
                INFO("boxes ", static_cast<int>(boxes), ", leaves ", round.mostLeaves, ", seed ", seed);
                Round scaled = round;
                scaled.operations = std::max(round.operations / 6, test_scaled(round.operations));
                play(scaled, seed);
            }
        }
    }
}

} // namespace

TEST_CASE("after each operation the tree is Box2D's, to the bit") {
    size_t moved = 0;
    EachRound([&](const Round &round, uint32_t seed) {
        b2DynamicTree stock, ours;
        Player stockPlayer(seed, round.boxes, round.mostLeaves),
            ourPlayer(seed, round.boxes, round.mostLeaves);
        const auto box2Ds = [](b2DynamicTree *tree, int32 leaf, const b2AABB &box, const b2Vec2 &by) {
            tree->MoveProxy(leaf, box, by);
        };
        Ours moves;
        for (size_t i = 0; i < round.operations; ++i) {
            stockPlayer.Play(&stock, &box2Ds);
            ourPlayer.Play(&ours, &moves);
            const bool same = BitsOf(stock) == BitsOf(ours);
            if (!same)
                REQUIRE_MESSAGE(same, "operation ", i);
        }
        REQUIRE(moves.here > moves.moved);
        CHECK((round.boxes == Boxes::kWild || round.boxes == Boxes::kExtreme ||
               round.boxes == Boxes::kNumberless || moves.here > 8 * moves.box2d));
        moved += moves.moved;
    });
    CHECK(moved > 0);
}

TEST_CASE("ids of no leaf in the tree are Box2D's to assert on") {
    b2DynamicTree tree;
    b2AABB box;
    box.lowerBound.SetZero();
    box.upperBound.Set(1.0f, 1.0f);
    const int32 a = tree.CreateProxy(box, nullptr), b = tree.CreateProxy(box, nullptr);
    const int32 parent = tree.*Named(bmr::TreeRoot());
    tree.DestroyProxy(b);
    const std::vector<uint32_t> before = BitsOf(tree);
    bool moved;
    for (const int32 id : {-1, b, parent, 15, 16, 1 << 30}) {
        CHECK_FALSE(MoveHere(&tree, id, box, b2Vec2(50.0f, 0.0f), &moved));
    }
    CHECK(BitsOf(tree) == before);
    box.upperBound.Set(9.0f, 9.0f);
    CHECK(MoveHere(&tree, a, box, b2Vec2(50.0f, 0.0f), &moved));
    CHECK(moved);
}

#if !defined(BMR_FLOAT4_PLAIN)

// --- Proxies that go down the tree together find what Box2D's own query finds for each, in its order.

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
        bmr::tree::DescentScratch scratch;
        for (int step = 0; step < 4; ++step) {
            const std::vector<int32> moves = bodies.Move();
            std::vector<Found> alone, together;
            for (const int32 proxy : moves) {
                Alone query = {bodies.Tree(), proxy, &alone};
                if (proxy != b2BroadPhase::e_nullProxy)
                    bodies.Tree().Query(&query, bodies.Tree().GetFatAABB(proxy));
            }
            const auto keep = [&together](int32 proxy, int32 leaf) { together.push_back({proxy, leaf}); };
            bmr::tree::PairDescent(bodies.Tree(), &scratch, keep)
                .Run(moves.data(), static_cast<int32>(moves.size()));
            REQUIRE(together == alone);
            found += alone.size();
            most = std::max(most, moves.size());
        }
    }
    CHECK(found > 0);
    CHECK(most > 1024); // the proxies of one step, which go down in two parts
}

#endif
