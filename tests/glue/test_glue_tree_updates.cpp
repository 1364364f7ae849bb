// SPDX-License-Identifier: MIT
// Leaves put into a tree of boxes, taken out and moved by the plugin's code, and by Box2D's: after each
// operation the two trees are the same to the bit, and so are their lists of free nodes.
#include "cases.h"
#include "tree/edit.h"
#include "tree_play.h"

namespace {

using namespace bmr::tree;

/// As the hooks do it: what is not done here is Box2D's.
struct Ours {
    size_t here = 0, box2d = 0;

    int32 Create(b2DynamicTree *tree, const b2AABB &box, void *userData) {
        int32 leaf;
        if (Counted(CreateHere(*tree, box, userData, &leaf)))
            return leaf;
        return tree->CreateProxy(box, userData);
    }
    void Destroy(b2DynamicTree *tree, int32 leaf) {
        if (!Counted(DestroyHere(*tree, leaf)))
            tree->DestroyProxy(leaf);
    }
    bool Move(b2DynamicTree *tree, int32 leaf, const b2AABB &box, const b2Vec2 &displacement) {
        bool moved;
        if (Counted(MoveHere(*tree, leaf, box, displacement, &moved)))
            return moved;
        return tree->MoveProxy(leaf, box, displacement);
    }

private:
    bool Counted(bool done) {
        ++(done ? here : box2d);
        return done;
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

TEST_CASE("ids of no leaf in the tree are Box2D's to assert on") {
    b2DynamicTree tree;
    b2AABB box;
    box.lowerBound.SetZero();
    box.upperBound.Set(1.0f, 1.0f);
    const int32 a = tree.CreateProxy(box, nullptr), b = tree.CreateProxy(box, nullptr);
    const int32 parent = *MembersOf(tree).root;
    tree.DestroyProxy(b);
    const std::vector<uint32_t> before = treeplay::BitsOf(tree);
    bool moved;
    for (const int32 id : {-1, b, parent, 15, 16, 1 << 30}) {
        CHECK_FALSE(DestroyHere(tree, id));
        CHECK_FALSE(MoveHere(tree, id, box, b2Vec2(50.0f, 0.0f), &moved));
    }
    CHECK(treeplay::BitsOf(tree) == before);
    box.upperBound.Set(9.0f, 9.0f);
    CHECK(MoveHere(tree, a, box, b2Vec2(50.0f, 0.0f), &moved));
    CHECK(moved);
}

TEST_CASE("Box2D alone makes its array of nodes larger") {
    b2DynamicTree tree;
    b2AABB box;
    box.lowerBound.SetZero();
    box.upperBound.Set(1.0f, 1.0f);
    int32 id = 0, made = 0;
    const TreeMembers members = MembersOf(tree);
    while (CreateHere(tree, box, nullptr, &id))
        ++made;
    CHECK(made == 8); // and seven parents: one node is left
    CHECK(MembersOf(tree).nodes == members.nodes);
    CHECK(*members.nodeCount == 15);
}
