// SPDX-License-Identifier: MIT
#include "kds/failing.h"

#include <math.h>

double bmr_condition_rate(const bmr_condition *condition, const bmr_instant *now) {
    const bmr_pose *q = &now->pose;
    const bool of_a = condition->owner == 0;
    if (condition->kind == BMR_CONDITION_TURN) {
        // cross(n, R x), and cross(R n, x) for B: what turns is at a right angle to what it turns into.
        const bmr_vec2 turning = bmr_rotate(q, of_a ? condition->point : condition->normal);
        const bmr_vec2 still = of_a ? condition->normal : condition->point;
        return (of_a ? now->spin : -now->spin) * bmr_dot(turning, still);
    }
    if (condition->kind == BMR_CONDITION_BEYOND && !of_a) {
        // <R n, x - p> - h, x fixed in A
        const bmr_vec2 n = bmr_rotate(q, condition->normal), d = bmr_sub(condition->point, q->position);
        return now->spin * bmr_dot(bmr_left(n), d) - bmr_dot(n, now->velocity);
    }
    const bmr_vec2 arm = bmr_rotate(q, condition->point);
    const bmr_vec2 velocity = bmr_add(now->velocity, bmr_scale(now->spin, bmr_left(arm)));
    if (condition->kind == BMR_CONDITION_BEYOND)
        return bmr_dot(condition->normal, velocity);
    const bmr_vec2 d = bmr_sub(bmr_add(arm, q->position), condition->normal);
    const double length = hypot(d.x, d.y);
    return length > 0.0 ? bmr_dot(d, velocity) / length : 0.0;
}

bool bmr_condition_fails(const bmr_condition *condition, const bmr_instant *now, double tolerance) {
    const double value = bmr_condition_value(condition, &now->pose);
    if (!(value > 0.0)) // a NaN has failed
        return true;
    return value <= tolerance && bmr_condition_rate(condition, now) < 0.0;
}
