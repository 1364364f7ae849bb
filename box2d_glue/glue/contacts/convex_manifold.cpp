// SPDX-License-Identifier: MIT
#include "glue/contacts/convex_manifold.h"

#include <box2d/b2_chain_shape.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>

#include "glue/proofs/polygon_view.h"

namespace bmr {

namespace {

/// Box2D's: the second polygon's face must be better by this to be the reference.
constexpr float kTolerance = 0.1f * b2_linearSlop;

/// The polygon of a fixture, with its seams or without.
bmr_convex32 PolygonWith(Seams seams, const b2Fixture &fixture) {
    bmr_convex32 polygon = RealPolygon(fixture);
    if (seams == Seams::Ignored)
        polygon.seams = nullptr;
    return polygon;
}

} // namespace

bmr_edge32 EdgeOf(const b2Fixture *fixture, int32 child) {
    if (fixture->GetType() == b2Shape::e_edge)
        return Edge32(*static_cast<const b2EdgeShape *>(fixture->GetShape()));
    b2EdgeShape link;
    static_cast<const b2ChainShape *>(fixture->GetShape())->GetChildEdge(&link, child);
    return Edge32(link);
}

float TwoFixtures::RadiusSum() const {
    return a->GetShape()->m_radius + b->GetShape()->m_radius;
}

/// Which it is is decided by what the fixtures are, and by no more: their shapes may be changed in place.
void CollideConvex(const TwoFixtures &two, Seams seams, b2Manifold *manifold, const b2Transform &xfA,
                   const b2Transform &xfB, bmr_convex32_memory *memory) {
    bmr_manifold32 *const made = Manifold32(manifold);
    const float radii = two.RadiusSum();
    if (two.b->GetType() == b2Shape::e_circle) {
        const bmr_convex32 polygon = PolygonWith(seams, *two.a);
        const auto *circle = static_cast<const b2CircleShape *>(two.b->GetShape());
        bmr_convex32_collide_circle(made, &polygon, Transform32(xfA), *Vectors32(&circle->m_p),
                                    Transform32(xfB), radii, memory);
        return;
    }
    const bmr_convex32 b = PolygonWith(seams, *two.b);
    if (two.a->GetType() != b2Shape::e_polygon) {
        const bmr_edge32 edge = EdgeOf(two.a, two.childA);
        const auto *polygon = static_cast<const b2PolygonShape *>(two.b->GetShape());
        bmr_convex32_collide_edge(made, &edge, Transform32(xfA), &b, *Vectors32(&polygon->m_centroid),
                                  Transform32(xfB), radii, memory);
        return;
    }
    const bmr_convex32 a = PolygonWith(seams, *two.a);
    bmr_convex32_collide(made, &a, Transform32(xfA), &b, Transform32(xfB), radii, kTolerance, memory);
}

} // namespace bmr
