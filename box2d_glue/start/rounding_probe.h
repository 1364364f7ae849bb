// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_ROUNDING_PROBE_H
#define BOOMERANG_GLUE_ROUNDING_PROBE_H

namespace bmr {

/// Does the b2CollidePolygons of this process compute separations with the same bits as core/exact32? It does
/// in builds for plain x86-64; a Box2D compiled with fused multiply-add (ARM, -march=native) rounds
/// otherwise, and remembered edges need a margin. Found out by asking it: pairs of boxes whose radii are set
/// to exactly the separation that exact32 computes, and to one float less.
bool Box2DRoundsAsExact32();

} // namespace bmr

#endif
