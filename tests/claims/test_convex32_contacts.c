// SPDX-License-Identifier: MIT
// Contacts of float polygons: what is said to be apart is so, whatever was remembered and however large the
// polygons are; impulses follow features, so features follow the points. (Manifolds to the bit, of up to 500
// vertices: random/fuzz_convex32.cpp.)
#include "checks.h"
#include "convex32/convex32_collide.h"
#include "convex32/edge_search.h"
#include "convex32_poses.h"
#include "convex32_reference.h"
#include "geometry/predicates.h"
#include "polygons.h"

static const bmr_transform32 here = {{0.0f, 0.0f}, 0.0f, 1.0f};

/// In double, as it lies there.
static bmr_polygon *placed(const bmr_convex32 *p, const bmr_transform32 *pose) {
    bmr_vec2 *points = malloc(p->count * sizeof *points);
    assert_non_null(points);
    const bmr_pose at = {{(double)pose->p.x, (double)pose->p.y}, (double)pose->c, (double)pose->s};
    for (uint32_t i = 0; i < p->count; ++i)
        points[i] = bmr_transform(&at, bmr_vec2_make((double)p->vertices[i].x, (double)p->vertices[i].y));
    bmr_polygon *polygon = made_polygon(points, p->count);
    free(points);
    return polygon;
}

/// Is all of the other beyond an edge of this one?
static bool edge_separates(const bmr_polygon *own, const bmr_polygon *other) {
    for (uint32_t i = 0; i < own->count; ++i) {
        const bmr_vec2 from = own->vertices[i], to = own->vertices[(i + 1) % own->count];
        uint32_t beyond = 0;
        while (beyond < other->count && bmr_orientation(from, to, other->vertices[beyond]) < 0)
            ++beyond;
        if (beyond == other->count)
            return true;
    }
    return false;
}

/// Is there a gap between the two? Placed in double, then exactly. (Without GMP, which ARM64's test has not.)
static bool have_gap(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                     const bmr_transform32 *pose_b) {
    own_polygon *p = placed(a, pose_a), *q = placed(b, pose_b);
    return edge_separates(p, q) || edge_separates(q, p);
}

static bmr_convex32_block *made_of(const bmr_vec32 *vertices, size_t count) {
    bmr_convex32_block *block = NULL;
    assert_int_equal(bmr_convex32_create_raw(vertices, count, NULL, &block), BMR_OK);
    return block;
}

static bmr_convex32_block *square(void) {
    const bmr_vec32 vertices[] = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}};
    return made_of(vertices, 4);
}

TEST(no_remembered_direction_is_too_long) {
    own_convex32 *const block = square();
    const bmr_convex32 *const p = &block->polygon;
    const float away = 0.5f * sqrtf(0.5f); // corners half a metre apart
    const bmr_transform32 there = {{1.0f + away, 1.0f + away}, 0.0f, 1.0f};
    static const int16_t longest[] = {INT16_MIN, -32767, 0, 32767};
    for (int i = 0; i < 16; ++i)
        for (uint16_t vertex = 0; vertex < 5; ++vertex) {
            const bmr_convex32_memory memory = {vertex, vertex, longest[i / 4], longest[i % 4]};
            bmr_convex32_memory kept = memory;
            assert_false(bmr_convex32_apart(p, &here, p, &there, 0.51f, &kept));
            kept = memory;
            assert_true(bmr_convex32_apart(p, &here, p, &there, 0.3f, &kept));
        }
}

/// The second vertex turns so little that along some directions both its edges seem to descend where both
/// ascend: it is the other end of the polygon.
TEST(a_vertex_that_hardly_turns_is_no_end) {
    static const bmr_vec32 flat[] = {{0x1.60700ep-2f, 0x1.88aaf6p-2f},
                                     {-0x1.2a4836p-27f, 0x1.0bb8dcp-27f},
                                     {-0x1.4b8c74p-2f, -0x1.7164fp-2f},
                                     {0x1.ae8374p-2f, -0x1.07585cp+0f},
                                     {0x1.169ffep+0f, -0x1.23518cp-2f}};
    static const bmr_vec32 tiny[] = {{0.01f, 0.0f}, {0.0f, 0.01f}, {-0.01f, -0.01f}};
    static const struct {
        float sine;
        int16_t axis_x, axis_y;
    } cases[] = {{0x1.4ade3ap-14f, 24387, -21885},
                 {-0x1.8840ep-14f, 24383, -21889},
                 {-0x1.f875f8p-16f, 24385, -21888}};
    own_convex32 *const a = made_of(flat, 5), *const b = made_of(tiny, 3);
    for (int i = 0; i < 3; ++i) {
        // In the middle of it.
        const bmr_transform32 pose = {{0.0f, 0.0f}, cases[i].sine, 1.0f},
                              inside = {{0.37f, -0.33f}, 0.0f, 1.0f};
        assert_false(have_gap(&a->polygon, &pose, &b->polygon, &inside));
        bmr_convex32_memory memory = {1, 0, cases[i].axis_x, cases[i].axis_y};
        assert_false(bmr_convex32_apart(&a->polygon, &pose, &b->polygon, &inside, 0.0f, &memory));
    }
}

