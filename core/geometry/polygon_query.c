// SPDX-License-Identifier: MIT
#include "geometry/polygon_query.h"

#include <math.h>

#include "geometry/length.h"
#include "geometry/predicates.h"

/// What rounding can do to a support value, as a multiple of extent * |direction|: a difference, two
/// products, a sum.
#define SUPPORT_ROUNDING 1e-15

/// Does edge i lead farther in the direction?
static inline bool ascends(const bmr_polygon *p, uint32_t i, bmr_vec2 direction) {
    return bmr_ascends(bmr_edge_vector(p, i), direction);
}

bmr_vec2 bmr_polygon_normal(const bmr_polygon *polygon, uint32_t edge) {
    if (polygon->count == 1)
        return bmr_vec2_make(1.0, 0.0);
    const bmr_vec2 e = bmr_scale_up_if_tiny(bmr_edge_vector(polygon, edge));
    const double length = sqrt(e.x * e.x + e.y * e.y);
    return bmr_vec2_make(e.y / length, -e.x / length);
}

uint32_t bmr_support_counted(const bmr_polygon *polygon, bmr_vec2 direction, unsigned *steps) {
    const bmr_vec2 d = bmr_scale_up_if_tiny(direction);
    // Along the right chain, lowest to highest, the angles of the edges rise through [0, 180) degrees; along
    // the left one through [180, 360). The chain that holds the angle of `direction` + 90 degrees holds the
    // answer, and there "edge i ascends" is true up to the answer and false from it on: no wrap-around, and
    // no second change of sign at the bottom.
    const bool right = d.x > 0.0 || (d.x == 0.0 && d.y < 0.0);
    const uint32_t n = polygon->count;
    const uint32_t first = right ? polygon->lowest : polygon->highest;
    const uint32_t last = right ? polygon->highest : polygon->lowest;
    uint32_t low = 0, high = last >= first ? last - first : last + n - first;
    while (low < high) {
        ++*steps;
        const uint32_t middle = low + (high - low) / 2;
        const uint32_t i = first + middle;
        if (ascends(polygon, i < n ? i : i - n, d))
            low = middle + 1;
        else
            high = middle;
    }
    const uint32_t answer = first + low;
    return answer < n ? answer : answer - n;
}

uint32_t bmr_polygon_support(const bmr_polygon *polygon, bmr_vec2 direction) {
    unsigned unused = 0;
    return bmr_support_counted(polygon, direction, &unused);
}

/// Does the vertex lie farther in the direction than the centre of the bounding disk, by more than rounding?
/// A climb that ended at a vertex that does not is not believed: it may have stopped at the lowest vertex,
/// where both edges were level up to rounding.
static inline bool surely_upper(const bmr_polygon *p, uint32_t i, bmr_vec2 d) {
    const double rise = bmr_dot(d, bmr_sub(p->vertices[i], p->center));
    return rise > SUPPORT_ROUNDING * p->extent * (fabs(d.x) + fabs(d.y));
}

uint32_t bmr_support_from_counted(const bmr_polygon *polygon, bmr_vec2 direction, uint32_t hint,
                                  unsigned *steps) {
    const uint32_t n = polygon->count;
    uint32_t i = hint < n ? hint : hint % n;
    const bmr_vec2 d = bmr_scale_up_if_tiny(direction);
    if (!(d.x != 0.0 || d.y != 0.0) || d.x != d.x || d.y != d.y)
        return i;
    if (n <= 2) // both edges of a segment may be level: nothing to climb
        return bmr_support_counted(polygon, d, steps);
    ++*steps;
    if (ascends(polygon, i, d)) {
        for (uint32_t step = 0; step < n && ascends(polygon, i, d); ++step, ++*steps)
            i = i + 1 < n ? i + 1 : 0;
    } else {
        for (uint32_t step = 0; step < n; ++step, ++*steps) {
            const uint32_t before = i > 0 ? i - 1 : n - 1;
            if (ascends(polygon, before, d))
                break;
            i = before;
        }
    }
    return surely_upper(polygon, i, d) ? i : bmr_support_counted(polygon, d, steps);
}

uint32_t bmr_polygon_support_from(const bmr_polygon *polygon, bmr_vec2 direction, uint32_t hint) {
    unsigned unused = 0;
    return bmr_support_from_counted(polygon, direction, hint, &unused);
}

/// At most `tolerance` beyond every edge's line; of a segment also beyond its ends.
static bool contains_with_tolerance(const bmr_polygon *p, bmr_vec2 point, double tolerance) {
    if (p->count <= 2) {
        const bmr_vec2 a = p->vertices[0], e = bmr_sub(p->vertices[p->count - 1], a), r = bmr_sub(point, a);
        const double square = bmr_dot(e, e);
        const double t = square > 0.0 ? fmin(fmax(bmr_dot(r, e) / square, 0.0), 1.0) : 0.0;
        return hypot(r.x - t * e.x, r.y - t * e.y) <= tolerance;
    }
    for (uint32_t i = 0; i < p->count; ++i)
        if (!(bmr_dot(bmr_polygon_normal(p, i), bmr_sub(point, p->vertices[i])) <= tolerance))
            return false;
    return true;
}

static bool between(double a, double x, double b) {
    return (a <= x && x <= b) || (b <= x && x <= a);
}

bool bmr_polygon_contains(const bmr_polygon *polygon, bmr_vec2 point, double tolerance) {
    if (!isfinite(point.x) || !isfinite(point.y) || !(tolerance >= 0.0))
        return false;
    if (tolerance > 0.0)
        return contains_with_tolerance(polygon, point, tolerance);
    const bmr_vec2 *v = polygon->vertices;
    const uint32_t n = polygon->count;
    if (n == 1)
        return point.x == v[0].x && point.y == v[0].y;
    if (n == 2)
        return bmr_orientation(v[0], v[1], point) == 0 && between(v[0].x, point.x, v[1].x) &&
               between(v[0].y, point.y, v[1].y);
    if (bmr_orientation(v[0], v[1], point) < 0 || bmr_orientation(v[0], v[n - 1], point) > 0)
        return false;
    uint32_t low = 1, high = n - 1; // point is left of (0, low), not left of (0, high)
    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        if (bmr_orientation(v[0], v[middle], point) >= 0)
            low = middle;
        else
            high = middle;
    }
    return bmr_orientation(v[low], v[low + 1], point) >= 0;
}
