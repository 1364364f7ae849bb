// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_MOTION_LAYOUT_H
#define BMR_KINETIC_MOTION_LAYOUT_H

#include "boomerang/motion.h"

/// @file
/// What a motion is made of, for those who keep pieces of their own.

typedef struct bmr_timed_piece {
    double from;
    bmr_motion_piece piece;
} bmr_timed_piece;

struct bmr_motion {
    const bmr_allocator *allocator;
    size_t count, capacity;
    bmr_timed_piece *pieces; ///< ascending; the first is from -INFINITY
};

/// Copies a piece that bmr_piece_check found nothing wrong with, and makes its rotation of unit length.
void bmr_timed_piece_set(bmr_timed_piece *timed, double from, const bmr_motion_piece *piece);

/// The motion of this one piece, for all time, without memory of its own: not to be changed or destroyed.
static inline bmr_motion bmr_motion_of_piece(bmr_timed_piece *timed) {
    const bmr_motion motion = {NULL, 1, 1, timed};
    return motion;
}

/// What the motion is from `time` on, in blocks of `allocator`. Errors: NO_MEMORY.
bmr_error bmr_motion_copy_from(const bmr_motion *motion, double time, const bmr_allocator *allocator,
                               bmr_motion **copy);

#endif
