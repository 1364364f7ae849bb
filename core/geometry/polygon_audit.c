// SPDX-License-Identifier: MIT
#include <math.h>

#include "boomerang/polygon.h"
#include "geometry/predicates.h"
#include "geometry/stamp.h"

static bmr_error audit_range(const bmr_polygon *p) {
    double extent = 0.0, right = p->vertices[0].x, left = right, top = p->vertices[0].y, bottom = top;
    for (uint32_t i = 0; i < p->count; ++i) {
        const bmr_vec2 v = p->vertices[i];
        if (!isfinite(v.x) || !isfinite(v.y))
            return BMR_ERROR_NOT_FINITE;
        extent = fmax(extent, fmax(fabs(v.x), fabs(v.y)));
        right = fmax(right, v.x);
        left = fmin(left, v.x);
        top = fmax(top, v.y);
        bottom = fmin(bottom, v.y);
    }
    if (extent > BMR_MAX_COORDINATE || (p->count > 1 && fmax(right - left, top - bottom) < BMR_MIN_SIDE))
        return BMR_ERROR_OUT_OF_RANGE;
    return extent == p->extent ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE;
}

static bool sweeps_before(bmr_vec2 a, bmr_vec2 b) {
    return a.y < b.y || (a.y == b.y && a.x < b.x);
}

/// Only left turns, and only one turn in all: exactly one vertex is lower than both its neighbours.
static bool is_strictly_convex(const bmr_polygon *p) {
    const bmr_vec2 *v = p->vertices;
    const uint32_t n = p->count;
    if (n == 1)
        return true;
    if (n == 2)
        return v[0].x != v[1].x || v[0].y != v[1].y;
    uint32_t bottoms = 0;
    for (uint32_t i = 0; i < n; ++i) {
        const bmr_vec2 a = v[i], b = v[(i + 1) % n], c = v[(i + 2) % n];
        if (bmr_orientation(a, b, c) <= 0)
            return false;
        bottoms += sweeps_before(b, a) && sweeps_before(b, c);
    }
    return bottoms == 1;
}

static bool is_measured(const bmr_polygon *p) {
    if (p->lowest >= p->count || p->highest >= p->count || !isfinite(p->center.x) || !isfinite(p->center.y))
        return false;
    const bmr_vec2 low = p->vertices[p->lowest], high = p->vertices[p->highest];
    for (uint32_t i = 0; i < p->count; ++i) {
        const bmr_vec2 v = p->vertices[i];
        if (sweeps_before(v, low) || sweeps_before(high, v))
            return false;
        if (!(hypot(v.x - p->center.x, v.y - p->center.y) <= p->radius))
            return false;
    }
    return true;
}

bmr_error bmr_polygon_audit(const bmr_polygon *polygon) {
    if (!polygon || !polygon->vertices)
        return BMR_ERROR_NULL_ARGUMENT;
    if (polygon->count == 0 || polygon->count > BMR_MAX_VERTICES)
        return BMR_ERROR_INVALID_STRUCTURE;
    const bmr_error error = audit_range(polygon);
    if (error == BMR_ERROR_NOT_FINITE || error == BMR_ERROR_OUT_OF_RANGE)
        return error;
    if (!is_strictly_convex(polygon))
        return BMR_ERROR_NOT_CONVEX;
    const bool stamped = polygon->stamp == bmr_polygon_stamp_of(polygon);
    return error == BMR_OK && stamped && is_measured(polygon) ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE;
}
