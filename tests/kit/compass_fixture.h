// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_COMPASS_FIXTURE_H
#define BMR_TEST_COMPASS_FIXTURE_H

#include "checks.h"
#include "hierarchies.h"

/// @file
/// One compass for all tests of a program.

static bmr_compass *compass;

__attribute__((constructor)) static void make_compass(void) {
    if (bmr_compass_create(BMR_MAX_VERTICES, NULL, &compass) != BMR_OK)
        abort();
}
__attribute__((destructor)) static void drop_compass(void) {
    bmr_compass_destroy(compass, NULL);
}

/// A hierarchy of the kind by malloc; one that cannot be built fails the test.
static inline bmr_hierarchy *built(int kind, const bmr_polygon *polygon) {
    bmr_hierarchy *hierarchy = NULL;
    assert_int_equal(bmr_hierarchy_build((bmr_hierarchy_kind)kind, polygon, compass, NULL, &hierarchy),
                     BMR_OK);
    return hierarchy;
}

#endif
