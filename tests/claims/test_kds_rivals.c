// SPDX-License-Identifier: MIT
// The rivals cost Theta(n) and Theta(n^2) events, and prove what they say of needles, too.
#include "checks.h"
#include "kds/features.h"
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

/// The line of a structure, and whether a mere turn has moved it.
typedef struct rolls {
    const test_kds_body *bodies[2];
    bool known;
    bmr_kds_proof line;
    size_t kept, moved;
} rolls;

/// How far the other body is beyond a line: by all of its vertices.
static double beyond(const test_kds_body *const bodies[2], const bmr_kds_proof *line,
                     const bmr_pose *b_in_a) {
    const bmr_pose a_in_b = bmr_pose_inverse(b_in_a);
    const bmr_polygon *other = bodies[1 - line->owner]->polygon;
    double least = INFINITY;
    for (uint32_t i = 0; i < other->count; i++) {
        const bmr_vec2 v = bmr_transform(line->owner == 0 ? b_in_a : &a_in_b, other->vertices[i]);
        least = fmin(least, bmr_dot(line->line.normal, v) - line->line.offset);
    }
    return least;
}

static void look_at_roll(void *context, const test_drive_event *event) {
    rolls *r = context;
    if (r->known && event->report.apart && event->failed.kind == BMR_CONDITION_TURN &&
        beyond(r->bodies, &r->line, &event->now.pose) > 1e-3) {
        r->kept += !event->report.line_changed;
        r->moved += event->report.line_changed;
    }
    r->known = bmr_kds_get_proof(event->kds, &r->line);
}

/// Another vertex is the nearest: the edge stays, though others may have more slack by now.
TEST(test_a_separating_edge_stays_while_the_nearest_vertex_changes) {
    test_random random = {10};
    own_kds_body a = test_kds_body_make(test_polygon(TEST_CIRCLE, 24, &random)),
                 b = test_kds_body_make(test_polygon(TEST_REGULAR, 24, &random));
    for (double spin = -3.0; spin <= 3.0; spin += 6.0) {
        rolls r = {.bodies = {&a, &b}};
        test_path path;
        memset(&path, 0, sizeof path);
        path.cubic[0] = bmr_vec2_make(-3.0, 3.0);
        path.cubic[1] = bmr_vec2_make(6.0, 0.0);
        path.spin = spin;
        own_kds *kds = make(&bmr_kds_separating_edge_walk, &a, &b, 1e-6);
        const test_drive d = {.path = &path, .margin = 1e-6, .on_event = look_at_roll, .context = &r};
        const test_drive_result result = test_drive_run(kds, a.polygon, b.polygon, &d);
        assert_true(test_drive_is_sound(&result));
        assert_true(r.kept >= 5 && r.moved == 0);
    }
}

/// The feature audit finds a pair of features that is not the closest one although its line separates.
TEST(test_feature_audit_finds_features_that_are_not_the_closest) {
    test_random random = {6};
    own_kds_body a = test_kds_body_make(test_polygon(TEST_CIRCLE, 40, &random)),
                 b = test_kds_body_make(test_polygon(TEST_CIRCLE, 40, &random));
    own_kds *kds = make(&bmr_kds_closest_features, &a, &b, 1e-6);
    const bmr_instant now = {test_pose_at(a.polygon, b.polygon, 1.0, 2.0, 0.5), {0.0, 0.0}, 0.0};
    bmr_feature_pair pair = {.vertex = {0, 0}, .edge_owner = -1};
    unsigned touched = 0;
    assert_true(bmr_features_start(kds, &now, &pair, &touched));
    assert_int_equal(bmr_features_audit(kds, &pair, &now.pose), BMR_OK);
    for (uint32_t step = 1; step < 40; step++) {
        bmr_feature_pair wrong = pair;
        wrong.vertex[0] = (wrong.vertex[0] + step) % a.polygon->count;
        assert_int_equal(bmr_features_audit(kds, &wrong, &now.pose), BMR_ERROR_INVALID_STRUCTURE);
    }
}

/// A triangle of length 1 with a short edge of that length, both in random directions: the normals of the
/// long edges are nearly opposite, or opposite but for rounding. NULL where rounding leaves no triangle.
static bmr_polygon *needle(double width, test_random *random) {
    const double along = test_random_uniform(random, 0.0, 6.3),
                 across = test_random_uniform(random, 0.0, 6.3);
    const bmr_vec2 tip = {cos(along), sin(along)}, way = {width * cos(across), width * sin(across)};
    const bmr_vec2 corners[] = {{0.0, 0.0}, tip, bmr_add(tip, way)};
    bmr_polygon *polygon = NULL;
    if (bmr_polygon_create(corners, 3, NULL, &polygon) == BMR_OK && polygon->count == 3)
        return polygon;
    bmr_polygon_destroy(polygon, NULL);
    return NULL;
}

/// However thin a needle is and however small the margin: what is said of it is true.
TEST(test_needles_of_any_width_are_proved) {
    test_random random = {9};
    const size_t trials = test_scaled(1500);
    size_t thin = 0;
    own_kds_body b = test_kds_body_make(test_polygon(TEST_CIRCLE, 5, &random));
    for (size_t trial = 0; trial < trials; trial++) {
        const double width = exp(test_random_uniform(&random, log(1e-17), 0.0));
        const double margin = exp(test_random_uniform(&random, log(1e-14), log(1e-2)));
        bmr_polygon *polygon = needle(width, &random);
        if (!polygon)
            continue;
        thin += width < 1e-14;
        test_kds_body a = test_kds_body_make(polygon);
        const test_kds_body *p = trial % 2 == 0 ? &a : &b, *q = trial % 2 == 0 ? &b : &a;
        const bmr_pose pose =
            test_pose_at(p->polygon, q->polygon, test_random_uniform(&random, 0.0, 6.3),
                         test_random_uniform(&random, 0.0, 6.3), test_random_uniform(&random, 0.05, 1.0));
        const bmr_instant now = {pose, {0.0, 0.0}, 0.0};
        for (size_t k = 0; k < RIVALS; k++) {
            own_kds *kds = make(rivals[k], p, q, margin);
            bmr_kds_report report;
            bmr_kds_start(kds, &now, &report);
            assert_true(report.apart);
            if (bmr_kds_audit(kds, &now.pose) != BMR_OK)
                fail_msg("%s: trial %zu, width %g, margin %g", rivals[k]->name, trial, width, margin);
        }
        test_kds_body_destroy(&a);
    }
    assert_true(thin > trials / 100);
}
