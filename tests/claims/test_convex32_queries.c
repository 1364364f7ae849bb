// SPDX-License-Identifier: MIT
// What is asked of a polygon of any size in O(log n) is what a loop over all vertices answers, to the bit.
// Each comparison has a control: a plausible short cut that it catches.

#include "checks.h"
#include <float.h>
#include <math.h>

#include "convex32/convex32.h"
#include "convex32/directions.h"
#include "convex32_loops.h"
#include "convex32_random.h"
#include "polygons.h"
#include "test_scale.h"

/// The control: the vertex where the direction really leaves the polygon.
static uint32_t leaving_vertex(const bmr_convex32 *p, bmr_vec32 d) {
    for (uint32_t i = 0; i < p->count; ++i)
        if (convex32_leaves_at(p, i, d))
            return i;
    return 0;
}

TEST(supports_have_the_largest_product_of_all) {
    test_random random = {4};
    size_t control = 0;
    for (size_t k = 0; k < test_scaled(1500); ++k) {
        bmr_convex32_block *block = random_polygon(&random, random_count(&random));
        const bmr_convex32 *p = &block->polygon;
        for (int q = 0; q < 50; ++q) {
            const bmr_vec32 d = random_direction(&random, p);
            const float most = loop_support(p, d);
            const uint32_t support = bmr_convex32_support(p, d);
            assert_true(support < p->count && convex32_dot(p->vertices[support], d) == most);
            const uint32_t hint =
                q % 5 ? (support + test_random_below(&random, q % 2 ? 6 : p->count)) % p->count : UINT32_MAX;
            const uint32_t from = bmr_convex32_support_from(p, d, hint);
            assert_true(from < p->count && convex32_dot(p->vertices[from], d) == most);
            control += convex32_dot(p->vertices[leaving_vertex(p, d)], d) != most;
        }
        bmr_convex32_destroy(block, NULL);
    }
    assert_true(control > 0);
}

TEST(directions_that_are_none_have_an_answer) {
    test_random random = {5};
    const float values[] = {0.0f, -0.0f, 1.0f, NAN, INFINITY, -INFINITY, FLT_MAX, -FLT_MAX, FLT_MIN, 1e-45f};
    for (int k = 0; k < 20; ++k) {
        bmr_convex32_block *block = random_polygon(&random, 3 + 20 * (size_t)k);
        const bmr_convex32 *p = &block->polygon;
        for (size_t i = 0; i < COUNT_OF(values) * COUNT_OF(values); ++i) {
            const bmr_vec32 d = {values[i / COUNT_OF(values)], values[i % COUNT_OF(values)]};
            const uint32_t support = bmr_convex32_support(p, d);
            const uint32_t from = bmr_convex32_support_from(p, d, p->count / 2);
            assert_true(support < p->count && from < p->count);
            if (isnan(d.x) || isnan(d.y) || (d.x == 0.0f && d.y == 0.0f))
                assert_true(support == 0 && from == 0);
            else if (isfinite(loop_support(p, d)))
                assert_true(convex32_dot(p->vertices[support], d) == loop_support(p, d));
        }
        bmr_convex32_destroy(block, NULL);
    }
}

/// The control: what is true of the vertices.
static bool really_contains(const bmr_convex32 *p, bmr_vec32 q) {
    for (uint32_t i = 0; i < p->count; ++i) {
        const bmr_vec32 v = p->vertices[i], w = p->vertices[convex32_next(p, i)];
        if (((double)w.x - (double)v.x) * ((double)q.y - (double)v.y) -
                ((double)w.y - (double)v.y) * ((double)q.x - (double)v.x) <
            0.0)
            return false;
    }
    return true;
}

static bmr_vec32 point_near(test_random *random, const bmr_convex32 *p) {
    const bmr_vec32 a = any_vertex(random, p), b = any_vertex(random, p);
    const uint32_t edge = test_random_below(random, p->count);
    const double t = test_random_uniform(random, 0.0, 1.0);
    switch (test_random_below(random, 6)) {
    case 0:
        return a;
    case 1:
        return between(a, b, t);
    case 2: // beyond, by as little as an ulp
        return between(a, b, test_random_below(random, 2) ? 1.0 + 1e-7 * t : 1.0 + t);
    default: // on an edge, as far as floats go
        return between(p->vertices[edge], p->vertices[convex32_next(p, edge)], t);
    }
}

