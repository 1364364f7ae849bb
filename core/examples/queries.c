// SPDX-License-Identifier: MIT
// What is asked first: how far apart two polygons are, how deep in each other, and of many pairs which may
// have changed. Links boomerang::core alone.
#include <stdio.h>
#include <stdlib.h>

#include "boomerang/boomerang.h"

static void require(bmr_error error) {
    if (error == BMR_OK)
        return;
    fprintf(stderr, "%s\n", bmr_error_describe(error));
    exit(1);
}

int main(void) {
    const bmr_vec2 points[6] = {{2, 0}, {1, 1}, {-1, 1}, {-2, 0}, {-1, -1}, {1, -1}};
    bmr_polygon *polygon;
    require(bmr_polygon_create(points, 6, NULL, &polygon));

    // Two of them, one upright.
    const bmr_pose here = bmr_pose_identity(), there = bmr_pose_from_angle(bmr_vec2_make(5, 1), 1.5707963);
    bmr_closest_points closest;
    require(bmr_distance(polygon, &here, polygon, &there, &closest));
    printf("%.3f apart, from (%.2f, %.2f) to (%.2f, %.2f)\n", closest.distance, closest.point_a.x,
           closest.point_a.y, closest.point_b.x, closest.point_b.y);

    const bmr_pose near = bmr_pose_from_angle(bmr_vec2_make(2, 1), 1.5707963);
    bmr_overlap overlap;
    require(bmr_penetration(polygon, &here, polygon, &near, &overlap));
    printf("%.3f deep, out along (%.2f, %.2f)\n", overlap.depth, overlap.normal.x, overlap.normal.y);

    // Ten in a row, and a pair of every two neighbours. After its first advance a pair is checked, and
    // advanced again only where its proof no longer holds.
    bmr_pose poses[10];
    bmr_pair pairs[9];
    for (uint32_t i = 0; i < 10; ++i)
        poses[i] = bmr_pose_from_angle(bmr_vec2_make(5.0 * i, 0), 0.3 * i);
    for (uint32_t i = 0; i < 9; ++i)
        bmr_pair_init(&pairs[i]);
    const bmr_shape shape = {.polygon = polygon};
    bmr_pair_def def = bmr_default_pair_def();
    def.structure = BMR_FREE_DIRECTION;
    for (int step = 0; step < 4; ++step) {
        int count = 0;
        for (uint32_t i = 0; i < 9; ++i) {
            const bmr_pose b_in_a = bmr_pose_relative(&poses[i], &poses[i + 1]);
            double gap;
            if (bmr_pair_check(&pairs[i], &b_in_a, def.margin, &gap))
                continue;
            ++count;
            bmr_pair_advance(&pairs[i], &def, &shape, &shape, &b_in_a, NULL, NULL);
        }
        printf("step %d: %d of 9 pairs to be advanced\n", step, count);
        poses[4].position.x += 0.7; // one of them moves
    }
    bmr_polygon_destroy(polygon, NULL);
    return 0;
}
