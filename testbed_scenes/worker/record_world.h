// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_RECORD_WORLD_H
#define BOOMERANG_TESTBED_RECORD_WORLD_H

#include <vector>

#include <box2d/box2d.h>

#include "recording/recording.h"

/// @file
/// The parts of a frame (recording/recording.h) that are a world's own, read off it. None changes the world.

namespace testbed {

recording::Vec ToVec(const b2Vec2 &v);

std::vector<recording::Body> RecordBodies(const b2World &world);
/// Every fixture there is.
std::vector<recording::Fixture> RecordFixtures(const b2World &world);
std::vector<recording::Box> RecordBoxes(const b2World &world);
/// As b2Joint::Draw draws them.
std::vector<recording::Joint> RecordJoints(const b2World &world);
/// Touching contacts of solid fixtures.
std::vector<recording::Contact> RecordTouching(const b2World &world);

/// Closest points of two fixtures, one child each, without their radii (b2Distance).
struct Closest {
    float distance;
    b2Vec2 onA, onB;
};
Closest MeasureClosest(const b2Fixture &fixtureA, const b2Fixture &fixtureB);

} // namespace testbed

#endif
