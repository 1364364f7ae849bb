// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_DRIVEN_H
#define BMR_TEST_DRIVEN_H

#include "checks.h"
#include "kds_driver.h"

/// @file
/// One drive of a structure that is made for it. In C.

/// The structure of that name takes A and B along the drive's path. The test has failed if anything is wrong
/// with it, and says what, and with whom.
static inline test_drive_result driven(const char *name, const test_kds_body *a, const test_kds_body *b,
                                       const test_drive *drive) {
    bmr_kds_def def = drive->def ? *drive->def : bmr_default_kds_def();
    if (drive->margin > 0.0)
        def.margin = drive->margin;
    own_kds *kds = made_kds(test_structure(name), &def, &a->shape, &b->shape);
    const test_drive_result r = test_drive_run(kds, a->polygon, b->polygon, drive);
    if (r.false_audits + r.dead_repairs + r.false_contacts + r.missed_contacts + r.changed_by_none +
            r.silent_lines >
        0)
        fail_msg("%s, polygons of %u and %u vertices: %u false audits (%s), %u dead repairs, %u false and %u "
                 "missed contacts, %u changes by none, %u silent lines",
                 name, a->polygon->count, b->polygon->count, r.false_audits, bmr_error_describe(r.error),
                 r.dead_repairs, r.false_contacts, r.missed_contacts, r.changed_by_none, r.silent_lines);
    return r;
}

#endif
