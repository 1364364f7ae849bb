// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_COURSE_SCENE_H
#define BOOMERANG_TESTBED_COURSE_SCENE_H

#include <string>

#include "scene.h"

namespace testbed {

/// A scene that is not in the list: two convex bodies that are led through given poses, one pose a step. The
/// file says, in this order,
///
///     course STEPS TIMESTEP
///     outline N X Y X Y ..             of A, counter-clockwise; then another, of B
///     XA YA ANGLEA XB YB ANGLEB        STEPS + 1 times; angles go on beyond pi
///
/// Box2D integrates: each step gives the bodies the velocities that take them to their next pose. A is
/// kinematic, B is a bullet, so that Box2D asks all its questions. Throws std::runtime_error for a file that
/// cannot be read.
SceneInfo CourseScene(const std::string &file);

} // namespace testbed

#endif
