// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_COARSE_LINE_H
#define BMR_KDS_COARSE_LINE_H

#include <math.h>

#include "boomerang/inflated.h"
#include "kds/windowed_line.h"

/// The coarse line (certificate/coarse.h); the other body stands by its own vertices. `closest` is the
/// direction of the closest points; `support` are vertices near the support vertices in it. False: no edge
/// separates by more than bmr_windowed_least. O(log n).
bool bmr_coarse_line(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_vec2 closest, const uint32_t support[2],
                     bmr_windowed_line *line);

/// The slack below which an inflated structure takes the coarsest edge where no level keeps its promise: half
/// of what offsets that halve come to on the last of `depth` levels, alpha D / (2 n) or less. Where the
/// offsets shrink more slowly promises end farther out, and until here the edge of most slack is better.
static inline double bmr_coarse_below(const bmr_inflation *inflation, uint32_t depth) {
    return ldexp(inflation->first, -1 - (int)depth);
}

#endif
