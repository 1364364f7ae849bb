// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CONVEX_SHAPE_H
#define BOOMERANG_CONVEX_SHAPE_H

#include <cstdint>

#include <box2d/b2_polygon_shape.h>

#include "boomerang/box2d_glue.h"
#include "boomerang/error.h"

class b2Draw;
class b2World;
struct bmr_convex32_block;

// The handle of the real polygon must not make the shape larger than a b2PolygonShape. The Itanium C++ ABI
// puts it into that one's padding. Others do not: there the polygon inside has 7 vertices, and the handle
// lies in the eighth normal.
#if defined(__GNUC__) && !defined(_MSC_VER) && UINTPTR_MAX > UINT32_MAX &&                                   \
    !defined(BMR_CONVEX_HANDLE_IN_NORMALS)
#    define BMR_CONVEX_HANDLE_IN_PADDING 1
#endif

/// @file
/// A convex polygon of any number of vertices as one fixture. Games include boomerang/box2d.h.
///
///     bmr::ConvexShape coin;
///     if (coin.SetRegular(256, 0.5f) == BMR_OK)
///         body->CreateFixture(&coin, 1.0f);
///
/// One fixture, one proxy in the broad phase, one contact a pair, however many vertices.

namespace bmr {

namespace internal {
struct ConvexShapeAccess;
} // namespace internal

/// Points that a polygon left out because they lie in the place of others.
struct Welded {
    int32 count = 0;       ///< how many
    float distance = 0.0f; ///< none of them is farther from the one that was kept
};

/// Box2D knows polygons of at most 8 vertices. Up to 8 vertices a ConvexShape is one of these, to the bit.
/// Above, it holds the real polygon, and shows Box2D's own code an octagon of eight of its vertices (a
/// heptagon if the compiler has another C++ ABI than Itanium's). Masses, boxes, rays, points and contacts
/// with every kind of shape are the real polygon's, on every platform. Time of impact, sensors, b2Distance
/// and b2ShapeCast are the real polygon's if the shared library stands in front of Box2D or Box2D is compiled
/// with us, and else the octagon's (docs/any-size-polygons.md says why nothing tunnels).
///
/// Copies and clones share the polygon; it is freed with the last of them. Shapes may be made, copied and
/// destroyed on any thread. Members that it inherits from Box2D work as usual: a game may change m_radius. A
/// shape whose m_vertices or m_count are changed in place (b2PolygonShape::Set and SetAsBox through a pointer
/// to the base do that) is from then on the polygon that they describe, as any b2PolygonShape is: at most 8
/// vertices, and no seams if it is a piece of an outline. Copied into a plain b2PolygonShape it is the
/// octagon. Do not change the shape of a fixture by calls of this class from at most 8 to more vertices, or
/// back: its contacts stay as they were until they part.
class BMR_BOX2D_API ConvexShape final : public b2PolygonShape {
public:
    ConvexShape() noexcept;
    ConvexShape(const ConvexShape &other) noexcept;
    ConvexShape &operator=(const ConvexShape &other) noexcept;
    ~ConvexShape() override;

    /// Most vertices of a polygon.
    static constexpr int32 kMostVertices = 65535;

    /// The convex hull of 3 and more points, counter-clockwise from the rightmost one (of these the lowest).
    /// Vertices that turn by no more than rounding (at most about 1e-7) are dropped.
    ///
    /// If the hull has at most 8 vertices, the shape is the one that b2PolygonShape::Set of Box2D 2.4.1 makes
    /// of the points (of the hull's vertices, if there are more than 8 points), bit for bit. If Set would
    /// assert because its wrapping finds no hull, it is the exact hull.
    ///
    /// Points that equal another are left out. If the polygon has at most 8 vertices, so are points within
    /// half of b2_linearSlop of one before them, as b2PolygonShape::Set does. *welded says how many and how
    /// far.
    ///
    /// Errors leave the shape and *welded as they were: BMR_ERROR_NULL_ARGUMENT, BMR_ERROR_TOO_FEW_POINTS
    /// (all on one line, too), BMR_ERROR_TOO_MANY_POINTS (on the hull), BMR_ERROR_NOT_FINITE,
    /// BMR_ERROR_OUT_OF_RANGE (a coordinate beyond 1e9 where there are more than 8 points, a product that
    /// overflows, an area of at most b2_epsilon), BMR_ERROR_TOO_CLOSE (fewer than three points are left that
    /// are not within half of b2_linearSlop of each other), BMR_ERROR_NO_MEMORY, BMR_ERROR_UNSUPPORTED (more
    /// than 8 vertices need a Box2D that the glue knows). O(n log n).
    bmr_error Set(const b2Vec2 *points, int32 count);
    bmr_error Set(const b2Vec2 *points, int32 count, Welded *welded);
    /// The same for vertices that are a hull already, counter-clockwise from any one. It keeps them and their
    /// order. BMR_ERROR_NOT_CONVEX if they are no hull, BMR_ERROR_TOO_CLOSE if Set would weld two. O(n).
    bmr_error SetRaw(const b2Vec2 *vertices, int32 count);

