// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_CONE_H
#define BMR_KDS_CONE_H

#include "kds/structure.h"

/// The end, counter-clockwise (`side` 1) or clockwise (-1), of the directions that separate the two polygons
/// by at least `least` (>= 0), starting from one that separates them by more. All are of unit length, in A's
/// frame, from A to B; the separation at the end is `least`, up to rounding. `support` are vertices near the
/// support vertices of `inside`. O(log n): a step halves what is left of either polygon.
bmr_vec2 bmr_cone_end(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_vec2 inside, double least, int side,
                      const uint32_t support[2]);

/// Leaning ahead: this many failures on the same side make a structure take a line that is turned to that
/// side.
#define BMR_LEAN_AFTER 2

/// On which side of their lines the last failures were.
typedef struct bmr_lean {
    int8_t side; ///< of the last one: the way the closest direction had turned from the line's
    uint8_t row; ///< failures on that side, one after the other
} bmr_lean;
/// One more failure: of a line across `line`, where the closest direction is `closest` now.
void bmr_lean_note(bmr_lean *lean, bmr_vec2 line, bmr_vec2 closest);
/// Has it failed on the same side often enough?
static inline bool bmr_lean_is_due(const bmr_lean *lean) {
    return lean->row >= BMR_LEAN_AFTER && lean->side != 0;
}
/// The direction that leans to that side: `part` of the way from the closest direction to the last one that
/// still separates by a quarter of the distance beyond the margin.
bmr_vec2 bmr_lean_direction(const bmr_lean *lean, const bmr_kds *kds, const bmr_pose *b_in_a, double part,
                            bmr_vec2 closest, double distance, const uint32_t support[2]);

#endif
