// SPDX-License-Identifier: MIT
//
//   tree_game [OPERATIONS]
//
// A game that keeps trees of boxes of its own beside its world, and puts any boxes into them.
#include <cstdlib>

#include "../kit/tree_play.h"
#include "small_world.h"

int main(int count, char **arguments) {
    const int operations = count > 1 ? std::atoi(arguments[1]) : 5000;
    b2World world(b2Vec2(0.0f, -10.0f));
    FillWithBoxes(world);
    Hash hash;
    Step(world, 20, &hash);
    Print("world", hash);
    uint32_t seed = 0;
    for (const treeplay::Boxes boxes : treeplay::kAllBoxes) {
        b2DynamicTree tree;
        ++seed;
        treeplay::Player player(seed, boxes, 30 + 40 * static_cast<int32>(seed));
        treeplay::OfBox2D proxies;
        for (int i = 0; i < operations; ++i) {
            player.Play(&tree, &proxies);
            if (i % 16 == 0 || i + 1 == operations)
                treeplay::EachWord(tree, [&hash](uint32_t word) { hash.Add(word); });
        }
        Print("tree", hash);
    }
    Step(world, 100, &hash);
    Print("world", hash);
    return 0;
}
