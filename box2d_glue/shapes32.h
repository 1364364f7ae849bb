// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SHAPES32_H
#define BOOMERANG_GLUE_SHAPES32_H

#include <cstddef>

#include <box2d/b2_polygon_shape.h>

#include "boomerang/exact32.h"

namespace bmr {

// Box2D's own arrays are read in place: the layouts must agree.
static_assert(sizeof(b2Vec2) == sizeof(bmr_vec32) && offsetof(b2Vec2, y) == offsetof(bmr_vec32, y));
static_assert(sizeof(b2Transform) == sizeof(bmr_transform32));
static_assert(offsetof(b2Rot, s) == 0 && offsetof(b2Rot, c) == 4);
static_assert(offsetof(b2Transform, q) == offsetof(bmr_transform32, s));
static_assert(b2_maxPolygonVertices <= 8, "core/exact32 holds 8 vertices");

inline const bmr_vec32 *Vectors32(const b2Vec2 *vectors) {
    return reinterpret_cast<const bmr_vec32 *>(vectors);
}

inline bmr_polygon32 Polygon32(const b2PolygonShape &shape) {
    return {Vectors32(shape.m_vertices), Vectors32(shape.m_normals), shape.m_count};
}

inline const bmr_transform32 *Transform32(const b2Transform &xf) {
    return reinterpret_cast<const bmr_transform32 *>(&xf);
}

} // namespace bmr

#endif
