// SPDX-License-Identifier: MIT
// A module with a game that is compiled again and again, and says which version of it plays.
#include "../kit/small_world.h"

int PlayModule();

int PlayModule() {
    b2World world(b2Vec2(0.0f, -10.0f));
    FillWithBoxes(world);
    Hash hash;
    Step(world, 30, &hash);
    std::printf("version %d: ", VERSION);
    Print("played", hash);
    return 0;
}
