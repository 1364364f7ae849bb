// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_PLUGIN_CHANGES_H
#define BOOMERANG_TEST_PLUGIN_CHANGES_H

#include "watching.h"

namespace surprises {

/// A world as a change meets it.
struct Surroundings {
    b2World &world;
    Crowd &crowd;
    Watching &watching;
    float timeStep;     ///< of the next steps
    bool updatesFollow; ///< all contacts will be updated once more before bodies are moved
};

/// What has happened to the pair between the steps before, with the change and without it.
enum Before {
    kNothing,
    kInside,   ///< nothing, but the change is of sensors that are touched: for places that updates follow
    kPush,     ///< A moves so that it meets B in the step
    kShot,     ///< A is a bullet, so fast that it would pass through B in the step
    kShotAsIs, ///< the same, but A is as much of a bullet as it was
    kOverlap   ///< A of the pairs asleep was put into B
};

/// One way in which an answer can change that a pair was known to have.
struct Change {
    const char *name;
    bool whileLocked; ///< Box2D lets a callback do it
    Before before;
    /// Of a pair whose bodies are both there; nullptr where the change is the world's.
    void (*ofPair)(Surroundings &, Pair &);
    void (*ofWorld)(Surroundings &);
    /// Some steps later, between two: takes it back or lets it be seen; or nullptr.
    void (*later)(Surroundings &, Pair &);
};

const std::vector<Change> &AllChanges();

/// Does `before` to a pair, between two steps.
void Prepare(Surroundings &around, Pair &pair, Before before);

} // namespace surprises

#endif
