// SPDX-License-Identifier: MIT
#ifndef BMR_CERTIFICATE_WINDOW_H
#define BMR_CERTIFICATE_WINDOW_H

#include "boomerang/polygon.h"

/// What stands for a whole polygon while the direction one looks at it from stays in a bracket: two
/// points whose support is never below the polygon's there, and never far above it.
typedef struct bmr_window {
    bmr_vec2 corner[2];
    bmr_vec2 low, high; ///< unit; both zero: every direction
    /// Cosine of the angle by which the direction may turn before it leaves the bracket; less is better, -2
    /// if it never does.
    double life;
    unsigned steps; ///< edges that were looked at for it
} bmr_window;

/// gamma of docs/open-question.md: how much of the gap (beyond what must be proved) a window's corners may
/// cost within its bracket. More gives wider brackets and fewer rolls, less gives fewer pushes: least events
/// on a tumbling orbit at 0.3, on a tumbling pass at 0.7, and within some third of the least from 0.2 on.
#define BMR_WINDOW_PART 0.3

/// The geometry of the free direction, which kds/free_direction.c takes at instants of a known motion and
/// pair/free_direction.c at sampled poses.
///
/// A window of `polygon` around `direction` (unit length), whose support vertex is `support`: the two points
/// where three consecutive tangents meet, as far apart as keeps each point within `limit` (> 0, length units)
/// of the polygon. `lean` 0: the middle tangent is the one at `direction`, so that the window is exact there.
/// 1 (-1): the bracket lies mostly counter-clockwise (clockwise) of `direction`, for a body that is known to
/// turn that way; up to the limit may be lost at `direction` then. An end is at least 2 atan(limit / (2 D))
/// away (D the polygon's diameter) or 75 degrees; on the short side of a leaning bracket the limit is a
/// sixteenth, and 15 degrees the most. O(1) where vertices are spread evenly, O(log n) anyway.
void bmr_window_make(const bmr_polygon *polygon, bmr_vec2 direction, uint32_t support, double limit, int lean,
                     bmr_window *window);

#endif
