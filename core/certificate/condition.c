// SPDX-License-Identifier: MIT
#include "boomerang/condition.h"

#include "geometry/length.h"

bmr_condition bmr_condition_beyond(int owner, bmr_vec2 normal, double offset, bmr_vec2 point, int label) {
    bmr_condition k = {normal, offset, point, BMR_CONDITION_BEYOND, (uint8_t)owner, (uint8_t)label, {0}};
    return k;
}

bmr_condition bmr_condition_turn(int owner, bmr_vec2 normal, bmr_vec2 direction, int label) {
    bmr_condition k = {normal, 0.0, direction, BMR_CONDITION_TURN, (uint8_t)owner, (uint8_t)label, {0}};
    return k;
}

bmr_condition bmr_condition_disks(bmr_vec2 center_a, bmr_vec2 center_b, double reach, int label) {
    bmr_condition k = {center_a, reach, center_b, BMR_CONDITION_DISKS, 0, (uint8_t)label, {0}};
    return k;
}

double bmr_condition_value(const bmr_condition *condition, const bmr_pose *b_in_a) {
    const bmr_pose other_in_owner = condition->owner == 0 ? *b_in_a : bmr_pose_inverse(b_in_a);
    switch (condition->kind) {
    case BMR_CONDITION_BEYOND:
        return bmr_dot(condition->normal, bmr_transform(&other_in_owner, condition->point)) -
               condition->offset;
    case BMR_CONDITION_TURN:
        return bmr_cross(condition->normal, bmr_rotate(&other_in_owner, condition->point));
    default: {
        const bmr_vec2 d = bmr_sub(bmr_transform(&other_in_owner, condition->point), condition->normal);
        return bmr_length(d) - condition->offset;
    }
    }
}
