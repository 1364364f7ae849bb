// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_GAS_SCENE_H
#define BOOMERANG_TESTBED_GAS_SCENE_H

#include <string>

#include "scene.h"

namespace testbed {

/// A scene that is not in the list: free bodies without gravity or friction, all of them bullets and
/// perfectly elastic, in a box. The file says, in this order,
///
///     gas STEPS TIMESTEP COUNT
///     box LEFT BOTTOM RIGHT TOP | open
///     body N X Y X Y .. X Y ANGLE VX VY SPIN     COUNT times: an outline, counter-clockwise, its place, its
///     way
///
/// Bodies are numbered in this order; the box is one more. Throws std::runtime_error for a file that cannot
/// be read.
SceneInfo GasScene(const std::string &file);

} // namespace testbed

#endif
