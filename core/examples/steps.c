// SPDX-License-Identifier: MIT
// The same with poses that come step by step, without a known motion: a pair of 64 bytes is taken from pose
// to pose. Links boomerang::core alone.
#include <stdio.h>

#include "boomerang/boomerang.h"

int main(void) {
    const bmr_vec2 rhomb[4] = {{2, 0}, {0, 1}, {-2, 0}, {0, -1}},
                   box[4] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    bmr_polygon *polygons[2];
    if (bmr_polygon_create(rhomb, 4, NULL, &polygons[0]) != BMR_OK ||
        bmr_polygon_create(box, 4, NULL, &polygons[1]) != BMR_OK)
        return 1;
    const bmr_shape a = {.polygon = polygons[0]},
                    b = {.polygon = polygons[1]}; // free directions need no hierarchy
    bmr_pair_def def = bmr_default_pair_def();
    def.structure = BMR_FREE_DIRECTION;
    def.margin = 0.01;

    bmr_pair pair;
    bmr_pair_init(&pair);
    int repairs = 0;
    for (int step = 0; step <= 600; ++step) {
        const bmr_pose pose = {{-6.0 + 0.02 * step, 2.5}, 1.0, 0.0};
        double gap;
        if (bmr_pair_check(&pair, &pose, def.margin, &gap))
            continue; // the old certificate still holds: one cache line was looked at
        ++repairs;
        if (bmr_pair_advance(&pair, &def, &a, &b, &pose, NULL, &gap) == BMR_APART)
            printf("step %d: a new certificate, at least %.2f apart\n", step, gap);
        else
            printf("step %d: ask an exact test\n", step);
    }
    printf("601 checks, %d repairs\n", repairs);
    bmr_polygon_destroy(polygons[0], NULL);
    bmr_polygon_destroy(polygons[1], NULL);
    return 0;
}
