// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_COMPASS_FIXTURE_H
#define BMR_TEST_COMPASS_FIXTURE_H

#include "hierarchies.h"

/// @file
/// A group fixture of cmocka: one compass table for all tests of a program. To be included behind cmocka.h.

static bmr_compass *compass;

static int make_compass(void **state) {
    (void)state;
    return bmr_compass_create(BMR_MAX_VERTICES, NULL, &compass) == BMR_OK ? 0 : -1;
}

static int drop_compass(void **state) {
    (void)state;
    bmr_compass_destroy(compass, NULL);
    return 0;
}

/// A hierarchy of the kind by malloc; one that cannot be built fails the test.
static inline bmr_hierarchy *built(int kind, const bmr_polygon *polygon) {
    bmr_hierarchy *hierarchy = NULL;
    assert_int_equal(test_build_hierarchy((bmr_hierarchy_kind)kind, polygon, compass, NULL, &hierarchy),
                     BMR_OK);
    return hierarchy;
}

#endif
