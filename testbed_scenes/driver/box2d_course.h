// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_BOX2D_COURSE_H
#define BOOMERANG_TESTBED_BOX2D_COURSE_H

#include <cstdint>

#include "theory/experiment.h"
#include "workers.h"

namespace testbed {

/// What Box2D asked while it led two bodies along a course.
struct Box2DCalls {
    int64_t steps = 0;
    double tests = 0.0;     ///< b2CollidePolygons
    double impacts = 0.0;   ///< b2TimeOfImpact
    double distances = 0.0; ///< b2Distance, those that b2TimeOfImpact makes among them
};

/// The same course on stock Box2D and with the plugin.
struct Box2DCourse {
    Box2DCalls stock, plugin;
    double pluginEvents =
        0.0; ///< of the two hulls' structure and of contacts: pushes, stabs, rolls, contacts, leaves
};

/// Runs a course in Box2D: the polygons as bodies of fixtures of at most 8 vertices, one step for each tenth
/// of a radian or unit of length. The bodies are made large enough that Box2D's skins do not touch. Throws
/// WorkerError if a worker fails.
Box2DCourse RunInBox2D(const Course &course, const Workers &workers);

} // namespace testbed

#endif
