// SPDX-License-Identifier: MIT
#include "convex32/mass.h"

#include <float.h>
#include <math.h>

#include "convex32/triangle.h"

bmr_error convex32_measure(const bmr_convex32 *polygon, bmr_mass32 *mass, float *reach) {
    // A fan of triangles around vertex 0, so that a polygon far from the origin is as exact as one at it.
    const bmr_vec32 *v = polygon->vertices;
    const double x0 = (double)v[0].x, y0 = (double)v[0].y;
    double farthest = hypot(x0, y0), twice_area = 0.0, six_x = 0.0, six_y = 0.0, twelve_inertia = 0.0;
    for (uint32_t i = 1; i < polygon->count; ++i) {
        const double x = (double)v[i].x - x0, y = (double)v[i].y - y0;
        farthest = fmax(farthest, hypot((double)v[i].x, (double)v[i].y));
        if (i + 1 == polygon->count)
            break;
        const double next_x = (double)v[i + 1].x - x0, next_y = (double)v[i + 1].y - y0;
        const double cross = convex32_twice_area(v[0], v[i], v[i + 1]);
        twice_area += cross;
        six_x += cross * (x + next_x);
        six_y += cross * (y + next_y);
        twelve_inertia +=
            cross * (x * x + x * next_x + next_x * next_x + y * y + y * next_y + next_y * next_y);
    }
    const double area = 0.5 * twice_area;
    const double from_x = six_x / (6.0 * area), from_y = six_y / (6.0 * area);
    const double x = x0 + from_x, y = y0 + from_y;
    // From vertex 0 to the centroid, and from there to the origin.
    const double own = twelve_inertia / 12.0 - area * (from_x * from_x + from_y * from_y);
    const double inertia = own + area * (x * x + y * y);
    if (!(area >= (double)FLT_MIN) || !(inertia >= (double)FLT_MIN) || !(inertia <= (double)FLT_MAX))
        return BMR_ERROR_OUT_OF_RANGE;
    const bmr_mass32 made = {(float)area, {(float)x, (float)y}, (float)fmax(own, (double)FLT_MIN)};
    *mass = made;
    // No vertex may be farther: up, where rounding went down.
    *reach = (float)farthest;
    if ((double)*reach < farthest * (1.0 + DBL_EPSILON))
        *reach = nextafterf(*reach, INFINITY);
    return BMR_OK;
}
