// SPDX-License-Identifier: MIT
// Impulses follow features, so features must follow the points.

#include "checks.h"

#include <string.h>

#include "convex32/convex32_collide.h"

static bmr_manifold32 two_points(float x0, uint8_t first, float x1, uint8_t second) {
    bmr_manifold32 m;
    memset(&m, 0, sizeof m);
    m.type = BMR_MANIFOLD_FACE_A;
    m.count = 2;
    m.points[0].point.x = x0;
    m.points[0].feature.index_b = first;
    m.points[1].point.x = x1;
    m.points[1].feature.index_b = second;
    return m;
}

TEST(points_keep_their_own_features_first) {
    const bmr_manifold32 old = two_points(0.0f, 1, 1.0f, 2);
    bmr_manifold32 m = two_points(1.0f, 1, 0.0f, 2); // changed places
    bmr_convex32_keep_features(&m, &old, 0.1f);
    assert_int_equal(m.points[0].feature.index_b, 1);
    assert_int_equal(m.points[1].feature.index_b, 2);
}

TEST(points_with_new_features_take_the_nearest_within_the_distance) {
    const bmr_manifold32 old = two_points(0.0f, 1, 1.0f, 2);
    bmr_manifold32 m = two_points(1.05f, 7, 0.05f, 8), far = two_points(0.5f, 7, 0.05f, 8);
    bmr_convex32_keep_features(&m, &old, 0.1f);
    assert_int_equal(m.points[0].feature.index_b, 2);
    assert_int_equal(m.points[1].feature.index_b, 1);
    bmr_convex32_keep_features(&far, &old, 0.1f);
    assert_int_equal(far.points[0].feature.index_b, 7);
    assert_int_equal(far.points[1].feature.index_b, 1);
}

TEST(a_point_is_taken_over_once) {
    const bmr_manifold32 old = two_points(0.0f, 1, 1.0f, 2);
    bmr_manifold32 m = two_points(0.01f, 7, 0.02f, 8);
    bmr_convex32_keep_features(&m, &old, 0.1f);
    assert_int_equal(m.points[0].feature.index_b, 1);
    assert_int_equal(m.points[1].feature.index_b, 8);
}

TEST(another_reference_is_compared_by_features_alone) {
    bmr_manifold32 old = two_points(0.0f, 1, 1.0f, 2);
    old.type = BMR_MANIFOLD_FACE_B;
    bmr_manifold32 m = two_points(0.0f, 7, 1.0f, 2);
    bmr_convex32_keep_features(&m, &old, 0.1f);
    assert_int_equal(m.points[0].feature.index_b, 7);
    assert_int_equal(m.points[1].feature.index_b, 2);
}

TEST(no_two_are_alike) {
    bmr_manifold32 old, m = two_points(0.0f, 5, 1.0f, 5); // numbers 5 and 261 of many
    memset(&old, 0, sizeof old);
    bmr_convex32_keep_features(&m, &old, 0.1f);
    assert_int_not_equal(m.points[0].feature.index_b, m.points[1].feature.index_b);
}
