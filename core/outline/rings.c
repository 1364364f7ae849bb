// SPDX-License-Identifier: MIT
#include "outline/rings.h"

#include <math.h>
#include <string.h>

#include "boomerang/polygon.h"
#include "geometry/memory.h"

bmr_error bmr_rings_check(const bmr_rings *rings, uint32_t *count) {
    if (!rings)
        return BMR_ERROR_NULL_ARGUMENT;
    if (rings->ring_count == 0)
        return BMR_ERROR_NO_POINTS;
    if (!rings->counts)
        return BMR_ERROR_NULL_ARGUMENT;
    // Every ring has a point at least, or is a fault: so there are not more of them than points.
    uint32_t sum = 0;
    for (uint32_t r = 0; r < rings->ring_count; ++r) {
        if (rings->counts[r] > BMR_MAX_VERTICES - sum || r >= BMR_MAX_VERTICES)
            return BMR_ERROR_TOO_MANY_POINTS;
        sum += rings->counts[r];
    }
    if (!rings->points && sum > 0)
        return BMR_ERROR_NULL_ARGUMENT;
    for (uint32_t i = 0; i < sum; ++i)
        if (!isfinite(rings->points[i].x) || !isfinite(rings->points[i].y))
            return BMR_ERROR_NOT_FINITE;
    *count = sum;
    return BMR_OK;
}

bmr_error bmr_distinct_rings_make(const bmr_rings *rings, uint32_t count, const bmr_allocator *allocator,
                                  bmr_distinct_rings *distinct) {
    const size_t bytes = bmr_rings_bytes(count, rings->ring_count);
    bmr_vec2 *points = bmr_allocate(allocator, bytes);
    if (!points)
        return BMR_ERROR_NO_MEMORY;
    uint32_t *kept = (uint32_t *)(void *)(points + count), *counts = kept + count;
    uint32_t left = 0, begin = 0;
    for (uint32_t r = 0; r < rings->ring_count; ++r) {
        const uint32_t first = left;
        for (uint32_t i = begin; i < begin + rings->counts[r]; ++i)
            if (left == first || bmr_sweep_compare(rings->points[i], points[left - 1]) != 0) {
                points[left] = rings->points[i];
                kept[left++] = i;
            }
        while (left > first + 1 && bmr_sweep_compare(points[left - 1], points[first]) == 0)
            --left;
        counts[r] = left - first;
        begin += rings->counts[r];
    }
    *distinct = (bmr_distinct_rings){{points, counts, rings->ring_count}, left, kept, points, bytes};
    return BMR_OK;
}

void bmr_distinct_rings_free(bmr_distinct_rings *distinct, const bmr_allocator *allocator) {
    bmr_release(allocator, distinct->block, distinct->bytes);
}

bmr_error bmr_rings_find_short(const bmr_rings *rings, bmr_outline_fault *fault) {
    uint32_t begin = 0;
    for (uint32_t r = 0; r < rings->ring_count; ++r) {
        const uint32_t count = rings->counts[r];
        if (count < 3) {
            const uint32_t edge = count > 0 ? begin : BMR_OUTLINE_NONE;
            const bmr_vec2 where = count > 0 ? rings->points[begin] : bmr_vec2_make(0.0, 0.0);
            *fault = (bmr_outline_fault){BMR_ERROR_TOO_FEW_POINTS, {edge, edge}, {r, r}, where};
            return fault->error;
        }
        begin += count;
    }
    return BMR_OK;
}

bmr_error bmr_ring_links_make(const bmr_rings *rings, uint32_t count, const bmr_allocator *allocator,
                              bmr_ring_links *links) {
    const size_t bytes = (size_t)count * 3 * sizeof(uint32_t);
    uint32_t *block = bmr_allocate(allocator, bytes);
    if (!block)
        return BMR_ERROR_NO_MEMORY;
    *links = (bmr_ring_links){
        rings->points, count, rings->ring_count, block, block + count, block + 2 * (size_t)count, bytes};
    uint32_t begin = 0;
    for (uint32_t r = 0; r < rings->ring_count; ++r) {
        const uint32_t end = begin + rings->counts[r];
        for (uint32_t i = begin; i < end; ++i) {
            links->next[i] = i + 1 < end ? i + 1 : begin;
            links->previous[i] = i > begin ? i - 1 : end - 1;
            links->ring[i] = r;
        }
        begin = end;
    }
    return BMR_OK;
}

void bmr_ring_links_free(bmr_ring_links *links, const bmr_allocator *allocator) {
    bmr_release(allocator, links->next, links->bytes);
}

static void merge_runs(const uint32_t *a, const uint32_t *a_end, const uint32_t *b, const uint32_t *b_end,
                       uint32_t *merged, bmr_index_before *before, const void *context) {
    while (a < a_end && b < b_end)
        *merged++ = before(context, *b, *a) ? *b++ : *a++;
    while (a < a_end)
        *merged++ = *a++;
    while (b < b_end)
        *merged++ = *b++;
}

void bmr_sort_indices(uint32_t *items, uint32_t count, uint32_t *scratch, bmr_index_before *before,
                      const void *context) {
    uint32_t *from = items, *to = scratch;
    for (uint32_t width = 1; width < count; width *= 2) {
        for (uint32_t i = 0; i < count; i += 2 * width) {
            const uint32_t middle = i + width < count ? i + width : count;
            const uint32_t end = middle + width < count ? middle + width : count;
            merge_runs(from + i, from + middle, from + middle, from + end, to + i, before, context);
        }
        uint32_t *swap = from;
        from = to;
        to = swap;
    }
    if (from != items)
        memcpy(items, from, count * sizeof *items);
}

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

bmr_error bmr_polygon_mass(const bmr_polygon *polygon, bmr_mass *mass) {
    if (!polygon)
        return BMR_ERROR_NULL_ARGUMENT;
    const bmr_rings ring = {polygon->vertices, &polygon->count, 1};
    return bmr_outline_mass(&ring, mass);
}
