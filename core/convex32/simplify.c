// SPDX-License-Identifier: MIT
#include <math.h>
#include <string.h>

#include "boomerang/hierarchy.h"
#include "convex32/build.h"
#include "geometry/distance.h"
#include "geometry/memory.h"

#define MOST_INNER 8u

/// Keeps the list ascending and free of repetitions; gives back its new length.
static uint32_t insert(uint32_t *list, uint32_t length, uint32_t vertex) {
    uint32_t place = length;
    while (place > 0 && list[place - 1] >= vertex) {
        if (list[place - 1] == vertex)
            return length;
        --place;
    }
    for (uint32_t i = length; i > place; --i)
        list[i] = list[i - 1];
    list[place] = vertex;
    return length + 1;
}

/// The vertex that is not in the list and spans the largest triangle with the two of the list that it lies
/// between.
static uint32_t most_missing(const bmr_convex32 *p, const uint32_t *list, uint32_t length) {
    uint32_t found = UINT32_MAX;
    double most = 0.0;
    for (uint32_t k = 0; k < length; ++k) {
        const uint32_t first = list[k], last = list[k + 1 < length ? k + 1 : 0];
        for (uint32_t i = convex32_next(p, first); i != last; i = convex32_next(p, i)) {
            const double area = convex32_twice_area(p->vertices[first], p->vertices[i], p->vertices[last]);
            // Any of them, where none is more than another.
            if (found == UINT32_MAX || area > most) {
                most = area;
                found = i;
            }
        }
    }
    return found;
}

void bmr_convex32_inner(const bmr_convex32 *polygon, uint32_t *vertices, uint32_t count) {
    if (count > MOST_INNER)
        count = MOST_INNER;
    if (count > polygon->count)
        count = polygon->count;
    uint32_t list[MOST_INNER], length = 0;
    for (uint32_t k = 0; k < count; ++k) {
        const double angle = 2.0 * 3.14159265358979323846 * (double)k / (double)count;
        const bmr_vec32 direction = {(float)cos(angle), (float)sin(angle)};
        length = insert(list, length, bmr_convex32_support(polygon, direction));
    }
    while (length < count) {
        // One vertex alone lies between itself and itself: any other will do.
        const uint32_t vertex =
            length > 1 ? most_missing(polygon, list, length) : convex32_next(polygon, list[0]);
        length = insert(list, length, vertex);
    }
    for (uint32_t k = 0; k < count; ++k)
        vertices[k] = list[k];
}

/// @file
/// The edges of a Dobkin-Kirkpatrick hierarchy by levels are ever better choices of the polygon's own edges;
/// each brings its first vertex. A boomerang whose chain is within the tolerance of the chord is not opened.

typedef struct choice {
    const bmr_polygon *polygon;
    const bmr_hierarchy *hierarchy;
    double tolerance;
    bool *kept;
} choice;

static double distance_to_segment(bmr_vec2 p, bmr_vec2 a, bmr_vec2 b) {
    const bmr_vec2 along = bmr_sub(b, a), to = bmr_sub(p, a);
    const double length = bmr_dot(along, along);
    const double t = length > 0.0 ? fmin(fmax(bmr_dot(to, along) / length, 0.0), 1.0) : 0.0;
    return hypot(to.x - t * along.x, to.y - t * along.y);
}

/// Are all vertices between two within the tolerance of the chord? Then so is the chain: distance is convex.
static bool chord_will_do(const choice *c, uint32_t from, uint32_t to) {
    const bmr_vec2 *v = c->polygon->vertices;
    for (uint32_t i = bmr_vertex_after(c->polygon, from); i != to; i = bmr_vertex_after(c->polygon, i))
        if (!(distance_to_segment(v[i], v[from], v[to]) <= c->tolerance))
            return false;
    return true;
}

