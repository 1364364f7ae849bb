// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_ANY_SIZE_H
#define BOOMERANG_TESTBED_ANY_SIZE_H

#include <memory>
#include <vector>

#include "polygon_choice.h"
#include "shapes.h"

/// @file
/// The same world with polygons of more than 8 vertices in three ways. What each world costs and how it moves
/// is comparable; the bits are not, for the worlds are not the same.

namespace testbed {

/// A convex polygon as `kind` asks for it, made once and put on as many bodies as there are: their fixtures
/// share what can be shared.
class AnySizePolygon {
public:
    /// Counter-clockwise, strictly convex. Throws std::runtime_error where this worker has no such shape.
    AnySizePolygon(BodyKind kind, const Outline &outline);
    /// A regular polygon around the origin; or the circle that goes through its vertices.
    AnySizePolygon(const PolygonChoice &choice, float radius, float phase = 0.0f);

    void AddTo(Stage &stage, b2Body *body, const b2FixtureDef &def) const;

private:
    std::vector<std::unique_ptr<b2Shape>> m_pieces;
};

/// One shape with all these vertices: a b2PolygonShape up to 8, above what the plugin has. Each worker has
/// its own; stock's throws std::runtime_error above 8.
std::unique_ptr<b2Shape> MakeOnePolygon(const Outline &outline);
/// All vertices of a polygon, whatever it is, in the body's frame.
Outline VerticesOf(const b2PolygonShape &polygon);

} // namespace testbed

#endif
