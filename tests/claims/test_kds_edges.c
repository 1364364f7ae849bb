// SPDX-License-Identifier: MIT
// What boomerang/kds.h promises of every structure on separating edges of hierarchies: for points, on
// explicit sums, and the lazy ones of two polygons.

#include "checks.h"
#include <math.h>
#include <string.h>

#include "kds_driver.h"
#include "motions.h"
#include "structure_named.h"

static const char *const names[] = {
    "triangle-levels-compass",       "triangle-levels-dudley", "triangle-binary-compass",
    "triangle-binary-dudley",        "point-lazy-compass",     "point-lazy-dudley",
    "point-lazy-dobkin-kirkpatrick", "point-inflated-compass", "point-inflated-dudley",
    "point-inflated-slack",          "point-complex",          "sum-triangle-compass",
    "sum-triangle-dudley",           "sum-lazy-compass",       "sum-lazy-dudley",
    "sum-inflated-compass",          "lazy-compass",           "lazy-dudley",
    "lazy-dobkin-kirkpatrick"};
#define NAMES (sizeof names / sizeof *names)

static const bmr_kds_info *info_of(size_t i) {
    const bmr_kds_info *info = test_structure(names[i]);
    assert_non_null(info);
    return info;
}

static test_kds_body regular(size_t n) {
    test_random random = {n};
    return test_kds_body_make(test_polygon(TEST_REGULAR, n, &random));
}

static test_kds_body other_body(size_t i, size_t n) {
    return info_of(i)->domain == BMR_KDS_POINT ? test_kds_point_make(0.125, 0.0) : regular(n);
}

static bmr_kds *made(size_t i, const bmr_kds_def *def, const test_kds_body *a, const test_kds_body *b) {
    bmr_kds *kds = NULL;
    assert_int_equal(bmr_kds_create(info_of(i), def, &a->shape, &b->shape, NULL, &kds), BMR_OK);
    return kds;
}

static bmr_instant at_gap(const test_kds_body *a, const test_kds_body *b, double gap) {
    const bmr_instant now = {test_pose_at(a->polygon, b->polygon, 0.3, 0.5, gap), {0.0, 0.0}, 0.0};
    return now;
}

TEST(an_early_repair_reports_none_and_changes_nothing) {
    for (size_t i = 0; i < NAMES; ++i) {
        test_kds_body a = regular(24), b = other_body(i, 16);
        const bmr_kds_def def = bmr_default_kds_def();
        bmr_kds *kds = made(i, &def, &a, &b);
        const bmr_instant now = at_gap(&a, &b, 0.02);
        bmr_condition before[BMR_KDS_MAX_CONDITIONS], after[BMR_KDS_MAX_CONDITIONS];
        bmr_kds_report report;
        assert_int_equal(bmr_kds_conditions(kds, before), 0); // nothing known yet
        bmr_kds_start(kds, &now, &report);
        assert_int_equal(report.kind, BMR_KDS_START);
        assert_true(report.apart && report.touched > 0);
        const size_t count = bmr_kds_conditions(kds, before);
        assert_true(count >= 1 && count <= BMR_KDS_MAX_CONDITIONS);
        for (size_t k = 0; k < count; ++k) {
            assert_true(bmr_condition_value(&before[k], &now.pose) > 0.0);
            bmr_kds_repair(kds, &now, k, &report);
            assert_int_equal(report.kind, BMR_KDS_NONE);
            assert_true(report.apart && !report.line_changed);
            assert_int_equal(report.level_before, report.level_after);
            assert_int_equal(bmr_kds_conditions(kds, after), count);
            assert_memory_equal(before, after, count * sizeof *before);
        }
        // The control: a repair that is due does something.
        bmr_instant later = now; // on the other side
        later.pose = test_pose_at(a.polygon, b.polygon, 0.3 + 3.14, 0.5, 0.02);
        bmr_kds_repair(kds, &later, 0, &report);
        assert_int_not_equal(report.kind, BMR_KDS_NONE);
        bmr_kds_destroy(kds, NULL);
        test_kds_body_destroy(&a);
        test_kds_body_destroy(&b);
    }
}

