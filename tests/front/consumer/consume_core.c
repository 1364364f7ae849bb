// SPDX-License-Identifier: MIT
#include <stdio.h>

#include <boomerang/boomerang.h>

int main(void) {
    const bmr_vec2 points[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
    bmr_polygon *polygon = NULL;
    const bmr_error error = bmr_polygon_create(points, 5, NULL, &polygon);
    printf("%s\n", bmr_error_describe(error));
    bmr_closest_points closest = {0};
    const bmr_pose beside = bmr_pose_from_angle(bmr_vec2_make(5, 0), 0.0);
    const bmr_error asked = bmr_distance(polygon, NULL, polygon, &beside, &closest);
    printf("%s\n", bmr_error_describe(asked));
    const int good = error == BMR_OK && polygon->count == 4 && asked == BMR_OK && closest.distance == 3.0;
    bmr_polygon_destroy(polygon, NULL);
    return good ? 0 : 1;
}
