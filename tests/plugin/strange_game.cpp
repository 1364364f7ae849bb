// SPDX-License-Identifier: MIT
#include <cstdio>

#include "strange_box2d.h"

int main() {
    b2World world;
    for (int i = 0; i < 4; ++i)
        world.Step(0.25f, 8, 3);
    const b2Shape shape;
    b2DistanceProxy proxy;
    proxy.Set(&shape, 1);
    std::printf("time %g radius %g\n", double{world.time}, double{proxy.radius});
    return world.time == 1.0f ? 0 : 1;
}