TEST(contact_is_left_beyond_margin_and_hysteresis_only) {
    for (size_t i = 0; i < NAMES; ++i) {
        test_kds_body a = regular(24), b = other_body(i, 16);
        bmr_kds_def def = bmr_default_kds_def();
        def.margin = 1e-3;
        def.hysteresis = 1e-2;
        bmr_kds *kds = made(i, &def, &a, &b);
        bmr_kds_report report;
        const double gaps[] = {-0.1, 0.5e-3, 5e-3, 5e-2, 5e-3, 0.9e-3};
        const bmr_kds_event_kind kinds[] = {BMR_KDS_CONTACT, BMR_KDS_CONTACT, BMR_KDS_CONTACT,
                                            BMR_KDS_LEAVE,   BMR_KDS_START,   BMR_KDS_CONTACT};
        for (size_t k = 0; k < sizeof gaps / sizeof *gaps; ++k) {
            // In the direction of a vertex: the gap is the distance.
            bmr_instant now = at_gap(&a, &b, 0.0);
            const bmr_vec2 u = {cos(0.3), sin(0.3)};
            uint32_t steps = 0;
            double low = -1.0, high = 1.0; // where the distance is the gap
            while (steps++ < 60) {
                const double middle = 0.5 * (low + high);
                bmr_instant there = now;
                there.pose.position = bmr_add(now.pose.position, bmr_scale(middle, u));
                const double distance = test_distance(a.polygon, b.polygon, &there.pose);
                if (distance > gaps[k])
                    high = middle;
                else
                    low = middle;
            }
            now.pose.position = bmr_add(now.pose.position, bmr_scale(gaps[k] < 0.0 ? -0.1 : high, u));
            bmr_kds_start(kds, &now, &report);
            assert_int_equal(report.kind, kinds[k]);
            assert_true(bmr_kds_in_contact(kds) == (kinds[k] == BMR_KDS_CONTACT));
            bmr_kds_proof proof;
            assert_true(bmr_kds_get_proof(kds, &proof) == !bmr_kds_in_contact(kds));
            assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_OK);
        }
        bmr_kds_destroy(kds, NULL);
        test_kds_body_destroy(&a);
        test_kds_body_destroy(&b);
    }
}

TEST(the_state_does_not_grow_with_the_polygons_unless_it_says_so) {
    for (size_t i = 0; i < NAMES; ++i) {
        size_t bytes[2];
        for (int large = 0; large < 2; ++large) {
            test_kds_body a = regular(large ? 500 : 8), b = other_body(i, large ? 500 : 8);
            const bmr_kds_def def = bmr_default_kds_def();
            bmr_kds *kds = made(i, &def, &a, &b);
            bytes[large] = bmr_kds_bytes(kds);
            bmr_kds_destroy(kds, NULL);
            test_kds_body_destroy(&a);
            test_kds_body_destroy(&b);
        }
        const bool linear = strstr(names[i], "sum-") || strstr(names[i], "-binary-");
        assert_true(linear ? bytes[1] > 4 * bytes[0] : bytes[1] == bytes[0]);
        assert_true(bytes[0] <= 16384 && (linear || bytes[0] <= 512));
    }
}

