// SPDX-License-Identifier: MIT
#ifndef BOX2D_BUILDS_EDIT_H
#define BOX2D_BUILDS_EDIT_H

#include <box2d/b2_polygon_shape.h>

namespace box2d_builds {

/// Moves all vertices away from the middle of the body, or toward it once one is farther than `reach`.
/// Normals stay right, and Box2D is not told.
inline void ScaleInPlace(b2PolygonShape *polygon, float reach) {
    float farthest = 0.0f;
    for (int32 i = 0; i < polygon->m_count; ++i)
        farthest = b2Max(farthest, polygon->m_vertices[i].Length());
    const float factor = farthest > reach ? 0.75f : 1.25f;
    for (int32 i = 0; i < polygon->m_count; ++i)
        polygon->m_vertices[i] *= factor;
    polygon->m_centroid *= factor;
}

} // namespace box2d_builds

#endif
