// SPDX-License-Identifier: MIT
#include "kds/coarse_line.h"

#include "certificate/coarse.h"

bool bmr_coarse_line(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_vec2 closest, const uint32_t support[2],
                     bmr_windowed_line *line) {
    const bmr_polygon *a = kds->shapes[0].polygon, *b = kds->shapes[1].polygon;
    const double least = bmr_windowed_least(kds);
    unsigned steps = 0;
    bmr_coarse coarse;
    const bool found = bmr_coarse_pick(a, b, b_in_a, closest, least, support, &coarse, &steps);
    bmr_kds_tally(kds, steps);
    if (!found)
        return false;
    const bmr_vec2 direction = coarse.owner == 0 ? coarse.normal : bmr_neg(bmr_rotate(b_in_a, coarse.normal));
    bmr_windowed_line_set(line, kds, b_in_a, coarse.owner, direction, support);
    // Where little more than `least` is left, rounding moves the ends of the fan.
    const bmr_vec2 p = a->vertices[line->support[0]], q = b->vertices[line->support[1]];
    if (!(bmr_dot(direction, bmr_sub(bmr_transform(b_in_a, q), p)) > least))
        return false;
    bmr_windowed_exact(line, kds, b_in_a, 0);
    return true;
}
