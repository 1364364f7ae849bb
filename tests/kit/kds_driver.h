// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_KDS_DRIVER_H
#define BMR_TEST_KDS_DRIVER_H

#include "boomerang/kds.h"
#include "polygons.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Drives one kinetic structure along a motion, event by event, without any of core/kinetic: failures are
/// found by cautious steps and bisection of the conditions' values, and everything is audited by brute force.

/// The structure of a name. A test that misspells it ends with core's own sentence.
const bmr_kds_info *test_structure(const char *name);

/// A polygon with its hierarchies of all kinds. Aborts on failure: a test without memory is none.
typedef struct test_kds_body {
    bmr_polygon *polygon;
    bmr_hierarchy *hierarchies[BMR_HIERARCHY_KIND_COUNT];
    bmr_shape shape;
} test_kds_body;
/// Takes the polygon over.
test_kds_body test_kds_body_make(bmr_polygon *polygon);
/// A body of one vertex.
test_kds_body test_kds_point_make(double x, double y);
void test_kds_body_destroy(test_kds_body *body);
#define own_kds_body OWNED(test_kds_body_destroy) test_kds_body

/// A smooth relative motion over times [0, 1]: a cubic and three harmonics in the position, a line and one
/// harmonic in the angle. All rates are exact.
#define TEST_PATH_HARMONICS 3
typedef struct test_path {
    bmr_vec2 cubic[4]; ///< coefficients of 1, t, t^2, t^3
    double radius[TEST_PATH_HARMONICS], frequency[TEST_PATH_HARMONICS], phase[TEST_PATH_HARMONICS];
    double angle, spin, swing, swing_frequency; ///< angle + spin t + swing sin(swing_frequency t)
} test_path;
bmr_instant test_path_at(const test_path *path, double time);
/// Upper bounds over [0, 1]: of the speed of the origin, of the spin, and of |position|.
void test_path_bounds(const test_path *path, double *speed, double *spin, double *reach);

typedef enum test_path_kind {
    TEST_PATH_LINE,     ///< a straight pass
    TEST_PATH_PARABOLA, ///< a pass that bends away
    TEST_PATH_CUBIC,    ///< any cubic
    TEST_PATH_ORBIT,    ///< once around on a circle
    TEST_PATH_WANDER,   ///< three harmonics
    TEST_PATH_HIT,      ///< a straight path into the other body
    TEST_PATH_KIND_COUNT
} test_path_kind;
/// A random path of the kind that comes about as near as `gap` to the other body (HIT: into it). `rotates`:
/// with some turns of spin and swing; otherwise at a random fixed angle.
test_path test_path_make(test_path_kind kind, const bmr_polygon *a, const bmr_polygon *b, double gap,
                         bool rotates, test_random *random);

/// One event of a drive.
typedef struct test_drive_event {
    double time;
    bmr_instant now;
    bmr_kds_report report;
    bmr_condition failed; ///< zero at a start
    const bmr_kds *kds;
} test_drive_event;

typedef struct test_drive {
    const test_path *path;
    /// Failures that heal within this much time may be missed; else the first one is found to 1e-15. Also the
    /// time between looks at a pair in contact. 0: 1e-6.
    double resolution;
    /// Audit at every so many steps between events, beside the events themselves; 0: 16.
    unsigned audit_every;
    /// The structure's margin; 0: that of its definition.
    double margin;
    const bmr_kds_def *def; ///< NULL: bmr_default_kds_def
    /// Stop at the first contact.
    bool stop_at_contact;
    void (*on_event)(void *context, const test_drive_event *event);
    void *context;
} test_drive;

/// What happened. All of the first group must be 0 for a right structure.
typedef struct test_drive_result {
    unsigned false_audits;    ///< bmr_kds_audit said no, at an event or between
    unsigned dead_repairs;    ///< a condition that stayed failed after a repair, again and again
    unsigned false_contacts;  ///< contact where the polygons are apart by more than margin and rounding
    unsigned missed_contacts; ///< not in contact where they overlap
    unsigned changed_by_none; ///< a repair that reported NONE changed the conditions
    unsigned silent_lines;    ///< a repair that did not say so left another line
    bmr_error error;          ///< of the first false audit

    uint64_t events[BMR_KDS_EVENT_KIND_COUNT];
    double contact_time; ///< of the first contact; INFINITY
    double nearest;      ///< the least distance at any step
} test_drive_result;

/// Starts the structure at time 0 and takes it to time 1.
test_drive_result test_drive_run(bmr_kds *kds, const bmr_polygon *a, const bmr_polygon *b,
                                 const test_drive *drive);
/// Is the condition among those that it waits for?
bool test_waits_for(const bmr_kds *kds, const bmr_condition *condition);
/// Repairs, not counting NONE, starts and contacts.
uint64_t test_drive_events(const test_drive_result *result);

#ifdef __cplusplus
}
#endif
#endif
