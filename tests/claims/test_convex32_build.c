// SPDX-License-Identifier: MIT
// Polygons of any size in float: how they are made, what of, and what is made of them.
#include "checks.h"
#include <float.h>

#include "convex32/convex32.h"
#include "convex32/directions.h"
#include "convex32_poses.h"
#include "convex32_reference.h"
#include "exact32/clip.h"
#include "polygons.h"

static bmr_vec32 vec(double x, double y) {
    const bmr_vec32 v = {(float)x, (float)y};
    return v;
}

#define PI 3.14159265358979323846

/// Lattice polygons: edges are short primitive vectors in order of direction, so every vertex turns, by more
/// than a float's rounding.
static uint32_t lattice_polygon(uint32_t most, bmr_vec32 *points) {
    enum { LONGEST = 184 };
    uint32_t count = 0;
    int32_t x = 0, y = 0;
    // Slopes of an eighth are the Farey sequence, up from 0/1 or down from 1/1.
    for (int eighth = 0; eighth < 8; ++eighth) {
        const bool down = eighth % 2 != 0;
        int32_t p = down, q = 1, next_p = down ? LONGEST - 1 : 1, next_q = LONGEST;
        while (down ? p > 0 : p < q) {
            int32_t dx = down ? p : q, dy = down ? q : p;
            for (int turn = 0; turn < eighth / 2; ++turn) {
                const int32_t was = dx;
                dx = -dy;
                dy = was;
            }
            if (count < most)
                points[count++] = vec(x, y);
            x += dx;
            y += dy;
            const int32_t k = (LONGEST + q) / next_q, third_p = k * next_p - p, third_q = k * next_q - q;
            p = next_p;
            q = next_q;
            next_p = third_p;
            next_q = third_q;
        }
    }
    return count;
}

TEST(polygons_have_up_to_65535_vertices) {
    bmr_vec32 *points = malloc(131072 * sizeof *points);
    assert_non_null(points);
    const uint32_t all = lattice_polygon(131072, points);
    assert_true(all > BMR_CONVEX32_MOST);
    bmr_convex32_block *const untouched = (bmr_convex32_block *)points, *block = untouched;
    assert_int_equal(bmr_convex32_create(points, all, NULL, &block), BMR_ERROR_TOO_MANY_POINTS);
    assert_int_equal(bmr_convex32_create_raw(points, all, NULL, &block), BMR_ERROR_TOO_MANY_POINTS);
    assert_int_equal(bmr_convex32_create(points, BMR_CONVEX32_MOST + 1, NULL, &block),
                     BMR_ERROR_TOO_MANY_POINTS);
    assert_ptr_equal(block, untouched);
    assert_int_equal(bmr_convex32_create_raw(points, BMR_CONVEX32_MOST, NULL, &block), BMR_OK);
    bmr_convex32_block *raw = block;
    assert_int_equal(bmr_convex32_create(points, BMR_CONVEX32_MOST, NULL, &block), BMR_OK);
    assert_int_equal(block->polygon.count, BMR_CONVEX32_MOST);
    const bmr_convex32 *p = &block->polygon;
    for (uint32_t b = 0; b < 1u << p->bucket_bits; ++b)
        assert_true(convex32_leaves_at(p, p->buckets[b], convex32_bucket_begin(b, p->bucket_bits)));
    assert_true(bmr_convex32_bytes(BMR_CONVEX32_MOST) <= 40 * (size_t)BMR_CONVEX32_MOST);
    for (int k = 0; k < 200; ++k) {
        const bmr_vec32 d = vec(cos(0.0314 * k), sin(0.0314 * k));
        assert_true(dot(p->vertices[bmr_convex32_support(p, d)], d) == loop_support(p, d));
    }
    bmr_convex32_destroy(raw, NULL);
    bmr_convex32_destroy(block, NULL);
    free(points);
}

