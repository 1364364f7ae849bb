// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_SHAPES_H
#define BOOMERANG_TESTBED_SHAPES_H

#include <memory>
#include <utility>
#include <vector>

#include "stage.h"

/// @file
/// The shapes that scenes are made of. Polygons of more than 8 vertices there are in three ways, and concave
/// bodies in two: cut into few convex pieces that know their seams, or into triangles. What each world costs
/// and how it moves is comparable; the bits are not, for the worlds are not the same.

namespace testbed {

/// Counter-clockwise vertices, in the body's frame.
using Vertices = std::vector<b2Vec2>;

b2PolygonShape MakeBox(float halfWidth, float halfHeight, b2Vec2 center = {0.0f, 0.0f}, float angle = 0.0f);
/// A regular polygon of 3 to 8 vertices.
b2PolygonShape MakeRegular(int count, float radius, float phase = 0.0f);
b2CircleShape MakeCircle(float radius, b2Vec2 center = {0.0f, 0.0f});
b2EdgeShape MakeEdge(b2Vec2 from, b2Vec2 to);

/// Those of a regular polygon of any size.
Vertices RegularVertices(int count, float radius, float phase = 0.0f);
/// Star-shaped about the origin, of `count` vertices whose distances from it are random in [inner, outer).
Vertices RoughVertices(Random &random, int count, float inner, float outer);
/// `count` vertices, alternately at `outer` and at `inner`; an odd one out lies halfway.
Vertices StarVertices(int count, float inner, float outer);

/// A closed arena about `center`: one static body of four wide walls, whose inner sides are halfWidth and
/// halfHeight away. The walls touch at their corners.
b2Body *AddArena(Stage &stage, b2Vec2 center, float halfWidth, float halfHeight, float restitution);

/// Of hills: a wave of so many radians a metre and metres in height, and how far each point is off it at
/// random.
struct Swell {
    float frequency, height, roughness;
};
/// Hills from left to right, a point a metre; the walls at both ends keep everything in.
Vertices MakeHills(Random &random, b2Vec2 from, float width, const Swell &swell);
/// Edges that know nothing of each other, as a level of separate segments has them.
void AddEdges(Stage &stage, const Vertices &hills, float friction);
/// One-sided, from right to left, so that its front is up.
void AddChain(Stage &stage, const Vertices &hills);

/// A car on two sprung wheels, above a place of the road. The joint is that of the rear wheel, which has a
/// motor.
b2WheelJoint *AddCar(Stage &stage, b2Vec2 road);

/// Places for `size` bodies in rows of `columns`, `spacing` apart, about the origin: what fills an arena of
/// halfWidth and halfHeight evenly.
class Grid {
public:
    Grid(int size, int columns, float spacing);
    b2Vec2 Place(int index) const;
    const float halfWidth, halfHeight;

private:
    int m_columns;
    float m_spacing;
};

/// The place of the i-th of many in rows of `columns` about x = 0, the lowest row at this height. Neighbours
/// in a row, and rows, are `spacing` apart.
b2Vec2 InRows(int i, int columns, float spacing, float lowest);

/// A dynamic body at a place, at any angle, that drifts at a speed in [slowest, fastest) and turns at less
/// than `spin`.
b2BodyDef Drifting(Random &random, b2Vec2 place, float slowest, float fastest, float spin);

/// A fixture definition whose shape is still to be set.
b2FixtureDef Material(float density, float friction = 0.2f, float restitution = 0.0f);

// --- polygons of any size ---

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
Fixtures AnySizePolygon(BodyKind kind, const Vertices &vertices);
/// A regular polygon around the origin; or the circle that goes through its vertices.
Fixtures AnySizePolygon(const PolygonChoice &choice, float radius, float phase = 0.0f);

/// One shape with all these vertices: a b2PolygonShape up to 8, above what the plugin has. Each worker has
/// its own; stock's throws std::runtime_error above 8.
std::unique_ptr<b2Shape> MakeOnePolygon(const Vertices &vertices);
/// All vertices of a polygon, also of one with more than 8, in its body's frame.
Vertices VerticesOf(const b2PolygonShape &polygon);

// --- concave bodies ---

/// An outline, and triangles that it can be cut into.
struct Concave {
    Vertices ring; ///< the outer one
    std::vector<Vertices> holes;
    std::vector<Vertices> triangles;
};

/// An outline that is star-shaped about the origin: its triangles are its edges, each with the origin.
Concave StarShaped(const Vertices &ring);

/// Pieces within `tolerance` of the outline. Throws std::runtime_error where this worker has none.
Fixtures OutlinedBody(BodyKind kind, const Concave &concave, float tolerance = 0.0f);

/// The pieces of an outline that know their seams. Each worker has its own; stock's throws
/// std::runtime_error.
std::vector<std::unique_ptr<b2Shape>> MakeOutlinePieces(const Concave &concave, float tolerance);
/// Of a fixture's polygon: the edges behind which another piece goes on.
std::vector<int> InnerEdgesOf(const b2Fixture &fixture);

} // namespace testbed

#endif
