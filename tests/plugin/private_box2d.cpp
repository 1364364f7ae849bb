// SPDX-License-Identifier: MIT
// A module with a Box2D of its own inside, as engines bring it: the mangled names are Box2D's, the classes
// are not. What is called is seen from outside, so that a preloaded library stands in front of it. VERSION
// tells one module from another.
#include <cstdio>

/// Its number lies behind all that another Box2D would take for a world, and that is zeros: nothing to do.
class b2World {
public:
    void Step(float timeStep, int velocityIterations, int positionIterations);
    char room[1 << 18];
    int steps;
};

__attribute__((noinline)) void b2World::Step(float, int, int) {
    steps += VERSION;
}

int PlayModule();

int PlayModule() {
    auto *world = new b2World();
    for (int i = 0; i < 5; ++i)
        world->Step(0.25f, 8, 3);
    std::printf("steps %d\n", world->steps);
    delete world;
    return 0;
}
