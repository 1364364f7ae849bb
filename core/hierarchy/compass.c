// SPDX-License-Identifier: MIT
#include <math.h>

#include "geometry/memory.h"
#include "hierarchy/builder.h"

#define QUARTER_TURN 1.57079632679489661923

static size_t compass_bytes(uint32_t levels) {
    return sizeof(bmr_compass) + ((size_t)BMR_ROOTS << levels) * sizeof(bmr_vec2);
}

/// Direction k of the 4 * 2^levels. The sines of half a quadrant serve all, so that the table is symmetric
/// bit for bit.
static bmr_vec2 compass_direction(uint32_t k, uint32_t levels) {
    const uint32_t quarter = (uint32_t)1 << levels;
    const uint32_t r = k & (quarter - 1);
    const uint32_t folded = 2 * r > quarter ? quarter - r : r;
    const double angle = QUARTER_TURN * (double)folded / (double)quarter;
    double c = cos(angle), s = sin(angle);
    if (2 * r == quarter)
        c = s = sqrt(0.5);
    const double x = 2 * r > quarter ? s : c, y = 2 * r > quarter ? c : s;
    switch (k >> levels) {
    case 0:
        return bmr_vec2_make(x, y);
    case 1:
        return bmr_vec2_make(0.0 - y, x); // not -y: no negative zeros
    case 2:
        return bmr_vec2_make(0.0 - x, 0.0 - y);
    default:
        return bmr_vec2_make(y, 0.0 - x);
    }
}

bmr_error bmr_compass_create(size_t max_vertices, const bmr_allocator *allocator, bmr_compass **compass) {
    if (!compass)
        return BMR_ERROR_NULL_ARGUMENT;
    if (max_vertices == 0)
        return BMR_ERROR_NO_POINTS;
    if (max_vertices > BMR_MAX_VERTICES)
        return BMR_ERROR_TOO_MANY_POINTS;
    const uint32_t levels = bmr_ceil_log2((uint32_t)max_vertices);
    bmr_compass *made = bmr_allocate(allocator, compass_bytes(levels));
    if (!made)
        return BMR_ERROR_NO_MEMORY;
    made->levels = levels;
    made->reserved = 0;
    bmr_vec2 *next = made->directions;
    for (uint32_t k = 0; k < BMR_ROOTS; ++k)
        *next++ = compass_direction(k << levels, levels);
    for (uint32_t level = 1; level <= levels; ++level)
        for (uint32_t odd = 1; odd < BMR_ROOTS << level; odd += 2)
            *next++ = compass_direction(odd << (levels - level), levels);
    *compass = made;
    return BMR_OK;
}

void bmr_compass_destroy(bmr_compass *compass, const bmr_allocator *allocator) {
    if (compass)
        bmr_release(allocator, compass, compass_bytes(compass->levels));
}

/// Lemma 3.3(a): a compass boomerang of level i is O(D/2^i) high.
/// Lemma 3.3(b): O(sqrt(D/s) log(D/s)) compass boomerangs are at least s high.
bmr_error bmr_hierarchy_build_compass(const bmr_polygon *polygon, const bmr_compass *compass,
                                      const bmr_allocator *allocator, bmr_hierarchy **hierarchy) {
    return bmr_hierarchy_build_compass_with_corners(polygon, compass, 0, allocator, hierarchy);
}

/// Section 6, tuning: with richer roots and slower offsets beta nears 1 and kappa nears 3.
bmr_error bmr_hierarchy_build_compass_with_corners(const bmr_polygon *polygon, const bmr_compass *compass,
                                                   uint32_t corner_levels, const bmr_allocator *allocator,
                                                   bmr_hierarchy **hierarchy) {
    if (!polygon || !compass || !hierarchy)
        return BMR_ERROR_NULL_ARGUMENT;
    const uint32_t needed = bmr_ceil_log2(polygon->count),
                   levels = needed > corner_levels ? needed : corner_levels;
    if (compass->levels < levels)
        return BMR_ERROR_TABLE_TOO_SMALL;
    const bmr_build build = {polygon, BMR_HIERARCHY_COMPASS, NULL, 0, compass, levels, corner_levels};
    return bmr_build_of_edges(build, allocator, hierarchy);
}
