// SPDX-License-Identifier: MIT

#include "checks.h"
#include <math.h>

#include "boomerang/polygon.h"
#include "geometry/distance.h"
#include "geometry/predicates.h"
#include "polygons.h"
#include "test_scale.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

/// As scaled, but enough for every control to see what it waits for.
static size_t rounds(size_t count) {
    const size_t least = count / 10, scaled = test_scaled(count);
    return scaled > least ? scaled : least;
}

static bmr_polygon *hull_of(const bmr_vec2 *points, size_t count) {
    bmr_polygon *polygon = NULL;
    assert_int_equal(bmr_polygon_create(points, count, NULL, &polygon), BMR_OK);
    assert_int_equal(bmr_polygon_audit(polygon), BMR_OK);
    return polygon;
}

/// Up to what the header allows for rounding.
static bool is_support(const bmr_polygon *p, bmr_vec2 d, uint32_t vertex) {
    double most = -INFINITY;
    for (uint32_t i = 0; i < p->count; ++i)
        most = fmax(most, bmr_dot(d, p->vertices[i]));
    return vertex < p->count && bmr_dot(d, p->vertices[vertex]) >= most - 1e-15 * p->extent * hypot(d.x, d.y);
}

static bmr_vec2 random_direction(const bmr_polygon *p, test_random *random) {
    const double angle = test_random_uniform(random, 0.0, 6.3);
    const uint32_t edge = test_random_below(random, p->count);
    const bmr_vec2 normal = bmr_polygon_normal(p, edge);
    switch (test_random_below(random, 4)) {
    case 0: // at right angles to an edge, up to rounding
        return normal;
    case 1:
        return bmr_vec2_make(normal.x + test_random_uniform(random, -1e-12, 1e-12), normal.y);
    case 2: // tiny
        return bmr_vec2_make(1e-300 * cos(angle), 1e-300 * sin(angle));
    default:
        return bmr_vec2_make(cos(angle), sin(angle));
    }
}

TEST(support_is_a_farthest_vertex_from_scratch_and_from_any_hint) {
    test_random random = {13};
    size_t controls = 0, rejected = 0;
    for (int family = 0; family < TEST_FAMILY_COUNT; ++family)
        for (size_t n = 3; n <= 1100; n = 3 * n + 1) {
            bmr_polygon *p = test_polygon((test_family)family, n, &random);
            for (size_t round = 0; round < rounds(60); ++round) {
                const bmr_vec2 d = random_direction(p, &random);
                const uint32_t hint = (uint32_t)test_random_next(&random);
                assert_true(is_support(p, d, bmr_polygon_support(p, d)));
                assert_true(is_support(p, d, bmr_polygon_support_from(p, d, hint)));
                // Control: a vertex a third of the way round is nearly never one.
                ++controls;
                rejected += !is_support(p, d, (bmr_polygon_support(p, d) + p->count / 3 + 1) % p->count);
            }
            bmr_polygon_destroy(p, NULL);
        }
    assert_true(rejected * 10 > controls * 8);
}

TEST(support_of_a_tie_is_the_counter_clockwise_first) {
    bmr_vec2 points[4];
    test_box_points(2.0, 1.0, points);
    bmr_polygon *box = hull_of(points, 4);
    const bmr_vec2 axes[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}}; // edge i's normal
    for (uint32_t i = 0; i < 4; ++i) {
        assert_int_equal(bmr_polygon_support(box, axes[i]), i);
        for (uint32_t hint = 0; hint < 9; ++hint)
            assert_int_equal(bmr_polygon_support_from(box, axes[i], hint), i);
    }
    bmr_polygon_destroy(box, NULL);
    const bmr_vec2 ends[] = {{0, 0}, {3, 4}};
    bmr_polygon *segment = hull_of(ends, 2);
    const bmr_vec2 right = {4, -3}, left = {-4, 3};
    for (uint32_t hint = 0; hint < 2; ++hint) {
        assert_int_equal(bmr_polygon_support_from(segment, right, hint), 0);
        assert_int_equal(bmr_polygon_support_from(segment, left, hint), 1);
    }
    bmr_polygon_destroy(segment, NULL);
}

TEST(support_across_a_level_segment_is_the_start_of_the_side_it_faces) {
    const bmr_vec2 level[] = {{0, 0}, {2, 0}}, upright[] = {{0, 0}, {0, 2}};
    bmr_polygon *p = hull_of(level, 2), *q = hull_of(upright, 2);
    assert_int_equal(bmr_polygon_support(p, bmr_vec2_make(0, -1)), 0);
    assert_int_equal(bmr_polygon_support(p, bmr_vec2_make(0, 1)), 1);
    assert_int_equal(bmr_polygon_support(q, bmr_vec2_make(1, 0)), 0);
    assert_int_equal(bmr_polygon_support(q, bmr_vec2_make(-1, 0)), 1);
    bmr_polygon_destroy(p, NULL);
    bmr_polygon_destroy(q, NULL);
}