/// (What is bad in other ways: tests/random/polygon32.cpp.)
TEST(points_that_are_hardly_a_polygon_are_one_or_are_refused) {
    const struct {
        bmr_vec32 points[4];
        size_t count;
        bmr_error hull, raw;
    } cases[] = {
        // Long enough in one of the two ways.
        {{{0, 0}, {2e-9f, 0}, {0, 5e-10f}}, 3, BMR_OK, BMR_OK},
        {{{0, 0}, {5e-10f, 0}, {0, 2e-9f}}, 3, BMR_OK, BMR_OK},
        // A needle whose long sides have opposite normals, as far as those can tell: its tip is no straight
        // vertex.
        {{{-1e9f, -1e9f}, {0.25f, -1}, {1, 0.25f}, {-0.25f, 1}},
         4,
         BMR_ERROR_TOO_FEW_POINTS,
         BMR_ERROR_NOT_CONVEX},
        // Turns by 1e-8, and so straight as far as its normals can tell.
        {{{-1, -1}, {0, -0x1p-27f}, {1, 1}, {-1, 1}}, 4, BMR_OK, BMR_ERROR_NOT_CONVEX},
    };
    for (size_t k = 0; k < COUNT_OF(cases); ++k) {
        own_convex32 *hull = NULL, *raw = NULL;
        assert_int_equal(bmr_convex32_create(cases[k].points, cases[k].count, NULL, &hull), cases[k].hull);
        assert_int_equal(bmr_convex32_create_raw(cases[k].points, cases[k].count, NULL, &raw), cases[k].raw);
    }
}

/// Of a needle whose short side is level, the area is known: half of base times height, both differences of
/// two floats.
TEST(masses_of_needles_are_exact) {
    test_random random = test_random_from(14);
    size_t made = 0, lost = 0;
    for (size_t k = 0; k < 100000; ++k) {
        const float scale = ldexpf(1.0f, (int)floor(test_random_uniform(&random, -40.0, -24.0)));
        const bmr_vec32 points[3] = {
            {(float)test_random_uniform(&random, 0.1, 1.0), (float)test_random_uniform(&random, -1.0, 0.5)},
            {scale * (float)test_random_uniform(&random, 0.0, 1.0), 1.0f},
            {-scale * (float)test_random_uniform(&random, 0.0, 1.0), 1.0f}};
        own_convex32 *block = NULL;
        if (bmr_convex32_create(points, 3, NULL, &block) != BMR_OK)
            continue;
        ++made;
        const long double base = (long double)points[1].x - (long double)points[2].x;
        const long double area = base * (1.0L - (long double)points[0].y) / 2;
        assert_true(fabsl((long double)block->mass.area - area) <= 1e-7L * area);
        const loop_mass truth = loop_measure(&block->polygon);
        assert_true(fabsl(truth.area - area) <= 1e-12L * area);
        assert_true(fabsl((long double)block->mass.inertia - truth.inertia) <= 1e-7L * truth.inertia);
        assert_true(fabsl((long double)block->mass.centroid.x - truth.x) <=
                    1e-7L * (long double)block->reach);
        assert_true(fabsl((long double)block->mass.centroid.y - truth.y) <=
                    1e-7L * (long double)block->reach);
        // The control: a product of rounded differences is somewhere else.
        const double ax = (double)points[0].x, ay = (double)points[0].y;
        const double rounded =
            ((double)points[1].x - ax) * (1.0 - ay) - (1.0 - ay) * ((double)points[2].x - ax);
        lost += fabsl(rounded / 2 - area) > 1e-7L * area;
    }
    assert_true(made > 100 && lost > 10);
}

/// (Of any polygon: random/polygon32.cpp.)
TEST(the_polygon_inside_spreads) {
    // Of a disk the octagon's depth is its sagitta.
    bmr_vec32 points[256];
    for (int i = 0; i < 256; ++i)
        points[i] = vec(cos(2.0 * PI * i / 256), sin(2.0 * PI * i / 256));
    own_convex32 *block = made_convex32(points, 256);
    uint32_t inner[8];
    bmr_convex32_inner(&block->polygon, inner, 8);
    for (uint32_t i = 0; i < 8; ++i)
        assert_int_equal(inner[i], 32 * i);
}
