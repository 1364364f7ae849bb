// SPDX-License-Identifier: MIT
#include <stdio.h>

#include <boomerang/polygon.h>

int main(void) {
    const bmr_vec2 points[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
    bmr_polygon *polygon = NULL;
    const bmr_error error = bmr_polygon_create(points, 5, NULL, &polygon);
    printf("%s\n", bmr_error_describe(error));
    const int good = error == BMR_OK && polygon->count == 4;
    bmr_polygon_destroy(polygon, NULL);
    return good ? 0 : 1;
}
