// SPDX-License-Identifier: MIT
#include "kds/cone.h"

#include <math.h>

#include "geometry/distance.h"

/// Newton's method on a concave function of few pieces: more steps than this were never needed for 4096
/// vertices, and any bound does, for the answer is checked.
#define CONE_STEPS 24

bmr_vec2 bmr_cone_end(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_vec2 inside, double least, int side,
                      const uint32_t support[2]) {
    // The separation along y is at most <y, w> for the vector w between any two vertices, and equal to it for
    // the support vertices. So the end lies before the direction where <y, w> = least: from there take the
    // new support vertices, and so on, always beyond the end or on it.
    const bmr_polygon *a = kds->shapes[0].polygon, *b = kds->shapes[1].polygon;
    unsigned steps = 0;
    bmr_vec2 answer = inside;
    uint32_t i = bmr_support_near(a, inside, support[0] % a->count, &steps);
    uint32_t j = bmr_support_near(b, bmr_unrotate(b_in_a, bmr_neg(inside)), support[1] % b->count, &steps);
    for (int step = 0; step < CONE_STEPS; ++step) {
        const bmr_vec2 w = bmr_sub(bmr_transform(b_in_a, b->vertices[j]), a->vertices[i]);
        const double square = bmr_dot(w, w), across = square - least * least;
        if (!(across > 0.0))
            break;
        const bmr_vec2 turned = bmr_scale(side * sqrt(across), bmr_left(w));
        const bmr_vec2 end = bmr_scale(1.0 / square, bmr_add(bmr_scale(least, w), turned));
        const uint32_t next_i = bmr_support_near(a, end, i, &steps);
        const uint32_t next_j = bmr_support_near(b, bmr_unrotate(b_in_a, bmr_neg(end)), j, &steps);
        if (next_i == i && next_j == j) {
            answer = end;
            break;
        }
        i = next_i;
        j = next_j;
    }
    bmr_kds_tally(kds, steps);
    return answer;
}
