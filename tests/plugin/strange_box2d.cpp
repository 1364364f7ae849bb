// SPDX-License-Identifier: MIT
#include "strange_box2d.h"

void b2World::Step(float timeStep, int, int) {
    time += timeStep;
}
