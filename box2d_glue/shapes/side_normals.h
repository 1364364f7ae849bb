// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SIDE_NORMALS_H
#define BOOMERANG_GLUE_SIDE_NORMALS_H

class b2PolygonShape;

namespace bmr {

/// @file
/// Can a polygon of Box2D's own size be believed? A game may write to its vertices and normals.

/// Does b2CollidePolygons see nothing of this small polygon but its vertices' hull? Ask each time before the
/// vertices are relied on: when a hull is built of them, and when an existing hull is checked against them.
bool VerticesTellAll(const b2PolygonShape &polygon);

/// Do its normals turn to the left, once around? If they do not, Box2D may report contacts with shapes that
/// are far away. Ask only where VerticesTellAll is true.
bool TurnsOnce(const b2PolygonShape &polygon);

} // namespace bmr

#endif
