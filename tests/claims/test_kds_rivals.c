// SPDX-License-Identifier: MIT
// The rivals cost Theta(n) and Theta(n^2) events.
#include "checks.h"
#include "kds/registry.h"
#include "kds_driver.h"
#include "motions.h"
#include "test_scale.h"

#define RIVALS 3
static const bmr_kds_info *const rivals[RIVALS] = {&bmr_kds_closest_features, &bmr_kds_inner_tangent,
                                                   &bmr_kds_separating_edge_walk};

static bmr_kds *make(const bmr_kds_info *info, const test_kds_body *a, const test_kds_body *b,
                     double margin) {
    bmr_kds_def def = bmr_default_kds_def();
    def.margin = margin;
    return made_kds(info, &def, &a->shape, &b->shape);
}

static test_drive_result drive(const bmr_kds_info *info, const test_kds_body *a, const test_kds_body *b,
                               const test_path *path, double margin) {
    own_kds *kds = make(info, a, b, margin);
    const test_drive d = {.path = path, .margin = margin};
    const test_drive_result r = test_drive_run(kds, a->polygon, b->polygon, &d);
    return r;
}

/// Events of a rival that a line past regular n-gons at a distance costs, or a turn in place.
static uint64_t regular_events(const bmr_kds_info *info, size_t n, bool turns) {
    bmr_vec2 points[128];
    bmr_polygon *polygons[2];
    for (int k = 0; k < 2; k++) {
        test_regular_points(n, 1.0, 0.1 + 0.3 * k, points);
        assert_int_equal(bmr_polygon_create(points, n, NULL, &polygons[k]), BMR_OK);
    }
    own_kds_body a = test_kds_body_make(polygons[0]), b = test_kds_body_make(polygons[1]);
    test_path path;
    memset(&path, 0, sizeof path);
    path.cubic[0] = bmr_vec2_make(turns ? 0.0 : -30.0, 3.0);
    path.cubic[1] = bmr_vec2_make(turns ? 0.0 : 60.0, 0.0);
    path.spin = turns ? 6.283185307179586 : 0.0;
    const test_drive_result r = drive(info, &a, &b, &path, 1e-6);
    assert_true(test_drive_is_sound(&r));
    return test_drive_events(&r);
}

TEST(test_a_pass_and_a_turn_cost_events_in_proportion_to_n) {
    for (int turns = 0; turns < 2; turns++)
        for (size_t k = 0; k < RIVALS; k++) {
            const uint64_t few = regular_events(rivals[k], 16, turns),
                           many = regular_events(rivals[k], 128, turns);
            printf("%s, %s: %d events for n = 16, %d for 128\n", rivals[k]->name, turns ? "turn" : "pass",
                   (int)few, (int)many);
            assert_true(few >= 7);
            // Eight times, and an end; the corners of a coarse body that turns rock the other's feature too.
            assert_true(many >= (turns ? 5 : 7) * few && many <= 9 * few);
        }
}
