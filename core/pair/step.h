// SPDX-License-Identifier: MIT
#ifndef BMR_PAIR_STEP_H
#define BMR_PAIR_STEP_H

#include "boomerang/pair.h"
#include "certificate/coarse.h"
#include "certificate/walk.h"
#include "geometry/distance.h"

/// @file
/// What the files of this folder share. A structure is one function that repairs a pair whose certificate has
/// failed (or that has none yet). pair.c calls it. step.c does what all structures share: the quick check,
/// the disks, contact, and notes for the observer.

/// One call of bmr_pair_advance.
typedef struct bmr_step {
    bmr_pair *pair;
    const bmr_pair_def *def;
    const bmr_shape *shapes[2]; ///< A, B
    const bmr_pose *pose;       ///< of B in A's frame
    const bmr_observer *observer;
    double need;    ///< the gap that a certificate must prove: margin, and hysteresis for a pair in contact
    double reach;   ///< need, and all that a certificate may lose by rounding: apart by more than this can be
                    ///< certified
    unsigned steps; ///< elementary steps so far (geometry/distance.h)
} bmr_step;

/// Why a repair is called for.
typedef enum bmr_failure {
    BMR_FAILURE_NEW,     ///< nothing known
    BMR_FAILURE_DISKS,   ///< the disks touch
    BMR_FAILURE_CROSSED, ///< the window crossed the line
    BMR_FAILURE_ROLLED,  ///< the direction left the bracket
    BMR_FAILURE_CONTACT  ///< was in contact at the last advance
} bmr_failure;

/// Makes the certificate of two bounding disks, with its level, if they prove more than `need`. *gap: what
/// they prove.
bool bmr_disks_certify(bmr_step *step, double need, double *gap);
/// What the two disks of a certificate prove at this pose.
double bmr_disks_gap(const bmr_certificate *certificate, const bmr_pose *b_in_a);
bmr_error bmr_disks_audit(const bmr_certificate *certificate, const bmr_polygon *a, const bmr_polygon *b,
                          const bmr_pose *b_in_a);

/// How much of the gap the closest direction may miss: a query that stops this early saves a quarter of its
/// iterations on smooth bodies of 500 vertices and nearly half at 4000, and the loss is small beside what a
/// window may cost.
#define BMR_CLOSEST_SLACK 0.0625

/// What a pair remembers of its two polygons. All of it is modulo 2^32. Where one polygon is kept and the
/// other's stamp changes, the pair's stamp changes: the multiplier is odd. Where A and B change places, the
/// pair's stamp changes by (multiplier - 1) times the difference of their stamps. The multiplier less 1 is
/// twice an odd number, so the pair's stamp stays as it is only where the two stamps are the same or differ
/// by exactly 2^31.
static inline uint32_t bmr_pair_stamp(const bmr_polygon *a, const bmr_polygon *b) {
    return a->stamp * UINT32_C(0x9e3779b3) + b->stamp;
}
/// Which structure keeps a pair of these: the one that was asked for, if both have what it walks on.
bmr_structure bmr_pair_structure(const bmr_pair_def *def, const bmr_shape *a, const bmr_shape *b);

/// The distance query of a step, from the vertices given; true: apart by more than step->reach.
bool bmr_step_closest(bmr_step *step, bmr_simplex *simplex, bmr_closest *closest);
/// The simplex that a pair in contact remembers.
bmr_simplex bmr_contact_simplex(const bmr_pair *pair);
/// Puts the pair in contact, remembering the simplex; an event unless it was in contact before.
bmr_answer bmr_contact_enter(bmr_step *step, const bmr_simplex *simplex, int level);

/// Counts an event and hands it to the observer.
void bmr_step_note(const bmr_step *step, bmr_event_kind kind, int level_before, int level_after, double gap);
/// Does the pair's certificate prove more than `margin` at this pose? *gap: what it proves.
static inline bmr_check bmr_pair_quick_check(const bmr_pair *pair, const bmr_pose *b_in_a, double margin,
                                             double *gap) {
    if (pair->level == BMR_LEVEL_DISKS) {
        *gap = bmr_disks_gap(&pair->certificate, b_in_a);
        return *gap > margin ? BMR_CHECK_HOLDS : BMR_CHECK_CROSSED;
    }
    return bmr_certificate_check_pair(&pair->certificate, b_in_a, pair->owner, margin, gap);
}
/// The same at the step's pose.
bool bmr_step_holds(const bmr_step *step, double need, double *gap);

/// A line in the closest direction, fixed in the body that leaves the wider bracket, and a window of the
/// other body. False: nothing that proves more than the need came of it. The pair's state is left alone.
bool bmr_free_certify(bmr_step *step, const bmr_closest *closest, double *gap);
/// The coarse line that a pair of two lines remembers in other_after, made of these polygons' edges. False:
/// it has none.
bool bmr_spare_line(const bmr_pair *pair, const bmr_polygon *a, const bmr_polygon *b, bmr_coarse *spare);

bmr_answer bmr_free_repair(bmr_step *step, bmr_failure failure, double *gap);
bmr_answer bmr_lazy_pair_repair(bmr_step *step, bmr_failure failure, double *gap);

#endif
