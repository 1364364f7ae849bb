// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_ANY_SIZE_H
#define BOOMERANG_TESTBED_ANY_SIZE_H

#include <memory>
#include <utility>
#include <vector>

#include "shapes.h"

/// @file
/// The same world with polygons of more than 8 vertices in three ways, and with concave bodies in two: cut
/// into few convex pieces that know their seams, or into triangles. What each world costs and how it moves is
/// comparable; the bits are not, for the worlds are not the same.

namespace testbed {

/// A shape as `kind` asks for it, made once and put on as many bodies as there are: their fixtures share what
/// can be shared.
class Fixtures {
public:
    explicit Fixtures(std::vector<std::unique_ptr<b2Shape>> pieces) : m_pieces(std::move(pieces)) {}
    void AddTo(Stage &stage, b2Body *body, const b2FixtureDef &def) const;

private:
    std::vector<std::unique_ptr<b2Shape>> m_pieces;
};

/// Counter-clockwise, strictly convex. Throws std::runtime_error where this worker has no such shape.
Fixtures AnySizePolygon(BodyKind kind, const Outline &outline);
/// A regular polygon around the origin; or the circle that goes through its vertices.
Fixtures AnySizePolygon(const PolygonChoice &choice, float radius, float phase = 0.0f);

/// One shape with all these vertices: a b2PolygonShape up to 8, above what the plugin has. Each worker has
/// its own; stock's throws std::runtime_error above 8.
std::unique_ptr<b2Shape> MakeOnePolygon(const Outline &outline);
/// All vertices of a polygon, whatever it is, in the body's frame.
Outline VerticesOf(const b2PolygonShape &polygon);

// --- concave bodies ---

/// An outline, and triangles that it can be cut into.
struct Concave {
    Outline ring; ///< the outer one
    std::vector<Outline> holes;
    std::vector<Outline> triangles;
};

/// An outline that is star-shaped about the origin: its triangles are its edges, each with the origin.
Concave StarShaped(const Outline &outline);

/// Pieces within `tolerance` of the outline. Throws std::runtime_error where this worker has none.
Fixtures OutlinedBody(BodyKind kind, const Concave &concave, float tolerance = 0.0f);

/// The pieces of an outline that know their seams. Each worker has its own; stock's throws
/// std::runtime_error.
std::vector<std::unique_ptr<b2Shape>> MakeOutlinePieces(const Concave &concave, float tolerance);
/// Of a fixture's polygon: the edges behind which another piece goes on.
std::vector<int> InnerEdgesOf(const b2Fixture &fixture);

} // namespace testbed

#endif
