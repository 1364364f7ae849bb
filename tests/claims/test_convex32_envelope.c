// SPDX-License-Identifier: MIT
// Envelopes of big polygons hold them, and no more than they must.
#include "checks.h"
#include "convex32/convex32_envelope.h"

#define MOST 3000u
#define EDGES 64u

static bmr_vec32 points[MOST];

static void ellipse(uint32_t count, double width, double height, double turn) {
    for (uint32_t i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * i / count, x = width * cos(angle), y = height * sin(angle);
        points[i].x = (float)(x * cos(turn) - y * sin(turn) + 0.25 * width);
        points[i].y = (float)(x * sin(turn) + y * cos(turn));
    }
}

/// Of the envelope of `count` points on an ellipse, with every corner moved towards the middle by `shrink`.
static void look(uint32_t count, double height, double turn, double shrink, bool held) {
    ellipse(count, 1.0, height, turn);
    own_convex32 *block = made_convex32(points, count);
    bmr_vec2 corners[EDGES];
    bmr_convex32_envelope(&block->polygon, EDGES, corners);
    for (uint32_t i = 0; i < EDGES; ++i) {
        corners[i].x = 0.25 + (corners[i].x - 0.25) * (1.0 - shrink);
        corners[i].y *= 1.0 - shrink;
    }
    own_polygon *outer = made_polygon(corners, EDGES);
    assert_true(outer->count <= EDGES);
    int outside = 0;
    for (uint32_t i = 0; i < block->polygon.count; ++i) {
        const bmr_vec2 v = {(double)block->polygon.vertices[i].x, (double)block->polygon.vertices[i].y};
        outside += !bmr_polygon_contains(outer, v, 0.0);
    }
    assert_int_equal(outside == 0, held);
    assert_int_equal(bmr_convex32_held(&block->polygon, outer, 0.0), held);
    // All lie in the unit disk, whose own envelope has no corner farther out than this.
    for (uint32_t i = 0; i < outer->count; ++i)
        assert_true(hypot(outer->vertices[i].x - 0.25, outer->vertices[i].y) <
                    1.0 / cos(3.1415927 / EDGES) + 1e-6);
}

TEST(an_envelope_holds_every_vertex) {
    for (uint32_t count = 9; count <= MOST; count = count * 3 / 2)
        for (int i = 0; i < 20; ++i)
            look(count, 1.0 - 0.049 * i, 0.37 * i, 0.0, true);
}

TEST(control_one_that_is_smaller_does_not) {
    for (uint32_t count = 9; count <= MOST; count = count * 3 / 2)
        for (int i = 0; i < 20; ++i)
            look(count, 1.0 - 0.049 * i, 0.37 * i, 1e-6, false);
}

static bmr_convex32_block *regular_raw(uint32_t count, double from) {
    for (uint32_t i = 0; i < count; ++i) {
        const double angle = from + 2.0 * 3.14159265358979323846 * i / count;
        points[i].x = (float)cos(angle);
        points[i].y = (float)sin(angle);
    }
    bmr_convex32_block *block = NULL;
    assert_int_equal(bmr_convex32_create_raw(points, count, NULL, &block), BMR_OK);
    return block;
}

TEST(a_segment_holds_nothing) {
    own_convex32 *block = regular_raw(12, 0.0);
    const bmr_vec2 ends[] = {{-5.0, 0.0}, {5.0, 0.0}};
    own_polygon *segment = made_polygon(ends, 2);
    assert_false(bmr_convex32_held(&block->polygon, segment, 10.0));
}

TEST(the_polygon_inside_has_8_vertices_at_most) {
    own_convex32 *block = regular_raw(24, 0.1);
    uint32_t eight[8], asked_for_more[9];
    asked_for_more[8] = 1234;
    bmr_convex32_inner(&block->polygon, eight, 8);
    bmr_convex32_inner(&block->polygon, asked_for_more, 9);
    assert_memory_equal(eight, asked_for_more, sizeof eight);
    assert_int_equal(asked_for_more[8], 1234);
}

