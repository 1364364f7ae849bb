// SPDX-License-Identifier: MIT
#ifndef BMR_FUZZ_PATHS_H
#define BMR_FUZZ_PATHS_H

#include "boomerang/motion.h"
#include "bytes.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Reads rigid motions. What `reach` and `spin` bound, they bound at the times of interest, some units around
/// 0; without `wild` all numbers are moderate.

typedef struct fuzz_motion_range {
    double reach; ///< of coordinates
    double speed; ///< of velocities
    double spin;  ///< radians per unit of time; 0: nothing turns
    double begin, end;
    bool wild;  ///< any number may come
    bool roots; ///< a control: rotations with common roots come too, against the contract
} fuzz_motion_range;

static inline double fuzz_wild(fuzz_bytes *bytes, const fuzz_motion_range *range, double most) {
    return range->wild ? fuzz_number(bytes) : fuzz_in(bytes, -most, most);
}

static inline bmr_pose fuzz_pose(fuzz_bytes *bytes, const fuzz_motion_range *range, double angle) {
    const double x = fuzz_wild(bytes, range, range->reach);
    const bmr_pose pose = {{x, fuzz_wild(bytes, range, range->reach)}, cos(angle), sin(angle)};
    return pose;
}

/// One piece; it may be one that cannot be made, if wild.
static inline bmr_motion_piece fuzz_piece(fuzz_bytes *bytes, const fuzz_motion_range *range) {
    const uint8_t kind = fuzz_u8(bytes);
    const double origin = kind >= 128 ? fuzz_wild(bytes, range, range->end) : 0.0;
    const double angle = fuzz_in(bytes, -3.2, 3.2);
    if (kind % 2 == 0) {
        const bmr_pose pose = fuzz_pose(bytes, range, angle);
        const double vx = fuzz_wild(bytes, range, range->speed);
        const bmr_vec2 velocity = {vx, fuzz_wild(bytes, range, range->speed)};
        const double spin = kind % 8 != 0 ? fuzz_wild(bytes, range, range->spin) : 0.0;
        return bmr_piece_screw(origin, pose, velocity, range->spin > 0.0 ? spin : 0.0);
    }
    bmr_motion_piece piece;
    memset(&piece, 0, sizeof piece);
    piece.kind = BMR_PIECE_ALGEBRAIC;
    piece.origin = origin;
    bmr_algebraic_piece *const w = &piece.as.algebraic;
    w->degree = fuzz_below(bytes, BMR_MOTION_MAX_DEGREE + 1);
    double scale = range->reach;
    for (size_t k = 0; k <= w->degree; ++k, scale /= 3.0) {
        w->x[k] = fuzz_wild(bytes, range, scale);
        w->y[k] = fuzz_wild(bytes, range, scale);
    }
    w->rotation_degree = range->spin > 0.0 && kind % 4 == 1 ? fuzz_below(bytes, 4) : 0;
    if (kind % 32 == 5 && range->spin > 0.0)
        w->rotation_degree = fuzz_below(bytes, BMR_MOTION_MAX_DEGREE + 1);
    scale = 1.0;
    w->a[0] = 1.0;
    for (size_t k = 0; k <= w->rotation_degree && w->rotation_degree > 0; ++k, scale /= 2.0) {
        w->a[k] = fuzz_wild(bytes, range, scale);
        w->b[k] = fuzz_wild(bytes, range, scale);
    }
    w->start_c = cos(angle);
    w->start_s = sin(angle);
    return piece;
}

/// What failure times are exact to by default: two times nearer to one another than this are one.
#define FUZZ_TIME 1e-12
/// What a sum of terms may be wrong by, in parts of the terms (failure.h).
#define FUZZ_ROUNDING 1e-14

/// |a + i b| at a time of the piece; *size: the lengths of the terms that it is the sum of.
static inline double fuzz_turn(const bmr_algebraic_piece *w, double u, double *size) {
    double a = 0.0, b = 0.0;
    *size = 0.0;
    for (size_t k = w->rotation_degree + 1; k-- > 0;) {
        a = a * u + w->a[k];
        b = b * u + w->b[k];
        *size = *size * fabs(u) + hypot(w->a[k], w->b[k]);
    }
    return hypot(a, b);
}

