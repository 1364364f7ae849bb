// SPDX-License-Identifier: MIT
#include "analysis/course.h"

#include <math.h>

#include "geometry/distance.h"

bool bmr_course_is_valid(const bmr_course *course) {
    return isfinite(course->from) && isfinite(course->to) && course->from <= course->to;
}

bmr_pose bmr_course_pose(const bmr_course *course, double time) {
    const bmr_pose a = bmr_motion_pose(course->motions[0], time, NULL, NULL),
                   b = bmr_motion_pose(course->motions[1], time, NULL, NULL);
    return bmr_pose_relative(&a, &b);
}

double bmr_course_piece_end(const bmr_course *course, double time) {
    double end_a, end_b;
    bmr_motion_piece_at(course->motions[0], time, &end_a);
    bmr_motion_piece_at(course->motions[1], time, &end_b);
    return fmin(course->to, fmin(end_a, end_b));
}

double bmr_course_speed(const bmr_course *course, double from, double to, double weight) {
    const bmr_motion_piece *a = bmr_motion_piece_at(course->motions[0], from, NULL),
                           *b = bmr_motion_piece_at(course->motions[1], from, NULL);
    // A's frame sees B's origin move by its own speed, A's, and A's spin at its distance.
    const double own_a = bmr_motion_piece_speed(a, from, to, 0.0),
                 own_b = bmr_motion_piece_speed(b, from, to, 0.0);
    const bmr_pose pose = bmr_course_pose(course, from);
    const double reach = hypot(pose.position.x, pose.position.y) + (own_a + own_b) * (to - from);
    // The speed at a radius is at least that of the turning there less that of the origin.
    const double turning_a = bmr_motion_piece_speed(a, from, to, weight + reach) + own_a,
                 turning_b = weight > 0.0 ? bmr_motion_piece_speed(b, from, to, weight) + own_b : 0.0;
    return own_a + own_b + turning_a + turning_b;
}

double bmr_pose_distance(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a) {
    bmr_simplex simplex = bmr_simplex_make(0, 0);
    bmr_closest closest;
    return bmr_closest_direction(a, b, b_in_a, 0.0, 0.0, &simplex, &closest) ? closest.separation : 0.0;
}

double bmr_pose_turn(const bmr_pose *p, const bmr_pose *q) {
    return atan2(p->c * q->s - p->s * q->c, p->c * q->c + p->s * q->s);
}
