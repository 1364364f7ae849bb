// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_WINDOW_H
#define BMR_KDS_WINDOW_H

#include "boomerang/polygon.h"

/// What stands for a whole polygon while the direction one looks at it from stays in a bracket: one or two
/// points whose support is never below the polygon's there, and never far above it.
typedef struct bmr_window {
    bmr_vec2 corner[2];
    bmr_vec2 low, high; ///< unit; both zero: every direction
    /// Cosine of the angle by which the direction may turn before it leaves the bracket; less is better, -2
    /// if it never does.
    double life;
} bmr_window;

/// A window of `polygon` around `direction` (unit length), whose support vertex is `support`: the two points
/// where three consecutive tangents meet, as far apart as keeps each point within `limit` (> 0, length units)
/// of the polygon. `lean` 0: the middle tangent is the one at `direction`, so that the window is exact there.
/// 1 (-1): the bracket lies mostly counter-clockwise (clockwise) of `direction`, for a body that is known to
/// turn that way. O(1) plus the logarithm of the number of vertices in the bracket.
void bmr_window_make(const bmr_polygon *polygon, bmr_vec2 direction, uint32_t support, double limit, int lean,
                     bmr_window *window);

#endif
