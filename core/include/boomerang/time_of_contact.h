// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TIME_OF_CONTACT_H
#define BOOMERANG_TIME_OF_CONTACT_H

#include "boomerang/hierarchy.h"
#include "boomerang/motion.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// The time at which two moving polygons first touch (section 2 of the paper: failure times, one after the
/// other). In boomerang::kinetic. boomerang/simulation.h goes on after a contact; many bodies are a
/// boomerang/world.h.

/// The first time in [from, until] at which the two polygons are within `margin` of each other; INFINITY if
/// there is none. `margin` > 0: at margin 0, polygons that slide along each other have no proof with any
/// slack. The time is as exact as bmr_failure_time is with its default options. However fast the bodies turn,
/// nothing is missed but a dip below the margin that is no deeper than rounding. The answer is at most 1e-12
/// of max(1, |time|) early. If the distance is larger than the margin by no more than 1e-9 of the extents and
/// 2e-8 of the margin (bmr_kds_def), it may count as within.
///
/// Hierarchies are not needed. If both shapes have one of Dudley's, the proofs in between are made on it.
/// Each proof costs O(log n) and a failure time, which is some microseconds for each of its conditions. The
/// search may compute beyond the contact, by up to a sixteenth of the interval. Memory: that of a
/// bmr_simulation of two bodies, released before this returns. Errors: NULL_ARGUMENT, NOT_FINITE (a time),
/// OUT_OF_RANGE (from > until, a margin that is not positive), NO_MEMORY, STALLED, and those of
/// bmr_failure_time. Then *time is untouched.
bmr_error bmr_time_of_contact(const bmr_shape *a, const bmr_motion *motion_a, const bmr_shape *b,
                              const bmr_motion *motion_b, double from, double until, double margin,
                              const bmr_allocator *allocator, double *time);

#ifdef __cplusplus
}
#endif
#endif
