// SPDX-License-Identifier: MIT
#include "boomerang/mass.h"

#include <math.h>

bmr_error bmr_polygon_mass(const bmr_polygon *polygon, bmr_mass *mass) {
    if (!polygon || !mass)
        return BMR_ERROR_NULL_ARGUMENT;
    const bmr_vec2 first = polygon->vertices[0];
    double twice_area = 0.0, twelve_inertia = 0.0;
    bmr_vec2 six_moment = bmr_vec2_make(0.0, 0.0);
    for (uint32_t i = 1; i + 1 < polygon->count; i++) {
        const bmr_vec2 p = bmr_sub(polygon->vertices[i], first);
        const bmr_vec2 q = bmr_sub(polygon->vertices[i + 1], first);
        const double cross = bmr_cross(p, q);
        twice_area += cross;
        six_moment = bmr_add(six_moment, bmr_scale(cross, bmr_add(p, q)));
        twelve_inertia += cross * (bmr_dot(p, p) + bmr_dot(p, q) + bmr_dot(q, q));
    }
    const double area = 0.5 * twice_area;
    const bmr_vec2 way = bmr_scale(1.0 / (6.0 * area), six_moment); // from vertex 0 to the centroid
    const double inertia = twelve_inertia / 12.0 - area * bmr_dot(way, way);
    // Written so that a NaN is no mass.
    if (!(area > 0.0) || !(inertia > 0.0))
        return BMR_ERROR_OUT_OF_RANGE;
    mass->area = area;
    mass->centroid = bmr_add(first, way);
    mass->inertia = inertia;
    return BMR_OK;
}
