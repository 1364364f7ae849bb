// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_STRANGE_BOX2D_H
#define BOOMERANG_STRANGE_BOX2D_H

/// A library that calls itself Box2D and is another: a world of one number. Its b2World has the same mangled
/// names.
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

#endif
