// SPDX-License-Identifier: MIT
#include <math.h>

#include "convex32/gjk.h"

// Grazing casts halve what is left at each step, all others square it: this is for grazing ones that cross
// 500 m at a slop.
enum { MOST_STEPS = 64 };

static double larger(double a, double b) {
    return a > b ? a : b;
}

bool bmr_convex32_cast(const bmr_proxy32 *a, const bmr_transform32 *pose_a, const bmr_proxy32 *b,
                       const bmr_transform32 *pose_b, bmr_vec32 translation, float linear_slop,
                       bmr_cast32 *cast) {
    const bmr_cast32 none = {{0.0f, 0.0f}, {0.0f, 0.0f}, 1.0f, 0};
    *cast = none;
    const bmr_posed32 at_a = bmr_posed32_at(a, pose_a), start = bmr_posed32_at(b, pose_b);
    bmr_posed32 at_b = start;
    const double slop = (double)linear_slop, skin = 2.0 * slop;
    const double radius_a = larger((double)a->radius, skin), radius_b = larger((double)b->radius, skin);
    const double wanted = larger(skin, radius_a + radius_b - skin), tolerance = 0.5 * slop;
    const bmr_vec2 way = bmr_widen(translation);

    // Box2D says no at once where the first two vertices that it looks at have met.
    bmr_closest32 closest = {bmr_posed32_support(&at_a, bmr_neg(way)), bmr_posed32_support(&at_b, way)};
    const bmr_vec2 first =
        bmr_sub(bmr_posed32_vertex(&at_b, closest.b), bmr_posed32_vertex(&at_a, closest.a));
    if (!(sqrt(bmr_dot(first, first)) - wanted > tolerance))
        return false;

    double lambda = 0.0;
    bmr_gjk32 search;
    for (int step = 0; step < MOST_STEPS; ++step) {
        bmr_gjk32_search(&search, &at_a, &at_b, &closest);
        cast->iterations += search.iterations;
        if (!(search.distance > 0.0))
            return false;
        if (search.distance - wanted <= tolerance)
            break;
        // The distance is a convex function of lambda, its slope the speed along the closest points.
        const double speed = -bmr_dot(way, search.closest) / search.distance;
        if (!(speed > 0.0))
            return false;
        lambda += (search.distance - wanted) / speed;
        if (!(lambda <= 1.0))
            return false;
        at_b.pose.position = bmr_add(start.pose.position, bmr_scale(lambda, way));
    }
    bmr_vec2 point_a, point_b;
    bmr_gjk32_points(&search, &at_a, &at_b, &point_a, &point_b);
    const bmr_vec2 normal = bmr_scale(1.0 / search.distance, search.closest);
    cast->point = bmr_narrow(bmr_add(point_a, bmr_scale(radius_a, normal)));
    cast->normal = bmr_narrow(normal);
    cast->lambda = (float)lambda;
    return true;
}
