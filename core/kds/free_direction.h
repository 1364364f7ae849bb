// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_FREE_DIRECTION_H
#define BMR_KDS_FREE_DIRECTION_H

#include "kds/windowed_line.h"

/// FD2's line across a direction (unit, A's frame, from A to B), that of the closest points, `gap` beyond the
/// margin: of the body whose line lasts longer, and two corners for the other one. `spin`: the way B turns in
/// A's frame, as far as known. `support` are vertices near the support vertices. O(log n).
void bmr_free_direction_lay(const bmr_kds *kds, const bmr_instant *now, bmr_vec2 direction, double gap,
                            int spin, const uint32_t support[2], bmr_windowed_line *line);

#endif
