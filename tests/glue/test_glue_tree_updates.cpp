// SPDX-License-Identifier: MIT
// Leaves put into a tree of boxes, taken out and moved by the plugin's code, and by Box2D's: after each
// operation the two trees are the same to the bit, and so are their lists of free nodes.
#include "cases.h"
#include "test_scale.h"
#include "tree/proxies.h"
#include "tree_play.h"

namespace {

using namespace bmr::tree;

/// As the hooks do it: what is not done here is Box2D's.
struct Ours {
    size_t here = 0, box2d = 0;

    int32 Create(b2DynamicTree *tree, const b2AABB &box, void *userData) {
        NoLog log;
        int32 leaf;
        if (Counted(CreateHere(*tree, box, userData, &log, &leaf)))
            return leaf;
        return tree->CreateProxy(box, userData);
    }
    void Destroy(b2DynamicTree *tree, int32 leaf) {
        NoLog log;
        if (!Counted(DestroyHere(*tree, leaf, &log)))
            tree->DestroyProxy(leaf);
    }
    bool Move(b2DynamicTree *tree, int32 leaf, const b2AABB &box, const b2Vec2 &displacement) {
        NoLog log;
        bool moved;
        if (Counted(MoveHere(*tree, leaf, box, displacement, &log, &moved)))
            return moved;
        return tree->MoveProxy(leaf, box, displacement);
    }

private:
    bool Counted(bool done) {
        ++(done ? here : box2d);
        return done;
    }
};

/// Done here, undone, done by Box2D, and compared, as in Mode::Verify. With `fault` Box2D's tree is spoilt
/// before it is compared.
struct Compared {
    bool fault = false;
    size_t compared = 0, undone = 0, noticed = 0;

    int32 Create(b2DynamicTree *tree, const b2AABB &box, void *userData) {
        return Compare(
            tree,
            [&](TreeLog *log) {
                int32 leaf;
                return CreateHere(*tree, box, userData, log, &leaf);
            },
            [&] { return tree->CreateProxy(box, userData); });
    }
    void Destroy(b2DynamicTree *tree, int32 leaf) {
        Compare(
            tree, [&](TreeLog *log) { return DestroyHere(*tree, leaf, log); },
            [&] {
                tree->DestroyProxy(leaf);
                return 0;
            });
    }
    bool Move(b2DynamicTree *tree, int32 leaf, const b2AABB &box, const b2Vec2 &displacement) {
        return Compare(
            tree,
            [&](TreeLog *log) {
                bool moved;
                return MoveHere(*tree, leaf, box, displacement, log, &moved);
            },
            [&] { return tree->MoveProxy(leaf, box, displacement); });
    }

private:
    template <typename Here, typename Box2D>
    auto Compare(b2DynamicTree *tree, const Here &here, const Box2D &box2d) -> decltype(box2d()) {
        const std::vector<uint32_t> before = treeplay::BitsOf(*tree);
        TreeLog log(*tree);
        const bool done = here(&log);
        log.Keep();
        const bool changed = treeplay::BitsOf(*tree) != before;
        log.Undo();
        undone += treeplay::BitsOf(*tree) == before ? 1 : 0;
        const auto result = box2d();
        if (fault && changed && *MembersOf(*tree).root != b2_nullNode)
            Spoil(tree);
        ++compared;
        noticed += done && log.Difference() != TreeLog::kNone ? 1 : 0;
        if (fault && changed && *MembersOf(*tree).root != b2_nullNode)
            Spoil(tree); // back again
        return result;
    }