/// Have a and b a common root in [low, high], times of the piece? Halves the interval until the first term
/// around its middle is more than all others, or until its times are one.
static inline bool fuzz_common_root(const bmr_algebraic_piece *w, double low, double high) {
    const double half = 0.5 * (high - low), middle = low + half;
    double a[BMR_MOTION_MAX_DEGREE + 1], b[BMR_MOTION_MAX_DEGREE + 1], size, others = 0.0;
    memcpy(a, w->a, sizeof a);
    memcpy(b, w->b, sizeof b);
    for (size_t i = 0; i < w->rotation_degree; ++i)
        for (size_t k = w->rotation_degree; k-- > i;) {
            a[k] += middle * a[k + 1];
            b[k] += middle * b[k + 1];
        }
    for (size_t k = w->rotation_degree; k > 0; --k)
        others = (others + hypot(a[k], b[k])) * half;
    if (fuzz_turn(w, middle, &size) > others + FUZZ_ROUNDING * size)
        return false;
    return high - low <= FUZZ_TIME || fuzz_common_root(w, low, middle) || fuzz_common_root(w, middle, high);
}

/// The contract: a rotation's a and b have no common root. Where they have one in the range, or come near to
/// one at a sample, the piece is made not to turn. (Between the samples they may come as near as they like.)
static inline void fuzz_tame(bmr_motion_piece *piece, const fuzz_motion_range *range) {
    if (range->wild || piece->kind != BMR_PIECE_ALGEBRAIC)
        return;
    bmr_algebraic_piece *const w = &piece->as.algebraic;
    bool turns =
        range->roots || !fuzz_common_root(w, range->begin - piece->origin, range->end - piece->origin);
    for (int i = 0; i <= 100 && turns; ++i) {
        double size;
        const double u = range->begin + (range->end - range->begin) * i / 100.0 - piece->origin;
        turns = fuzz_turn(w, u, &size) > 0.02 * size;
    }
    if (turns)
        return;
    w->rotation_degree = 0;
    w->a[0] = 1.0;
    w->b[0] = 0.0;
}

/// A motion of up to 7 pieces; NULL where it cannot be made.
static inline bmr_motion *fuzz_motion(fuzz_bytes *bytes, const fuzz_motion_range *range) {
    const uint8_t how = fuzz_u8(bytes);
    bmr_motion *motion = NULL;
    if (how % 4 == 0) { // from sample to sample
        double times[6];
        bmr_pose poses[6];
        const double angle = fuzz_in(bytes, -3.2, 3.2);
        const size_t count = 1 + how / 4 % 6;
        for (size_t i = 0; i < count; ++i) {
            const double part = ((double)i + fuzz_in(bytes, 0.05, 0.95)) / (double)count;
            times[i] = range->begin + (range->end - range->begin) * part;
            poses[i] = fuzz_pose(bytes, range, range->spin > 0.0 ? fuzz_in(bytes, -3.2, 3.2) : angle);
        }
        return bmr_motion_create_sampled(times, poses, count, NULL, &motion) == BMR_OK ? motion : NULL;
    }
    bmr_motion_piece first = fuzz_piece(bytes, range);
    fuzz_tame(&first, range);
    if (bmr_motion_create(&first, NULL, &motion) != BMR_OK)
        return NULL;
    // A wild search may take all of its steps for each two pieces.
    const int most = range->wild ? 2 : 6;
    for (int changes = how % 4 == 1 ? how / 4 % most : 0; changes > 0 && !fuzz_done(bytes); --changes) {
        // Mostly the pose stays and the plan changes; else it jumps.
        const double time = fuzz_in(bytes, range->begin, range->end);
        const bool jumps = fuzz_u8(bytes) % 8 == 0;
        bmr_motion_piece piece = fuzz_piece(bytes, range);
        const bmr_pose pose = bmr_motion_pose(motion, time, NULL, NULL);
        if (piece.kind == BMR_PIECE_SCREW) {
            if (!jumps)
                piece.as.screw.start = pose;
            else if (!(range->spin > 0.0)) {
                piece.as.screw.start.c = pose.c;
                piece.as.screw.start.s = pose.s;
            }
        } else {
            if (!jumps) {
                piece.as.algebraic.x[0] = pose.position.x;
                piece.as.algebraic.y[0] = pose.position.y;
                piece.as.algebraic.a[0] = 1.0;
                piece.as.algebraic.b[0] = 0.0;
            }
            if (!jumps || !(range->spin > 0.0)) {
                piece.as.algebraic.start_c = pose.c;
                piece.as.algebraic.start_s = pose.s;
            }
        }
        piece.origin = time;
        fuzz_tame(&piece, range);
        bmr_motion_change(motion, time, &piece); // refused: the motion stays as it was
    }
    return motion;
}

#ifdef __cplusplus
}
#endif
#endif
