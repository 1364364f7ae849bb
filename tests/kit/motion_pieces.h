// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_MOTION_PIECES_H
#define BMR_TEST_MOTION_PIECES_H

#include <string.h>

#include "boomerang/motion.h"

/// A path whose a and b are 1 and 0 at `origin`, which its terms are about: x and y alone are asked for where
/// it does not turn. O(1).
static inline bmr_motion_piece test_algebraic(double origin, bmr_algebraic_piece path) {
    bmr_motion_piece piece;
    memset(&piece, 0, sizeof piece);
    piece.kind = BMR_PIECE_ALGEBRAIC;
    piece.origin = origin;
    piece.as.algebraic = path;
    piece.as.algebraic.a[0] = piece.as.algebraic.start_c = 1.0;
    return piece;
}

/// Lets a piece begin at this time and pose, with the rates that it has: what a change of plan asks for.
/// O(1).
static inline void test_piece_begin(bmr_motion_piece *piece, double time, bmr_pose pose) {
    if (piece->kind == BMR_PIECE_SCREW) {
        piece->as.screw.start = pose;
    } else {
        piece->as.algebraic.x[0] = pose.position.x;
        piece->as.algebraic.y[0] = pose.position.y;
        piece->as.algebraic.a[0] = 1.0;
        piece->as.algebraic.b[0] = 0.0;
        piece->as.algebraic.start_c = pose.c;
        piece->as.algebraic.start_s = pose.s;
    }
    piece->origin = time;
}

#endif
