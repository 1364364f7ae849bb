// SPDX-License-Identifier: MIT
// The structures on an explicit Minkowski sum (section 5): their memory, and the turns that are not for them.
#include "boomerang/minkowski.h"
#include "checks.h"
#include "failing_allocator.h"
#include "kds/point.h"
#include "kds_driver.h"
#include "structure_named.h"
#include "test_scale.h"

static const char *const names[] = {"sum-triangle-compass", "sum-triangle-dudley", "sum-lazy-compass",
                                    "sum-lazy-dudley", "sum-inflated-compass"};
#define NAMES (sizeof names / sizeof *names)

static bmr_kds *made(const char *name, const bmr_kds_def *def, const test_kds_body *a,
                     const test_kds_body *b) {
    return made_kds(test_structure(name), def, &a->shape, &b->shape);
}

static test_kds_body random_body(test_random *random) {
    const size_t sizes[] = {3, 4, 6, 11, 24, 64};
    const test_family family = (test_family)test_random_below(random, TEST_FAMILY_COUNT);
    if (test_random_below(random, 16) == 0)
        return test_kds_point_make(0.5, 0.25);
    return test_kds_body_make(
        test_polygon(family, sizes[test_random_below(random, sizeof sizes / sizeof *sizes)], random));
}

/// The memory that is set aside is enough for every rotation, and linear.
TEST(the_sum_fits_its_block_at_every_rotation) {
    test_random random = {6};
    const size_t sizes[] = {3, 4, 5, 8, 9, 33, 64, 300};
    for (int family = 0; family < TEST_FAMILY_COUNT; ++family)
        for (size_t k = 0; k < sizeof sizes / sizeof *sizes; ++k)
            for (size_t i = 0; i < NAMES; ++i) {
                own_kds_body a = test_kds_body_make(test_polygon((test_family)family, sizes[k], &random));
                own_kds_body b = random_body(&random);
                const bmr_kds_def def = bmr_default_kds_def();
                own_kds *kds = made(names[i], &def, &a, &b);
                const double n = a.polygon->count + b.polygon->count;
                assert_true((double)bmr_kds_bytes(kds) <= 1024.0 + 720.0 * n);
                for (int turn = 0; turn < 8; ++turn) {
                    bmr_instant now = {{{0.0, 0.0}, 1.0, 0.0}, {0.0, 0.0}, 0.0};
                    const double angle = 0.25 * turn * 3.14159265358979 * (turn % 3 ? 1.0 : 1.001);
                    now.pose.c = cos(angle);
                    now.pose.s = sin(angle);
                    now.pose.position.x = 4.0 * (a.polygon->extent + b.polygon->extent);
                    bmr_kds_report report;
                    bmr_kds_start(kds, &now, &report);
                    assert_true(report.apart);
                    assert_non_null(bmr_point_get(kds)->hierarchy);
                    assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_OK);
                    // The same rotation again: nothing is built.
                    const bmr_hierarchy *built = bmr_point_get(kds)->hierarchy;
                    bmr_kds_start(kds, &now, &report);
                    assert_ptr_equal(built, bmr_point_get(kds)->hierarchy);
                }
            }
}
