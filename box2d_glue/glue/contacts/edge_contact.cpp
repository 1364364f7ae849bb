// SPDX-License-Identifier: MIT
#include "glue/contacts/edge_contact.h"

#include <box2d/b2_chain_shape.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>

#include "base/rounding_mode.h"
#include "glue/contacts/convex_contact.h"
#include "glue/contacts/solid_contact.h"
#include "shapes/big_polygons.h"
#include "shapes/shapes32.h"
#include "start/settings.h"

namespace bmr {

namespace {

const b2PolygonShape &PolygonOf(const b2Fixture *fixture) {
    return *static_cast<const b2PolygonShape *>(fixture->GetShape());
}

} // namespace

bool EdgeContact::Serves(const b2Shape & /*a*/, const b2Shape &b) {
    return BigPolygonOf(b) == nullptr;
}

/// False where Box2D must do it.
inline bool EdgeContact::EvaluateHere(b2Manifold *manifold, const b2Transform &xfA,
                                      const b2Transform &xfB) const {
    const b2PolygonShape &polygon = PolygonOf(m_fixtureB);
    if (polygon.m_count < 3 || polygon.m_count > b2_maxPolygonVertices || !RoundsToNearest())
        return false;
    const bmr_edge32 edge = EdgeOf(m_fixtureA, m_indexA);
    const bmr_polygon32 other = Polygon32(polygon);
    return bmr_exact32_collide_edge(Manifold32(manifold), &edge, Transform32(xfA), &other,
                                    *Vectors32(&polygon.m_centroid), Transform32(xfB),
                                    polygon.m_radius + m_fixtureA->GetShape()->m_radius);
}

void EdgeContact::EvaluateByBox2D(b2Manifold *manifold, const b2Transform &xfA,
                                  const b2Transform &xfB) const {
    const b2Shape *const shape = m_fixtureA->GetShape();
    b2EdgeShape link;
    if (shape->m_type == b2Shape::e_chain)
        static_cast<const b2ChainShape *>(shape)->GetChildEdge(&link, m_indexA);
    b2CollideEdgeAndPolygon(
        manifold, shape->m_type == b2Shape::e_chain ? &link : static_cast<const b2EdgeShape *>(shape), xfA,
        &PolygonOf(m_fixtureB), xfB);
}

void EdgeContact::Evaluate(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) {
    if (!EvaluateHere(manifold, xfA, xfB))
        EvaluateByBox2D(manifold, xfA, xfB);
}

} // namespace bmr
