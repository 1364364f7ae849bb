// SPDX-License-Identifier: MIT
// See names.h. Box2D's b2Island as a function that may be called from elsewhere, compiled as Box2D is.
// Nothing is renamed here.
#include BMR_BOX2D_ISLAND

#include "box2d/b2_contact.h"
#include "box2d/b2_joint.h"
#include "box2d/b2_stack_allocator.h"
#include "box2d/b2_time_step.h"

namespace bmr {

// As in box2d_glue/passes/which_solver.h, which is not of the language that this is compiled as.
struct IslandParts {
    b2Body *const *bodies;
    b2Contact *const *contacts;
    b2Joint *const *joints;
    uint32 bodyCount, contactCount, jointCount;
};

namespace stock {

void SolveIsland(const IslandParts &parts, const b2TimeStep &step, const b2Vec2 &gravity, bool allowSleep,
                 b2ContactListener *listener, b2Profile *profile);
void SolveToiIsland(const IslandParts &parts, const b2TimeStep &step, b2ContactListener *listener);
bool Asserts();

namespace {

/// A stack allocator is too large for some stacks.
struct Room {
    Room() : allocator(new b2StackAllocator) {}
    ~Room() { delete allocator; }
    Room(const Room &) = delete;
    Room &operator=(const Room &) = delete;
    b2StackAllocator *allocator;
};

void Fill(const IslandParts &parts, b2Island *island) {
    for (uint32 i = 0; i < parts.bodyCount; ++i)
        island->Add(parts.bodies[i]);
    for (uint32 i = 0; i < parts.contactCount; ++i)
        island->Add(parts.contacts[i]);
    for (uint32 i = 0; i < parts.jointCount; ++i)
        island->Add(parts.joints[i]);
}

} // namespace

void SolveIsland(const IslandParts &parts, const b2TimeStep &step, const b2Vec2 &gravity, bool allowSleep,
                 b2ContactListener *listener, b2Profile *profile) {
    const Room room;
    b2Island island(int32(parts.bodyCount), int32(parts.contactCount), int32(parts.jointCount),
                    room.allocator, listener);
    Fill(parts, &island);
    b2Profile here;
    island.Solve(&here, step, gravity, allowSleep);
    profile->solveInit += here.solveInit;
    profile->solveVelocity += here.solveVelocity;
    profile->solvePosition += here.solvePosition;
}

void SolveToiIsland(const IslandParts &parts, const b2TimeStep &step, b2ContactListener *listener) {
    const Room room;
    b2Island island(int32(parts.bodyCount), int32(parts.contactCount), 0, room.allocator, listener);
    Fill(parts, &island);
    island.SolveTOI(step, 0, 1);
}

bool Asserts() {
#if defined(NDEBUG)
    return false;
#else
    return true;
#endif
}

} // namespace stock
} // namespace bmr
