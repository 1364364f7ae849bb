// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_OUTLINE_RAY_H
#define BOOMERANG_GLUE_OUTLINE_RAY_H

#include "convex32/convex32.h"
#include "shapes/convex_registry.h"

namespace bmr {

/// A ray from p1 towards p2, in the shape's frame, hits a piece of an outline by an edge, at a fraction of
/// the way (bmr_convex32_ray) and with that edge's normal. Does it come into the outline there?
///
/// True also where a corner of the outline let it through by rounding, and it hits the piece behind the
/// corner by an inner edge. Then `*normal` becomes that of the outline's edge at the corner, and `*fraction`
/// may become less.
///
/// O(1), but for the parts of that edge; of a ray that passes an end of an inner edge by no more than
/// rounding, O(all the outline's vertices). Reads what never changes: on any thread.
bool EntersOutline(registry::Handle piece, bmr_vec32 p1, bmr_vec32 p2, uint32_t edge, float *fraction,
                   bmr_vec32 *normal);

} // namespace bmr

#endif
