// SPDX-License-Identifier: MIT
// The least distance over a motion: intervals are closed by a distance and a bound on speed.
#include <math.h>

#include "boomerang/families.h"
#include "geometry/distance.h"

/// Thirds of an interval until it has no time left inside: 3^-34 is below double's precision.
#define MAX_DEPTH 36

typedef struct search {
    const bmr_polygon *a, *b;
    const bmr_motion *motion_a, *motion_b;
    const bmr_motion_piece *piece_a, *piece_b;
    double radius_a, radius_b; ///< about the frames' origins
    double tolerance;
    double best, time;
    bmr_simplex simplex; ///< where the last query ended
} search;

static double distance_at(search *s, double time) {
    const bmr_pose a = bmr_motion_pose(s->motion_a, time, NULL, NULL);
    const bmr_pose b = bmr_motion_pose(s->motion_b, time, NULL, NULL);
    const bmr_pose b_in_a = bmr_pose_relative(&a, &b);
    bmr_closest closest;
    const bool apart = bmr_closest_direction(s->a, s->b, &b_in_a, 0.0, 0.0, &s->simplex, &closest);
    const double distance = apart ? closest.separation : 0.0;
    if (distance < s->best) {
        s->best = distance;
        s->time = time;
    }
    return distance;
}

/// Both ends lie in one piece of each motion; `middle` is the distance half way.
static void narrow(search *s, double from, double to, double middle, int depth) {
    const double speed = bmr_motion_piece_speed(s->piece_a, from, to, s->radius_a) +
                         bmr_motion_piece_speed(s->piece_b, from, to, s->radius_b);
    if (s->best <= 0.0 || middle - 0.5 * speed * (to - from) >= s->best - s->tolerance || depth == 0)
        return;
    const double third = (to - from) / 3.0, one = from + third, two = to - third;
    const double first = distance_at(s, from + 0.5 * third), last = distance_at(s, to - 0.5 * third);
    narrow(s, one, two, middle, depth - 1);
    narrow(s, from, one, first, depth - 1);
    narrow(s, two, to, last, depth - 1);
}

/// Calls `narrow` (or, before that, just measures the middle) for every stretch of one piece of each motion.
static void sweep(search *s, double from, double to, bool only_middle) {
    for (double at = from; at < to && s->best > 0.0;) {
        double end_a, end_b;
        s->piece_a = bmr_motion_piece_at(s->motion_a, at, &end_a);
        s->piece_b = bmr_motion_piece_at(s->motion_b, at, &end_b);
        const double end = fmin(to, fmin(end_a, end_b));
        const double middle = distance_at(s, at + 0.5 * (end - at));
        if (!only_middle)
            narrow(s, at, end, middle, MAX_DEPTH);
        at = end;
    }
}

static double reach_from_origin(const bmr_polygon *polygon) {
    return hypot(polygon->center.x, polygon->center.y) + polygon->radius;
}

bmr_error bmr_least_distance(const bmr_polygon *a, const bmr_polygon *b, const bmr_motion *motion_a,
                             const bmr_motion *motion_b, double from, double to, double tolerance,
                             double *distance, double *time) {
    if (!a || !b || !motion_a || !motion_b || !distance || !time)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!(tolerance > 0.0) || !isfinite(from) || !isfinite(to) || from > to)
        return BMR_ERROR_OUT_OF_RANGE;
    search s = {.a = a,
                .b = b,
                .motion_a = motion_a,
                .motion_b = motion_b,
                .radius_a = reach_from_origin(a),
                .radius_b = reach_from_origin(b),
                .tolerance = tolerance,
                .best = INFINITY,
                .time = from,
                .simplex = bmr_simplex_make(0, 0)};
    distance_at(&s, from);
    distance_at(&s, to);
    // A good bound first: then most stretches are closed at once.
    sweep(&s, from, to, true);
    sweep(&s, from, to, false);
    *distance = s.best;
    *time = s.time;
    return BMR_OK;
}
