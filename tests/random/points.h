// SPDX-License-Identifier: MIT
#ifndef BMR_FUZZ_POINTS_H
#define BMR_FUZZ_POINTS_H

#include <stdlib.h>

#include "boomerang/polygon.h"
#include "bytes.h"
#include "polygons.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Reads points for a polygon: one by one, each in the way its first byte says, or by a generator that makes
/// many of few bytes. `points` has FUZZ_POINTS(most).

#define FUZZ_POINTS(most) ((size_t)(most) + 12)

/// One more point after `count` others.
static inline bmr_vec2 fuzz_point(fuzz_bytes *bytes, const bmr_vec2 *points, size_t count) {
    const uint8_t how = fuzz_u8(bytes);
    const bmr_vec2 last = count > 0 ? points[count - 1] : bmr_vec2_make(0.0, 0.0);
    switch (how % 10) {
    case 0: { // grid
        const double x = (int8_t)fuzz_u8(bytes);
        return bmr_vec2_make(x, (int8_t)fuzz_u8(bytes));
    }
    case 1: { // a circle
        const double angle = fuzz_in(bytes, -4.0, 4.0);
        return bmr_vec2_make(cos(angle), sin(angle));
    }
    case 2: { // in a square
        const double x = fuzz_in(bytes, -1.0, 1.0);
        return bmr_vec2_make(x, fuzz_in(bytes, -1.0, 1.0));
    }
    case 3: { // on the line of two others, to rounding
        if (count < 2)
            return last;
        const bmr_vec2 a = points[fuzz_u8(bytes) % count], b = points[fuzz_u8(bytes) % count];
        const double t = fuzz_in(bytes, -1.0, 2.0);
        return bmr_add(a, bmr_scale(t, bmr_sub(b, a)));
    }
    case 4: { // another, some ulps on
        if (count == 0)
            return last;
        bmr_vec2 p = points[fuzz_u8(bytes) % count];
        const uint8_t steps = fuzz_u8(bytes);
        for (int i = steps % 16; i > 7; --i)
            p.x = nextafter(p.x, INFINITY);
        for (int i = steps / 16; i > 7; --i)
            p.y = nextafter(p.y, -INFINITY);
        return p;
    }
    case 5: { // the mirror of another
        if (count == 0)
            return last;
        const bmr_vec2 p = points[fuzz_u8(bytes) % count];
        return how >= 128 ? bmr_neg(p) : bmr_vec2_make(-p.x, p.y);
    }
    case 6: { // another, float rounding away
        if (count == 0)
            return last;
        const bmr_vec2 p = points[fuzz_u8(bytes) % count];
        const uint8_t steps = fuzz_u8(bytes);
        return bmr_vec2_make(p.x * (1.0 + 0x1p-24 * (steps % 16)), p.y * (1.0 - 0x1p-24 * (steps / 16)));
    }
    case 7: { // a parabola: every point is a vertex
        const double x = (int8_t)fuzz_u8(bytes);
        return bmr_vec2_make(x, x * x);
    }
    case 8: {
        const double x = fuzz_number(bytes);
        return bmr_vec2_make(x, fuzz_number(bytes));
    }
    default: {
        const double x = fuzz_raw_double(bytes);
        return bmr_vec2_make(x, fuzz_raw_double(bytes));
    }
    }
}

/// Returns how many points, 0 to `most` + 12.
static inline size_t fuzz_points(fuzz_bytes *bytes, bmr_vec2 *points, size_t most) {
    const uint8_t how = fuzz_u8(bytes), place = fuzz_u8(bytes);
    size_t count = 0;
    if (how < 96) { // one by one, up to an end
        size_t wanted = fuzz_u8(bytes);
        if (how == 0)
            wanted = fuzz_u16(bytes);
        for (; count < wanted && count < most && !fuzz_done(bytes); ++count)
            points[count] = fuzz_point(bytes, points, count);
    } else {
        test_random random = {fuzz_u16(bytes)};
        size_t wanted = 3 + fuzz_u8(bytes) % 40;
        if (how >= 250)
            wanted = 3 + fuzz_u16(bytes) % 300;
        if (wanted > most)
            wanted = most;
        if (how % (TEST_FAMILY_COUNT + 1) == TEST_FAMILY_COUNT) {
            bmr_vec2 hard[64];
            count = test_hard_points(&random, hard);
            if (count > most)
                count = most;
            memcpy(points, hard, count * sizeof *hard);
        } else if (wanted >= 3) {
            count = test_points((test_family)(how % (TEST_FAMILY_COUNT + 1)), wanted, &random, points);
        }
        // Some of them are bent by what follows.
        for (uint32_t bent = fuzz_u8(bytes) % 8; bent > 0 && count > 0 && !fuzz_done(bytes); --bent) {
            const size_t i = fuzz_u8(bytes) % count;
            points[i] = fuzz_point(bytes, points, count);
        }
    }
    if (place >= 128) { // elsewhere, larger or smaller
        const double scale =
            ldexp(1.0 + (place % 4) / 3.0, (place - 128) / 4 - 16 + (int8_t)fuzz_u8(bytes) / 16);
        const double x = fuzz_number(bytes), y = fuzz_number(bytes);
        for (size_t i = 0; i < count; ++i)
            points[i] = bmr_vec2_make(scale * points[i].x + x, scale * points[i].y + y);
    }
    return count;
}

/// The hull of fuzz_points, of 3 vertices and more if it may be; NULL where the points make none.
static inline bmr_polygon *fuzz_polygon(fuzz_bytes *bytes, size_t most) {
    bmr_vec2 *points = (bmr_vec2 *)malloc(FUZZ_POINTS(most) * sizeof *points);
    bmr_polygon *polygon = NULL;
    if (!points)
        abort();
    const size_t count = fuzz_points(bytes, points, most);
    if (bmr_polygon_create(points, count, NULL, &polygon) != BMR_OK)
        polygon = NULL;
    free(points);
    return polygon;
}

/// The same of an extent from 1/4 to 4, and at least `least` vertices; NULL where the bytes make none.
static inline bmr_polygon *fuzz_polygon_of_size(fuzz_bytes *bytes, size_t most, uint32_t least) {
    const int size = (int)fuzz_below(bytes, 4) - 1;
    bmr_polygon *polygon = fuzz_polygon(bytes, most), *scaled = NULL;
    if (!polygon || polygon->count < least) {
        bmr_polygon_destroy(polygon, NULL);
        return NULL;
    }
    int exponent;
    (void)frexp(polygon->extent, &exponent);
    const uint32_t count = polygon->count;
    bmr_vec2 *points = (bmr_vec2 *)malloc(count * sizeof *points);
    if (!points)
        abort();
    for (uint32_t i = 0; i < count; ++i)
        points[i] = bmr_scale(ldexp(1.0, size - exponent), polygon->vertices[i]);
    bmr_polygon_destroy(polygon, NULL);
    const bmr_error error = bmr_polygon_create(points, count, NULL, &scaled);
    free(points);
    if (error == BMR_OK && scaled->count >= (count < least ? count : least))
        return scaled;
    bmr_polygon_destroy(error == BMR_OK ? scaled : NULL, NULL);
    return NULL;
}

#ifdef __cplusplus
}
#endif
#endif