    /// b2PolygonShape::SetAsBox, bit for bit, in place of the shape's polygon. Errors leave it as it was:
    /// BMR_ERROR_NOT_FINITE, BMR_ERROR_OUT_OF_RANGE (a size that is not above zero).
    bmr_error SetAsBox(float halfWidth, float halfHeight);
    bmr_error SetAsBox(float halfWidth, float halfHeight, const b2Vec2 &center, float angle);

    /// A regular polygon around the origin; its first vertex lies on the positive x axis. It keeps vertices
    /// that floats can tell from a straight line (all of 12,000, about 26,000 of 65,535): GetVertexCount.
    /// Errors of this and the next three: those of Set, and BMR_ERROR_TOO_CLOSE (at most 8 vertices, two
    /// within half of b2_linearSlop). Of this and the next two, too: BMR_ERROR_OUT_OF_RANGE (a size that is
    /// not above zero), BMR_ERROR_TOO_MANY_POINTS (above kMostVertices).
    bmr_error SetRegular(int32 count, float radius);
    /// `count` vertices on an ellipse around the origin, dense where it bends.
    bmr_error SetEllipse(int32 count, float halfWidth, float halfHeight);
    /// A rectangle around the origin whose corners are rounded with `cornerRadius`, a quarter circle of
    /// `cornerVertices` (at least 2) each. halfHeight == cornerRadius: a capsule. A larger one is
    /// BMR_ERROR_CORNER_TOO_LARGE.
    bmr_error SetRounded(float halfWidth, float halfHeight, float cornerRadius, int32 cornerVertices);
    /// Fewer vertices, all of them among those it has, nowhere farther than `tolerance` from what it was
    /// (bmr_convex32_simplify). A shape without vertices is BMR_ERROR_TOO_FEW_POINTS, a tolerance below zero
    /// BMR_ERROR_NEGATIVE. Usually O(n log n).
    bmr_error Simplify(float tolerance);

    /// The real polygon. O(1).
    int32 GetVertexCount() const;
    const b2Vec2 &GetVertex(int32 index) const;
    const b2Vec2 &GetNormal(int32 index) const; ///< of the edge from vertex `index` to the next
    /// All of them, in order; valid as long as any shape shares the polygon.
    const b2Vec2 *GetVertices() const;

    /// The shape as a ConvexShape, or nullptr if it is none.
    static const ConvexShape *From(const b2Shape *shape);

    b2Shape *Clone(b2BlockAllocator *allocator) const override;
    bool TestPoint(const b2Transform &xf, const b2Vec2 &p) const override;
    bool RayCast(b2RayCastOutput *output, const b2RayCastInput &input, const b2Transform &xf,
                 int32 childIndex) const override;
    void ComputeAABB(b2AABB *aabb, const b2Transform &xf, int32 childIndex) const override;
    /// Above 8 vertices the inertia is chosen so that a body of this fixture alone gets the float nearest to
    /// the right one. Farther from the body's origin than 1,448 times the radius of gyration it gets one
    /// above zero. OutlineShape::CreateFixtures says why.
    void ComputeMass(b2MassData *massData, float density) const override;

private:
    friend struct internal::ConvexShapeAccess;

    /// The real polygon's handle; 0 if there is none, or if the game changed the shape's vertices in place.
    uint32_t GetHandle() const;
    /// The handle that the shape has a reference to, or 0.
    uint32_t GetKeptHandle() const;
    void SetHandle(uint32_t handle);
    /// Takes over the polygon of a handle, with its reference, and shows Box2D the polygon of at most 8
    /// vertices inside it.
    void Adopt(uint32_t handle);
    /// Takes over a polygon of at most 8 vertices, from its vertex `first` on. The skin stays.
    void TakeSmall(const b2PolygonShape &small, int32 first);
    /// Set. Weld::Refused: points within half of b2_linearSlop of others are BMR_ERROR_TOO_CLOSE.
    enum class Weld { Allowed, Refused };
    bmr_error SetHull(const b2Vec2 *points, int32 count, Weld weld, Welded *welded);
    /// The polygon of `polygon` vertices as it is, which was just made.
    bmr_error AdoptBlock(bmr_convex32_block *block);

#if defined(BMR_CONVEX_HANDLE_IN_PADDING)
    /// Lies in the padding behind b2PolygonShape's last member: Box2D frees sizeof(b2PolygonShape) bytes.
    uint32_t m_handle;
#endif
};

/// Draws every ConvexShape of more than 8 vertices, and every piece of an OutlineShape, with its real
/// vertices, in the colours of b2World::DebugDraw; call it after that, on the same thread. Where the shared
/// library stands in front of Box2D, DebugDraw itself draws them (as Options::drawAs says), and a call that
/// follows it for the same world and drawer does nothing. DrawAs::Pieces, a fan of polygons of at most 8
/// vertices, suits every drawer; DrawAs::Whole hands DrawSolidPolygon up to 65,535 vertices at a time.
BMR_BOX2D_API void DrawConvexShapes(const b2World &world, b2Draw &draw, DrawAs drawAs = DrawAs::Pieces);

} // namespace bmr

#endif
