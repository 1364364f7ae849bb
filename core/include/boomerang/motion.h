// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_MOTION_H
#define BOOMERANG_MOTION_H

#include <stddef.h>

#include "boomerang/allocator.h"
#include "boomerang/error.h"
#include "boomerang/pose.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Rigid motions of one body as a function of time (section 2 of the paper), in boomerang::kinetic.
///
/// A motion is a sequence of pieces. Each piece holds from its own time until the next piece's; the first
/// holds from -INFINITY. A change of flight plan replaces everything after a time. A motion is two blocks of
/// its allocator: itself, and its pieces, whose block is doubled when it is full.

/// A body whose frame's origin moves along a straight line while the body turns about that origin at a
/// constant rate: the motion of a body without forces if the origin is its centre of mass. Spin 0 is a
/// translation.
typedef struct bmr_screw_motion {
    bmr_pose start;    ///< the pose at time 0
    bmr_vec2 velocity; ///< of the origin, length units per unit of time
    double
        spin; ///< counter-clockwise, radians per unit of time; the angle turned is spin * time, rounded once
} bmr_screw_motion;

/// The highest degree of a coordinate polynomial of an algebraic piece, and of each of the two polynomials of
/// its rational rotation.
#define BMR_MOTION_MAX_DEGREE 8

typedef enum bmr_motion_piece_kind {
    BMR_PIECE_ALGEBRAIC, ///< polynomial position, rational rotation
    BMR_PIECE_SCREW      ///< linear position, constant spin
} bmr_motion_piece_kind;

/// An algebraic frame. With u = t - origin, the position is (sum x[k] u^k, sum y[k] u^k). The rotation is
/// start turned by the angle 2 atan2(b(u), a(u)), that is (c, s) = (a^2 - b^2, 2 a b) / (a^2 + b^2): an
/// orthonormal frame whose entries are rational functions of degree 2 rotation_degree. a and b must have no
/// common root. (Creation does not look for one. At a common root the pose is NaN, and a search past it
/// returns BMR_ERROR_NOT_FINITE.)
typedef struct bmr_algebraic_piece {
    size_t degree; ///< of the position
    double x[BMR_MOTION_MAX_DEGREE + 1], y[BMR_MOTION_MAX_DEGREE + 1];
    size_t rotation_degree; ///< of a and b; 0: a fixed rotation
    double a[BMR_MOTION_MAX_DEGREE + 1], b[BMR_MOTION_MAX_DEGREE + 1];
    double start_c, start_s; ///< unit length
} bmr_algebraic_piece;

typedef struct bmr_motion_piece {
    bmr_motion_piece_kind kind;
    double origin; ///< the piece's own time is 0 here
    union {
        bmr_algebraic_piece algebraic;
        bmr_screw_motion screw;
    } as;
} bmr_motion_piece;

/// A piece that stands still at a pose.
bmr_motion_piece bmr_piece_rest(bmr_pose pose);
/// A screw piece: at `pose` at time `origin`.
bmr_motion_piece bmr_piece_screw(double origin, bmr_pose pose, bmr_vec2 velocity, double spin);

typedef struct bmr_motion bmr_motion;

/// Makes a motion of one piece that holds for all time. The piece is copied and its rotation made of unit
/// length. The allocator (NULL: malloc) must outlive the motion. Errors: NULL_ARGUMENT, NOT_FINITE,
/// OUT_OF_RANGE (degrees, a rotation off unit length by more than 1e-9, a and b both zero), NO_MEMORY.
bmr_error bmr_motion_create(const bmr_motion_piece *piece, const bmr_allocator *allocator,
                            bmr_motion **motion);
/// Makes a motion of screws from sample to sample (turning the shorter way), at rest before the first and
/// after the last. `times` ascend strictly. Errors also: NO_POINTS (count 0), OUT_OF_RANGE (times do not
/// ascend), TOO_LARGE.
bmr_error bmr_motion_create_sampled(const double *times, const bmr_pose *poses, size_t count,
                                    const bmr_allocator *allocator, bmr_motion **motion);
/// NULL is no error.
void bmr_motion_destroy(bmr_motion *motion);

/// Replaces the motion from `time` on by `piece`. Earlier pieces stay; later ones are dropped. The pose may
/// jump at `time` (the kinetic simulation then starts the pair afresh). Errors as at creation, and NOT_FINITE
/// for the time, TOO_LARGE if the pieces cannot be addressed; then the motion is as it was. Amortized O(1)
/// beside the search for the place.
bmr_error bmr_motion_change(bmr_motion *motion, double time, const bmr_motion_piece *piece);

/// The piece that holds at `time` (at a change: the later one). If `end` is not NULL, it gets the time at
/// which the piece ends (INFINITY: never). The pointer is valid until the next change of plan. O(log pieces).
const bmr_motion_piece *bmr_motion_piece_at(const bmr_motion *motion, double time, double *end);
/// The pose at `time`. `velocity` and `spin`, if not NULL, get the velocity of the origin and the rate of the
/// angle.
bmr_pose bmr_motion_pose(const bmr_motion *motion, double time, bmr_vec2 *velocity, double *spin);
/// An upper bound, over [from, to] (finite) of one piece, of the speed of any point within `radius` (>= 0) of
/// the frame's origin. It is tight as the interval shrinks. INFINITY if a rotation's a and b come too near to
/// a common root, and for a degree above BMR_MOTION_MAX_DEGREE.
double bmr_motion_piece_speed(const bmr_motion_piece *piece, double from, double to, double radius);

#ifdef __cplusplus
}
#endif
#endif
