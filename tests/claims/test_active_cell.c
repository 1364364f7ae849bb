// SPDX-License-Identifier: MIT
#include "checks.h"
#include "kds_driver.h"
#include "motions.h"

/// @file
/// The structures on the mixed hierarchy where they are hard. (On motions of every kind:
/// random/fuzz_structures.cpp.)

#define TWO_PI 6.283185307179586
static const char *const names[] = {"active-cell-compass", "active-cell-dudley", "tiling-dudley"};

static bmr_kds *made(const char *name, const test_kds_body *a, const test_kds_body *b, double margin) {
    bmr_kds_def def = bmr_default_kds_def();
    def.margin = margin;
    const bmr_kds_info *info = test_structure(name);
    assert_non_null(info);
    return made_kds(info, &def, &a->shape, &b->shape);
}

static test_kds_body random_body(test_random *random) {
    const test_family family = (test_family)test_random_below(random, TEST_FAMILY_COUNT);
    return test_kds_body_make(test_polygon(family, 3 + test_random_below(random, 40), random));
}

/// Boxes, octagons and regular polygons at multiples of a right angle, moving along the axes on the lines of
/// their own sides: without the displacement the point would move along borders of cells.
TEST(aligned_bodies_on_aligned_ways_are_no_trap) {
    static const test_family families[] = {TEST_BOX, TEST_OCTAGON, TEST_GRID, TEST_PARALLEL, TEST_TURNED_BOX};
    test_random random = {505};
    for (size_t round = 0; round < test_scaled(120); ++round) {
        own_kds_body a = test_kds_body_make(test_polygon(families[round % COUNT_OF(families)], 12, &random));
        own_kds_body b = test_random_below(&random, 3) == 0
                             ? test_kds_point_make(0.0, 0.0)
                             : test_kds_body_make(test_polygon(
                                   families[test_random_below(&random, COUNT_OF(families))], 12, &random));
        const double size = 2.0 * (a.polygon->extent + b.polygon->extent);
        test_path path;
        memset(&path, 0, sizeof path);
        // Some vertex of B moves along some vertex of A's level or upright line.
        const bmr_vec2 p = a.polygon->vertices[test_random_below(&random, a.polygon->count)];
        const bmr_vec2 q = b.polygon->vertices[test_random_below(&random, b.polygon->count)];
        const bool upright = test_random_below(&random, 2) != 0;
        path.cubic[0] = bmr_sub(p, q);
        *(upright ? &path.cubic[0].y : &path.cubic[0].x) -= size;
        *(upright ? &path.cubic[1].y : &path.cubic[1].x) = 2.0 * size;
        const char *name = names[round % COUNT_OF(names)];
        own_kds *kds = made(name, &a, &b, 1e-6);
        const test_drive drive = {.path = &path};
        const test_drive_result result = test_drive_run(kds, a.polygon, b.polygon, &drive);
        assert_true(test_drive_is_sound(&result));
    }
}

// --- poses that come in steps, rates unknown ---

static size_t first_failed(const bmr_kds *kds, const bmr_pose *pose) {
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_kds_conditions(kds, conditions);
    size_t i = 0;
    while (i < count && bmr_condition_value(&conditions[i], pose) > 0.0)
        ++i;
    return i == count ? SIZE_MAX : i;
}

/// Whatever the pose, one repair makes all conditions true there, or finds contact.
TEST(a_repair_after_any_jump_leads_to_the_right_cell) {
    test_random random = {507};
    size_t repairs = 0, failed_before = 0;
    for (size_t round = 0; round < test_scaled(60); ++round) {
        own_kds_body a = random_body(&random), b = random_body(&random);
        test_motion motion = test_motion_make((test_motion_kind)(round % TEST_MOTION_KIND_COUNT), a.polygon,
                                              b.polygon, &random);
        own_kds *kds = made(names[round / TEST_MOTION_KIND_COUNT % 2], &a, &b, 1e-6);
        bmr_kds_report report;
        for (int step = 0; step < 200; ++step) {
            const bmr_instant now = {test_motion_next(&motion, &random), {0.0, 0.0}, 0.0};
            if (bmr_kds_in_contact(kds) || step == 0)
                bmr_kds_start(kds, &now, &report);
            const size_t failed = bmr_kds_in_contact(kds) ? SIZE_MAX : first_failed(kds, &now.pose);
            if (failed != SIZE_MAX) {
                failed_before += bmr_kds_audit(kds, &now.pose) != BMR_OK; // control: it was wrong
                bmr_kds_repair(kds, &now, failed, &report);
                ++repairs;
                assert_int_not_equal(report.kind, BMR_KDS_NONE);
            }
            if (!bmr_kds_in_contact(kds))
                assert_true(first_failed(kds, &now.pose) == SIZE_MAX);
            assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_OK);
        }
    }
    assert_true(repairs > 0 && failed_before > repairs / 2);
}

