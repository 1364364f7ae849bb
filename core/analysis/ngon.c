// SPDX-License-Identifier: MIT
#include <math.h>

#include "analysis/family_paths.h"
#include "boomerang/families.h"
#include "kinetic/roots.h"

#include <gsl/gsl_randist.h>

// ---- random numbers ----

gsl_rng *bmr_random_create(uint64_t seed) {
    bmr_gsl_guard_enter();
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    bmr_gsl_guard_leave();
    if (random) // the upper half is folded in: the generator takes 32 bits
        gsl_rng_set(random, (unsigned long)((seed ^ (seed >> 32) * 2654435761u) & 0xffffffffu));
    return random;
}

#define PI 3.14159265358979323846
/// The short axis of the ellipses; the long one is 1.
#define ELLIPSE_MINOR 0.25
/// Half the angle of each of the lens's two arcs.
#define LENS_HALF_ANGLE (PI / 6.0)
#define DISC_RADIUS 0.5

const char *bmr_ngon_name(bmr_ngon kind) {
    static const char *const names[BMR_NGON_COUNT] = {"regular", "random", "lens", "ellipse", "disc"};
    return (unsigned)kind < BMR_NGON_COUNT ? names[kind] : NULL;
}

static void ellipse_points(size_t n, double major, double minor, double phase, bmr_vec2 *points) {
    for (size_t i = 0; i < n; i++) {
        const double angle = phase + 2.0 * PI * (double)i / (double)n;
        points[i] = bmr_vec2_make(major * cos(angle), minor * sin(angle));
    }
}

static void random_points(size_t n, gsl_rng *random, bmr_vec2 *points) {
    for (size_t i = 0; i < n; i++) {
        const double angle = gsl_ran_flat(random, 0.0, 2.0 * PI);
        points[i] = bmr_vec2_make(cos(angle), ELLIPSE_MINOR * sin(angle));
    }
}

/// Two arcs that meet in (-1, 0) and (1, 0), the ends given once.
static void lens_points(size_t n, bmr_vec2 *points) {
    const size_t below = n / 2;
    for (size_t i = 0; i < n; i++) {
        const bool lower = i < below;
        const double part = lower ? (double)i / (double)below : (double)(i - below) / (double)(n - below);
        const double angle = LENS_HALF_ANGLE * (2.0 * part - 1.0);
        const double x = sin(angle) / sin(LENS_HALF_ANGLE);
        const double y = (cos(angle) - cos(LENS_HALF_ANGLE)) / sin(LENS_HALF_ANGLE);
        points[i] = lower ? bmr_vec2_make(x, -y) : bmr_vec2_make(-x, y);
    }
}

static void turn_points(size_t n, double angle, bmr_vec2 *points) {
    const bmr_pose turn = {{0.0, 0.0}, cos(angle), sin(angle)};
    for (size_t i = 0; i < n; i++)
        points[i] = bmr_rotate(&turn, points[i]);
}

bmr_error bmr_ngon_points(bmr_ngon kind, size_t n, uint64_t seed, bmr_vec2 *points) {
    if (!points)
        return BMR_ERROR_NULL_ARGUMENT;
    if ((unsigned)kind >= BMR_NGON_COUNT || n < 3 || n > BMR_MAX_VERTICES)
        return BMR_ERROR_OUT_OF_RANGE;
    gsl_rng *random = bmr_random_create(seed);
    if (!random)
        return BMR_ERROR_NO_MEMORY;
    const double phase = gsl_ran_flat(random, 0.0, 2.0 * PI), angle = gsl_ran_flat(random, 0.0, 2.0 * PI);
    switch (kind) {
    case BMR_NGON_REGULAR:
        ellipse_points(n, 1.0, 1.0, phase, points);
        break;
    case BMR_NGON_RANDOM:
        random_points(n, random, points);
        turn_points(n, angle, points);
        break;
    case BMR_NGON_LENS:
        lens_points(n, points);
        turn_points(n, angle, points);
        break;
    case BMR_NGON_ELLIPSE:
        ellipse_points(n, 1.0, ELLIPSE_MINOR, phase, points);
        turn_points(n, angle, points);
        break;
    default:
        ellipse_points(n, DISC_RADIUS, DISC_RADIUS, phase, points);
        break;
    }
    gsl_rng_free(random);
    return BMR_OK;
}
