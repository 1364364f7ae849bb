// SPDX-License-Identifier: MIT
#include "kds/cone.h"

#include <math.h>

#include "geometry/distance.h"

/// The most steps of Newton's method. The function is concave and of few pieces; with 4096 vertices it never
/// took more. The answer is checked, so that any bound will do.
#define CONE_STEPS 24

/// A leaning line may turn towards the end of the cone until it separates by only this part of the distance.
#define LEAN_LEAST_PART 0.25

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

void bmr_lean_note(bmr_lean *lean, bmr_vec2 line, bmr_vec2 closest) {
    const double turned = bmr_cross(line, closest);
    const int side = (turned > 0.0) - (turned < 0.0);
    lean->row =
        side != lean->side ? 1 : (uint8_t)(lean->row < BMR_LEAN_AFTER ? lean->row + 1 : BMR_LEAN_AFTER);
    lean->side = (int8_t)side;
}

bmr_vec2 bmr_lean_direction(const bmr_lean *lean, const bmr_kds *kds, const bmr_pose *b_in_a, double part,
                            bmr_vec2 closest, double distance, const uint32_t support[2]) {
    const double margin = kds->def.margin;
    const double least = margin + LEAN_LEAST_PART * (distance - margin);
    const bmr_vec2 end = bmr_cone_end(kds, b_in_a, closest, least, lean->side, support);
    const double angle = part * atan2(bmr_cross(closest, end), bmr_dot(closest, end));
    const bmr_pose turn = {{0.0, 0.0}, cos(angle), sin(angle)};
    return bmr_rotate(&turn, closest);
}
