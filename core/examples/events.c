// SPDX-License-Identifier: MIT
// Two polygons pass each other while one turns; a structure of the paper proves them apart all the time, and
// every event is printed. Links boomerang::kinetic, and so GSL.
#include <stdio.h>
#include <stdlib.h>

#include "boomerang/kinetic.h"

static void require(bmr_error error) {
    if (error == BMR_OK)
        return;
    fprintf(stderr, "%s\n", bmr_error_describe(error));
    exit(1);
}

static void print_event(void *context, const bmr_simulation_event *event) {
    (void)context;
    printf("%.4f %-5s level %d, %s\n", event->time, bmr_kds_event_name(event->report.kind),
           event->report.level_after, event->after.owner == 0 ? "an edge of A" : "an edge of B");
}

int main(void) {
    // The hull of any points, and a hierarchy: once for each polygon, shared by all pairs that it is in.
    const bmr_vec2 points[2][6] = {{{2, 0}, {1, 1}, {-1, 1}, {-2, 0}, {-1, -1}, {1, -1}},
                                   {{1.5, 0}, {0.5, 0.8}, {-0.5, 0.8}, {-1.5, 0}, {-0.5, -0.8}, {0.5, -0.8}}};
    bmr_polygon *polygons[2];
    bmr_hierarchy *hierarchies[2];
    bmr_shape shapes[2] = {{0}, {0}};
    for (int i = 0; i < 2; ++i) {
        require(bmr_polygon_create(points[i], 6, NULL, &polygons[i]));
        require(bmr_hierarchy_build_dudley(polygons[i], NULL, &hierarchies[i]));
        shapes[i].polygon = polygons[i];
        shapes[i].hierarchies[BMR_HIERARCHY_DUDLEY] = hierarchies[i];
    }
    // A rests. B comes from the left, passes above A and turns by 3 radians on the way.
    const bmr_pose home = bmr_pose_identity(), left = {{-6.0, 2.7}, 1.0, 0.0};
    bmr_motion_piece pieces[2] = {bmr_piece_rest(home),
                                  bmr_piece_screw(0.0, left, bmr_vec2_make(3.0, 0.0), 0.75)};
    bmr_motion *motions[2];
    for (int i = 0; i < 2; ++i)
        require(bmr_motion_create(&pieces[i], NULL, &motions[i]));

    bmr_simulation_def def = bmr_default_simulation_def();
    require(bmr_kds_find("lazy-dudley", &def.structure));
    bmr_simulation *simulation;
    require(bmr_simulation_create(&def, shapes, motions, 0.0, print_event, NULL, NULL, &simulation));
    require(bmr_simulation_run(simulation, 4.0));

    bmr_simulation_destroy(simulation);
    for (int i = 0; i < 2; ++i) {
        bmr_motion_destroy(motions[i]);
        bmr_hierarchy_destroy(hierarchies[i], NULL);
        bmr_polygon_destroy(polygons[i], NULL);
    }
    return 0;
}
