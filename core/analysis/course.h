// SPDX-License-Identifier: MIT
#ifndef BMR_ANALYSIS_COURSE_H
#define BMR_ANALYSIS_COURSE_H

#include "boomerang/analysis.h"

/// B in A's frame at a time.
bmr_pose bmr_course_pose(const bmr_course *course, double time);
/// Where the pieces of both motions that hold at `time` end, at most the course's end.
double bmr_course_piece_end(const bmr_course *course, double time);
/// An upper bound over [from, to], one piece of each motion, of the speed of |tau| + weight * |delta| of the
/// relative pose.
double bmr_course_speed(const bmr_course *course, double from, double to, double weight);
/// The distance of the two polygons at a relative pose, 0 where they overlap.
double bmr_pose_distance(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a);
bool bmr_course_is_valid(const bmr_course *course);

#endif
