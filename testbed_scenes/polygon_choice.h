// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_POLYGON_CHOICE_H
#define BOOMERANG_TESTBED_POLYGON_CHOICE_H

namespace testbed {

enum class BodyKind {
    One,   ///< one fixture with all vertices (bmr::ConvexShape above 8): the worker with the plugin alone
    Many,  ///< stock fixtures of at most 8 vertices each, which share the first vertex
    Circle ///< what is round becomes a circle, all else as Many
};

/// What a scene is told that lets its polygons' size be chosen.
struct PolygonChoice {
    BodyKind bodies = BodyKind::Many;
    int vertices = 0; ///< 0: there is nothing to choose
};

/// "one", "many" or "circle".
const char *NameOf(BodyKind kind);

} // namespace testbed

#endif
