// SPDX-License-Identifier: MIT
#include "boomerang/kinetic.h"

#include <math.h>

bmr_pose bmr_screw_motion_pose(const bmr_screw_motion *motion, double time) {
    const double angle = motion->spin * time;
    const double c = cos(angle), s = sin(angle);
    bmr_pose pose;
    pose.position = bmr_add(motion->start.position, bmr_scale(time, motion->velocity));
    pose.c = c * motion->start.c - s * motion->start.s;
    pose.s = s * motion->start.c + c * motion->start.s;
    return pose;
}
