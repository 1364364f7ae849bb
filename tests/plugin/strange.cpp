// SPDX-License-Identifier: MIT
// A library that calls itself Box2D and is another: a world of one number; its b2World has the same mangled
// names. STRANGE_BOX2D and STRANGE_IMPACT are object files of their own, of which a linker takes the second
// out of an archive only if no library ahead of it has the function. Otherwise a game that uses them.
#include <cstdio>

class b2World {
public:
    void Step(float timeStep, int velocityIterations, int positionIterations);
    float time = 0.0f;
};

struct b2TOIInput {
    float tMax;
};
struct b2TOIOutput {
    float t;
};
void b2TimeOfImpact(b2TOIOutput *output, const b2TOIInput *input);

/// Laid out as a polygon of 2.4.1: the second word is a type.
class b2Shape {
public:
    void *first = nullptr;
    int type = 2;
    float radius = 0.5f;
    float rest[64] = {};
};
struct b2DistanceProxy {
    void Set(const b2Shape *shape, int index);
    float radius = 0.0f;
    float rest[15] = {};
};

#if defined(STRANGE_BOX2D)

void b2World::Step(float timeStep, int, int) {
    b2TOIOutput output = {0.0f};
    const b2TOIInput input = {timeStep};
    b2TimeOfImpact(&output, &input);
    time += output.t;
}

void b2DistanceProxy::Set(const b2Shape *shape, int index) {
    radius = shape->radius + static_cast<float>(index);
}

#elif defined(STRANGE_IMPACT)

void b2TimeOfImpact(b2TOIOutput *output, const b2TOIInput *input) {
    output->t = input->tMax;
}

#else

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

#endif
