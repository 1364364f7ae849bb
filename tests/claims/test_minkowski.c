// SPDX-License-Identifier: MIT
#include "boomerang/minkowski.h"
#include "checks.h"
#include "motions.h"
#include "polygons.h"
#include "test_scale.h"

static bmr_polygon *difference_of(const bmr_polygon *a, const bmr_polygon *b, double angle) {
    bmr_polygon *m = NULL;
    const bmr_vec2 rotation = {cos(angle), sin(angle)};
    assert_int_equal(bmr_minkowski_difference(a, b, rotation, NULL, &m), BMR_OK);
    return m;
}

/// Brute force: the hull of all differences of two vertices.
static bmr_polygon *all_differences(const bmr_polygon *a, const bmr_polygon *b, double angle) {
    bmr_vec2 *points = malloc((size_t)a->count * b->count * sizeof *points);
    const bmr_pose turn = {{0.0, 0.0}, cos(angle), sin(angle)};
    size_t count = 0;
    for (uint32_t i = 0; i < a->count; ++i)
        for (uint32_t j = 0; j < b->count; ++j)
            points[count++] = bmr_sub(a->vertices[i], bmr_rotate(&turn, b->vertices[j]));
    bmr_polygon *m = made_polygon(points, count);
    free(points);
    return m;
}

/// The largest difference of the two support functions, over the normals of both and some directions.
static double support_error(const bmr_polygon *p, const bmr_polygon *q, test_random *random) {
    double most = 0.0;
    for (uint32_t i = 0; i < p->count + q->count + 32; ++i) {
        const double angle = test_random_uniform(random, 0.0, 6.3);
        const bmr_vec2 d = i < p->count              ? bmr_polygon_normal(p, i)
                           : i < p->count + q->count ? bmr_polygon_normal(q, i - p->count)
                                                     : bmr_vec2_make(cos(angle), sin(angle));
        const double hp = bmr_dot(d, p->vertices[bmr_polygon_support(p, d)]);
        const double hq = bmr_dot(d, q->vertices[bmr_polygon_support(q, d)]);
        most = fmax(most, fabs(hp - hq));
    }
    return most;
}

TEST(it_is_the_hull_of_all_differences) {
    test_random random = {21};
    const size_t sizes[] = {3, 4, 7, 20};
    size_t wrong_angles = 0, pairs = 0;
    for (size_t round = 0; round < test_scaled(1); ++round)
        for (int f = 0; f < TEST_FAMILY_COUNT; ++f)
            for (int g = 0; g < TEST_FAMILY_COUNT; ++g) {
                const size_t n = sizes[test_random_below(&random, 4)],
                             m = sizes[test_random_below(&random, 4)];
                own_polygon *a = test_polygon((test_family)f, n, &random);
                own_polygon *b = test_polygon((test_family)g, m, &random);
                const double angle =
                    test_random_below(&random, 2) ? 0.0 : test_random_uniform(&random, -4.0, 4.0);
                own_polygon *sum = difference_of(a, b, angle), *brute = all_differences(a, b, angle);
                own_polygon *other = difference_of(a, b, angle + 0.5);
                assert_int_equal(bmr_polygon_audit(sum), BMR_OK);
                assert_true(sum->count <= a->count + b->count);
                const double slop = 1e-15 * (a->extent + b->extent);
                assert_true(support_error(sum, brute, &random) <= 8.0 * slop);
                wrong_angles += support_error(other, brute, &random) > 1e3 * slop; // the control
                ++pairs;
            }
    assert_true(wrong_angles > pairs / 2);
}

TEST(parallel_edges_become_one) {
    test_random random = {22};
    own_polygon *box = test_polygon(TEST_BOX, 4, &random), *octagon = test_polygon(TEST_OCTAGON, 8, &random);
    own_polygon *grid = test_polygon(TEST_PARALLEL, 16, &random);
    bmr_polygon *m = difference_of(box, box, 0.0);
    assert_int_equal(m->count, 4);
    bmr_polygon_destroy(m, NULL);
    m = difference_of(box, octagon, 0.0);
    assert_int_equal(m->count, 8);
    bmr_polygon_destroy(m, NULL);
    m = difference_of(grid, grid, 0.0); // centrally symmetric: -B has B's edges
    assert_int_equal(m->count, grid->count);
    bmr_polygon_destroy(m, NULL);
    m = difference_of(grid, grid, 0.1); // the control: turned, none is parallel
    assert_int_equal(m->count, 2 * grid->count);
    bmr_polygon_destroy(m, NULL);
}

TEST(points_and_segments_have_one_too) {
    const bmr_vec2 points[] = {{1.0, 2.0}, {3.0, 5.0}, {0.0, 4.0}};
    own_polygon *point = made_polygon(points, 1), *segment = made_polygon(points, 2);
    own_polygon *cross = made_polygon(points + 1, 2);
    bmr_polygon *m = difference_of(point, point, 0.0);
    assert_int_equal(m->count, 1);
    assert_true(m->vertices[0].x == 0.0 && m->vertices[0].y == 0.0);
    bmr_polygon_destroy(m, NULL);
    m = difference_of(segment, point, 0.0);
    assert_int_equal(m->count, 2);
    bmr_polygon_destroy(m, NULL);
    m = difference_of(segment, segment, 0.0);
    assert_int_equal(m->count, 2);
    bmr_polygon_destroy(m, NULL);
    m = difference_of(segment, cross, 0.0);
    assert_int_equal(m->count, 4);
    bmr_polygon_destroy(m, NULL);
}
