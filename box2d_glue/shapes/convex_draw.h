// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONVEX_DRAW_H
#define BOOMERANG_GLUE_CONVEX_DRAW_H

#include <box2d/b2_math.h>

#include "boomerang/box2d_glue.h"
#include "convex32/convex32.h"

class b2Draw;
class b2World;
struct b2Color;

namespace bmr {

/// Hands a polygon at a pose to a game's b2Draw::DrawSolidPolygon: in pieces of at most b2_maxPolygonVertices
/// vertices, which is all that a drawer of Box2D's polygons must have room for, or whole. Without memory for
/// the whole outline, in pieces. Of a piece of an outline with seams the edges that are the outline's follow
/// as segments; of an edge behind a part of which another piece goes on, the other parts.
void DrawOutline(const bmr_convex32_block &block, const b2Transform &xf, const b2Color &color,
                 Outlines outlines, b2Draw &draw);

/// b2World::DebugDraw calls this on its thread when it draws a big polygon of the world: the next
/// DrawConvexShapes of the same world and drawer then has nothing left to do, up to the next step of any
/// world on this thread (which calls it with nullptr).
void NoteDrawnByBox2D(const b2World *world, const b2Draw *draw);

} // namespace bmr

#endif
