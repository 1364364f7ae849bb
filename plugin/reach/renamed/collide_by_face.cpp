// SPDX-License-Identifier: MIT
// See names.h. b2CollidePolygons is Box2D's, and nothing of its source is renamed where that is compiled.
// Here it is compiled once more as CollideByFace, in which the search for the reference face is left out; the
// points are computed by the same source with the same flags, so that they are rounded as Box2D's are.
// (Whether the bits are the same is tried out: start/rounding_probe.h. A file of its own, for compilers may
// compile a function otherwise that stands beside one like it.)
#include "box2d/b2_collision.h"
#include "box2d/b2_polygon_shape.h"

namespace {

// `face` is an edge of A, or 8 and an edge of B. Separations that b2CollidePolygons takes that face for: both
// are below the radii, and B's is larger than A's by more than its tolerance where the face is B's.

float BmrSeparationOfA(int32 face, int32 *edge, const b2Transform &, const b2PolygonShape *,
                       const b2Transform &) {
    *edge = face;
    return -b2_maxFloat;
}

float BmrSeparationOfB(int32 face, int32 *edge, const b2Transform &, const b2PolygonShape *,
                       const b2Transform &) {
    *edge = face - 8;
    return face < 8 ? -b2_maxFloat : -0.5f * b2_maxFloat;
}

} // namespace

// Told apart by the first word of the second argument: the definition, which is not called, and the two
// calls.
#define b2FindMaxSeparation(edge, polygon, ...) BMR_SEPARATION_##polygon, edge, __VA_ARGS__)
#define BMR_SEPARATION_const BmrFindMaxSeparation(const
#define BMR_SEPARATION_polyA BmrSeparationOfA(bmrFace
#define BMR_SEPARATION_polyB BmrSeparationOfB(bmrFace
#define b2CollidePolygons(...) BmrCollideByFace(__VA_ARGS__, int32 bmrFace)

void BmrCollideByFace(b2Manifold *manifold, const b2PolygonShape *polyA, const b2Transform &xfA,
                      const b2PolygonShape *polyB, const b2Transform &xfB, int32 face);

#include BMR_BOX2D_SOURCE
#undef b2FindMaxSeparation
#undef b2CollidePolygons

namespace bmr {
namespace stock {

void CollideByFace(b2Manifold *manifold, const b2PolygonShape *polyA, const b2Transform &xfA,
                   const b2PolygonShape *polyB, const b2Transform &xfB, int32 face);

void CollideByFace(b2Manifold *manifold, const b2PolygonShape *polyA, const b2Transform &xfA,
                   const b2PolygonShape *polyB, const b2Transform &xfB, int32 face) {
    (void)&BmrFindMaxSeparation;
    BmrCollideByFace(manifold, polyA, xfA, polyB, xfB, face);
}

} // namespace stock
} // namespace bmr
