// SPDX-License-Identifier: MIT
#include "checks.h"
#include "kds_driver.h"
#include "motions.h"

/// @file
/// The structures on the mixed hierarchy on a border of a cell, along it. (On motions of every kind, aligned
/// bodies and jumps among them: random/fuzz_structures.cpp.)

#define TWO_PI 6.283185307179586
static const char *const names[] = {"active-cell-compass", "active-cell-dudley", "tiling-dudley"};

static test_kds_body random_body(test_random *random) {
    const test_family family = (test_family)test_random_below(random, TEST_FAMILY_COUNT);
    return test_kds_body_make(test_polygon(family, 3 + test_random_below(random, 40), random));
}

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
    test_random random = test_random_from(513);
    bmr_kds_def def = bmr_default_kds_def();
    def.margin = 1e-6;
    size_t crossed = 0, grown = 0;
    for (size_t round = 0; round < test_scaled(400); ++round) {
        own_kds_body a = random_body(&random), b = random_body(&random);
        const double size = a.polygon->radius + b.polygon->radius;
        const double gap = size * exp(test_random_uniform(&random, log(1e-4), log(0.2)));
        const double extents = a.polygon->extent + b.polygon->extent;
        const bmr_pose at = test_pose_at(a.polygon, b.polygon, test_random_uniform(&random, 0.0, TWO_PI),
                                         test_random_uniform(&random, 0.0, TWO_PI), gap);
        for (size_t i = 0; i < 4; ++i) {
            own_kds *kds = made_kds(test_structure(names[round % COUNT_OF(names)]), &def, &a.shape, &b.shape);
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
                if (round % 4 == 0)
                    now.velocity = bmr_vec2_make(0.0, 0.0); // unknown: straight on
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
