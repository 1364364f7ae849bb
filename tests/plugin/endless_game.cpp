// SPDX-License-Identifier: MIT
// A game that steps until it is ended from outside. It says when it has begun.
#include "../kit/small_world.h"

int main() {
    b2World world(b2Vec2(0.0f, -10.0f));
    FillWithBoxes(world);
    Hash hash;
    for (uint64_t round = 0;; ++round) {
        Step(world, 1, &hash);
        if (round == 9)
            Print("played", hash);
    }
}
