// SPDX-License-Identifier: MIT
#include "boomerang/minkowski.h"

#include <math.h>
#include <stdbool.h>

#include "geometry/hull.h"
#include "geometry/memory.h"

/// One of the two bodies turned into A's frame: A itself, or -R B. Edges are turned as vectors: a difference
/// of turned points would be noise where an edge is short.
typedef struct chain {
    const bmr_polygon *polygon;
    bmr_pose turn;
    uint32_t first;         ///< its lowest vertex
    uint32_t passed, count; ///< edges passed, of how many
} chain;

static bmr_vec2 point_of(const chain *c) {
    return bmr_rotate(&c->turn, c->polygon->vertices[(c->first + c->passed) % c->polygon->count]);
}

static bmr_vec2 edge_of(const chain *c) {
    const uint32_t n = c->polygon->count, i = (c->first + c->passed) % n;
    return bmr_rotate(&c->turn, bmr_sub(c->polygon->vertices[(i + 1) % n], c->polygon->vertices[i]));
}

static chain chain_make(const bmr_polygon *polygon, bmr_vec2 rotation) {
    chain c = {polygon, {{0.0, 0.0}, rotation.x, rotation.y}, 0, 0, 0};
    c.count = polygon->count > 1 ? polygon->count : 0;
    // Of two lowest vertices the clockwise one, whose edge goes to the right, is the start.
    c.first = bmr_polygon_support(polygon, bmr_unrotate(&c.turn, bmr_vec2_make(0.0, -1.0)));
    return c;
}

/// Edges in the order of their angles in [0, 360): upwards (or level to the right) before downwards.
static bool upwards(bmr_vec2 e) {
    return e.y > 0.0 || (e.y == 0.0 && e.x > 0.0);
}

/// -1: e comes first; 1: f does; 0: they are parallel.
static int order(bmr_vec2 e, bmr_vec2 f) {
    if (upwards(e) != upwards(f))
        return upwards(e) ? -1 : 1;
    const double turn = bmr_cross(e, f);
    return turn > 0.0 ? -1 : turn < 0.0;
}

/// The vertices in counter-clockwise order, up to rounding. Returns how many.
static size_t merge(const bmr_polygon *a, const bmr_polygon *b, bmr_vec2 rotation, bmr_vec2 *points) {
    chain c = chain_make(a, bmr_vec2_make(1.0, 0.0)), d = chain_make(b, bmr_neg(rotation));
    size_t count = 0;
    do {
        const bmr_vec2 sum = bmr_add(point_of(&c), point_of(&d));
        points[count++] = bmr_vec2_make(sum.x + 0.0, sum.y + 0.0); // no negative zeros
        const bool more_c = c.passed < c.count, more_d = d.passed < d.count;
        const int first = more_c && more_d ? order(edge_of(&c), edge_of(&d)) : more_c ? -1 : 1;
        c.passed += more_c && first <= 0;
        d.passed += more_d && first >= 0;
    } while (c.passed < c.count || d.passed < d.count);
    return count;
}

/// The strictly convex hull of points that rise from the first to the highest and fall from there, in O(n).
/// 0: they do not.
static size_t clean(const bmr_vec2 *points, size_t count, bmr_vec2 *hull) {
    size_t size = 0, i = 0;
    for (; i < count && (i == 0 || bmr_hull_sweeps_before(points[i - 1], points[i])); ++i)
        size = bmr_hull_append(hull, size, 1, points[i]);
    const size_t top = size;
    for (; i < count; ++i) {
        if (!bmr_hull_sweeps_before(points[i], points[i - 1]) ||
            !bmr_hull_sweeps_before(points[0], points[i]))
            return 0;
        size = bmr_hull_append(hull, size, top, points[i]);
    }
    // And back to where it began.
    return count > 2 ? bmr_hull_append(hull, size, top, points[0]) - 1 : size;
}

bmr_error bmr_minkowski_difference(const bmr_polygon *a, const bmr_polygon *b, bmr_vec2 rotation,
                                   const bmr_allocator *allocator, bmr_polygon **difference) {
    if (!a || !b || !difference)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!isfinite(rotation.x) || !isfinite(rotation.y))
        return BMR_ERROR_NOT_FINITE;
    const size_t most = (size_t)a->count + b->count;
    if (most > BMR_MAX_VERTICES)
        return BMR_ERROR_TOO_MANY_POINTS;
    const size_t scratch_size = (2 * most + 1) * sizeof(bmr_vec2);
    bmr_vec2 *points = bmr_allocate(allocator, scratch_size);
    if (!points)
        return BMR_ERROR_NO_MEMORY;
    bmr_vec2 *hull = points + most;
    const size_t count = merge(a, b, rotation, points);
    const size_t kept = clean(points, count, hull);
    const bmr_error error = kept > 0 ? bmr_polygon_create_raw(hull, kept, allocator, difference)
                                     : bmr_polygon_create(points, count, allocator, difference);
    bmr_release(allocator, points, scratch_size);
    return error;
}
