// SPDX-License-Identifier: MIT
// Shapes that overlap while the search for their closest points stands on a side through the origin of their
// difference: what is left of the distance is rounding there, and its direction means nothing.
#include <math.h>

#include "checks.h"

#include "convex32/convex32_distance.h"

enum { MOST = 40 };
static const float slop = 0.005f;

/// A regular polygon about the origin. An even count has pairs of vertices that are opposite to the bit.
static bmr_convex32_block *regular(uint32_t count, float radius, float turn) {
    bmr_vec32 points[MOST];
    for (uint32_t i = 0; i < count; ++i) {
        const bool second_half = count % 2 == 0 && i >= count / 2;
        const float angle = 6.28318531f * (float)i / (float)count + turn;
        const bmr_vec32 p = {radius * cosf(angle), radius * sinf(angle)};
        const bmr_vec32 mirrored = second_half ? points[i - count / 2] : p;
        points[i] = second_half ? (bmr_vec32){-mirrored.x, -mirrored.y} : p;
    }
    bmr_convex32_block *block = NULL;
    assert_int_equal(bmr_convex32_create(points, count, NULL, &block), BMR_OK);
    return block;
}

static bmr_transform32 pose_at(bmr_vec32 place, float angle) {
    const bmr_transform32 pose = {place, sinf(angle), cosf(angle)};
    return pose;
}

/// A place up to 64 away: another one for each number.
static bmr_vec32 place_of(uint32_t i) {
    const bmr_vec32 place = {(float)(i * 2654435761u % 128000u) / 1000.0f - 64.0f,
                             (float)(i * 2246822519u % 128000u) / 1000.0f - 64.0f};
    return place;
}

/// From any pair of vertices on.
static void assert_no_distance(const bmr_proxy32 *a, const bmr_transform32 *at_a, const bmr_proxy32 *b,
                               const bmr_transform32 *at_b) {
    for (uint32_t i = 0; i < a->polygon.count; ++i)
        for (uint32_t k = 0; k < b->polygon.count; ++k) {
            bmr_closest32 closest = {i, k};
            assert_true(bmr_convex32_distance(a, at_a, b, at_b, &closest).distance == 0.0f);
        }
}

static void assert_casts_miss(const bmr_proxy32 *a, const bmr_transform32 *at_a, const bmr_proxy32 *b,
                              const bmr_transform32 *at_b) {
    for (int i = 0; i < 60; ++i) {
        const bmr_vec32 way = {47.9f * cosf(0.1f * (float)i), -47.5f * sinf(0.1f * (float)i)};
        bmr_cast32 cast;
        assert_false(bmr_convex32_cast(a, at_a, b, at_b, way, slop, &cast));
        assert_true(cast.normal.x == 0.0f && cast.normal.y == 0.0f);
    }
}

static void assert_impact_overlaps(const bmr_proxy32 *a, const bmr_proxy32 *b, bmr_vec32 place, float angle) {
    const bmr_sweep32 sweep_a = {{0.0f, 0.0f}, place, place, 0.0f, 0.0f, 0.0f};
    const bmr_sweep32 sweep_b = {{0.0f, 0.0f}, place, place, angle, angle, 0.0f};
    bmr_vec32 direction = {0.0f, 0.0f};
    float t = -1.0f;
    assert_int_equal(bmr_convex32_impact(a, &sweep_a, b, &sweep_b, 1.0f, slop, &direction, &t),
                     BMR_IMPACT_OVERLAPPED);
    assert_true(t == 0.0f);
}

/// From 4 to 38 vertices, each opposite another one to the bit, at the same place, from as large as the other
/// to 65,536 times as large: the difference of two opposite vertices goes through the origin but for the
/// rounding of their places.
TEST(polygons_about_one_centre_overlap) {
    static const uint32_t counts[] = {4, 8, 12, 30, 38};
    enum { COUNTS = sizeof counts / sizeof *counts };
    for (uint32_t kind = 0; kind < 5 * COUNTS * COUNTS; ++kind) {
        const int size = 4 * (int)(kind % 5);
        bmr_convex32_block *small = regular(counts[kind / 5 % COUNTS], 0.066f, 0.26f);
        bmr_convex32_block *large = regular(counts[kind / 5 / COUNTS], ldexpf(0.066f, size), 0.0555f);
        const bmr_proxy32 a = bmr_proxy32_polygon(small, 0.01f), b = bmr_proxy32_polygon(large, 0.03f);
        for (uint32_t i = 0; i < 8; ++i) {
            const bmr_vec32 place = place_of(8 * kind + i);
            const float angle = i % 2 == 0 ? 0.7853981634f * (float)i : 0.1f * (float)i;
            const bmr_transform32 at_a = pose_at(place, 0.0f), at_b = pose_at(place, angle);
            assert_no_distance(&a, &at_a, &b, &at_b);
            assert_casts_miss(&a, &at_a, &b, &at_b);
            assert_casts_miss(&b, &at_b, &a, &at_a);
            assert_impact_overlaps(&a, &b, place, angle);
            assert_impact_overlaps(&b, &a, place, angle);
        }
        bmr_convex32_destroy(small, NULL);
        bmr_convex32_destroy(large, NULL);
    }
}

/// Two edges that cross, and an edge with a circle's centre on it: points only, no area.
TEST(edges_through_one_point_overlap) {
    for (uint32_t i = 1; i < 500; ++i) {
        const float k = 0.1f * (float)i;
        const bmr_vec32 one[] = {{k, 0.7f}, {-k, -0.7f}}, other[] = {{-3.0f, k}, {3.0f, -k}};
        const bmr_vec32 centre = {0.0f, 0.0f};
        const bmr_proxy32 a = bmr_proxy32_points(one, 2, 0.01f), b = bmr_proxy32_points(other, 2, 0.01f),
                          c = bmr_proxy32_points(&centre, 1, 0.5f);
        const bmr_transform32 at = pose_at(place_of(i), k);
        assert_no_distance(&a, &at, &b, &at);
        assert_no_distance(&a, &at, &c, &at);
        assert_casts_miss(&a, &at, &b, &at);
        assert_casts_miss(&c, &at, &b, &at);
        assert_impact_overlaps(&a, &b, at.p, 0.0f);
        assert_impact_overlaps(&a, &c, at.p, k);
    }
}

/// What is apart by little stays apart: a ten-thousandth of the smaller one's size.
TEST(a_little_gap_is_a_gap) {
    for (int size = 0; size <= 8; size += 4) {
        const float r = ldexpf(1.0f, size);
        const bmr_vec32 large[] = {{r, r}, {-r, r}, {-r, -r}, {r, -r}};
        const bmr_vec32 small[] = {{0.5f, 0.5f}, {-0.5f, 0.5f}, {-0.5f, -0.5f}, {0.5f, -0.5f}};
        const bmr_proxy32 a = bmr_proxy32_points(large, 4, 0.01f), b = bmr_proxy32_points(small, 4, 0.01f);
        const bmr_transform32 at_a = {{0.0f, 0.0f}, 0.0f, 1.0f}, at_b = {{r + 0.5001f, 0.0f}, 0.0f, 1.0f};
        bmr_closest32 closest = {0, 0};
        const bmr_distance32 found = bmr_convex32_distance(&a, &at_a, &b, &at_b, &closest);
        assert_float_equal(found.distance, 1e-4f, 2e-5f);
        assert_true(found.distance > 0.0f);
    }
}
