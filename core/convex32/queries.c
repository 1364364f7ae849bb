// SPDX-License-Identifier: MIT
#include <stdint.h>

#include "convex32/convex32.h"

// Box2D's own loops over the edges, in its order of operations.

bool bmr_convex32_contains(const bmr_convex32 *polygon, bmr_vec32 point) {
    for (uint32_t i = 0; i < polygon->count; ++i) {
        const bmr_vec32 n = polygon->normals[i], v = polygon->vertices[i];
        if (n.x * (point.x - v.x) + n.y * (point.y - v.y) > 0.0f)
            return false;
    }
    return true;
}

bool bmr_convex32_ray(const bmr_convex32 *polygon, bmr_vec32 p1, bmr_vec32 p2, float max_fraction,
                      float *fraction, uint32_t *edge) {
    const bmr_vec32 d = {p2.x - p1.x, p2.y - p1.y};
    // The part of the segment that is inside of all edges so far, and the edge by which it comes in.
    float lower = 0.0f, upper = max_fraction;
    uint32_t entered = UINT32_MAX;
    for (uint32_t i = 0; i < polygon->count; ++i) {
        const bmr_vec32 n = polygon->normals[i], v = polygon->vertices[i];
        const float numerator = n.x * (v.x - p1.x) + n.y * (v.y - p1.y);
        const float denominator = n.x * d.x + n.y * d.y;
        if (denominator == 0.0f) {
            if (numerator < 0.0f)
                return false;
        } else if (denominator < 0.0f && numerator < lower * denominator) {
            lower = numerator / denominator;
            entered = i;
        } else if (denominator > 0.0f && numerator < upper * denominator)
            upper = numerator / denominator;
        if (upper < lower)
            return false;
    }
    if (entered == UINT32_MAX)
        return false;
    *fraction = lower;
    *edge = entered;
    return true;
}

void bmr_convex32_box(const bmr_convex32 *polygon, const bmr_transform32 *pose, bmr_vec32 *lower,
                      bmr_vec32 *upper) {
    // A coordinate is a dot product with a row of the pose, then a sum that keeps the order.
    const float s = pose->s, c = pose->c;
    const bmr_vec32 right = {c, -s}, up = {s, c}, left = {-c, s}, down = {-s, -c};
    const bmr_vec32 *v = polygon->vertices;
    const bmr_vec32 most_right = v[bmr_convex32_support(polygon, right)],
                    most_up = v[bmr_convex32_support(polygon, up)],
                    most_left = v[bmr_convex32_support(polygon, left)],
                    most_down = v[bmr_convex32_support(polygon, down)];
    upper->x = (c * most_right.x - s * most_right.y) + pose->p.x;
    upper->y = (s * most_up.x + c * most_up.y) + pose->p.y;
    lower->x = (c * most_left.x - s * most_left.y) + pose->p.x;
    lower->y = (s * most_down.x + c * most_down.y) + pose->p.y;
}