/// The boomerang between two edges whose vertices are kept. As deep as the hierarchy: O(log n).
static void open_boomerang(const choice *c, bmr_edge before, bmr_edge after) {
    const uint32_t from = bmr_hierarchy_touch(c->hierarchy, before),
                   to = bmr_hierarchy_touch(c->hierarchy, after);
    if (from == to || chord_will_do(c, from, to))
        return;
    const bmr_edge cut = bmr_hierarchy_corner(c->hierarchy, before, after).cut;
    if (cut == BMR_NO_EDGE) { // no edge is left between the two, so next to no vertex
        for (uint32_t i = bmr_vertex_after(c->polygon, from); i != to; i = bmr_vertex_after(c->polygon, i))
            c->kept[i] = true;
        return;
    }
    c->kept[bmr_hierarchy_touch(c->hierarchy, cut)] = true;
    open_boomerang(c, before, cut);
    open_boomerang(c, cut, after);
}

/// The kept vertex behind `i`; itself where there is no other.
static uint32_t next_kept(const choice *c, uint32_t i) {
    do
        i = bmr_vertex_after(c->polygon, i);
    while (!c->kept[i]);
    return i;
}

static uint32_t count_kept(const choice *c) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < c->polygon->count; ++i)
        count += c->kept[i];
    return count;
}

/// A polygon has three: the farthest from those there are, one at a time.
static void keep_three(const choice *c) {
    const bmr_vec2 *v = c->polygon->vertices;
    for (uint32_t count = count_kept(c); count < 3; ++count) {
        uint32_t a = 0, farthest = 0;
        while (!c->kept[a])
            ++a;
        const uint32_t b = next_kept(c, a);
        double most = -1.0;
        for (uint32_t i = 0; i < c->polygon->count; ++i) {
            const double distance = c->kept[i] ? -1.0 : distance_to_segment(v[i], v[a], v[b]);
            if (distance > most) {
                most = distance;
                farthest = i;
            }
        }
        c->kept[farthest] = true;
    }
}

/// Once around: what the levels opened from two sides is not always needed.
static void drop_needless(const choice *c) {
    uint32_t left = count_kept(c), first = 0;
    while (!c->kept[first])
        ++first;
    uint32_t before = first;
    for (uint32_t i = next_kept(c, first); i != first && left > 3;) {
        const uint32_t after = next_kept(c, i);
        if (chord_will_do(c, before, after)) {
            c->kept[i] = false;
            --left;
        } else
            before = i;
        i = after;
    }
}

static void choose(const choice *c) {
    for (bmr_edge root = 0; root < 4; ++root)
        c->kept[bmr_hierarchy_touch(c->hierarchy, root)] = true;
    for (bmr_edge root = 0; root < 4; ++root)
        open_boomerang(c, root, (root + 1) % 4);
    keep_three(c);
    drop_needless(c);
}

bmr_error bmr_convex32_simplify(const bmr_convex32 *polygon, float tolerance, const bmr_allocator *allocator,
                                bmr_vec32 *points, size_t *count) {
    if (!polygon || !points || !count)
        return BMR_ERROR_NULL_ARGUMENT;
    if (isnan(tolerance))
        return BMR_ERROR_NOT_FINITE;
    if (tolerance < 0.0f)
        return BMR_ERROR_NEGATIVE;
    const uint32_t n = polygon->count;
    const size_t size = n * (sizeof(bmr_vec2) + sizeof(bool));
    bmr_vec2 *vertices = bmr_allocate(allocator, size);
    if (!vertices)
        return BMR_ERROR_NO_MEMORY;
    bool *kept = (bool *)(vertices + n);
    memset(kept, 0, n * sizeof *kept);
    for (uint32_t i = 0; i < n; ++i)
        vertices[i] = bmr_vec2_make((double)polygon->vertices[i].x, (double)polygon->vertices[i].y);
    bmr_polygon *wide = NULL;
    bmr_hierarchy *hierarchy = NULL;
    bmr_error error = bmr_polygon_create_raw(vertices, n, allocator, &wide);
    if (error == BMR_OK)
        error = bmr_hierarchy_build_dobkin_kirkpatrick(wide, allocator, &hierarchy);
    if (error == BMR_OK) {
        const choice c = {wide, hierarchy, (double)tolerance, kept};
        choose(&c);
        size_t length = 0;
        for (uint32_t i = 0; i < n; ++i)
            if (kept[i])
                points[length++] = polygon->vertices[i];
        *count = length;
        bmr_hierarchy_destroy(hierarchy, allocator);
    }
    bmr_polygon_destroy(wide, allocator);
    bmr_release(allocator, vertices, size);
    return error;
}
