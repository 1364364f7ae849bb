// SPDX-License-Identifier: MIT
// Does a body go on from where it is, or jump? What differs by more than rounding is a jump. That is never
// wrong: it costs a search of the neighbours, and who is in contact after it was put there. To take a jump
// for rounding is wrong as soon as it is a part of the margin; so a part of the place (JUMP of pair_motion.c,
// which serves pairs that are watched in any case) would not do far from the origin.
//
// What is continued is still a rounding elsewhere. All certificates of the body are computed anew then, its
// own from where it is now (bmr_gate_crosses); so roundings do not add up.
#include <float.h>
#include <math.h>

#include "geometry/length.h"
#include "kinetic/motion.h"
#include "world/parts.h"

/// Rounding of a pose: so many of the terms of its path, and of its rotation's. (Horner's rule has two for
/// each degree, and the caller may have come to his pose in another way.)
#define ROUNDINGS 16.0
/// Couples halve the margin down to this part of it (couple.c): what is less is seen by no structure.
#define UNSEEN_PART 0x1p-20

/// By how much a pose may differ from another one of the same time: its place, and its (c, s).
typedef struct pose_room {
    double place, turn;
} pose_room;

/// Sum of the lengths of a path's terms.
static double terms(const double *x, const double *y, size_t degree, double elapsed) {
    double sum = 0.0, power = 1.0;
    for (size_t k = 0; k <= degree; k++, power *= elapsed)
        sum += power * (fabs(x[k]) + fabs(y[k]));
    return sum;
}

static pose_room room_of(const bmr_motion_piece *piece, const bmr_instant *now, double time) {
    const double elapsed = fabs(time - piece->origin);
    pose_room size;
    if (piece->kind == BMR_PIECE_SCREW) {
        const bmr_screw_motion *p = &piece->as.screw;
        const double x[] = {p->start.position.x, p->velocity.x}, y[] = {p->start.position.y, p->velocity.y};
        size.place = terms(x, y, 1, elapsed);
        size.turn = 1.0 + fabs(p->spin) * elapsed;
    } else {
        const bmr_algebraic_piece *p = &piece->as.algebraic, here = bmr_piece_expand(piece, time);
        size.place = terms(p->x, p->y, p->degree, elapsed);
        size.turn =
            terms(p->a, p->b, p->rotation_degree, elapsed) / bmr_length(bmr_vec2_make(here.a[0], here.b[0]));
    }
    const double part = ROUNDINGS * DBL_EPSILON, clock = BMR_CLOCK_ROUNDINGS * DBL_EPSILON * fabs(time);
    const pose_room room = {part * size.place + clock * bmr_length(now->velocity),
                            part * size.turn + clock * fabs(now->spin)};
    return room;
}

bool bmr_resident_jumps(const bmr_world *w, const bmr_resident *r, const bmr_motion_piece *piece) {
    const bmr_motion_piece *const before = &r->now.piece;
    bmr_timed_piece next;
    bmr_timed_piece_set(&next, w->time, piece); // of unit length
    const bmr_instant p = bmr_piece_instant(before, w->time), q = bmr_piece_instant(&next.piece, w->time);
    const pose_room old = room_of(before, &p, w->time), new = room_of(&next.piece, &q, w->time);
    const double unseen = UNSEEN_PART * w->def.kds.margin;
    const double place = old.place + new.place + ROUNDINGS *DBL_EPSILON * r->radius + unseen;
    const double turn = old.turn + new.turn + unseen / fmax(r->radius, w->def.kds.margin);
    // Written so that a NaN is a jump.
    return !(fabs(p.pose.position.x - q.pose.position.x) <= place &&
             fabs(p.pose.position.y - q.pose.position.y) <= place && fabs(p.pose.c - q.pose.c) <= turn &&
             fabs(p.pose.s - q.pose.s) <= turn);
}
