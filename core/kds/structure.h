// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_STRUCTURE_H
#define BMR_KDS_STRUCTURE_H

#include "boomerang/kds.h"

/// @file
/// What a file of this folder provides: one constant bmr_kds_class for each structure in it, named in
/// kds.c's table. kds.c does what all share: checks of arguments, memory, contact, the exact distance.

/// The pair that a structure works on; its own state follows it in the same block.
struct bmr_kds {
    const bmr_kds_info *info;
    bmr_kds_def def;
    bmr_shape shapes[2]; ///< A, B
    size_t bytes;
    bool contact, started;
    unsigned *steps; ///< of the report, during start and repair; else NULL
    /// Set by the `prepare` of a rival whose line moves with the pose: the line there (`proof` of its class
    /// gives that of the last event). NULL: the line is fixed.
    void (*proof_at)(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_kds_proof *proof);
    /// Structures' own state, `state_bytes` of their class, aligned for any type.
    _Alignas(16) unsigned char state[];
};

typedef struct bmr_kds_class {
    size_t state_bytes;
    /// More bytes than the state's for this pair (an explicit tiling); NULL: none.
    size_t (*extra_bytes)(const bmr_shape *a, const bmr_shape *b, const bmr_kds_def *def);
    /// Called once after creation, with the state zeroed; NULL: nothing to do. An error destroys the pair.
    bmr_error (*prepare)(bmr_kds *kds);
    /// True: a proof is in the state. False: the polygons are within the margin (kds.c verifies that by the
    /// exact distance and, where it is not so, reports an INVALID_STRUCTURE in the audit).
    bool (*start)(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report);
    size_t (*conditions)(const bmr_kds *kds, bmr_condition *conditions);
    /// As start, after the failure of one condition.
    bool (*repair)(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report);
    void (*proof)(const bmr_kds *kds, bmr_kds_proof *proof);
    /// The structure's own promises beyond the line; NULL: none.
    bmr_error (*audit)(const bmr_kds *kds, const bmr_pose *b_in_a);
} bmr_kds_class;

/// A body's hierarchy of the kind that the structure needs.
static inline const bmr_hierarchy *bmr_kds_hierarchy(const bmr_kds *kds, int body) {
    return kds->shapes[body].hierarchies[kds->info->hierarchy];
}

/// At this distance a pair that is apart comes into contact, and one in contact leaves it.
static inline double bmr_kds_reach(const bmr_kds *kds) {
    return kds->def.margin + (kds->contact ? kds->def.hysteresis : 0.0);
}

/// Counts elementary steps (bmr_kds_report.touched).
static inline void bmr_kds_tally(const bmr_kds *kds, unsigned steps) {
    if (kds->steps)
        *kds->steps += steps;
}

/// The signed separation of the two polygons along a direction of A's frame (unit length): min over B - max
/// over A. O(log n).
double bmr_kds_separation(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_vec2 direction);
/// Along a direction of the owner's frame: the most of its own vertices, and the least of the other's. Brute
/// force, for audits.
void bmr_kds_extremes(const bmr_kds *kds, int owner, const bmr_pose *b_in_a, bmr_vec2 normal,
                      double *own_most, double *other_least);
/// The direction of the closest points and the exact distance, from vertices `*a`, `*b` as hints (any value),
/// which become the support vertices in it. False: the distance is at most bmr_kds_reach. O(log n), O(log k)
/// for an answer k edges from the hints.
bool bmr_kds_closest(const bmr_kds *kds, const bmr_pose *b_in_a, uint32_t *a, uint32_t *b,
                     bmr_vec2 *direction, double *distance);
/// bmr_cone_end for the pair: an end of the directions that separate by `least`. O(log n).
bmr_vec2 bmr_kds_cone_end(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_vec2 inside, double least, int side,
                          const uint32_t support[2]);

/// Failure times are found a little early. So a condition that is still positive counts as failed where its
/// value is less than this part of the magnitudes that it is computed from, and falling.
#define BMR_FAILING_PART 1e-10

/// d/dt of bmr_condition_value under the instant's rates. O(1).
double bmr_condition_rate(const bmr_condition *condition, const bmr_instant *now);

/// Has the condition failed at this instant? It has if it is not positive, or if it is at most `tolerance`
/// and falling. A condition below zero has failed even if it grows: where a motion turns round just after the
/// failure, the search for failures reports this one for as long as the value is below zero.
bool bmr_condition_fails(const bmr_condition *condition, const bmr_instant *now, double tolerance);

#endif
