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

/// A path with a turn in it: the sum of the first rotation is not that of the others.
TEST(a_turn_is_out_of_their_domain_and_found_out) {
    test_random random = {5};
    unsigned wrong = 0;
    for (int round = 0; round < 20; ++round) {
        own_kds_body a = test_kds_body_make(test_polygon(TEST_ELLIPSE, 24, &random));
        own_kds_body b = test_kds_body_make(test_polygon(TEST_ELLIPSE, 24, &random));
        const test_path path = test_path_make(TEST_PATH_LINE, a.polygon, b.polygon, 0.01, true, &random);
        const test_drive how = {.path = &path, .resolution = 1e-4};
        const bmr_kds_def def = bmr_default_kds_def();
        own_kds *kds = made("sum-lazy-compass", &def, &a, &b);
        const test_drive_result r = test_drive_run(kds, a.polygon, b.polygon, &how);
        wrong += !test_drive_is_sound(&r);
    }
    assert_true(wrong > 5);
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

TEST(creation_asks_for_one_block_and_may_fail) {
    test_random random = {8};
    own_kds_body a = random_body(&random), b = random_body(&random);
    const bmr_kds_def def = bmr_default_kds_def();
    for (size_t i = 0; i < NAMES; ++i)
        for (size_t fail_at = 0; fail_at < 2; ++fail_at) {
            test_heap heap;
            test_heap_init(&heap, fail_at);
            bmr_kds *kds = NULL;
            const bmr_error error =
                bmr_kds_create(test_structure(names[i]), &def, &a.shape, &b.shape, &heap.allocator, &kds);
            assert_int_equal(error, fail_at == 0 ? BMR_ERROR_NO_MEMORY : BMR_OK);
            bmr_instant now = {{{9.0, 0.0}, 1.0, 0.0}, {0.0, 0.0}, 0.0};
            bmr_kds_report report;
            if (kds)
                bmr_kds_start(kds, &now, &report);
            assert_int_equal(heap.asked, 1);
            bmr_kds_destroy(kds, &heap.allocator);
            assert_int_equal(heap.blocks, 0);
        }
}
