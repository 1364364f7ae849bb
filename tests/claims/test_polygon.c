// SPDX-License-Identifier: MIT
#include "boomerang/mass.h"
#include "boomerang/polygon.h"
#include "checks.h"
#include "failing_allocator.h"
#include "polygons.h"

/// What an output that must stay untouched points to.
static bmr_polygon untouched;
#define UNTOUCHED (&untouched)

TEST(each_error_has_its_own_sentence) {
    for (int i = 0; i < BMR_ERROR_COUNT; ++i) {
        const char *text = bmr_error_describe((bmr_error)i);
        assert_non_null(text);
        assert_true(strlen(text) > 5);
        assert_int_not_equal(text[strlen(text) - 1], '.');
        for (int j = 0; j < i; ++j)
            assert_string_not_equal(text, bmr_error_describe((bmr_error)j));
    }
    assert_non_null(bmr_error_describe(BMR_ERROR_COUNT));
    assert_non_null(bmr_error_describe((bmr_error)12345));
}

// --- hull ---

static bmr_polygon *hull_of(const bmr_vec2 *points, size_t count) {
    bmr_polygon *polygon = made_polygon(points, count);
    assert_int_equal(bmr_polygon_audit(polygon), BMR_OK);
    return polygon;
}

static void assert_vertices(const bmr_polygon *polygon, const bmr_vec2 *expected, uint32_t count) {
    assert_int_equal(polygon->count, count);
    for (uint32_t i = 0; i < count; ++i) {
        assert_true(polygon->vertices[i].x == expected[i].x);
        assert_true(polygon->vertices[i].y == expected[i].y);
    }
}

// --- errors ---

typedef bmr_error (*create_function)(const bmr_vec2 *, size_t, const bmr_allocator *, bmr_polygon **);
static const create_function creators[] = {bmr_polygon_create, bmr_polygon_create_raw};

static void assert_refused(const bmr_vec2 *points, size_t count, bmr_error expected) {
    for (size_t i = 0; i < COUNT_OF(creators); ++i) {
        bmr_polygon *polygon = UNTOUCHED;
        assert_int_equal(creators[i](points, count, NULL, &polygon), expected);
        assert_ptr_equal(polygon, UNTOUCHED);
    }
}

TEST(bad_points_are_refused_and_leave_the_output_alone) {
    bmr_vec2 square[4];
    test_box_points(1.0, 1.0, square);
    assert_refused(square, 0, BMR_ERROR_NO_POINTS);
    assert_refused(NULL, 0, BMR_ERROR_NO_POINTS);
    assert_refused(NULL, 3, BMR_ERROR_NULL_ARGUMENT);
    for (size_t i = 0; i < COUNT_OF(creators); ++i)
        assert_int_equal(creators[i](square, 4, NULL, NULL), BMR_ERROR_NULL_ARGUMENT);
    const double bad[] = {NAN, INFINITY, -INFINITY, 1.0000001e9, -2e9};
    for (size_t i = 0; i < COUNT_OF(bad); ++i)
        for (size_t at = 0; at < 4; ++at) {
            const bmr_error expected = isfinite(bad[i]) ? BMR_ERROR_OUT_OF_RANGE : BMR_ERROR_NOT_FINITE;
            bmr_vec2 points[4];
            test_box_points(1.0, 1.0, points);
            points[at].x = bad[i];
            assert_refused(points, 4, expected);
            points[at] = bmr_vec2_make(0.0, bad[i]);
            assert_refused(points, 4, expected);
        }
    const bmr_vec2 too_small[] = {{0, 0}, {0.9e-9, 0}, {0, 0.9e-9}}, too_short[] = {{1, 1}, {1 + 1e-12, 1}};
    assert_refused(too_small, 3, BMR_ERROR_OUT_OF_RANGE);
    assert_refused(too_short, 2, BMR_ERROR_OUT_OF_RANGE);
}