// --- on a border, along it ---

/// Moves B until condition `i` is not positive, by no more than a few roundings. False: other borders are too
/// near.
static bool put_on_border(const bmr_kds *kds, size_t i, bmr_pose *pose, bmr_vec2 *inwards) {
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_kds_conditions(kds, conditions);
    const bmr_condition *border = &conditions[i];
    if (border->kind != BMR_CONDITION_BEYOND)
        return false;
    *inwards = border->owner == 0 ? border->normal : bmr_neg(bmr_rotate(pose, border->normal));
    for (int step = 0; step < 50 && bmr_condition_value(border, pose) > 0.0; ++step)
        pose->position = bmr_add(
            pose->position, bmr_scale(-bmr_condition_value(border, pose) - (double)step * 0x1p-54, *inwards));
    bool far = fabs(bmr_condition_value(border, pose)) < 1e-14;
    for (size_t k = 0; k < count; ++k)
        far = far && (k == i || bmr_condition_value(&conditions[k], pose) > 1e-6);
    return far;
}

/// The point goes over a side at a small angle, so that nothing but the rate tells on which side it will be:
/// a cell that is kept would be left again at the same time, for ever.
TEST(a_border_crossed_at_any_angle_is_crossed) {
    test_random random = {513};
    size_t crossed = 0, grown = 0;
    for (size_t round = 0; round < test_scaled(400); ++round) {
        own_kds_body a = random_body(&random), b = random_body(&random);
        const double size = a.polygon->radius + b.polygon->radius;
        const double gap = size * exp(test_random_uniform(&random, log(1e-4), log(0.2)));
        const double extents = a.polygon->extent + b.polygon->extent;
        const bmr_pose at = test_pose_at(a.polygon, b.polygon, test_random_uniform(&random, 0.0, TWO_PI),
                                         test_random_uniform(&random, 0.0, TWO_PI), gap);
        for (size_t i = 0; i < 4; ++i) {
            own_kds *kds = made(names[round % COUNT_OF(names)], &a, &b, 1e-6);
            bmr_instant now = {at, {0.0, 0.0}, 0.0};
            bmr_kds_report report;
            bmr_kds_start(kds, &now, &report);
            bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
            bmr_vec2 inwards;
            if (i < bmr_kds_conditions(kds, conditions) && put_on_border(kds, i, &now.pose, &inwards)) {
                const double slope = exp(test_random_uniform(&random, log(1e-12), log(1e-2)));
                now.velocity = bmr_add(bmr_scale(size, bmr_left(inwards)), bmr_scale(-slope * size, inwards));
                if (bmr_condition_value(&conditions[i], &now.pose) > -0x1p-51 * extents) {
                    // Controls: on the way back in nothing has failed; and what is kept is seen.
                    const bmr_instant back = {now.pose, bmr_scale(size, inwards), 0.0};
                    bmr_kds_repair(kds, &back, i, &report);
                    assert_int_equal(report.kind, BMR_KDS_NONE);
                    assert_true(test_waits_for(kds, &conditions[i]));
                    ++grown;
                }
                bmr_kds_repair(kds, &now, i, &report);
                assert_int_not_equal(report.kind, BMR_KDS_NONE);
                assert_true(!report.apart || !test_waits_for(kds, &conditions[i]));
                ++crossed;
            }
        }
    }
    printf("%zu borders crossed\n", crossed);
    assert_true(crossed > test_scaled(400) && grown > crossed / 2);
}
