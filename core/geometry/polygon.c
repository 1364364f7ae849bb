// SPDX-License-Identifier: MIT
#include "boomerang/polygon.h"

#include <math.h>
#include <string.h>

#include "geometry/bounding_disk.h"
#include "geometry/hull.h"
#include "geometry/memory.h"
#include "geometry/stamp.h"

/// The vertices begin at a multiple of their own size, so that none of them lies across two cache lines.
#define VERTICES_AT ((sizeof(bmr_polygon) + sizeof(bmr_vec2) - 1) / sizeof(bmr_vec2) * sizeof(bmr_vec2))

size_t bmr_polygon_bytes(size_t count) {
    return count <= BMR_MAX_VERTICES ? VERTICES_AT + count * sizeof(bmr_vec2) : SIZE_MAX;
}

static bmr_vec2 *vertices_of(bmr_polygon *block) {
    return (bmr_vec2 *)(void *)((char *)block + VERTICES_AT);
}

static bmr_error check_points(const bmr_vec2 *points, size_t count) {
    if (count == 0)
        return BMR_ERROR_NO_POINTS;
    if (count > BMR_MAX_VERTICES)
        return BMR_ERROR_TOO_MANY_POINTS;
    bmr_error error = BMR_OK;
    for (size_t i = 0; i < count; ++i) {
        if (!isfinite(points[i].x) || !isfinite(points[i].y))
            return BMR_ERROR_NOT_FINITE;
        if (fabs(points[i].x) > BMR_MAX_COORDINATE || fabs(points[i].y) > BMR_MAX_COORDINATE)
            error = BMR_ERROR_OUT_OF_RANGE;
    }
    return error;
}

/// The larger side of the bounding box.
static double box_side(const bmr_vec2 *vertices, size_t count) {
    bmr_vec2 low = vertices[0], high = vertices[0];
    for (size_t i = 1; i < count; ++i) {
        low = bmr_vec2_make(fmin(low.x, vertices[i].x), fmin(low.y, vertices[i].y));
        high = bmr_vec2_make(fmax(high.x, vertices[i].x), fmax(high.y, vertices[i].y));
    }
    return fmax(high.x - low.x, high.y - low.y);
}

/// Mixes 64 bits into a hash. The multiplication carries each bit into all those above it, and the shift
/// takes the upper half down again, so that every bit of the vertices can change every bit of the stamp. (The
/// multiplier is one of Steele and Vigna's.)
static uint64_t mix(uint64_t hash, uint64_t bits) {
    hash = (hash ^ bits) * UINT64_C(0xd1342543de82ef95);
    return hash ^ hash >> 32;
}

uint32_t bmr_polygon_stamp_of(const bmr_polygon *polygon) {
    uint64_t hash = mix(0, polygon->count);
    for (uint32_t i = 0; i < polygon->count; ++i) {
        uint64_t bits[2];
        memcpy(bits, &polygon->vertices[i], sizeof bits);
        hash = mix(mix(hash, bits[0]), bits[1]);
    }
    hash = mix(hash, 0);
    return (uint32_t)hash;
}

static void measure(bmr_polygon *polygon) {
    const bmr_vec2 *v = polygon->vertices;
    uint32_t lowest = 0, highest = 0;
    double extent = 0.0;
    for (uint32_t i = 0; i < polygon->count; ++i) {
        if (v[i].y < v[lowest].y || (v[i].y == v[lowest].y && v[i].x < v[lowest].x))
            lowest = i;
        if (v[i].y > v[highest].y || (v[i].y == v[highest].y && v[i].x > v[highest].x))
            highest = i;
        extent = fmax(extent, fmax(fabs(v[i].x), fabs(v[i].y)));
    }
    const bmr_disk disk = bmr_bounding_disk(v, polygon->count);
    polygon->lowest = (uint16_t)lowest;
    polygon->highest = (uint16_t)highest;
    polygon->center = disk.center;
    polygon->radius = disk.radius;
    polygon->extent = extent;
    polygon->stamp = bmr_polygon_stamp_of(polygon);
}

/// One block from vertices that have passed every check.
static bmr_error make(const bmr_vec2 *vertices, size_t count, const bmr_allocator *allocator,
                      bmr_polygon **polygon) {
    if (count > 1 && !(box_side(vertices, count) >= BMR_MIN_SIDE))
        return BMR_ERROR_OUT_OF_RANGE;
    bmr_polygon *made = bmr_allocate(allocator, bmr_polygon_bytes(count));
    if (!made)
        return BMR_ERROR_NO_MEMORY;
    bmr_vec2 *own = vertices_of(made);
    memcpy(own, vertices, count * sizeof *own);
    made->vertices = own;
    made->count = (uint32_t)count;
    measure(made);
    *polygon = made;
    return BMR_OK;
}

bmr_error bmr_polygon_create(const bmr_vec2 *points, size_t count, const bmr_allocator *allocator,
                             bmr_polygon **polygon) {
    if (!polygon || (!points && count > 0))
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_error error = check_points(points, count);
    if (error != BMR_OK)
        return error;
    const size_t scratch_size = (2 * count + 1) * sizeof(bmr_vec2);
    bmr_vec2 *scratch = bmr_allocate(allocator, scratch_size);
    if (!scratch)
        return BMR_ERROR_NO_MEMORY;
    for (size_t i = 0; i < count;
         ++i) // -0 becomes +0: equal points shall give equal bits, whichever survives
        scratch[i] = bmr_vec2_make(points[i].x + 0.0, points[i].y + 0.0);
    bmr_vec2 *hull = scratch + count;
    const size_t hull_count = bmr_convex_hull(scratch, count, hull);
    error = make(hull, hull_count, allocator, polygon);
    bmr_release(allocator, scratch, scratch_size);
    return error;
}

bmr_error bmr_polygon_create_raw(const bmr_vec2 *vertices, size_t count, const bmr_allocator *allocator,
                                 bmr_polygon **polygon) {
    if (!polygon || (!vertices && count > 0))
        return BMR_ERROR_NULL_ARGUMENT;
    const bmr_error error = check_points(vertices, count);
    return error == BMR_OK ? make(vertices, count, allocator, polygon) : error;
}

bmr_error bmr_polygon_copy(const bmr_polygon *polygon, const bmr_allocator *allocator, bmr_polygon **copy) {
    if (!polygon || !copy)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_polygon *made = bmr_allocate(allocator, bmr_polygon_bytes(polygon->count));
    if (!made)
        return BMR_ERROR_NO_MEMORY;
    bmr_vec2 *own = vertices_of(made);
    memcpy(own, polygon->vertices, polygon->count * sizeof *own);
    *made = *polygon;
    made->vertices = own;
    *copy = made;
    return BMR_OK;
}

void bmr_polygon_destroy(bmr_polygon *polygon, const bmr_allocator *allocator) {
    if (polygon)
        bmr_release(allocator, polygon, bmr_polygon_bytes(polygon->count));
}