TEST(more_than_65535_points_are_refused_and_65535_are_not) {
    bmr_vec2 *points = malloc(65536 * sizeof *points);
    assert_non_null(points);
    test_regular_points(65536, 1.0, 0.0, points);
    assert_refused(points, 65536, BMR_ERROR_TOO_MANY_POINTS);
    test_regular_points(65535, 1.0, 0.0, points);
    own_polygon *polygon = hull_of(points, 65535);
    assert_int_equal(polygon->count, 65535);
    free(points);
}

// --- audit ---

TEST(audit_refuses_what_is_not_strictly_convex) {
    const bmr_vec2 clockwise[] = {{0, 0}, {0, 1}, {1, 0}};
    const bmr_vec2 collinear[] = {{0, 0}, {1, 0}, {2, 0}, {0, 2}};
    const bmr_vec2 dented[] = {{0, 0}, {2, 0}, {1, 0.5}, {0, 2}};
    const bmr_vec2 twice_the_same[] = {{1, 1}, {1, 1}, {2, 2}};
    bmr_vec2 star[5], round[5];
    test_regular_points(5, 1.0, 0.3, round);
    for (size_t i = 0; i < 5; ++i) // all left turns, but twice round
        star[i] = round[2 * i % 5];
    const struct {
        const bmr_vec2 *points;
        size_t count;
        bmr_error expected;
    } cases[] = {{clockwise, 3, BMR_ERROR_NOT_CONVEX}, {collinear, 4, BMR_ERROR_NOT_CONVEX},
                 {dented, 4, BMR_ERROR_NOT_CONVEX},    {twice_the_same, 3, BMR_ERROR_NOT_CONVEX},
                 {star, 5, BMR_ERROR_NOT_CONVEX},      {round, 5, BMR_OK}};
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        own_polygon *polygon = NULL;
        assert_int_equal(bmr_polygon_create_raw(cases[i].points, cases[i].count, NULL, &polygon), BMR_OK);
        assert_vertices(polygon, cases[i].points, (uint32_t)cases[i].count);
        assert_int_equal(bmr_polygon_audit(polygon), cases[i].expected);
    }
    assert_int_equal(bmr_polygon_audit(NULL), BMR_ERROR_NULL_ARGUMENT);
}

TEST(audit_refuses_wrong_measures) {
    bmr_vec2 points[16];
    test_regular_points(16, 1.0, 0.1, points);
    bmr_polygon *polygon = hull_of(points, 16);
    const bmr_polygon good = *polygon;
    polygon->radius = 0.999 * good.radius;
    assert_int_equal(bmr_polygon_audit(polygon), BMR_ERROR_INVALID_STRUCTURE);
    *polygon = good;
    polygon->extent = nextafter(good.extent, 0.0);
    assert_int_equal(bmr_polygon_audit(polygon), BMR_ERROR_INVALID_STRUCTURE);
    *polygon = good;
    polygon->highest = (uint16_t)(good.highest + 1);
    assert_int_equal(bmr_polygon_audit(polygon), BMR_ERROR_INVALID_STRUCTURE);
    *polygon = good;
    polygon->lowest = 1;
    assert_int_equal(bmr_polygon_audit(polygon), BMR_ERROR_INVALID_STRUCTURE);
    *polygon = good;
    polygon->count = 0;
    assert_int_equal(bmr_polygon_audit(polygon), BMR_ERROR_INVALID_STRUCTURE);
    *polygon = good;
    ((bmr_vec2 *)(polygon + 1))[3].x = NAN; // the vertices lie in the same block
    assert_int_equal(bmr_polygon_audit(polygon), BMR_ERROR_NOT_FINITE);
    bmr_polygon_destroy(polygon, NULL);
}

TEST(what_has_no_area_has_no_mass) {
    const bmr_vec2 points[] = {{0.0, 0.0}, {3.0, 0.0}};
    own_polygon *segment = made_polygon(points, 2);
    bmr_mass mass = {-7.0, {0.0, 0.0}, 0.0};
    assert_int_equal(bmr_polygon_mass(segment, &mass), BMR_ERROR_OUT_OF_RANGE);
    assert_int_equal(bmr_polygon_mass(NULL, &mass), BMR_ERROR_NULL_ARGUMENT);
    assert_true(mass.area == -7.0);
}