/// Products with such edges underflow: a search that took them for level would end there.
TEST(edges_of_denormal_length_hide_no_vertex_behind_them) {
    const double least = 4.9406564584124654e-324;
    const bmr_vec2 points[] = {{-least, 0}, {least, 0}, {1e-260, 1e-290},
                               {3.5, 0.75}, {2.5, 2},   {-0.2, 0.14}};
    const size_t count = sizeof points / sizeof *points;
    for (int turn = 0; turn < 4; ++turn) { // what comes first, and which chain it is on
        bmr_vec2 turned[sizeof points / sizeof *points];
        for (size_t i = 0; i < count; ++i) {
            const bmr_vec2 v = points[i];
            turned[i] = turn == 0   ? v
                        : turn == 1 ? bmr_vec2_make(-v.y, v.x)
                        : turn == 2 ? bmr_vec2_make(-v.x, -v.y)
                                    : bmr_vec2_make(v.y, -v.x);
        }
        bmr_polygon *p = hull_of(turned, count);
        for (int i = 0; i < 360; ++i) {
            const bmr_vec2 d = bmr_vec2_make(cos(0.017453 * i), sin(0.017453 * i));
            assert_true(is_support(p, d, bmr_polygon_support(p, d)));
            for (uint32_t hint = 0; hint < p->count; ++hint) {
                unsigned steps = 0;
                assert_true(is_support(p, d, bmr_polygon_support_from(p, d, hint)));
                assert_true(is_support(p, d, bmr_support_near(p, d, hint, &steps)));
                assert_true(steps > 0);
            }
        }
        bmr_polygon_destroy(p, NULL);
    }
}

TEST(a_direction_that_is_none_gives_the_hint_back) {
    bmr_vec2 points[7];
    test_regular_points(7, 1.0, 0.0, points);
    bmr_polygon *p = hull_of(points, 7);
    const bmr_vec2 none[] = {{0, 0}, {NAN, 1}, {1, NAN}, {-0.0, 0.0}};
    for (size_t i = 0; i < COUNT_OF(none); ++i)
        for (uint32_t hint = 0; hint < 20; ++hint) {
            assert_int_equal(bmr_polygon_support_from(p, none[i], hint), hint % 7);
            assert_true(bmr_polygon_support(p, none[i]) < 7);
        }
    bmr_polygon_destroy(p, NULL);
}

/// Steps uphill by comparing values until neither neighbour is higher: what a climb may not do.
static uint32_t naive_climb(const bmr_polygon *p, bmr_vec2 d, uint32_t i) {
    for (;;) {
        const uint32_t after = (i + 1) % p->count, before = (i + p->count - 1) % p->count;
        const double here = bmr_dot(d, p->vertices[i]);
        if (bmr_dot(d, p->vertices[after]) > here)
            i = after;
        else if (bmr_dot(d, p->vertices[before]) > here)
            i = before;
        else
            return i;
    }
}

TEST(a_climb_does_not_get_stuck_where_the_bottom_is_flat_up_to_rounding) {
    test_random random = {17};
    size_t stuck = 0, tried = 0;
    for (size_t round = 0; round < rounds(20000); ++round) {
        const double angle = test_random_uniform(&random, 0.0, 6.3),
                     t = test_random_uniform(&random, -0.5, 0.5);
        const bmr_vec2 along = {cos(angle), sin(angle)}, up = bmr_left(along);
        // A flat side, bent by an ulp or so, and the centre of the disk on it.
        const bmr_vec2 points[] = {bmr_neg(along), bmr_scale(t, along), along, bmr_scale(0.5, up)};
        bmr_polygon *p = hull_of(points, 4);
        for (uint32_t hint = 0; hint < p->count && p->count == 4; ++hint) {
            assert_true(is_support(p, up, bmr_polygon_support_from(p, up, hint)));
            ++tried;
            stuck += !is_support(p, up, naive_climb(p, up, hint));
        }
        bmr_polygon_destroy(p, NULL);
    }
    assert_true(tried > 500);
    assert_true(stuck > 0); // control: a climb that believes its neighbours does get stuck here
}

