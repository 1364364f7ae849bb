// SPDX-License-Identifier: MIT
// When two polygons that move first touch. Links boomerang::kinetic, and so GSL.
#include <stdio.h>

#include "boomerang/kinetic.h"

int main(void) {
    const bmr_vec2 points[4] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    bmr_shape box = {.polygon = NULL};
    bmr_polygon *polygon = NULL;
    bmr_motion *rests = NULL, *comes = NULL;
    const bmr_motion_piece rest = bmr_piece_rest(bmr_pose_identity());
    const bmr_pose start = bmr_pose_from_angle(bmr_vec2_make(10, 0.5), 0.0);
    const bmr_motion_piece fly = bmr_piece_screw(0.0, start, bmr_vec2_make(-4, 0), 3.0); // and it spins
    bmr_error error = bmr_polygon_create(points, 4, NULL, &polygon);
    if (error == BMR_OK)
        error = bmr_motion_create(&rest, NULL, &rests);
    if (error == BMR_OK)
        error = bmr_motion_create(&fly, NULL, &comes);
    box.polygon = polygon;
    double time = 0.0;
    if (error == BMR_OK)
        error = bmr_time_of_contact(&box, rests, &box, comes, 0.0, 10.0, 1e-6, NULL, &time);
    if (error == BMR_OK)
        printf("they touch at %.4f\n", time);
    else
        printf("%s\n", bmr_error_describe(error));
    bmr_motion_destroy(rests);
    bmr_motion_destroy(comes);
    bmr_polygon_destroy(polygon, NULL);
    return error != BMR_OK;
}
