// SPDX-License-Identifier: MIT
#include "outline/rings.h"

/// Sums of a ring about a place, with the sign of its direction.
typedef struct moments {
    double twice_area, twelve_inertia;
    bmr_vec2 six_moment;
} moments;

static moments moments_of(const bmr_vec2 *ring, uint32_t count, bmr_vec2 about) {
    moments sum = {0.0, 0.0, {0.0, 0.0}};
    for (uint32_t i = 0; i < count; ++i) {
        const bmr_vec2 p = bmr_sub(ring[i], about), q = bmr_sub(ring[i + 1 < count ? i + 1 : 0], about);
        const double cross = bmr_cross(p, q);
        sum.twice_area += cross;
        sum.six_moment = bmr_add(sum.six_moment, bmr_scale(cross, bmr_add(p, q)));
        sum.twelve_inertia += cross * (bmr_dot(p, p) + bmr_dot(p, q) + bmr_dot(q, q));
    }
    return sum;
}

bmr_error bmr_outline_mass(const bmr_rings *rings, bmr_mass *mass) {
    if (!mass)
        return BMR_ERROR_NULL_ARGUMENT;
    uint32_t count;
    const bmr_error error = bmr_rings_check(rings, &count);
    if (error != BMR_OK)
        return error;
    if (rings->counts[0] == 0)
        return BMR_ERROR_OUT_OF_RANGE;
    const bmr_vec2 about = rings->points[0]; // an outline far from the origin is as exact as one at it
    moments sum = {0.0, 0.0, {0.0, 0.0}};
    const bmr_vec2 *ring = rings->points;
    for (uint32_t r = 0; r < rings->ring_count; ++r) {
        const moments own = moments_of(ring, rings->counts[r], about);
        // The outer ring counts, the others are taken off, whichever way they run.
        const double sign = (own.twice_area < 0.0) == (r == 0) ? -1.0 : 1.0;
        sum.twice_area += sign * own.twice_area;
        sum.six_moment = bmr_add(sum.six_moment, bmr_scale(sign, own.six_moment));
        sum.twelve_inertia += sign * own.twelve_inertia;
        ring += rings->counts[r];
    }
    const double area = 0.5 * sum.twice_area;
    const bmr_vec2 way = bmr_scale(1.0 / (6.0 * area), sum.six_moment); // to the centroid
    const double inertia = sum.twelve_inertia / 12.0 - area * bmr_dot(way, way);
    // Written so that a NaN is no mass.
    if (!(area > 0.0) || !(inertia > 0.0))
        return BMR_ERROR_OUT_OF_RANGE;
    *mass = (bmr_mass){area, bmr_add(about, way), inertia};
    return BMR_OK;
}