TEST(normals_have_unit_length_and_point_outwards) {
    test_random random = {19};
    for (int family = 0; family < TEST_FAMILY_COUNT; ++family) {
        bmr_polygon *p = test_polygon((test_family)family, 50, &random);
        for (uint32_t i = 0; i < p->count; ++i) {
            const bmr_vec2 n = bmr_polygon_normal(p, i);
            assert_true(fabs(hypot(n.x, n.y) - 1.0) < 4e-16);
            assert_true(is_support(p, n, i) && is_support(p, n, (i + 1) % p->count));
            assert_false(is_support(p, bmr_neg(n), i)); // control: an inward one
        }
        bmr_polygon_destroy(p, NULL);
    }
    const bmr_vec2 point = {5, 5};
    bmr_polygon *p = hull_of(&point, 1);
    assert_true(bmr_polygon_normal(p, 0).x == 1.0 && bmr_polygon_normal(p, 0).y == 0.0);
    bmr_polygon_destroy(p, NULL);
    const bmr_vec2 denormal[] = {{0, 0}, {1, 0}, {0x1p-1074, 0x1p-1074}}; // an edge of 1 ulp of nothing
    p = hull_of(denormal, 3);
    for (uint32_t i = 0; i < p->count; ++i)
        assert_true(fabs(hypot(bmr_polygon_normal(p, i).x, bmr_polygon_normal(p, i).y) - 1.0) < 4e-16);
    bmr_polygon_destroy(p, NULL);
}

static bool contains_by_all_edges(const bmr_polygon *p, bmr_vec2 x) {
    for (uint32_t i = 0; i < p->count; ++i)
        if (bmr_orientation(p->vertices[i], p->vertices[(i + 1) % p->count], x) < 0)
            return false;
    return true;
}

TEST(contains_agrees_with_every_edge_of_the_polygon) {
    test_random random = {23};
    size_t inside = 0, outside = 0;
    for (int family = 0; family < TEST_FAMILY_COUNT; ++family)
        for (size_t n = 3; n < 200; n = 2 * n + 1) {
            bmr_polygon *p = test_polygon((test_family)family, n, &random);
            for (size_t round = 0; round < rounds(200); ++round) {
                const uint32_t i = test_random_below(&random, p->count),
                               j = test_random_below(&random, p->count);
                const double t = test_random_uniform(&random, -0.2, 1.2);
                bmr_vec2 x = bmr_add(p->vertices[i], bmr_scale(t, bmr_sub(p->vertices[j], p->vertices[i])));
                if (round % 8 == 0)
                    x = p->vertices[i];
                const bool expected = contains_by_all_edges(p, x);
                assert_int_equal(bmr_polygon_contains(p, x, 0.0), expected);
                inside += expected;
                outside += !expected;
            }
            bmr_polygon_destroy(p, NULL);
        }
    assert_true(inside > 100 && outside > 100); // control: both answers occur
}

TEST(contains_takes_the_tolerance_from_every_edge) {
    bmr_vec2 points[4];
    test_box_points(1.0, 1.0, points);
    bmr_polygon *p = hull_of(points, 4);
    assert_true(bmr_polygon_contains(p, bmr_vec2_make(1.4, 1.4), 0.5)); // beyond two lines, by 0.4 each
    assert_false(bmr_polygon_contains(p, bmr_vec2_make(1.4, 1.6), 0.5));
    assert_false(bmr_polygon_contains(p, bmr_vec2_make(1.4, 0.0), 0.0));
    assert_false(bmr_polygon_contains(p, bmr_vec2_make(NAN, 0.0), 9.0));
    assert_false(bmr_polygon_contains(p, bmr_vec2_make(0.0, 0.0), NAN));
    bmr_polygon_destroy(p, NULL);
    const bmr_vec2 ends[] = {{0, 0}, {2, 2}};
    p = hull_of(ends, 2);
    assert_true(bmr_polygon_contains(p, bmr_vec2_make(1.0, 1.0), 0.0));
    assert_false(bmr_polygon_contains(p, bmr_vec2_make(3.0, 3.0), 0.0));
    assert_true(bmr_polygon_contains(p, bmr_vec2_make(3.0, 3.0), 1.5));
    assert_false(bmr_polygon_contains(p, bmr_vec2_make(3.0, 3.0), 1.4));
    bmr_polygon_destroy(p, NULL);
}

TEST(the_bounding_disk_holds_all_and_is_no_larger_than_jung_allows) {
    test_random random = {29};
    for (int family = 0; family < TEST_FAMILY_COUNT; ++family)
        for (size_t n = 3; n < 400; n = 2 * n + 1) {
            bmr_polygon *p = test_polygon((test_family)family, n, &random);
            double diameter = 0.0, farthest = 0.0;
            for (uint32_t i = 0; i < p->count; ++i) {
                const bmr_vec2 v = p->vertices[i];
                farthest = fmax(farthest, hypot(v.x - p->center.x, v.y - p->center.y));
                for (uint32_t j = 0; j < i; ++j)
                    diameter = fmax(diameter, hypot(v.x - p->vertices[j].x, v.y - p->vertices[j].y));
            }
            assert_true(farthest <= p->radius);
            assert_true(farthest >= p->radius * (1.0 - 1e-14)); // control: anything smaller would fail
            assert_true(p->radius <= diameter / sqrt(3.0) * (1.0 + 1e-12));
            bmr_polygon_destroy(p, NULL);
        }
}
