// SPDX-License-Identifier: MIT
// The structures for one point and one polygon (sections 5 and 6) on random motions, against brute force.

#include "checks.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "boomerang/inflated.h"
#include "kds/point.h"
#include "kds_driver.h"
#include "test_scale.h"

static bmr_kds *made(const bmr_kds_info *info, const bmr_kds_def *def, const test_kds_body *a,
                     const test_kds_body *b) {
    bmr_kds *kds = NULL;
    assert_int_equal(bmr_kds_create(info, def, &a->shape, &b->shape, NULL, &kds), BMR_OK);
    return kds;
}

static bool is_for_points(const bmr_kds_info *info) {
    return info->domain == BMR_KDS_POINT && info->role != BMR_KDS_RIVAL;
}

/// Random polygon, point, motion, margin.
static void random_drive(const bmr_kds_info *info, test_random *random, uint64_t *events,
                         uint64_t *contacts) {
    const size_t sizes[] = {3, 4, 6, 11, 24, 64};
    const test_family family = (test_family)test_random_below(random, TEST_FAMILY_COUNT);
    const size_t n = sizes[test_random_below(random, sizeof sizes / sizeof *sizes)];
    // Some are tiny, huge, or far from the origins of their frames.
    const double scales[] = {1.0, 1.0, 1.0, 1e-4, 1e3};
    const double scale = scales[test_random_below(random, 5)];
    const double shift = test_random_below(random, 3) == 0 ? 5.0 * scale : 0.0;
    test_kds_body a = test_kds_body_make_scaled(test_polygon(family, n, random), scale, shift);
    test_kds_body b =
        test_kds_point_make(scale * test_random_uniform(random, -1.0, 1.0), 0.25 * scale + shift);
    bmr_kds_def def = bmr_default_kds_def();
    def.margin = 1e-6 * a.polygon->radius;
    const test_path_kind kind = (test_path_kind)test_random_below(random, TEST_PATH_KIND_COUNT);
    const double gap = a.polygon->radius * exp(test_random_uniform(random, log(1e-4), log(1.0)));
    const test_path path =
        test_path_make(kind, a.polygon, b.polygon, gap, test_random_below(random, 2) == 0, random);
    const test_drive how = {.path = &path, .resolution = 1e-5, .margin = def.margin};
    bmr_kds *kds = made(info, &def, &a, &b);
    const test_drive_result r = test_drive_run(kds, a.polygon, b.polygon, &how);
    if (!test_drive_is_sound(&r))
        printf("%s: %s n=%zu path %d: audits %u (%s) dead %u contacts %u false %u missed none %u\n",
               info->name, test_family_name(family), n, kind, r.false_audits, bmr_error_describe(r.error),
               r.dead_repairs, r.false_contacts, r.missed_contacts, r.changed_by_none);
    assert_true(test_drive_is_sound(&r));
    if (kind == TEST_PATH_HIT)
        assert_true(r.contact_time < 1.0);
    *events += test_drive_events(&r);
    *contacts += r.events[BMR_KDS_CONTACT];
    bmr_kds_destroy(kds, NULL);
    test_kds_body_destroy(&a);
    test_kds_body_destroy(&b);
}

TEST(every_structure_is_valid_on_random_motions) {
    size_t structures = 0;
    for (size_t i = 0; i < bmr_kds_count(); ++i) {
        const bmr_kds_info *info = bmr_kds_at(i);
        if (!is_for_points(info))
            continue;
        ++structures;
        test_random random = {101};
        uint64_t events = 0, contacts = 0;
        const size_t rounds = 20 + test_scaled(400); // rare events want some rounds at any scale
        for (size_t round = 0; round < rounds; ++round)
            random_drive(info, &random, &events, &contacts);
        assert_true(events > rounds && contacts > rounds / 8);
    }
    assert_true(structures >= 3);
}
