// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CONDITION_H
#define BOOMERANG_CONDITION_H

#include <stdbool.h>
#include <stdint.h>

#include "boomerang/error.h"
#include "boomerang/pose.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// The conditions of an event-driven structure, as plain data: scalar functions of the relative pose that are
/// positive while the structure's claim holds (section 2 of the paper: a certificate is G(p_1(t), .., p_m(t))
/// > 0). A caller that knows the motions can compute from a condition alone when it first fails
/// (boomerang/failure.h).

typedef enum bmr_condition_kind {
    /// <normal, x> - offset > 0, x the point: a point of the other body lies beyond a line of the owner.
    BMR_CONDITION_BEYOND,
    /// cross(normal, x) > 0, x the point as a direction: a direction of the other body is counter-clockwise
    /// of one of the owner, by less than 180 degrees.
    BMR_CONDITION_TURN,
    /// |x - normal| - offset > 0: the centre of the other's bounding disk (`point`) is farther from that of
    /// the owner (`normal`) than the sum of the radii.
    BMR_CONDITION_DISKS,
    BMR_CONDITION_KIND_COUNT
} bmr_condition_kind;

/// `normal` is in the owner's frame, `point` in the other body's. In BEYOND the value is a distance if the
/// normal is a unit vector. In TURN it is a sine if both are unit vectors.
typedef struct bmr_condition {
    bmr_vec2 normal;
    double offset; ///< a margin is part of it; 0 in TURN
    bmr_vec2 point;
    uint8_t kind;  ///< bmr_condition_kind
    uint8_t owner; ///< 0: A, 1: B
    uint8_t label; ///< the structure's own number of this condition
    uint8_t reserved[5];
} bmr_condition;

/// The condition's value at a pose of B in A's frame. It holds if this is > 0. O(1).
double bmr_condition_value(const bmr_condition *condition, const bmr_pose *b_in_a);

bmr_condition bmr_condition_beyond(int owner, bmr_vec2 normal, double offset, bmr_vec2 point, int label);
bmr_condition bmr_condition_turn(int owner, bmr_vec2 normal, bmr_vec2 direction, int label);
bmr_condition bmr_condition_disks(bmr_vec2 center_a, bmr_vec2 center_b, double reach, int label);

#ifdef __cplusplus
}
#endif
#endif
