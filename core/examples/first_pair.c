// SPDX-License-Identifier: MIT
// The first program of docs/first-steps.md: two polygons, a pair, its events. Links boomerang::core alone.
#include <stdio.h>

#include "boomerang/boomerang.h"

static void print_event(void *context, const bmr_event *event) {
    const int *const step = context;
    printf("step %3d: %s, at least %.2f apart\n", *step, bmr_event_name(event->kind), event->gap);
}

int main(void) {
    const bmr_vec2 corners_a[4] = {{2, 0}, {0, 1}, {-2, 0}, {0, -1}}; // a rhombus
    const bmr_vec2 corners_b[4] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    bmr_polygon *polygon_a, *polygon_b;
    if (bmr_polygon_create(corners_a, 4, NULL, &polygon_a) != BMR_OK ||
        bmr_polygon_create(corners_b, 4, NULL, &polygon_b) != BMR_OK)
        return 1;
    const bmr_shape a = {.polygon = polygon_a}, b = {.polygon = polygon_b};

    bmr_pair_def def = bmr_default_pair_def();
    def.structure = BMR_FREE_DIRECTION; // needs nothing but the two polygons
    def.margin = 0.01;                  // nearer than this counts as contact
    bmr_pair pair;
    bmr_pair_init(&pair);

    int step, checked = 0;
    const bmr_observer observer = {.on_event = print_event, .context = &step};
    for (step = 0; step <= 600; ++step) {
        // B flies past A from left to right: its place in A's frame, and its angle.
        const bmr_pose b_in_a = bmr_pose_from_angle(bmr_vec2_make(-6.0 + 0.02 * step, 2.2), 0.004 * step);
        double gap;
        if (bmr_pair_check(&pair, &b_in_a, def.margin, &gap)) {
            ++checked; // still apart: the proof holds, and only the pair's 64 bytes were read
            continue;
        }
        if (bmr_pair_advance(&pair, &def, &a, &b, &b_in_a, &observer, &gap) == BMR_STAB_POLYGON)
            continue; // BMR_STAB_POLYGON: not proved apart. A game calls its exact test here.
    }
    printf("%d of 601 steps were answered by the check alone\n", checked);
    bmr_polygon_destroy(polygon_a, NULL);
    bmr_polygon_destroy(polygon_b, NULL);
    return 0;
}
