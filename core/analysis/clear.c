// SPDX-License-Identifier: MIT
// Greedy clear decompositions of a path (section 6): one that exists, and a size that none can go below.
#include <math.h>

#include "analysis/course.h"
#include "geometry/length.h"

/// Steps are this part of a clear disk's radius.
#define STEP_PART 0.05
/// A path nearer than this part of the extents is taken to touch.
#define TOUCHING 1e-9
/// So many configurations of a segment are kept to measure its diameter. Beyond that new ones are compared
/// with these only, and the lower bound may be less sharp; it stays one.
#define KEPT 512

typedef struct decomposition {
    const bmr_course *course;
    double kappa, weight;
    bmr_pose kept[KEPT];
    size_t kept_count;
    double nearest; ///< least distance on the segment of the lower bound
    double across;  ///< its diameter
    bmr_pose centre;
    double radius; ///< of the clear disk about the segment's first point
    bmr_clear clear;
} decomposition;

static double between(const decomposition *d, const bmr_pose *p, const bmr_pose *q) {
    return hypot(q->position.x - p->position.x, q->position.y - p->position.y) +
           d->weight * fabs(bmr_pose_turn(p, q));
}

/// The lower bound's segment goes on if it can still lie in a clear disk.
static void add_to_least(decomposition *d, const bmr_pose *pose, double distance) {
    double across = d->across;
    for (size_t k = 0; k < d->kept_count; k++)
        across = fmax(across, between(d, &d->kept[k], pose));
    const double nearest = fmin(d->nearest, distance);
    const bool fits = across <= 2.0 / (d->kappa - 1.0) * nearest;
    if (!fits) {
        d->clear.least++;
        d->kept_count = 0;
    }
    d->nearest = fits ? nearest : distance;
    d->across = fits ? across : 0.0;
    if (d->kept_count < KEPT)
        d->kept[d->kept_count++] = *pose;
}

/// `step`: how far the path may have gone from the pose before; it had the distance `before`.
static void add_to_found(decomposition *d, const bmr_pose *from, double before, const bmr_pose *pose,
                         double step) {
    if (between(d, &d->centre, pose) + step > d->radius) {
        d->clear.found++;
        d->centre = *from;
        d->radius = before / d->kappa;
    }
}

/// The end of a step from `time` on which the path goes no farther than `reach`.
static double step_end(const decomposition *d, double time, double reach) {
    double end = bmr_course_piece_end(d->course, time);
    for (int k = 0; k < 64; k++) {
        const double span = end - time, speed = bmr_course_speed(d->course, time, end, d->weight);
        if (speed * span <= reach)
            return end;
        // Speed bounds are tight on short intervals: shrink towards what this one allows, not at once.
        end = time + fmax(reach / speed, 0.25 * span);
        if (!(speed < INFINITY))
            end = time + 0.25 * span;
    }
    return end;
}

/// Theorem 6.2: no more events than the least kappa-clear decomposition, kappa = 2 beta + 1.
bmr_error bmr_clear_decomposition(const bmr_course *course, double kappa, double diameter, bmr_clear *clear) {
    if (!course || !clear || !course->polygons[0] || !course->polygons[1] || !course->motions[0] ||
        !course->motions[1])
        return BMR_ERROR_NULL_ARGUMENT;
    if (!bmr_course_is_valid(course) || !(kappa > 1.0) || !isfinite(kappa) || !(diameter >= 0.0) ||
        !isfinite(diameter))
        return BMR_ERROR_OUT_OF_RANGE;
    const bmr_polygon *a = course->polygons[0], *b = course->polygons[1];
    decomposition d = {.course = course, .kappa = kappa, .weight = diameter, .clear = {1, 1, 1}};
    bmr_pose at = bmr_course_pose(course, course->from);
    double distance = bmr_pose_distance(a, b, &at);
    d.centre = at;
    d.radius = distance / kappa;
    d.nearest = distance;
    d.kept[d.kept_count++] = at;
    for (double time = course->from; time < course->to;) {
        if (!(distance > TOUCHING * (a->extent + b->extent)))
            return BMR_ERROR_OUT_OF_RANGE;
        const double step = STEP_PART * distance / kappa;
        const double next = step_end(&d, time, step);
        if (!(next > time))
            return BMR_ERROR_OUT_OF_RANGE; // faster than time resolves
        const bmr_pose to = bmr_course_pose(course, next);
        const double there = bmr_pose_distance(a, b, &to);
        add_to_found(&d, &at, distance, &to, step);
        add_to_least(&d, &to, there);
        d.clear.samples++;
        at = to;
        distance = there;
        time = next;
    }
    *clear = d.clear;
    return BMR_OK;
}