/// A raw polygon begins anywhere: what is kept need not begin with its first vertex.
TEST(polygons_are_simplified_wherever_they_begin) {
    for (int step = 0; step < 16; ++step) {
        own_convex32 *block = regular_raw(32, 0.05 + 0.4 * step);
        for (float tolerance = 0.01f; tolerance < 4.0f; tolerance *= 2.0f) {
            bmr_vec32 kept[32];
            size_t count = 0;
            assert_int_equal(bmr_convex32_simplify(&block->polygon, tolerance, NULL, kept, &count), BMR_OK);
            assert_true(count >= 3 && count <= 32);
            if (tolerance > 2.0f)
                assert_int_equal(count, 3);
            // Some of the vertices, in their order.
            uint32_t at = 0;
            for (size_t i = 0; i < count; ++i, ++at) {
                while (at < 32 && (block->polygon.vertices[at].x != kept[i].x ||
                                   block->polygon.vertices[at].y != kept[i].y))
                    ++at;
                assert_true(at < 32);
            }
        }
    }
}

/// Of a needle, two vertices are the ends in all four directions of the roots: the third is the farthest from
/// these.
TEST(a_needle_keeps_three_vertices_wherever_it_begins) {
    static const bmr_vec32 needle[] = {
        {10.0f, 10.0f}, {1.0f, 1.5f}, {-1.0f, -0.5f}, {-10.0f, -10.0f}, {1.0f, 0.5f}};
    for (uint32_t first = 0; first < 5; ++first) {
        for (uint32_t i = 0; i < 5; ++i)
            points[i] = needle[(first + i) % 5];
        own_convex32 *block = NULL;
        assert_int_equal(bmr_convex32_create_raw(points, 5, NULL, &block), BMR_OK);
        bmr_vec32 kept[5];
        size_t count = 0;
        assert_int_equal(bmr_convex32_simplify(&block->polygon, 100.0f, NULL, kept, &count), BMR_OK);
        assert_int_equal(count, 3);
    }
}

/// The lowest vertex, with which the hull begins, turns by less than a float can tell.
TEST(a_first_vertex_that_does_not_turn_is_dropped) {
    static const bmr_vec32 house[] = {
        {-10.0f, 1e-45f}, {0.0f, 0.0f}, {10.0f, 1e-45f}, {10.0f, 10.0f}, {-10.0f, 10.0f}};
    for (int turn = 0; turn < 4; ++turn) { // whichever vertex a hull begins with
        bmr_vec32 turned[5];
        for (int i = 0; i < 5; ++i) {
            const bmr_vec32 v = house[i];
            turned[i].x = turn == 0 ? v.x : turn == 1 ? -v.y : turn == 2 ? -v.x : v.y;
            turned[i].y = turn == 0 ? v.y : turn == 1 ? v.x : turn == 2 ? -v.y : -v.x;
        }
        own_convex32 *block = made_convex32(turned, 5);
        assert_int_equal(block->polygon.count, 4);
    }
}

TEST(the_audit_refuses_counts_that_no_polygon_has) {
    own_convex32 *block = regular_raw(12, 0.0);
    bmr_convex32 polygon = block->polygon;
    polygon.count = 2;
    assert_int_equal(bmr_convex32_audit(&polygon), BMR_ERROR_TOO_FEW_POINTS);
    polygon.count = BMR_CONVEX32_MOST + 1;
    assert_int_equal(bmr_convex32_audit(&polygon), BMR_ERROR_TOO_MANY_POINTS);
    assert_int_equal(bmr_convex32_create_raw(points, BMR_CONVEX32_MOST + 1, NULL, &block),
                     BMR_ERROR_TOO_MANY_POINTS);
    assert_int_equal(bmr_convex32_create_raw(points, 2, NULL, &block), BMR_ERROR_TOO_FEW_POINTS);
}
