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
/// otherwise. Found out by asking it: pairs of boxes whose radii are set
/// to exactly the separation that exact32 computes, and to one float less.
bool Box2DRoundsAsExact32();

/// Does its b2CollideEdgeAndPolygon give the bits of bmr_exact32_collide_edge? Found out on links and
/// polygons of all kinds: a game may compile a Box2D whose rules for edges it has changed.
bool Box2DCollidesEdgesAsExact32();

} // namespace bmr

#endif
