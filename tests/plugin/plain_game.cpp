// SPDX-License-Identifier: MIT
// A Box2D program that knows nothing of Boomerang: boxes that fall on planks past a sensor, bullets between
// them. It prints what happened, to the last bit.
#include "../kit/small_world.h"

namespace {

constexpr int kSteps = 240;

class Counter : public b2ContactListener {
public:
    void BeginContact(b2Contact *) override { ++begun; }
    void EndContact(b2Contact *) override { ++ended; }
    int begun = 0, ended = 0;
};

} // namespace

int main() {
    b2World world(b2Vec2(0.0f, -10.0f));
    Counter counter;
    world.SetContactListener(&counter);
    FillWithBoxes(world);
    Hash hash;
    Step(world, kSteps, &hash);
#if defined(VERSION) // as a module, of which there are several
    std::printf("version %d: ", VERSION);
#endif
    std::printf("%016" PRIx64 " begun %d ended %d\n", hash.Value(), counter.begun, counter.ended);
    return 0;
}
