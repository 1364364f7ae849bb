// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONVEX_DRAW_H
#define BOOMERANG_GLUE_CONVEX_DRAW_H

#include <box2d/b2_math.h>

#include "boomerang/convex32.h"

class b2Draw;
struct b2Color;

namespace bmr {

/// The outline at a pose, filled. Without memory for it nothing is drawn.
void DrawOutline(const bmr_convex32 &polygon, const b2Transform &xf, const b2Color &color, b2Draw &draw);

} // namespace bmr

#endif
