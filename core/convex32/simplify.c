// SPDX-License-Identifier: MIT
#include <float.h>
#include <math.h>

#include "boomerang/outline.h"
#include "convex32/build.h"
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

bmr_error bmr_convex32_simplify(const bmr_convex32 *polygon, float tolerance, const bmr_allocator *allocator,
                                bmr_vec32 *points, size_t *count) {
    if (!polygon || !points || !count)
        return BMR_ERROR_NULL_ARGUMENT;
    const uint32_t n = polygon->count;
    const size_t size = n * (sizeof(bmr_vec2) + sizeof(uint32_t));
    bmr_vec2 *vertices = bmr_allocate(allocator, size);
    if (!vertices)
        return BMR_ERROR_NO_MEMORY;
    uint32_t *kept = (uint32_t *)(vertices + n), left;
    for (uint32_t i = 0; i < n; ++i)
        vertices[i] = convex32_wide(polygon->vertices[i]);
    const bmr_rings ring = {vertices, &n, 1};
    const double most = (double)(isinf(tolerance) ? copysignf(FLT_MAX, tolerance) : tolerance);
    const bmr_error error = bmr_outline_simplify(&ring, most, allocator, kept, &left, NULL);
    if (error == BMR_OK) {
        for (uint32_t i = 0; i < left; ++i)
            points[i] = polygon->vertices[kept[i]];
        *count = left;
    }
    bmr_release(allocator, vertices, size);
    return error;
}
