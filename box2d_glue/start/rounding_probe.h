// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_ROUNDING_PROBE_H
#define BOOMERANG_GLUE_ROUNDING_PROBE_H

#include <box2d/b2_api.h>
#include <box2d/b2_types.h>

class b2PolygonShape;
struct b2Manifold;
struct b2Transform;

namespace bmr {

/// Does the b2CollidePolygons of this process compute separations with the same bits as core/exact32? It does
/// in builds for plain x86-64; a Box2D compiled with fused multiply-add (ARM, -march=native) rounds
/// otherwise, and remembered edges need a margin. Found out by asking it: pairs of boxes whose radii are set
/// to exactly the separation that exact32 computes, and to one float less.
bool Box2DRoundsAsExact32();

/// Does its b2CollideEdgeAndPolygon give the bits of bmr_exact32_collide_edge? Found out on links and
/// polygons of all kinds: a game may compile a Box2D whose rules for edges it has changed.
bool Box2DCollidesEdgesAsExact32();

/// b2CollidePolygons where the reference face is known: an edge of A, or BMR_EDGES_OF_B32 plus one of B. The
/// same manifold, without the search for the face.
using CollideByFace = void (*)(b2Manifold *manifold, const b2PolygonShape *a, const b2Transform &xfA,
                               const b2PolygonShape *b, const b2Transform &xfB, int32 face);

/// Who compiles Box2D's source has such a function, with its rounding. Ahead of Install; nullptr until then.
void SetCollideByFace(CollideByFace function);
/// That function, if it gives the bits of b2CollidePolygons: a compiler that fuses products may do it
/// otherwise in a function that is a little different. Found out on pairs of polygons with points of all
/// kinds, where any other choice shows in half of them. nullptr if it does not, or where there is none.
CollideByFace FindCollideByFace();

} // namespace bmr

#endif
