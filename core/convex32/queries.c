// SPDX-License-Identifier: MIT
#include "convex32/convex32.h"
#include "convex32/near_edges.h"

/// A size that leaves room for every product.
#define LARGE 1e15f

static bool contains_by_all(const bmr_convex32 *p, bmr_vec32 point) {
    for (uint32_t i = 0; i < p->count; ++i)
        if (edge_separation(p, i, point) > 0.0f)
            return false;
    return true;
}

bool bmr_convex32_contains(const bmr_convex32 *polygon, bmr_vec32 point) {
    if (!polygon->buckets || !(convex32_size(point) < LARGE))
        return contains_by_all(polygon, point);
    const float margin = CONVEX32_SEPARATION_NOISE * separation_size(polygon, point);
    edge_range edges[CONVEX32_SECTORS];
    uint32_t hits[CONVEX32_SECTORS];
    bool unsure[CONVEX32_SECTORS];
    for (uint32_t k = 0; k < CONVEX32_SECTORS; ++k) {
        unsure[k] = false;
        edges[k] = sector_edges(polygon, k);
        if (edges[k].count == 0)
            continue;
        hits[k] = sector_hit(polygon, edges[k], k, point);
        const float separation =
            edge_separation(polygon, convex32_wrap(polygon, edges[k].first + hits[k]), point);
        if (separation > 0.0f)
            return false;
        unsure[k] = separation > -1.5f * margin;
    }
    for (uint32_t k = 0; k < CONVEX32_SECTORS; ++k) {
        if (!unsure[k])
            continue;
        const edge_range near = around(polygon, edges[k], hits[k], point, margin);
        for (uint32_t i = 0; i < near.count; ++i)
            if (edge_separation(polygon, convex32_wrap(polygon, near.first + i), point) > 0.0f)
                return false;
    }
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
