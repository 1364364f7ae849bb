// SPDX-License-Identifier: MIT
// Distances, casts and times of impact of float polygons where they are hard: shapes about one centre, a side
// that turns while something slides along it. (At random: random/fuzz_convex32.cpp. Casts that begin in
// touch: test_glue_convex_distance.cpp.)
#include "checks.h"
#include "convex32/convex32_distance.h"

static const float slop = 0.005f;

// --- shapes that overlap while the search stands on a side through the origin of their difference: what is
// left of the distance is rounding there, and its direction means nothing ---

enum { MOST = 40 };

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
    return made_convex32(points, count);
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

static void assert_within(const bmr_proxy32 *shape, const bmr_transform32 *pose, bmr_vec32 place) {
    const bmr_proxy32 point = bmr_proxy32_points(&place, 1, 0.0f);
    const bmr_transform32 here = {{0.0f, 0.0f}, 0.0f, 1.0f};
    bmr_closest32 closest = {0, 0};
    const float off = bmr_convex32_distance(shape, pose, &point, &here, &closest).distance;
    assert_true(off <= 1e-6f * (64.0f + shape->reach));
}

/// From any pair of vertices on; what is said to be the closest is a place of both.
static void assert_no_distance(const bmr_proxy32 *a, const bmr_transform32 *at_a, const bmr_proxy32 *b,
                               const bmr_transform32 *at_b) {
    for (uint32_t i = 0; i < a->polygon.count; ++i)
        for (uint32_t k = 0; k < b->polygon.count; ++k) {
            bmr_closest32 closest = {i, k};
            const bmr_distance32 found = bmr_convex32_distance(a, at_a, b, at_b, &closest);
            assert_true(found.distance == 0.0f);
            assert_within(a, at_a, found.point_a);
            assert_within(b, at_b, found.point_b);
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
        own_convex32 *small = regular(counts[kind / 5 % COUNTS], 0.066f, 0.26f);
        own_convex32 *large = regular(counts[kind / 5 / COUNTS], ldexpf(0.066f, size), 0.0555f);
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

/// What is apart by little stays apart: a ten-thousandth of the smaller one's size. Wherever the search
/// begins: behind the last vertex of each is a place of the other, which is not the shape's.
TEST(a_little_gap_is_a_gap) {
    for (int size = 0; size <= 8; size += 4) {
        const float r = ldexpf(1.0f, size);
        const bmr_vec32 large[] = {{r, r}, {-r, r}, {-r, -r}, {r, -r}, {r + 1.0001f, 0.5f}};
        const bmr_vec32 small[] = {{0.5f, 0.5f}, {-0.5f, 0.5f}, {-0.5f, -0.5f}, {0.5f, -0.5f}, {-0.5001f, r}};
        const bmr_proxy32 a = bmr_proxy32_points(large, 4, 0.01f), b = bmr_proxy32_points(small, 4, 0.01f);
        const bmr_transform32 at_a = {{0.0f, 0.0f}, 0.0f, 1.0f}, at_b = {{r + 0.5001f, 0.0f}, 0.0f, 1.0f};
        static const bmr_closest32 begins[] = {{0, 0}, {4, 0}, {0, 4}};
        for (int i = 0; i < 3; ++i) {
            bmr_closest32 closest = begins[i];
            const bmr_distance32 found = bmr_convex32_distance(&a, &at_a, &b, &at_b, &closest);
            assert_in_range(found.distance, 1e-4f - 2e-5f, 1e-4f + 2e-5f);
            assert_true(found.distance > 0.0f);
        }
    }
}

static const float tolerance = 0.25f * 0.005f;

static bmr_transform32 swept_to(const bmr_sweep32 *sweep, float t) {
    const float angle = (1.0f - t) * sweep->a0 + t * sweep->a, s = sinf(angle), c = cosf(angle);
    const bmr_vec32 l = sweep->local_center;
    const bmr_transform32 pose = {{(1.0f - t) * sweep->c0.x + t * sweep->c.x - (c * l.x - s * l.y),
                                   (1.0f - t) * sweep->c0.y + t * sweep->c.y - (s * l.x + c * l.y)},
                                  s,
                                  c};
    return pose;
}

static float distance_at(const bmr_proxy32 *a, const bmr_sweep32 *sweep_a, const bmr_proxy32 *b,
                         const bmr_sweep32 *sweep_b, float t) {
    const bmr_transform32 at_a = swept_to(sweep_a, t), at_b = swept_to(sweep_b, t);
    bmr_closest32 closest = {0, 0};
    return bmr_convex32_distance(a, &at_a, b, &at_b, &closest).distance;
}

/// A triangle turns by three radians, and a circle keeps to a side of four metres: it passes, three
/// millimetres farther than the distance looked for, or touches with a skin that is thicker by four.
TEST(a_circle_along_a_turning_side_is_followed_to_the_end) {
    static const bmr_vec32 triangle[] = {
        {0.303084105f, 4.33253002f}, {-2.64281178f, 1.35380948f}, {-1.82097781f, 0.225786775f}};
    static const bmr_vec32 centre = {0.384313732f, 0.384313732f};
    const bmr_proxy32 side = bmr_proxy32_points(triangle, 3, 0.01f);
    const bmr_sweep32 sweep_side = {{0.0215609986f, 0.390951395f},
                                    {1.93548501f, 1.93548501f},
                                    {3.87097001f, -0.689875722f},
                                    -5.37254906f,
                                    -8.59607887f,
                                    0.0f};
    const bmr_sweep32 sweep_circle = {{-0.53725493f, 0.2657969f},
                                      {1.98339295f, 1.98339295f},
                                      {3.96678591f, -0.0990970135f},
                                      -2.86274505f,
                                      -4.58039188f,
                                      0.0f};
    for (int how = 0; how < 4; ++how) { // the side that turns is the first shape's, or the second's
        const bool swapped = how % 2 != 0, touches = how >= 2;
        const bmr_proxy32 circle = bmr_proxy32_points(&centre, 1, touches ? 0.600078455f : 0.596078455f);
        const float target = side.radius + circle.radius - 3.0f * slop;
        bmr_vec32 direction = {0.0f, 0.0f};
        float t = -1.0f;
        const bmr_impact32 answer =
            swapped
                ? bmr_convex32_impact(&circle, &sweep_circle, &side, &sweep_side, 1.0f, slop, &direction, &t)
                : bmr_convex32_impact(&side, &sweep_side, &circle, &sweep_circle, 1.0f, slop, &direction, &t);
        assert_int_equal(answer, touches ? BMR_IMPACT_TOUCHING : BMR_IMPACT_SEPARATED);
        float least = INFINITY, last = 0.0f;
        for (int i = 0; i <= 1000; ++i) {
            last = distance_at(&side, &sweep_side, &circle, &sweep_circle, t * (float)i / 1000.0f);
            least = fminf(least, last);
        }
        assert_true(least > target - 1e-5f);
        if (touches)
            assert_true(last < target + tolerance + 1e-5f);
        else
            assert_true(t == 1.0f && least < target + 0.0035f);
    }
}