TEST(points_are_inside_where_the_loop_says_so) {
    test_random random = {6};
    size_t inside = 0, control = 0, asked = 0;
    for (size_t k = 0; k < test_scaled(1500); ++k) {
        bmr_convex32_block *block = random_polygon(&random, random_count(&random));
        const bmr_convex32 *p = &block->polygon;
        for (int q = 0; q < 50; ++q, ++asked) {
            const bmr_vec32 point = point_near(&random, p);
            const bool in = loop_contains(p, point);
            assert_int_equal(bmr_convex32_contains(p, point), in);
            inside += in;
            control += really_contains(p, point) != in;
        }
        const float strange[] = {NAN, INFINITY, -INFINITY, FLT_MAX, -FLT_MAX, 0.0f};
        for (size_t i = 0; i < 36; ++i) {
            const bmr_vec32 point = {strange[i / 6], strange[i % 6]};
            assert_int_equal(bmr_convex32_contains(p, point), loop_contains(p, point));
        }
        bmr_convex32_destroy(block, NULL);
    }
    assert_true(inside > asked / 10 && inside < asked - asked / 10);
    assert_true(control > 0);
}

typedef struct ray {
    bmr_vec32 p1, p2;
    float max_fraction;
} ray;

static ray random_ray(test_random *random, const bmr_convex32_block *block) {
    const bmr_convex32 *p = &block->polygon;
    const double angle = test_random_uniform(random, -3.2, 3.2);
    const double far = (double)block->reach * pow(10.0, test_random_uniform(random, -1.0, 3.0));
    const bmr_vec32 a = any_vertex(random, p);
    const uint32_t edge = test_random_below(random, p->count);
    const bmr_vec32 from = p->vertices[edge], to = p->vertices[convex32_next(p, edge)];
    ray r = {vec((double)a.x + far * cos(angle), (double)a.y + far * sin(angle)), point_near(random, p),
             1.0f};
    switch (test_random_below(random, 13)) {
    case 0: // along an edge
        r.p1 = between(from, to, -1.0 - test_random_uniform(random, 0.0, 3.0));
        r.p2 = between(from, to, 2.0);
        break;
    case 1: // next to parallel to it
        r.p1 = between(from, to, -5.0);
        r.p2 = between(point_near(random, p), to, 1.0 - 1e-3);
        break;
    case 2:
        r.p2.y = r.p1.y;
        break;
    case 3:
        r.p2.x = r.p1.x;
        break;
    case 4: // from inside or on it
        r.p1 = point_near(random, p);
        break;
    case 5: // no ray at all
        r.p1 = r.p2;
        break;
    case 6:
    case 7: { // past a vertex, some ulps above or below
        const bmr_vec32 n = p->normals[edge];
        const double turn = test_random_below(random, 2) ? test_random_uniform(random, -1e-3, 1e-3) : 0.0;
        const double up = (double)block->reach * ldexp(test_random_uniform(random, -1.0, 1.0), -20);
        const double x = far * ((double)n.y + turn * (double)n.x),
                     y = far * (turn * (double)n.y - (double)n.x);
        const double at_x = (double)from.x + up * (double)n.x, at_y = (double)from.y + up * (double)n.y;
        r.p1 = vec(at_x - x, at_y - y);
        r.p2 = vec(at_x + x, at_y + y);
        if (test_random_below(random, 2) == 0)
            r.max_fraction = (float)pow(10.0, test_random_uniform(random, 0.0, 9.0));
        return r;
    }
    case 8: // ends far beyond
        r.max_fraction = (float)pow(10.0, test_random_uniform(random, 0.0, 12.0));
        return r;
    default: // through, or short of it
        r.p2 = between(r.p1, r.p2, test_random_uniform(random, 0.5, 2.0));
    }
    if (test_random_below(random, 4) == 0)
        r.max_fraction = (float)test_random_uniform(random, 0.0, 3.0);
    return r;
}

