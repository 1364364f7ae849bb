// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_SWEPT32_MOVERS_H
#define BMR_TEST_SWEPT32_MOVERS_H

#include <float.h>
#include <math.h>

#include "convex32_poses.h"
#include "exact32/swept32.h"

/// @file
/// Random shapes of up to 8 points in motion, and their gaps on the way, in double. In C.

enum { MOST = BMR_SWEPT32_MOST };

static dice random = {0x9e3779b97f4a7c15u};

static inline float random_in(float low, float high) {
    return (float)dice_in(&random, (double)low, (double)high);
}

/// Signalling NaN: any arithmetic with it raises FE_INVALID.
static const uint32_t trap_bits = 0x7fa00000u;

/// A hull of up to 8 points, in order, in an array of 8. What is past the count is a trap.
typedef struct outline {
    bmr_vec32 points[MOST];
    int32_t count;
} outline;

static inline outline random_outline(void) {
    outline o;
    uint32_t *raw = (uint32_t *)(void *)o.points;
    for (int i = 0; i < 2 * MOST; ++i)
        raw[i] = trap_bits;
    o.count = 1 + (int32_t)dice_below(&random, MOST);
    const float size = powf(10.0f, random_in(-1.0f, 0.7f)), flat = random_in(0.05f, 1.0f);
    const bmr_vec32 center = {random_in(-1.0f, 1.0f), random_in(-1.0f, 1.0f)};
    const float from = random_in(-3.0f, 3.0f);
    for (int i = 0; i < o.count; ++i) {
        const float angle = from + 6.28318f * ((float)i + random_in(0.0f, 0.8f)) / (float)o.count;
        o.points[i].x = center.x + size * cosf(angle);
        o.points[i].y = center.y + flat * size * sinf(angle);
    }
    return o;
}

/// Of a regular square about the origin.
static inline outline square(float half) {
    const outline o = {{{half, -half}, {half, half}, {-half, half}, {-half, -half}}, 4};
    return o;
}

typedef struct mover {
    outline shape;
    bmr_motion32 motion;
    double angle; ///< at the end
} mover;

static const bmr_vec32 none = {0.0f, 0.0f};

static inline mover place(outline shape, bmr_vec32 center, bmr_vec32 start, bmr_vec32 end, float angle,
                          float turn) {
    const mover m = {shape, {center, start, end, sinf(angle), cosf(angle), turn}, (double)angle};
    return m;
}

/// `way` and `turn` bound how far it goes.
static inline mover random_mover(bmr_vec32 about, float way, float turn) {
    const bmr_vec32 center = {random_in(-1.0f, 1.0f), random_in(-1.0f, 1.0f)};
    const bmr_vec32 end = {about.x + random_in(-3.0f, 3.0f), about.y + random_in(-3.0f, 3.0f)};
    const bmr_vec32 start = {end.x + random_in(-way, way), end.y + random_in(-way, way)};
    return place(random_outline(), center, start, end, random_in(-3.0f, 3.0f), random_in(-turn, turn));
}

static inline bmr_swept32 swept(const mover *m) {
    bmr_swept32 s;
    bmr_swept32_make(&s, m->shape.points, m->shape.count, &m->motion);
    return s;
}

typedef struct point {
    double x, y;
} point;

/// Where the shape's points are when a part `t` of the motion is done.
static inline void pose(const mover *m, double t, point *points) {
    const double angle = m->angle - (1.0 - t) * (double)m->motion.turn, s = sin(angle), c = cos(angle);
    const double px = (1.0 - t) * (double)m->motion.start.x + t * (double)m->motion.end.x;
    const double py = (1.0 - t) * (double)m->motion.start.y + t * (double)m->motion.end.y;
    for (int i = 0; i < m->shape.count; ++i) {
        const double x = (double)m->shape.points[i].x - (double)m->motion.center.x;
        const double y = (double)m->shape.points[i].y - (double)m->motion.center.y;
        points[i].x = c * x - s * y + px;
        points[i].y = s * x + c * y + py;
    }
}

/// How far apart two shapes are along n at a time.
static inline double gap_at(const mover *a, const mover *b, double t, bmr_vec32 n) {
    point pa[MOST], pb[MOST];
    pose(a, t, pa);
    pose(b, t, pb);
    double most = -DBL_MAX, least = DBL_MAX;
    for (int i = 0; i < a->shape.count; ++i)
        most = fmax(most, (double)n.x * pa[i].x + (double)n.y * pa[i].y);
    for (int i = 0; i < b->shape.count; ++i)
        least = fmin(least, (double)n.x * pb[i].x + (double)n.y * pb[i].y);
    return least - most;
}

/// The least of it over the motion, as finely as it is looked at.
static inline double least_gap(const mover *a, const mover *b, bmr_vec32 n) {
    enum { LOOKS = 32 };
    double least = DBL_MAX;
    for (int i = 0; i <= LOOKS; ++i)
        least = fmin(least, gap_at(a, b, (double)i / LOOKS, n));
    return least;
}

/// The largest gap of two still hulls along any direction, of many.
static inline double largest_gap(const mover *a, const mover *b) {
    enum { DIRECTIONS = 720 };
    double most = -DBL_MAX;
    for (int i = 0; i < DIRECTIONS; ++i) {
        const float angle = 6.2831853f * (float)i / DIRECTIONS;
        const bmr_vec32 n = {cosf(angle), sinf(angle)};
        most = fmax(most, gap_at(a, b, 1.0, n));
    }
    return most;
}

#endif