/// Vertex against vertex, nearer than any edge's line would allow: the line is the closest direction's own.
/// It is repaired like any other, whether B turns, goes round A, or both.
TEST(a_free_line_is_repaired_like_that_of_an_edge) {
    const double lean = 0.4; // else an edge of the rectangle around would do
    const double quarter = 0.5 * 3.14159265358979323846;
    bmr_vec2 diamond[4];
    for (int k = 0; k < 4; ++k)
        diamond[k] = bmr_vec2_make(cos(lean + quarter * k), sin(lean + quarter * k));
    static const struct {
        double around, turned; ///< quarter turns: where B is, and by how much it has turned
    } ways[] = {{0, 1}, {1, 1}, {1, 2}, {2, 3}, {3, 3}, {2, 2}, {0, 1}, {1, 1}, {2, 1}, {0, 0}};
    for (size_t i = 0; i < NAMES; ++i) {
        bmr_polygon *square = NULL;
        assert_int_equal(bmr_polygon_create(diamond, 4, NULL, &square), BMR_OK);
        test_kds_body a = test_kds_body_make(square), b;
        const bool point = info_of(i)->domain == BMR_KDS_POINT;
        if (point) {
            b = test_kds_point_make(0.0, 0.0);
        } else {
            assert_int_equal(bmr_polygon_create(diamond, 4, NULL, &square), BMR_OK);
            b = test_kds_body_make(square);
        }
        bmr_kds_def def = bmr_default_kds_def();
        def.margin = 0.01;
        bmr_kds *kds = made(i, &def, &a, &b);
        const double away = (point ? 1.0 : 2.0) + 1.05 * def.margin;
        bmr_kds_report report;
        bmr_instant now = {{{away * cos(lean), away * sin(lean)}, 1.0, 0.0}, {0.0, 0.0}, 0.0};
        bmr_kds_start(kds, &now, &report);
        assert_true(report.apart);
        for (size_t k = 0; k < sizeof ways / sizeof *ways; ++k) {
            const double at = lean + quarter * ways[k].around;
            now.pose.position = bmr_vec2_make(away * cos(at), away * sin(at));
            const bool turns = !point && info_of(i)->domain == BMR_KDS_RIGID;
            now.pose.c = turns ? cos(quarter * ways[k].turned) : 1.0;
            now.pose.s = turns ? sin(quarter * ways[k].turned) : 0.0;
            bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
            const size_t count = bmr_kds_conditions(kds, conditions);
            for (size_t c = 0; c < count; ++c)
                if (!(bmr_condition_value(&conditions[c], &now.pose) > 0.0)) {
                    bmr_kds_repair(kds, &now, c, &report);
                    assert_true(report.apart);
                    break;
                }
            assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_OK);
        }
        bmr_kds_destroy(kds, NULL);
        test_kds_body_destroy(&a);
        test_kds_body_destroy(&b);
    }
}

TEST(no_pose_is_contact_and_no_point_is_an_error) {
    test_kds_body a = regular(8), b = regular(5), point = test_kds_point_make(0.0, 0.0);
    const bmr_kds_def def = bmr_default_kds_def();
    for (size_t i = 0; i < NAMES; ++i) {
        bmr_kds *kds = NULL;
        if (info_of(i)->domain == BMR_KDS_POINT)
            assert_int_equal(bmr_kds_create(info_of(i), &def, &a.shape, &b.shape, NULL, &kds),
                             BMR_ERROR_OUT_OF_RANGE);
        bmr_shape bare = {.polygon = a.polygon};
        if (info_of(i)->hierarchy >= 0)
            assert_int_equal(bmr_kds_create(info_of(i), &def, &bare, &point.shape, NULL, &kds),
                             BMR_ERROR_NULL_ARGUMENT);
        assert_null(kds);
        kds = made(i, &def, &a, &point);
        bmr_instant now = at_gap(&a, &point, 0.5);
        bmr_kds_report report;
        bmr_kds_start(kds, &now, &report);
        assert_true(report.apart);
        now.pose.position.x = NAN;
        bmr_kds_repair(kds, &now, 0, &report);
        assert_int_equal(report.kind, BMR_KDS_CONTACT);
        assert_true(bmr_kds_in_contact(kds));
        bmr_kds_destroy(kds, NULL);
    }
    test_kds_body_destroy(&point);
    test_kds_body_destroy(&b);
    test_kds_body_destroy(&a);
}