    /// The root is on every way: one bit of it.
    static void Spoil(b2DynamicTree *tree) {
        const TreeMembers members = MembersOf(*tree);
        b2TreeNode &root = members.nodes[*members.root];
        uint32_t bits;
        std::memcpy(&bits, &root.aabb.upperBound.y, sizeof bits);
        bits ^= 1;
        std::memcpy(&root.aabb.upperBound.y, &bits, sizeof bits);
    }
};

struct Round {
    treeplay::Boxes boxes;
    int32 mostLeaves;
    size_t operations;
};

/// Small trees, whose every shape comes up, and larger ones.
template <typename Play> void EachRound(const Play &play) {
    for (const treeplay::Boxes boxes : treeplay::kAllBoxes) {
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
    size_t here = 0, moved = 0;
    EachRound([&](const Round &round, uint32_t seed) {
        b2DynamicTree stock, ours;
        treeplay::Player stockPlayer(seed, round.boxes, round.mostLeaves),
            ourPlayer(seed, round.boxes, round.mostLeaves);
        treeplay::OfBox2D ofBox2D;
        Ours proxies;
        for (size_t i = 0; i < round.operations; ++i) {
            stockPlayer.Play(&stock, &ofBox2D);
            ourPlayer.Play(&ours, &proxies);
            const bool same = treeplay::BitsOf(stock) == treeplay::BitsOf(ours);
            if (!same)
                REQUIRE_MESSAGE(same, "operation ", i);
        }
        REQUIRE(proxies.here > 0);
        CHECK((round.boxes == treeplay::Boxes::kWild || round.boxes == treeplay::Boxes::kExtreme ||
               round.boxes == treeplay::Boxes::kNumberless || proxies.here > 8 * proxies.box2d));
        here += proxies.here;
        moved += ourPlayer.Moved();
    });
    CHECK(here > moved);
    CHECK(moved > 0);
}

TEST_CASE("an edit that is undone leaves the tree as it was, and is what Box2D does") {
    EachRound([](const Round &round, uint32_t seed) {
        b2DynamicTree tree;
        treeplay::Player player(seed, round.boxes, round.mostLeaves);
        Compared proxies;
        for (size_t i = 0; i < round.operations / 4; ++i)
            player.Play(&tree, &proxies);
        CHECK(proxies.compared > 0);
        CHECK(proxies.undone == proxies.compared);
        CHECK(proxies.noticed == 0);
    });
}

TEST_CASE("control: one bit that Box2D has otherwise is noticed") {
    b2DynamicTree tree;
    treeplay::Player player(1, treeplay::Boxes::kScattered, 50);
    Compared proxies;
    proxies.fault = true;
    for (int i = 0; i < 1000; ++i)
        player.Play(&tree, &proxies);
    CHECK(proxies.undone == proxies.compared);
    CHECK(proxies.noticed > 400);
}

TEST_CASE("ids of no leaf in the tree are Box2D's to assert on") {
    b2DynamicTree tree;
    NoLog log;
    b2AABB box;
    box.lowerBound.SetZero();
    box.upperBound.Set(1.0f, 1.0f);
    const int32 a = tree.CreateProxy(box, nullptr), b = tree.CreateProxy(box, nullptr);
    const int32 parent = *MembersOf(tree).root;
    tree.DestroyProxy(b);
    const std::vector<uint32_t> before = treeplay::BitsOf(tree);
    bool moved;
    for (const int32 id : {-1, b, parent, 15, 16, 1 << 30}) {
        CHECK_FALSE(DestroyHere(tree, id, &log));
        CHECK_FALSE(MoveHere(tree, id, box, b2Vec2(50.0f, 0.0f), &log, &moved));
    }
    CHECK(treeplay::BitsOf(tree) == before);
    box.upperBound.Set(9.0f, 9.0f);
    CHECK(MoveHere(tree, a, box, b2Vec2(50.0f, 0.0f), &log, &moved));
    CHECK(moved);
}

TEST_CASE("Box2D alone makes its array of nodes larger") {
    b2DynamicTree tree;
    NoLog log;
    b2AABB box;
    box.lowerBound.SetZero();
    box.upperBound.Set(1.0f, 1.0f);
    int32 id = 0, made = 0;
    const TreeMembers members = MembersOf(tree);
    while (CreateHere(tree, box, nullptr, &log, &id))
        ++made;
    CHECK(made == 8); // and seven parents: one node is left
    CHECK(MembersOf(tree).nodes == members.nodes);
    CHECK(*members.nodeCount == 15);
}
