// SPDX-License-Identifier: MIT
#include "boomerang/mass.h"
#include "boomerang/polygon.h"
#include "checks.h"
#include "polygons.h"

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

TEST(audit_refuses_wrong_measures) {
    bmr_vec2 points[16];
    test_regular_points(16, 1.0, 0.1, points);
    bmr_polygon *polygon = made_polygon(points, 16);
    assert_int_equal(bmr_polygon_audit(polygon), BMR_OK);
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
