// SPDX-License-Identifier: MIT
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <math.h>

#include "boomerang/polygon.h"
#include "failing_allocator.h"
#include "geometry/predicates.h"
#include "polygons.h"
#include "test_scale.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))
#define UNTOUCHED ((bmr_polygon *)(uintptr_t)0x5a5a5a50u)

static void each_error_has_its_own_sentence(void **state) {
    (void)state;
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

// --- the predicate ---

static int naive_orientation(bmr_vec2 a, bmr_vec2 b, bmr_vec2 c) {
    const double d = bmr_cross(bmr_sub(b, a), bmr_sub(c, a));
    return (d > 0.0) - (d < 0.0);
}

typedef int (*orientation_function)(bmr_vec2, bmr_vec2, bmr_vec2);

/// Points a few ulps around (1/2, 1/2) against the line y = x: the sign is that of j - i.
static int wrong_signs_near_diagonal(orientation_function orientation, double scale) {
    const double ulp = 0x1p-53;
    const bmr_vec2 b = {12.0 * scale, 12.0 * scale}, c = {24.0 * scale, 24.0 * scale};
    int wrong = 0;
    for (int i = 0; i < 64; ++i)
        for (int j = 0; j < 64; ++j) {
            const bmr_vec2 a = {scale * (0.5 + (double)i * ulp), scale * (0.5 + (double)j * ulp)};
            wrong += orientation(a, b, c) != (j > i) - (j < i);
        }
    return wrong;
}

static void orientation_is_exact_where_rounding_decides(void **state) {
    (void)state;
    // 2^-1000 and 2^1000 make every product underflow or overflow.
    const double scales[] = {1.0, 0x1p25, 0x1p-200, 0x1p-1000, 0x1p1000};
    for (size_t i = 0; i < COUNT_OF(scales); ++i)
        assert_int_equal(wrong_signs_near_diagonal(bmr_orientation, scales[i]), 0);
    // Control: the plain formula fails the same check.
    assert_true(wrong_signs_near_diagonal(naive_orientation, 1.0) > 100);
}

static void orientation_sees_denormals(void **state) {
    (void)state;
    const double tiny = 0x1p-1074;
    const bmr_vec2 o = {0.0, 0.0}, far = {1.0, 1.0};
    assert_int_equal(bmr_orientation(o, far, bmr_vec2_make(tiny, 2.0 * tiny)), 1);
    assert_int_equal(bmr_orientation(o, far, bmr_vec2_make(2.0 * tiny, tiny)), -1);
    assert_int_equal(bmr_orientation(o, far, bmr_vec2_make(3.0 * tiny, 3.0 * tiny)), 0);
    assert_int_equal(bmr_orientation(bmr_vec2_make(1e9, tiny), o, bmr_vec2_make(-1e9, 0.0)), -1);
    assert_int_equal(bmr_orientation(bmr_vec2_make(tiny, 0.0), bmr_vec2_make(0.0, tiny), o), 1);
    assert_int_equal(naive_orientation(bmr_vec2_make(tiny, 0.0), bmr_vec2_make(0.0, tiny), o), 0); // control
}

static void orientation_is_cyclic_and_antisymmetric(void **state) {
    (void)state;
    test_random random = {7};
    for (size_t round = 0; round < test_scaled(20000); ++round) {
        bmr_vec2 p[3];
        for (int i = 0; i < 3; ++i) // coarse mantissas make collinear triples common, exponents wild
            p[i] = bmr_vec2_make(
                ldexp((double)test_random_below(&random, 16) - 8.0, (int)test_random_below(&random, 4)),
                ldexp((double)test_random_below(&random, 16) - 8.0, (int)test_random_below(&random, 4)));
        const int o = bmr_orientation(p[0], p[1], p[2]);
        assert_int_equal(o,
                         naive_orientation(p[0], p[1], p[2])); // small integers: the plain formula is exact
        assert_int_equal(o, bmr_orientation(p[1], p[2], p[0]));
        assert_int_equal(o, -bmr_orientation(p[1], p[0], p[2]));
        assert_int_equal(bmr_orientation(p[0], p[1], p[1]), 0);
    }
}

// --- hull ---

static bmr_polygon *hull_of(const bmr_vec2 *points, size_t count) {
    bmr_polygon *polygon = NULL;
    assert_int_equal(bmr_polygon_create(points, count, NULL, &polygon), BMR_OK);
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

static void hull_drops_inner_collinear_and_equal_points(void **state) {
    (void)state;
    const bmr_vec2 points[] = {{1, 1}, {0, 0}, {2, 0}, {1, 0},      {2, 2}, {0, 2},
                               {0, 1}, {2, 1}, {0, 0}, {-0.0, 0.0}, {1, 2}};
    const bmr_vec2 expected[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    bmr_polygon *polygon = hull_of(points, COUNT_OF(points));
    assert_vertices(polygon, expected, 4);
    bmr_polygon_destroy(polygon, NULL);
}

static void hull_of_one_place_is_a_point_and_of_a_line_a_segment(void **state) {
    (void)state;
    const bmr_vec2 same[] = {{3, -4}, {3, -4}, {3, -4}};
    bmr_polygon *polygon = hull_of(same, 3);
    assert_vertices(polygon, same, 1);
    assert_true(polygon->radius == 0.0 && polygon->extent == 4.0);
    bmr_polygon_destroy(polygon, NULL);

    const bmr_vec2 line[] = {{1, 2}, {-1, -2}, {0, 0}, {0.5, 1}, {2, 4}}, ends[] = {{-1, -2}, {2, 4}};
    polygon = hull_of(line, COUNT_OF(line));
    assert_vertices(polygon, ends, 2);
    bmr_polygon_destroy(polygon, NULL);
}

static void hull_keeps_a_vertex_that_sticks_out_by_one_ulp_and_drops_one_that_does_not(void **state) {
    (void)state;
    const double y = 0.5, out = nextafter(y, 0.0), in = nextafter(y, 1.0);
    const bmr_vec2 sticks_out[] = {{0, 0.0}, {1, 1}, {0.5, out}, {0, 1}};
    bmr_polygon *polygon = hull_of(sticks_out, 4);
    assert_int_equal(polygon->count, 4);
    bmr_polygon_destroy(polygon, NULL);
    const double others[] = {y, in};
    for (int i = 0; i < 2; ++i) {
        const bmr_vec2 does_not[] = {{0, 0.0}, {1, 1}, {0.5, others[i]}, {0, 1}};
        polygon = hull_of(does_not, 4);
        assert_int_equal(polygon->count, 3);
        bmr_polygon_destroy(polygon, NULL);
    }
}

static void hull_does_not_depend_on_the_order_of_the_points(void **state) {
    (void)state;
    test_random random = {11};
    for (int family = 0; family < TEST_FAMILY_COUNT; ++family) {
        bmr_vec2 points[112];
        const size_t count = test_points((test_family)family, 100, &random, points);
        bmr_polygon *first = hull_of(points, count);
        for (size_t i = count; i-- > 1;) {
            const size_t j = test_random_below(&random, (uint32_t)i + 1);
            const bmr_vec2 swapped = points[i];
            points[i] = points[j];
            points[j] = swapped;
        }
        bmr_polygon *second = hull_of(points, count);
        assert_int_equal(first->count, second->count);
        assert_memory_equal(first->vertices, second->vertices, first->count * sizeof(bmr_vec2));
        bmr_polygon_destroy(first, NULL);
        bmr_polygon_destroy(second, NULL);
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

static void bad_points_are_refused_and_leave_the_output_alone(void **state) {
    (void)state;
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

static void more_than_65535_points_are_refused_and_65535_are_not(void **state) {
    (void)state;
    bmr_vec2 *points = malloc(65536 * sizeof *points);
    assert_non_null(points);
    test_regular_points(65536, 1.0, 0.0, points);
    assert_refused(points, 65536, BMR_ERROR_TOO_MANY_POINTS);
    test_regular_points(65535, 1.0, 0.0, points);
    bmr_polygon *polygon = hull_of(points, 65535);
    assert_int_equal(polygon->count, 65535);
    bmr_polygon_destroy(polygon, NULL);
    free(points);
}

static void the_range_is_accepted_up_to_its_ends(void **state) {
    (void)state;
    const bmr_vec2 large[] = {{-1e9, -1e9}, {1e9, -1e9}, {1e9, 1e9}},
                   small[] = {{0, 0}, {1e-9, 0}, {0, 1e-9}};
    bmr_polygon *polygon = hull_of(large, 3);
    bmr_polygon_destroy(polygon, NULL);
    polygon = hull_of(small, 3);
    bmr_polygon_destroy(polygon, NULL);
}

static void every_failing_allocation_is_reported_and_nothing_leaks(void **state) {
    (void)state;
    bmr_vec2 points[64];
    test_regular_points(64, 1.0, 0.1, points);
    for (size_t i = 0; i < COUNT_OF(creators); ++i) {
        test_heap heap;
        test_heap_init(&heap, SIZE_MAX);
        bmr_polygon *polygon = NULL;
        assert_int_equal(creators[i](points, 64, &heap.allocator, &polygon), BMR_OK);
        const size_t allocations = heap.asked;
        assert_int_equal(heap.blocks, 1); // the scratch has gone back
        assert_int_equal(heap.bytes, bmr_polygon_bytes(64));
        bmr_polygon_destroy(polygon, &heap.allocator);
        assert_int_equal(heap.blocks + heap.bytes + heap.wrong_sizes, 0);
        for (size_t fail = 0; fail < allocations; ++fail) {
            test_heap_init(&heap, fail);
            polygon = UNTOUCHED;
            assert_int_equal(creators[i](points, 64, &heap.allocator, &polygon), BMR_ERROR_NO_MEMORY);
            assert_ptr_equal(polygon, UNTOUCHED);
            assert_int_equal(heap.blocks + heap.wrong_sizes, 0);
        }
    }
    bmr_polygon_destroy(NULL, NULL);
}

static void a_block_takes_16_bytes_a_vertex_and_64_more_at_most(void **state) {
    (void)state;
    for (size_t n = 1; n <= 65535; n = 2 * n + 1)
        assert_true(bmr_polygon_bytes(n) <= 16 * n + 64);
}

// --- audit ---

static void audit_refuses_what_is_not_strictly_convex(void **state) {
    (void)state;
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
        bmr_polygon *polygon = NULL;
        assert_int_equal(bmr_polygon_create_raw(cases[i].points, cases[i].count, NULL, &polygon), BMR_OK);
        assert_vertices(polygon, cases[i].points, (uint32_t)cases[i].count);
        assert_int_equal(bmr_polygon_audit(polygon), cases[i].expected);
        bmr_polygon_destroy(polygon, NULL);
    }
    assert_int_equal(bmr_polygon_audit(NULL), BMR_ERROR_NULL_ARGUMENT);
}

static void audit_refuses_wrong_measures(void **state) {
    (void)state;
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
    ((bmr_vec2 *)(uintptr_t)polygon->vertices)[3].x = NAN;
    assert_int_equal(bmr_polygon_audit(polygon), BMR_ERROR_NOT_FINITE);
    bmr_polygon_destroy(polygon, NULL);
}

// --- queries ---

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

static void support_is_a_farthest_vertex_from_scratch_and_from_any_hint(void **state) {
    (void)state;
    test_random random = {13};
    size_t controls = 0, rejected = 0;
    for (int family = 0; family < TEST_FAMILY_COUNT; ++family)
        for (size_t n = 3; n <= 1100; n = 3 * n + 1) {
            bmr_polygon *p = test_polygon((test_family)family, n, &random);
            for (size_t round = 0; round < test_scaled(60); ++round) {
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

static void support_of_a_tie_is_the_counter_clockwise_first(void **state) {
    (void)state;
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

static void a_direction_that_is_none_gives_the_hint_back(void **state) {
    (void)state;
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

static void a_climb_does_not_get_stuck_where_the_bottom_is_flat_up_to_rounding(void **state) {
    (void)state;
    test_random random = {17};
    size_t stuck = 0, tried = 0;
    for (size_t round = 0; round < test_scaled(20000); ++round) {
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
    assert_true(tried > 1000 || test_scaled(20000) < 20000);
    assert_true(stuck > 0); // control: a climb that believes its neighbours does get stuck here
}

static void normals_have_unit_length_and_point_outwards(void **state) {
    (void)state;
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

static void contains_agrees_with_every_edge_of_the_polygon(void **state) {
    (void)state;
    test_random random = {23};
    size_t inside = 0, outside = 0;
    for (int family = 0; family < TEST_FAMILY_COUNT; ++family)
        for (size_t n = 3; n < 200; n = 2 * n + 1) {
            bmr_polygon *p = test_polygon((test_family)family, n, &random);
            for (size_t round = 0; round < test_scaled(200); ++round) {
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

static void contains_takes_the_tolerance_from_every_edge(void **state) {
    (void)state;
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

static void the_bounding_disk_holds_all_and_is_no_larger_than_jung_allows(void **state) {
    (void)state;
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_error_has_its_own_sentence),
        cmocka_unit_test(orientation_is_exact_where_rounding_decides),
        cmocka_unit_test(orientation_sees_denormals),
        cmocka_unit_test(orientation_is_cyclic_and_antisymmetric),
        cmocka_unit_test(hull_drops_inner_collinear_and_equal_points),
        cmocka_unit_test(hull_of_one_place_is_a_point_and_of_a_line_a_segment),
        cmocka_unit_test(hull_keeps_a_vertex_that_sticks_out_by_one_ulp_and_drops_one_that_does_not),
        cmocka_unit_test(hull_does_not_depend_on_the_order_of_the_points),
        cmocka_unit_test(bad_points_are_refused_and_leave_the_output_alone),
        cmocka_unit_test(more_than_65535_points_are_refused_and_65535_are_not),
        cmocka_unit_test(the_range_is_accepted_up_to_its_ends),
        cmocka_unit_test(every_failing_allocation_is_reported_and_nothing_leaks),
        cmocka_unit_test(a_block_takes_16_bytes_a_vertex_and_64_more_at_most),
        cmocka_unit_test(audit_refuses_what_is_not_strictly_convex),
        cmocka_unit_test(audit_refuses_wrong_measures),
        cmocka_unit_test(support_is_a_farthest_vertex_from_scratch_and_from_any_hint),
        cmocka_unit_test(support_of_a_tie_is_the_counter_clockwise_first),
        cmocka_unit_test(a_direction_that_is_none_gives_the_hint_back),
        cmocka_unit_test(a_climb_does_not_get_stuck_where_the_bottom_is_flat_up_to_rounding),
        cmocka_unit_test(normals_have_unit_length_and_point_outwards),
        cmocka_unit_test(contains_agrees_with_every_edge_of_the_polygon),
        cmocka_unit_test(contains_takes_the_tolerance_from_every_edge),
        cmocka_unit_test(the_bounding_disk_holds_all_and_is_no_larger_than_jung_allows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
