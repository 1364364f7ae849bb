// SPDX-License-Identifier: MIT
// The families of motion come as near as they say, turn or do not turn, and are the same from the same seed.
#include "checks.h"
#include "course_stage.h"

#include "boomerang/families.h"
#include "hierarchies.h"
#include "motions.h"
#include "polygons.h"

#define PI 3.14159265358979323846

TEST(test_diameter_is_the_largest_distance_of_two_vertices) {
    test_random random = test_random_from(1);
    for (int family = 0; family < TEST_FAMILY_COUNT; family++)
        for (size_t n = 3; n < 60; n += 7) {
            own_polygon *p = test_polygon((test_family)family, n, &random);
            assert_non_null(p);
            const double brute = test_diameter(p), fast = bmr_polygon_diameter(p);
            assert_true(fabs(fast - brute) <= 1e-14 * brute);
        }
}

TEST(test_ngons_have_n_vertices_and_diameter_up_to_2) {
    for (int kind = 0; kind < BMR_NGON_COUNT; kind++)
        for (size_t n = 4; n <= 256; n *= 4) {
            own_polygon *p = ngon((bmr_ngon)kind, n, n + (size_t)kind);
            assert_int_equal(p->count, n);
            const double d = bmr_polygon_diameter(p), most = kind == BMR_NGON_DISC ? 1.0 : 2.0;
            assert_true(d <= most * (1.0 + 1e-12));
            if (n >= 16)
                assert_true(d > 0.8 * most);
        }
}

/// Samples, by code that shares nothing with core: nowhere nearer than claimed, and somewhere as near.
static void check_separation(const bmr_family_motion *m, const bmr_polygon *a, const bmr_polygon *b) {
    const size_t samples = test_scaled(2000);
    double least = INFINITY;
    for (size_t i = 0; i <= samples; i++) {
        const bmr_pose pose = relative_at(m->motions, (double)i / (double)samples);
        least = fmin(least, test_distance(a, b, &pose));
    }
    const bmr_pose nearest = relative_at(m->motions, m->nearest);
    assert_true(fabs(m->separation - m->sigma) <= 0.01 * m->sigma);
    assert_true(least >= 0.99 * m->sigma);
    assert_true(fabs(test_distance(a, b, &nearest) - m->separation) <= 1e-6 * m->sigma);
}

TEST(test_least_separation_is_sigma_within_1_percent) {
    static const bmr_ngon pairs[][2] = {{BMR_NGON_ELLIPSE, BMR_NGON_DISC},
                                        {BMR_NGON_REGULAR, BMR_NGON_LENS},
                                        {BMR_NGON_RANDOM, BMR_NGON_RANDOM}};
    for (int family = 0; family < BMR_FAMILY_COUNT; family++)
        for (size_t k = 0; k < 3; k++) {
            own_polygon *a = ngon(pairs[k][0], 32, k), *b = ngon(pairs[k][1], 24, k + 7);
            for (int step = 0; step < 3; step++) {
                const double ratio = 2.0 * pow(16.0, step);
                own_family m = family_motion((bmr_family)family, ratio, k + 1, a, b);
                check_separation(&m, a, b);
            }
        }
}

/// How far a pass leaves the straight line, in diameters: a parabola by 0.5 to 2.
TEST(test_only_a_parabola_bends_and_by_up_to_two_diameters) {
    double most = 0.0;
    for (uint64_t seed = 1; seed <= 20; seed++)
        for (int family = BMR_FAMILY_LINE; family <= BMR_FAMILY_PARABOLA; family++) {
            own_polygon *a = ngon(BMR_NGON_RANDOM, 12, seed), *b = ngon(BMR_NGON_LENS, 9, seed);
            own_family m = family_motion((bmr_family)family, 10.0, seed, a, b);
            const bmr_vec2 begin = relative_at(m.motions, 0.0).position,
                           middle = relative_at(m.motions, 0.5).position,
                           end = relative_at(m.motions, 1.0).position;
            const bmr_vec2 off = bmr_sub(bmr_scale(0.5, bmr_add(begin, end)), middle);
            const double bend = hypot(off.x, off.y) / m.diameter;
            assert_true(family == BMR_FAMILY_LINE ? bend < 1e-12 : bend > 0.5 - 1e-9 && bend < 2.0 + 1e-9);
            most = fmax(most, bend);
        }
    assert_true(most > 1.5);
}

/// B follows A's boundary all the way round at one distance, without a jump.
TEST(test_orbit_keeps_its_distance_and_closes) {
    for (size_t n = 3; n <= 100; n += 13) {
        own_polygon *a = ngon(BMR_NGON_RANDOM, n, n), *b = ngon(BMR_NGON_LENS, n + 2, n);
        own_family m = family_motion(BMR_FAMILY_ORBIT, 300.0, n, a, b);
        double turned = 0.0, last = NAN;
        for (int i = 0; i <= 20000; i++) {
            const bmr_pose q = relative_at(m.motions, i / 20000.0);
            if (i % 7 == 0)
                assert_true(fabs(test_distance(a, b, &q) - m.sigma) <= 1e-5 * m.sigma);
            const double angle = atan2(q.position.y, q.position.x);
            if (i > 0)
                turned += remainder(angle - last, 2.0 * PI);
            last = angle;
        }
        assert_true(fabs(turned - 2.0 * PI) < 1e-9);
    }
}

/// The control of the measurement: a motion whose least distance is known, and one that touches.
TEST(test_least_distance_finds_a_short_approach) {
    const bmr_vec2 point = {0.0, 0.0};
    own_polygon *a = ngon(BMR_NGON_REGULAR, 64, 1), *b = NULL;
    assert_int_equal(bmr_polygon_create(&point, 1, NULL, &b), BMR_OK);
    for (int touches = 0; touches < 2; touches++) {
        const bmr_pose rest = bmr_pose_identity(), far = {{3.0, touches ? 0.99 : 1.25}, 1.0, 0.0};
        const bmr_motion_piece still = bmr_piece_rest(rest),
                               pass = bmr_piece_screw(0.0, far, bmr_vec2_make(-1000.0, 0.0), 0.0);
        own_motion *motion_a = made_motion(still), *motion_b = made_motion(pass);
        double distance, time;
        assert_int_equal(bmr_least_distance(a, b, motion_a, motion_b, -1.0, 1.0, 1e-6, &distance, &time),
                         BMR_OK);
        const bmr_pose at = bmr_motion_pose(motion_b, time, NULL, NULL);
        assert_true(fabs(test_distance(a, b, &at) - distance) <= 1e-12);
        if (touches)
            assert_true(distance == 0.0);
        else // the top vertex is at most 1 - cos(pi / 64) = 0.0012 below the circle
            assert_true(distance > 0.249 && distance < 0.2514);
        // Where the approach is left out it is not found.
        assert_int_equal(bmr_least_distance(a, b, motion_a, motion_b, 0.1, 1.0, 1e-6, &distance, &time),
                         BMR_OK);
        assert_true(distance > 90.0);
    }
}
