// SPDX-License-Identifier: MIT
#include "kinetic/motion.h"

#include <float.h>
#include <math.h>

#include "geometry/distance.h"
#include "geometry/length.h"

/// Two poses differ by a jump, not by rounding, when they are this far apart, in parts of 1 + |position|.
/// Sampled motions and changes of plan that continue a pose agree to some 1e-15.
#define JUMP 1e-9

/// The shortest step of the search for the end of a contact, in parts of the longest: a pair that slides
/// along at the very distance that ends a contact is sampled so often and no more.
#define LEAST_STEP_PART 1e-3

/// Looks at one contact in one search, at most: about a second. At the default that is 200,000 units of time
/// in the longest steps, and 200 in the shortest.
#define MOST_SAMPLES ((size_t)1 << 21)

bmr_instant bmr_pair_instant(const bmr_pair_motion *pair, double time) {
    bmr_instant a, b, now;
    a.pose = bmr_motion_pose(pair->a, time, &a.velocity, &a.spin);
    b.pose = bmr_motion_pose(pair->b, time, &b.velocity, &b.spin);
    now.pose = bmr_pose_relative(&a.pose, &b.pose);
    const bmr_vec2 drift = bmr_unrotate(&a.pose, bmr_sub(b.velocity, a.velocity));
    now.velocity = bmr_sub(drift, bmr_scale(a.spin, bmr_left(now.pose.position)));
    now.spin = b.spin - a.spin;
    return now;
}

static bool jumps(const bmr_motion *motion, double time) {
    const bmr_motion_piece *const earlier = bmr_motion_piece_at(motion, nextafter(time, -INFINITY), NULL);
    const bmr_motion_piece *const later = bmr_motion_piece_at(motion, time, NULL);
    if (earlier == later)
        return false;
    const bmr_pose p = bmr_piece_instant(earlier, time).pose, q = bmr_piece_instant(later, time).pose;
    const double rounding = JUMP * (1.0 + fabs(p.position.x) + fabs(p.position.y));
    // Written so that a NaN is a jump.
    return !(fabs(p.position.x - q.position.x) <= rounding && fabs(p.position.y - q.position.y) <= rounding &&
             fabs(p.c - q.c) <= JUMP && fabs(p.s - q.s) <= JUMP);
}

bool bmr_pair_jumps_at(const bmr_pair_motion *pair, double time) {
    return jumps(pair->a, time) || jumps(pair->b, time);
}

static double next_jump(const bmr_motion *motion, double from, double to) {
    for (double end = from; end <= to;) {
        bmr_motion_piece_at(motion, end, &end);
        if (end <= to && jumps(motion, end))
            return end;
    }
    return INFINITY;
}

double bmr_pair_next_jump(const bmr_pair_motion *pair, double from, double to) {
    return fmin(next_jump(pair->a, from, to), next_jump(pair->b, from, to));
}

double bmr_pair_separation(const bmr_pair_motion *pair, double time) {
    const bmr_pose pose = bmr_pair_instant(pair, time).pose;
    bmr_simplex simplex = bmr_simplex_make(0, 0);
    bmr_closest closest;
    if (bmr_closest_direction(pair->shape_a, pair->shape_b, &pose, 0.0, 0.0, &simplex, &closest))
        return closest.separation;
    // A point has no edges: its one normal means nothing. Two points in one place touch.
    if (pair->shape_a->count == 1 && pair->shape_b->count == 1)
        return 0.0;
    const bmr_pose inverse = bmr_pose_inverse(&pose);
    const double most = fmax(bmr_best_edge(pair->shape_a, pair->shape_b, &pose).separation,
                             bmr_best_edge(pair->shape_b, pair->shape_a, &inverse).separation);
    return fmin(0.0, most);
}

/// Of any point of the body over an interval, pieces' ends included.
static double body_speed(const bmr_motion *motion, const bmr_polygon *shape, double from, double to) {
    const double radius = bmr_length(shape->center) + shape->radius;
    double most = 0.0;
    while (from < to) {
        double end;
        const bmr_motion_piece *piece = bmr_motion_piece_at(motion, from, &end);
        end = fmin(end, to);
        most = fmax(most, bmr_motion_piece_speed(piece, from, end, radius));
        from = end;
    }
    return most;
}

/// A time between `low` and `high` at which the separation rises above `level`: at `low` it is not above it,
/// at `high` it is.
static double rises(const bmr_pair_motion *pair, double low, double high, double level, double tolerance) {
    while (high - low > fmax(tolerance, 2.0 * DBL_EPSILON * fabs(high))) {
        const double middle = low + 0.5 * (high - low);
        if (bmr_pair_separation(pair, middle) > level)
            high = middle;
        else
            low = middle;
    }
    return high;
}

/// When the first of both pieces that hold at `time` ends; at most `to`.
static double pieces_end(const bmr_pair_motion *pair, double time, double to) {
    double a, b;
    bmr_motion_piece_at(pair->a, time, &a);
    bmr_motion_piece_at(pair->b, time, &b);
    return fmin(to, fmin(a, b));
}

double bmr_pair_speed(const bmr_pair_motion *pair, double from, double to) {
    return body_speed(pair->a, pair->shape_a, from, to) + body_speed(pair->b, pair->shape_b, from, to);
}

double bmr_pair_leaves(const bmr_pair_motion *pair, double from, double to, double target,
                       double longest_step, double tolerance) {
    const double least_step = fmax(LEAST_STEP_PART * longest_step, tolerance);
    double here = bmr_pair_separation(pair, from);
    // A contact may begin a rounding above the target: then it must rise from there.
    const double level = fmax(target, here);
    double time = from;
    for (size_t samples = 0; time < to; samples++) {
        if (samples == MOST_SAMPLES)
            return NAN;
        // Time is resolved to the tolerance: samples nearer to one another say nothing.
        double end = fmin(to, fmax(time + fmax(longest_step, tolerance), nextafter(time, INFINITY)));
        const double speed = bmr_pair_speed(pair, time, end);
        // A pair at rest stays where it is until a piece ends.
        if (!(speed > 0.0) && bmr_pair_speed(pair, time, pieces_end(pair, time, to)) == 0.0)
            end = fmax(end, pieces_end(pair, time, to));
        const double safe = speed > 0.0 ? (level - here) / speed : INFINITY;
        double next = fmin(end, time + fmax(safe, least_step));
        if (!(next > time))
            next = nextafter(time, INFINITY);
        here = bmr_pair_separation(pair, next);
        if (here > level)
            return rises(pair, time, next, level, tolerance);
        time = next;
    }
    return INFINITY;
}
