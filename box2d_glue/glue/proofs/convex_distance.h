// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONVEX_DISTANCE_H
#define BOOMERANG_GLUE_CONVEX_DISTANCE_H

#include <cstdint>

#include <box2d/b2_circle_shape.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_polygon_shape.h>

#include "exact32/exact32.h"
#include "glue/proofs/overlap.h"
#include "shapes/big_polygons.h"

struct b2TOIInput;
struct b2TOIOutput;

namespace bmr {

/// @file
/// Box2D's questions about distance, asked of big polygons: b2Distance, b2ShapeCast, b2TimeOfImpact and
/// b2TestOverlap as Box2D would answer them for all vertices, however many.
///
/// A proxy of a big polygon has its real vertices, and, in the buffer that Box2D needs for links of chains, a
/// mark that names the polygon. A proxy that other code filled may have any bytes there. So a mark counts
/// only if it is the number of a polygon that is alive and has these very vertices.

/// Makes the proxy that of the real polygon, and marks it; false, and nothing done, of any other shape.
bool SetBigProxy(b2DistanceProxy *proxy, const b2Shape &shape);

/// b2DistanceProxy::Set of a shape: real polygons, and without a call the shapes that most are. False, and
/// nothing done, of edges and chains.
inline bool SetCommonProxy(b2DistanceProxy *proxy, const b2Shape &shape) {
    if (shape.m_type == b2Shape::e_polygon) {
        if (AnyBigPolygon() && SetBigProxy(proxy, shape))
            return true;
        const auto &polygon = static_cast<const b2PolygonShape &>(shape);
        proxy->m_vertices = polygon.m_vertices;
        proxy->m_count = polygon.m_count;
    } else if (shape.m_type == b2Shape::e_circle) {
        proxy->m_vertices = &static_cast<const b2CircleShape &>(shape).m_p;
        proxy->m_count = 1;
    } else {
        return false;
    }
    proxy->m_radius = shape.m_radius;
    return true;
}

/// The same of any shape.
inline void SetProxy(b2DistanceProxy *proxy, const b2Shape &shape, int32 child) {
    if (!SetCommonProxy(proxy, shape))
        proxy->Set(&shape, child);
}

/// b2Distance where one of the two is big; false, and nothing done, of all others. The cache counts as warm
/// only where its 8-bit numbers can be meant.
bool BigDistance(b2DistanceOutput *output, b2SimplexCache *cache, const b2DistanceInput &input);

/// b2ShapeCast, likewise.
bool BigCast(b2ShapeCastOutput *output, const b2ShapeCastInput &input, bool *hit);

/// b2TimeOfImpact, likewise, for any tMax from 0 on; below 0 it looks at time 0 alone.
bool BigImpact(b2TOIOutput *output, const b2TOIInput &input);

/// One shape of a body during a step.
struct Swept {
    const b2Shape &shape;
    int32 child;
    const b2Sweep &sweep;
};

/// Is it certain that b2TimeOfImpact does not say e_touching of these two during the step? False, and nothing
/// done, where neither is big. As for bmr_convex32_impact, `guess` is a direction that may keep them apart.
bool BigNeverTouch(const Swept &a, const Swept &b, bmr_vec32 guess, bool *never);

/// The answer of b2TestOverlap for two proxies, one of which is big.
Overlap BigOverlap(const b2DistanceProxy &a, const b2Transform &xfA, const b2DistanceProxy &b,
                   const b2Transform &xfB);

} // namespace bmr

#endif
