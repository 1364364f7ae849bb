// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CONVEX_SHAPE_H
#define BOOMERANG_CONVEX_SHAPE_H

#include <cstdint>

#include <box2d/b2_polygon_shape.h>

#include "boomerang/box2d_glue.h"
#include "boomerang/error.h"

class b2Draw;
class b2World;

/// @file
/// A convex polygon of any number of vertices as one fixture. Games include boomerang/box2d.h.
///
///     bmr::ConvexShape coin;
///     if (coin.SetRegular(256, 0.5f) == BMR_OK)
///         body->CreateFixture(&coin, 1.0f);
///
/// One fixture, one proxy in the broad phase, one contact a pair, whatever the number of vertices.

namespace bmr {

/// Box2D knows polygons of at most 8 vertices. This is one (and Box2D's own code, to the bit) up to 8; above,
/// it holds the real polygon besides, and shows Box2D's own code an octagon of eight of its vertices. Masses,
/// boxes, rays, points and contacts with every kind of shape are the real polygon's, on every platform; time
/// of impact, sensors, b2Distance and b2ShapeCast are where the shared library stands in front of Box2D, and
/// the octagon's elsewhere (docs/any-size-polygons.md: nothing tunnels).
///
/// Copies and clones share the polygon; it is freed with the last of them. Shapes may be made, copied and
/// destroyed on any thread. What Box2D inherits is as it is: m_radius may be changed as ever, but m_vertices,
/// m_normals and m_count are not to be touched, nor is the shape to be copied into a plain b2PolygonShape
/// (which would be the octagon).
class BMR_BOX2D_API ConvexShape : public b2PolygonShape {
public:
    ConvexShape() noexcept;
    ConvexShape(const ConvexShape &other) noexcept;
    ConvexShape &operator=(const ConvexShape &other) noexcept;
    ~ConvexShape() override;

    /// Most vertices of a polygon.
    static constexpr int32 kMostVertices = 65535;

    /// The convex hull of 3 and more points. Where the hull has at most 8 vertices the shape is what
    /// b2PolygonShape::Set makes of the points, bit for bit, if Set neither welds nor asserts on them;
    /// otherwise BMR_ERROR_... says what is wrong. On an error the shape stays as it was. O(n log n).
    bmr_error Set(const b2Vec2 *points, int32 count);
    /// The same of vertices that are convex, counter-clockwise and no three on a line: kept as they are.
    /// O(n).
    bmr_error SetRaw(const b2Vec2 *vertices, int32 count);

    /// A regular polygon around the origin; its first vertex lies on the positive x axis.
    bmr_error SetRegular(int32 count, float radius);
    /// `count` vertices on an ellipse around the origin.
    bmr_error SetEllipse(int32 count, float halfWidth, float halfHeight);
    /// A rectangle whose corners are rounded with `cornerRadius`, a quarter circle of `cornerVertices` each
    /// (halfHeight == cornerRadius: a capsule).
    bmr_error SetRounded(float halfWidth, float halfHeight, float cornerRadius, int32 cornerVertices);
    /// Fewer vertices, all of them among those it has, nowhere farther than `tolerance` from what it was.
    bmr_error Simplify(float tolerance);

    /// The real polygon. O(1).
    int32 GetVertexCount() const;
    const b2Vec2 &GetVertex(int32 index) const;
    const b2Vec2 &GetNormal(int32 index) const; ///< of the edge from vertex `index` to the next
    /// All of them, in order; valid as long as any shape shares the polygon.
    const b2Vec2 *GetVertices() const;

    /// The shape as one of these, or nullptr where it is any other.
    static const ConvexShape *From(const b2Shape *shape);

    b2Shape *Clone(b2BlockAllocator *allocator) const override;
    bool TestPoint(const b2Transform &xf, const b2Vec2 &p) const override;
    bool RayCast(b2RayCastOutput *output, const b2RayCastInput &input, const b2Transform &xf,
                 int32 childIndex) const override;
    void ComputeAABB(b2AABB *aabb, const b2Transform &xf, int32 childIndex) const override;
    void ComputeMass(b2MassData *massData, float density) const override;

private:
    /// Lies in the padding behind b2PolygonShape's last member: Box2D frees sizeof(b2PolygonShape).
    uint32_t m_handle;
};

/// Draws every ConvexShape of the world with its real outline, in the colours of b2World::DebugDraw; call it
/// after that. Where the shared library stands in front of Box2D, DebugDraw itself does.
BMR_BOX2D_API void DrawConvexShapes(const b2World &world, b2Draw &draw);

} // namespace bmr

#endif
