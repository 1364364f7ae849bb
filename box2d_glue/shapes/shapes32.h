// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SHAPES32_H
#define BOOMERANG_GLUE_SHAPES32_H

#include <cstddef>

#include <box2d/b2_collision.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>

#include "boomerang/pose.h"
#include "exact32/exact32.h"

namespace bmr {

// Box2D's own arrays are read in place: the layouts must agree.
static_assert(sizeof(b2Vec2) == sizeof(bmr_vec32) && offsetof(b2Vec2, y) == offsetof(bmr_vec32, y));
static_assert(sizeof(b2Transform) == sizeof(bmr_transform32));
static_assert(offsetof(b2Rot, s) == 0 && offsetof(b2Rot, c) == 4);
static_assert(offsetof(b2Transform, q) == offsetof(bmr_transform32, s));
static_assert(sizeof(b2Manifold) == sizeof(bmr_manifold32) &&
              sizeof(b2ManifoldPoint) == sizeof(bmr_manifold_point32));
static_assert(offsetof(b2ManifoldPoint, id) == offsetof(bmr_manifold_point32, feature));
static_assert(offsetof(b2ContactFeature, typeA) == offsetof(bmr_feature32, type_a));
static_assert(offsetof(b2Manifold, localNormal) == offsetof(bmr_manifold32, normal));
static_assert(offsetof(b2Manifold, localPoint) == offsetof(bmr_manifold32, plane_point));
static_assert(offsetof(b2Manifold, type) == offsetof(bmr_manifold32, type));
static_assert(offsetof(b2Manifold, pointCount) == offsetof(bmr_manifold32, count));
static_assert(int{b2Manifold::e_faceA} == BMR_MANIFOLD_FACE_A &&
              int{b2Manifold::e_faceB} == BMR_MANIFOLD_FACE_B);
static_assert(int{b2ContactFeature::e_vertex} == BMR_FEATURE_VERTEX);
static_assert(int{b2ContactFeature::e_face} == BMR_FEATURE_FACE);
static_assert(b2_maxPolygonVertices <= 8, "for polygons of more vertices there is bmr::ConvexShape");

inline const bmr_vec32 *Vectors32(const b2Vec2 *vectors) {
    return reinterpret_cast<const bmr_vec32 *>(vectors);
}

inline const b2Vec2 *Vectors(const bmr_vec32 *vectors) {
    return reinterpret_cast<const b2Vec2 *>(vectors);
}

/// nullptr of a fixture of another shape.
inline const b2PolygonShape *PolygonOf(const b2Fixture &fixture) {
    return fixture.GetType() == b2Shape::e_polygon ? static_cast<const b2PolygonShape *>(fixture.GetShape())
                                                   : nullptr;
}

// In double, as core's structures have it.
inline bmr_vec2 Double(const b2Vec2 &v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}
inline bmr_vec2 Double(const bmr_vec32 &v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}
inline bmr_pose PoseOf(const b2Transform &xf) {
    return {Double(xf.p), static_cast<double>(xf.q.c), static_cast<double>(xf.q.s)};
}

inline bmr_polygon32 Polygon32(const b2PolygonShape &shape) {
    return {Vectors32(shape.m_vertices), Vectors32(shape.m_normals), shape.m_count};
}

inline const bmr_transform32 *Transform32(const b2Transform &xf) {
    return reinterpret_cast<const bmr_transform32 *>(&xf);
}

inline bmr_manifold32 *Manifold32(b2Manifold *manifold) {
    return reinterpret_cast<bmr_manifold32 *>(manifold);
}

inline const bmr_manifold32 *Manifold32(const b2Manifold *manifold) {
    return reinterpret_cast<const bmr_manifold32 *>(manifold);
}

inline bmr_edge32 Edge32(const b2EdgeShape &edge) {
    return {*Vectors32(&edge.m_vertex0), *Vectors32(&edge.m_vertex1), *Vectors32(&edge.m_vertex2),
            *Vectors32(&edge.m_vertex3), edge.m_oneSided};
}

} // namespace bmr

#endif
