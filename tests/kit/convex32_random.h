// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONVEX32_RANDOM_H
#define BOOMERANG_TEST_CONVEX32_RANDOM_H

#include "checks.h"
#include "convex32/convex32.h"
#include "polygons.h"

/// @file
/// Random polygons of any size in float, and directions that are hard for them.

static inline bmr_vec32 vec(double x, double y) {
    const bmr_vec32 v = {(float)x, (float)y};
    return v;
}

/// Points of a family, of any size, thinness and place. At most n + 12.
static inline size_t random_points(test_random *random, size_t n, bmr_vec32 *points) {
    bmr_vec2 *wide = malloc((n + 12) * sizeof *wide);
    assert_non_null(wide);
    const test_family family = (test_family)test_random_below(random, TEST_FAMILY_COUNT);
    const size_t count = test_points(family, n, random, wide);
    const double size = pow(10.0, test_random_uniform(random, -4.0, 4.0));
    const double away = test_random_below(random, 3) ? 0.0 : size * test_random_uniform(random, 0.0, 100.0);
    const bool plain = test_random_below(random, 8) == 0;
    for (size_t i = 0; i < count; ++i)
        points[i] = plain ? vec(wide[i].x, wide[i].y) : vec(size * wide[i].x + away, size * wide[i].y - away);
    free(wide);
    return count;
}

/// Never NULL: where the floats leave no polygon, another one is tried.
static inline bmr_convex32_block *random_polygon(test_random *random, size_t n) {
    bmr_vec32 *points = malloc((n + 12) * sizeof *points);
    bmr_convex32_block *block = NULL;
    assert_non_null(points);
    while (!block) {
        const size_t count = random_points(random, n, points);
        const bmr_error error = bmr_convex32_create(points, count, NULL, &block);
        assert_true(error == BMR_OK || error == BMR_ERROR_TOO_FEW_POINTS || error == BMR_ERROR_OUT_OF_RANGE);
    }
    free(points);
    return block;
}

/// Mostly small, now and then huge.
static inline size_t random_count(test_random *random) {
    switch (test_random_below(random, 64)) {
    case 0:
        return 3 + test_random_below(random, 20000);
    case 1:
    case 2:
    case 3:
        return 3 + test_random_below(random, 2000);
    default:
        return 3 + test_random_below(random, 80);
    }
}

static inline bmr_vec32 between(bmr_vec32 a, bmr_vec32 b, double t) {
    return vec((double)a.x + t * ((double)b.x - (double)a.x), (double)a.y + t * ((double)b.y - (double)a.y));
}

static inline bmr_vec32 random_direction(test_random *random, const bmr_convex32 *p) {
    const double angle = test_random_uniform(random, -3.2, 3.2);
    bmr_vec32 d = vec(cos(angle), sin(angle));
    switch (test_random_below(random, 8)) {
    case 0:
        return p->normals[test_random_below(random, p->count)];
    case 1:
        d.x *= 1e-6f;
        return d;
    case 2:
        return vec(1e-30 * (double)d.x, 1e-30 * (double)d.y);
    case 3: {
        static const float axes[][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}};
        const uint32_t k = test_random_below(random, COUNT_OF(axes));
        return vec((double)axes[k][0], (double)axes[k][1]);
    }
    default:
        return d;
    }
}

#endif
