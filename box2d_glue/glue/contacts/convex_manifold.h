// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONVEX_MANIFOLD_H
#define BOOMERANG_GLUE_CONVEX_MANIFOLD_H

#include <box2d/b2_collision.h>

#include "convex32/convex32_collide.h"

class b2Contact;
class b2Fixture;

namespace bmr {

/// Two fixtures in the order of a contact's: `a` is the polygon against a circle, and the edge or the chain
/// against a polygon.
struct TwoFixtures {
    const b2Fixture *a, *b;
    int32 childA;

    float RadiusSum() const;
};

/// Of an edge, or of a link of a chain.
bmr_edge32 EdgeOf(const b2Fixture *fixture, int32 child);

enum class Seams { Known, Ignored };

/// The manifold of two fixtures at least one of which is a big polygon, by all vertices. Where seams are
/// ignored a piece of an outline is a polygon as any other.
void CollideConvex(const TwoFixtures &two, Seams seams, b2Manifold *manifold, const b2Transform &xfA,
                   const b2Transform &xfB, bmr_convex32_memory *memory);

/// Is the first fixture or the second a piece that has inner edges?
bool HasSeams(const TwoFixtures &two);

/// The answer of a contact of a piece if the rules of seams gave it no points (convex32_pieces.h). They leave
/// points to other pieces, of which they know nothing. Here these are asked. `manifold` gets points where the
/// plain polygons overlap at a point that no other piece touches, and at an impact. `memory`: as the search
/// by the rules of seams left it.
void AnswerForOthers(const b2Contact &contact, const TwoFixtures &two, bool isImpact, b2Manifold *manifold,
                     const b2Transform &xfA, const b2Transform &xfB, bmr_convex32_memory memory);

} // namespace bmr

#endif
