// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SIDE_NORMALS_H
#define BOOMERANG_GLUE_SIDE_NORMALS_H

class b2PolygonShape;

namespace bmr {

/// @file
/// What may be believed of a polygon of Box2D's own size, whose vertices and normals anybody may write to.

/// Is a hull of this small polygon's vertices all that b2CollidePolygons goes by? To be asked as often as
/// vertices are believed: when a hull is built of them, and when one that stands is to hold them.
bool VerticesTellAll(const b2PolygonShape &polygon);

/// Do its normals turn to the left, once around? Of a polygon that does not, Box2D may find that it touches
/// what is far from it. To be asked where VerticesTellAll says yes.
bool TurnsOnce(const b2PolygonShape &polygon);

} // namespace bmr

#endif
