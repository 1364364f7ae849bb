// SPDX-License-Identifier: MIT
#include "strange_box2d.h"

void b2World::Step(float timeStep, int, int) {
    b2TOIOutput output = {0.0f};
    const b2TOIInput input = {timeStep};
    b2TimeOfImpact(&output, &input);
    time += output.t;
}

void b2DistanceProxy::Set(const b2Shape *shape, int index) {
    radius = shape->radius + static_cast<float>(index);
}