/// Bars side by side that meet, if at all, far from where the look finds their ends, which is at the bodies'
/// origins.
TEST(large_polygons_are_apart_where_that_is_said) {
    enum { LENGTH = 1000 };
    const bmr_vec32 left[] = {{0.0f, 0.0f}, {0.0f, LENGTH}, {-1.0f, LENGTH}, {-1.0f, 0.0f}},
                    right[] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, LENGTH}, {0.0f, LENGTH}};
    own_convex32 *const a = made_of(left, 4), *const b = made_of(right, 4);
    test_random d = test_random_from(1);
    size_t apart = 0;
    const size_t poses = test_scaled(20000);
    for (size_t i = 0; i < poses; ++i) {
        // A direction that is remembered as it is, and both bodies turned to it, to rounding.
        bmr_convex32_memory memory = {0, 0, 0, 0};
        const double angle = test_random_uniform(&d, 0.0, 6.28);
        memory.axis_x = (int16_t)lrint(32767.0 * cos(angle));
        memory.axis_y = (int16_t)lrint(32767.0 * sin(angle));
        const double turned = atan2((double)memory.axis_y, (double)memory.axis_x);
        const double tilt = ldexp(test_random_uniform(&d, -1.0, 1.0), -22),
                     gap = 0.02 * pow(test_random_uniform(&d, 0.0, 1.0), 4.0);
        const bmr_transform32 pose_a = {{0.0f, 0.0f}, (float)sin(turned + tilt), (float)cos(turned + tilt)},
                              pose_b = {{(float)(gap * cos(turned)), (float)(gap * sin(turned))},
                                        (float)sin(turned - tilt),
                                        (float)cos(turned - tilt)};
        if (!bmr_convex32_apart(&a->polygon, &pose_a, &b->polygon, &pose_b, 0.0f, &memory))
            continue;
        ++apart;
        assert_true(have_gap(&a->polygon, &pose_a, &b->polygon, &pose_b));
    }
    assert_true(apart > poses / 4 && apart < poses);
}

TEST(what_overflows_is_not_apart) {
    own_convex32 *const block = square();
    const bmr_convex32 *const p = &block->polygon;
    static const float large[] = {1e30f, 1e34f, 3e38f, -1e30f, -1e34f, -3e38f};
    for (int i = 0; i < 36; ++i)
        for (uint16_t vertex = 0; vertex < 16; ++vertex) {
            const bmr_transform32 stretched = {{0.0f, 0.0f}, large[i / 6], large[i % 6]};
            bmr_convex32_memory memory = {vertex / 4, vertex % 4, 32767, 0};
            assert_false(bmr_convex32_apart(p, &stretched, p, &here, 0.0f, &memory));
        }
}

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

/// The bound by which a search among one polygon's edges spares the other's.
TEST(no_edge_of_the_other_separates_by_more_than_the_rest) {
    test_random random = {911};
    const size_t rounds = test_scaled(5000);
    size_t needed = 0;
    for (size_t round = 0; round < rounds; ++round) {
        own_convex32 *const a = random_convex32(&random, random_kind(&random), 3 + (uint32_t)round % 9),
                            *const b = random_convex32(&random, random_kind(&random), 40);
        const bmr_transform32 pose = random_pose32(&random, 2.0),
                              there = pose_against(&random, &a->polygon, &pose, &b->polygon, 0.02);
        const edge_search search =
            edge_search_of(&a->polygon, &b->polygon, bmr_exact32_relative(&there, &pose), 0.005f);
        edge_found found;
        bmr_convex32_seek(&search, 0, 0, -FLT_MAX, &found);
        uint32_t edge;
        const float most = reference_max_separation(&b->polygon, &there, &a->polygon, &pose, &edge);
        assert_true(most <= fmaxf(found.rest, found.best.separation) + 1e-5f);
        needed += most > found.best.separation + 1e-4f;
    }
    assert_true(needed > rounds / 4); // control
}