TEST(rays_hit_what_the_loop_hits) {
    test_random random = {7};
    size_t hits = 0, asked = 0, control = 0;
    for (size_t k = 0; k < test_scaled(2000); ++k) {
        bmr_convex32_block *block = random_polygon(&random, random_count(&random));
        const bmr_convex32 *p = &block->polygon;
        for (int q = 0; q < 50; ++q, ++asked) {
            const ray r = random_ray(&random, block);
            float expected = -1.0f, fraction = -1.0f, other;
            uint32_t edge_expected = 0, edge = UINT32_MAX, other_edge;
            const bool hit = loop_ray(p, r.p1, r.p2, r.max_fraction, UINT32_MAX, &expected, &edge_expected);
            assert_int_equal(bmr_convex32_ray(p, r.p1, r.p2, r.max_fraction, &fraction, &edge), hit);
            if (hit) {
                assert_true(fraction == expected);
                assert_int_equal(edge, edge_expected);
                const bool still = loop_ray(p, r.p1, r.p2, r.max_fraction, edge, &other, &other_edge);
                control += !still || other != expected;
            } else
                assert_true(fraction == -1.0f && edge == UINT32_MAX);
            hits += hit;
        }
        const float strange[] = {NAN, INFINITY, FLT_MAX, -1e20f, 1e-30f};
        for (size_t i = 0; i < 25; ++i) {
            const ray r = {{strange[i / 5], 1.0f}, {0.5f, strange[i % 5]}, 1.0f};
            float expected = -1.0f, fraction = -1.0f;
            uint32_t edge_expected, edge = UINT32_MAX;
            const bool hit = loop_ray(p, r.p1, r.p2, r.max_fraction, UINT32_MAX, &expected, &edge_expected);
            assert_int_equal(bmr_convex32_ray(p, r.p1, r.p2, r.max_fraction, &fraction, &edge), hit);
            assert_true(!hit || fraction == expected || (isnan(fraction) && isnan(expected)));
        }
        bmr_convex32_destroy(block, NULL);
    }
    assert_true(hits > asked / 10 && hits < asked - asked / 10);
    assert_true(control > 0);
}

/// A lens so flat that no edge cuts a ray along it for sure: of a ray from far too much is left to know how
/// far rounding reaches, and all edges are asked.
TEST(rays_along_a_flat_lens_hit_what_the_loop_hits) {
    enum { HALF = 40 };
    bmr_vec32 lens[2 * HALF];
    const float height = 1e-8f;
    for (int i = 0; i < HALF; ++i) {
        const float x = -1.0f + 2.0f * (float)i / HALF;
        lens[i] = (bmr_vec32){x, -height * (1.0f - x * x)};
        lens[i + HALF] = (bmr_vec32){-x, height * (1.0f - x * x)};
    }
    bmr_convex32_block *block = NULL;
    assert_int_equal(bmr_convex32_create_raw(lens, 2 * HALF, NULL, &block), BMR_OK);
    size_t hits = 0;
    for (int i = -20; i <= 20; ++i) {
        const float end = 100.0f, rise = 0.2f * height * (float)i;
        const ray r = {{-3.0f, rise}, {end, rise}, 1.0f};
        float expected = -1.0f, fraction = -1.0f;
        uint32_t edge_expected = UINT32_MAX, edge = UINT32_MAX;
        const bool hit =
            loop_ray(&block->polygon, r.p1, r.p2, r.max_fraction, UINT32_MAX, &expected, &edge_expected);
        assert_int_equal(bmr_convex32_ray(&block->polygon, r.p1, r.p2, r.max_fraction, &fraction, &edge),
                         hit);
        assert_true(!hit || (fraction == expected && edge == edge_expected));
        hits += hit;
    }
    assert_true(hits > 0 && hits < 41);
    bmr_convex32_destroy(block, NULL);
}

TEST(boxes_are_those_of_all_vertices) {
    test_random random = {8};
    size_t control = 0;
    for (size_t k = 0; k < test_scaled(1500); ++k) {
        bmr_convex32_block *block = random_polygon(&random, random_count(&random));
        const bmr_convex32 *p = &block->polygon;
        for (int q = 0; q < 30; ++q) {
            const float angle = (float)test_random_uniform(&random, -3.2, 3.2);
            const bmr_transform32 pose = {
                vec(test_random_uniform(&random, -100, 100), test_random_uniform(&random, -100, 100)),
                q % 8 ? sinf(angle) : 0.0f, q % 8 ? cosf(angle) : 1.0f};
            bmr_vec32 low, high, lower, upper;
            loop_box(p, &pose, &low, &high);
            bmr_convex32_box(p, &pose, &lower, &upper);
            assert_true(lower.x == low.x && lower.y == low.y && upper.x == high.x && upper.y == high.y);
            const bmr_vec32 v = p->vertices[leaving_vertex(p, vec((double)pose.c, -(double)pose.s))];
            control += (pose.c * v.x - pose.s * v.y) + pose.p.x != high.x;
        }
        bmr_convex32_destroy(block, NULL);
    }
    assert_true(control > 0);
}
