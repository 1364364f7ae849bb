// SPDX-License-Identifier: MIT
// Casts of one shape against another: how far they go, and what a beginning in touch is. The numbers of
// b2ShapeCast (test_glue_convex_distance.cpp compares with it).

#include "checks.h"

#include "convex32/convex32_distance.h"

static const float slop = 0.005f; // skins of 2 slops: looked for are 2, reached at 2.5
static const bmr_vec32 down = {0.0f, -1.0f}, up = {0.0f, 1.0f}, along = {1.0f, 0.0f};

static const bmr_vec32 peak[] = {{0.5f, -0.5f}, {0.0f, 0.0f}, {-0.5f, -0.5f}};
static const bmr_vec32 table[] = {{1.0f, -1.0f}, {1.0f, 0.0f}, {-1.0f, 0.0f}, {-1.0f, -1.0f}};

/// A point with a skin, from above (0, 0) of a shape.
static bool cast_from(const bmr_vec32 *shape, uint32_t count, float height, bmr_vec32 translation,
                      bmr_cast32 *cast) {
    static const bmr_vec32 centre = {0.0f, 0.0f};
    const bmr_proxy32 a = bmr_proxy32_points(shape, count, 2.0f * slop);
    const bmr_proxy32 b = bmr_proxy32_points(&centre, 1, 2.0f * slop);
    const bmr_transform32 here = {{0.0f, 0.0f}, 0.0f, 1.0f}, there = {{0.0f, height}, 0.0f, 1.0f};
    return bmr_convex32_cast(&a, &here, &b, &there, translation, slop, cast);
}

static void assert_miss(bool hit, const bmr_cast32 *cast) {
    assert_false(hit);
    assert_true(cast->lambda == 1.0f);
    assert_true(cast->point.x == 0.0f && cast->point.y == 0.0f);
    assert_true(cast->normal.x == 0.0f && cast->normal.y == 0.0f);
}

TEST(casts_end_two_slops_apart) {
    bmr_cast32 cast;
    assert_true(cast_from(table, 4, 0.51f, down, &cast));
    assert_float_equal(cast.lambda, 0.5f, 1e-6f);
    assert_float_equal(cast.normal.y, 1.0f, 1e-6f);
    assert_float_equal(cast.point.y, 0.01f, 1e-6f); // on the table's skin
    assert_miss(cast_from(table, 4, 1.0126f, down, &cast), &cast);
    assert_miss(cast_from(table, 4, 0.51f, up, &cast), &cast);
    assert_miss(cast_from(table, 4, 0.51f, along, &cast), &cast);
}

TEST(casts_whose_first_vertices_begin_in_touch_miss) {
    bmr_cast32 cast;
    const float touching[] = {0.0f, 0.005f, 0.0099f, 0.0101f,
                              0.0124f}; // up to half a slop more than looked for
    for (size_t i = 0; i < sizeof touching / sizeof *touching; ++i)
        assert_miss(cast_from(peak, 3, touching[i], down, &cast), &cast); // into the peak, all the same
    assert_true(cast_from(peak, 3, 0.0126f, down, &cast));
    assert_float_equal(cast.lambda, 0.0026f, 1e-6f);
}

TEST(casts_that_otherwise_begin_in_touch_hit_at_once) {
    bmr_cast32 cast;
    const bmr_vec32 ways[] = {down, up, along};
    const float touching[] = {0.001f, 0.005f, 0.0099f, 0.0101f, 0.0124f};
    for (size_t i = 0; i < sizeof touching / sizeof *touching; ++i) {
        for (size_t k = 0; k < sizeof ways / sizeof *ways; ++k) {
            assert_true(cast_from(table, 4, touching[i], ways[k], &cast));
            assert_true(cast.lambda == 0.0f);
            assert_float_equal(cast.normal.y, 1.0f, 1e-6f);
        }
    }
    assert_true(cast_from(table, 4, 0.0126f, down, &cast));
    assert_float_equal(cast.lambda, 0.0026f, 1e-6f);
    assert_miss(cast_from(table, 4, 0.0126f, up, &cast), &cast);
}

TEST(casts_that_begin_overlapping_miss) {
    bmr_cast32 cast;
    assert_miss(cast_from(table, 4, -0.1f, down, &cast), &cast);
    assert_miss(cast_from(table, 4, -0.1f, up, &cast), &cast);
    assert_miss(cast_from(table, 4, 0.0f, down, &cast), &cast);
}
