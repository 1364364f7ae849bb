// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_SIMULATION_H
#define BOOMERANG_SIMULATION_H

#include "boomerang/failure.h"
#include "boomerang/kds.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// A kinetic simulation of two moving convex polygons: one structure, every event in time order. Many bodies
/// are a world (world.h). In boomerang::kinetic.

typedef struct bmr_simulation bmr_simulation;

typedef struct bmr_simulation_def {
    const bmr_kds_info *structure;
    bmr_kds_def kds;
    bmr_failure_options failure;
    /// The most time between two samples of a pair in contact; > 0. A contact ends where the distance rises
    /// above kds.margin + kds.hysteresis. Steps that the bodies' speeds make safe find that time to
    /// failure.tolerance. Leaving and touching again within a thousandth of this step may go unnoticed.
    double contact_step;
} bmr_simulation_def;
/// No structure yet; the defaults of its parts; contact_step 0.1.
bmr_simulation_def bmr_default_simulation_def(void);

/// One event, as the observer gets it. A repair takes place when the failed condition is no longer positive,
/// which may be a few failure.tolerance after `time`; `pose` is that of the repair.
typedef struct bmr_simulation_event {
    double time;
    bmr_kds_report report;
    bmr_condition failed;        ///< the condition that failed; zero for START, CONTACT by start, LEAVE
    bmr_kds_proof before, after; ///< before: zero for START and LEAVE; after: zero for CONTACT
    bmr_pose pose;               ///< of the second body in the first's frame
    const bmr_kds *kds;
} bmr_simulation_event;
/// Gets each event after it was processed. It may ask the simulation, and change plans: a
/// bmr_simulation_replan takes effect when it returns. It may not run the simulation (OUT_OF_RANGE) nor
/// destroy it (ignored).
typedef void (*bmr_simulation_observer)(void *context, const bmr_simulation_event *event);

/// Counts for the four qualities of a kinetic structure (compact, responsive, local, efficient).
typedef struct bmr_simulation_counts {
    uint64_t events[BMR_KDS_EVENT_KIND_COUNT];
    uint64_t lines;         ///< replacements of a separating line by another, starts not counted
    uint64_t touched;       ///< elementary steps of starts and repairs
    uint64_t failure_times; ///< failure times computed
    uint64_t replanned;     ///< of those, after a change of flight plan
    uint64_t external;      ///< contacts begun and ended since the start: any method must process these
    size_t conditions;      ///< at this moment
    size_t bytes;           ///< of the structure
} bmr_simulation_counts;

/// Makes a simulation that begins at `time`. The polygons, hierarchies and motions must outlive it. The
/// structure has a START (or is in CONTACT). Memory: two blocks of the allocator (NULL: malloc); nothing
/// later. Errors: NULL_ARGUMENT, NOT_FINITE (time), OUT_OF_RANGE (a def that makes no sense), NO_MEMORY, and
/// those of bmr_kds_create.
bmr_error bmr_simulation_create(const bmr_simulation_def *def, const bmr_shape shapes[2],
                                bmr_motion *const motions[2], double time, bmr_simulation_observer observer,
                                void *context, const bmr_allocator *allocator, bmr_simulation **simulation);
/// NULL is no error. A call from the observer is ignored.
void bmr_simulation_destroy(bmr_simulation *simulation);

/// Processes every event up to and including `until`, in time order, and calls the observer for each. If
/// there are more than BMR_SIMULATION_BURST events within failure.tolerance of one another (a Zeno loop), it
/// returns STALLED, and the simulation stands at that time. If a motion jumps, the structure is started
/// afresh: START, CONTACT or LEAVE. Errors also: NULL_ARGUMENT, NOT_FINITE, OUT_OF_RANGE (`until` is past, or
/// so far away that a search takes too many steps: one of bmr_failure_time, or two million samples of a
/// contact, which are at least contact_step / 1000 and failure.tolerance apart), and those of
/// bmr_failure_time. After one of these the simulation stands at its last event, and the next run searches
/// again from there.
bmr_error bmr_simulation_run(bmr_simulation *simulation, double until);
#define BMR_SIMULATION_BURST 1000
double bmr_simulation_time(const bmr_simulation *simulation);

/// Call this after a motion was changed (bmr_motion_change) from the present time on. It computes the failure
/// times anew, as far as any run went. If the pose jumps at the present time, it restarts the structure.
/// Until this call the simulation uses the old motion's times. Errors: NULL_ARGUMENT, those of
/// bmr_failure_time.
bmr_error bmr_simulation_replan(bmr_simulation *simulation);

const bmr_kds *bmr_simulation_kds(const bmr_simulation *simulation);
bmr_simulation_counts bmr_simulation_get_counts(const bmr_simulation *simulation);
/// Calls bmr_kds_audit at the present time.
bmr_error bmr_simulation_audit(const bmr_simulation *simulation);

#ifdef __cplusplus
}
#endif
#endif
