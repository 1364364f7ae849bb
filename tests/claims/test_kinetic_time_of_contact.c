// SPDX-License-Identifier: MIT

#include "checks.h"
#include <math.h>

#include "boomerang/time_of_contact.h"
#include "hierarchies.h"
#include "motions.h"
#include "polygons.h"
#include "test_scale.h"

#define MARGIN 1e-4
/// Looks of the oracle at one motion.
#define LOOKS 4000

typedef struct scene {
    bmr_shape a, b;
    bmr_motion *motions[2];
} scene;

static bmr_motion *screw(bmr_vec2 from, double angle, bmr_vec2 velocity, double spin) {
    const bmr_motion_piece piece = bmr_piece_screw(0.0, bmr_pose_from_angle(from, angle), velocity, spin);
    bmr_motion *motion = NULL;
    assert_int_equal(bmr_motion_create(&piece, NULL, &motion), BMR_OK);
    return motion;
}

/// The distance at a time, by another method than core's.
static double distance_at(const scene *s, double time) {
    const bmr_pose a = bmr_motion_pose(s->motions[0], time, NULL, NULL),
                   b = bmr_motion_pose(s->motions[1], time, NULL, NULL);
    const bmr_pose b_in_a = bmr_pose_relative(&a, &b);
    return test_distance(s->a.polygon, s->b.polygon, &b_in_a);
}

/// Are they at the margin at this time, and were they never nearer before? INFINITY: never at all.
static bool is_first_contact(const scene *s, double until, double time) {
    const double tolerance = 1e-8;
    for (int k = 0; k <= LOOKS; ++k) {
        const double t = until * k / LOOKS;
        if (t < time && distance_at(s, t) < MARGIN - tolerance)
            return false;
    }
    return time == INFINITY || (time == 0.0 && distance_at(s, 0.0) <= MARGIN + tolerance) ||
           fabs(distance_at(s, time) - MARGIN) <= tolerance;
}

TEST(the_first_contact_of_random_motions_is_found) {
    test_random random = {33};
    size_t hits = 0, misses = 0, at_once = 0;
    for (size_t round = 0; round < test_scaled(60); ++round) {
        bmr_polygon *polygons[2];
        bmr_hierarchy *hierarchies[2] = {NULL, NULL};
        scene s = {.a = {.polygon = NULL}};
        bmr_shape *shapes[2] = {&s.a, &s.b};
        const bool lazy = test_random_below(&random, 2) == 0;
        for (int i = 0; i < 2; ++i) {
            polygons[i] = test_polygon((test_family)test_random_below(&random, TEST_BOX), 12, &random);
            shapes[i]->polygon = polygons[i];
            if (lazy) {
                assert_int_equal(bmr_hierarchy_build_dudley(polygons[i], NULL, &hierarchies[i]), BMR_OK);
                shapes[i]->hierarchies[BMR_HIERARCHY_DUDLEY] = hierarchies[i];
            }
        }
        const double way = test_random_uniform(&random, -3.0, 3.0),
                     speed = test_random_uniform(&random, 0.2, 9.0);
        const double far = test_random_below(&random, 8) == 0 ? 0.5 : 6.0;
        const bmr_vec2 from = {far * cos(way), far * sin(way)};
        const double aim = way + test_random_uniform(&random, -0.6, 0.6);
        const bmr_vec2 velocity = {-speed * cos(aim), -speed * sin(aim)}, none = {0.0, 0.0};
        s.motions[0] = screw(none, 0.3, none, test_random_uniform(&random, -20.0, 20.0));
        s.motions[1] = screw(from, 1.0, velocity, test_random_uniform(&random, -20.0, 20.0));
        const double until = 12.0 / speed;
        double time = -1.0;
        assert_int_equal(
            bmr_time_of_contact(&s.a, s.motions[0], &s.b, s.motions[1], 0.0, until, MARGIN, NULL, &time),
            BMR_OK);
        assert_true(is_first_contact(&s, until, time));
        if (time < INFINITY && time > 0.0) { // the control: neither later nor earlier
            assert_false(is_first_contact(&s, until, time + 0.02 * until));
            assert_false(is_first_contact(&s, until, 0.9 * time));
            assert_false(is_first_contact(&s, until, INFINITY));
        }
        hits += time < INFINITY;
        misses += time == INFINITY;
        at_once += time == 0.0;
        for (int i = 0; i < 2; ++i) {
            bmr_motion_destroy(s.motions[i]);
            bmr_hierarchy_destroy(hierarchies[i], NULL);
            bmr_polygon_destroy(polygons[i], NULL);
        }
    }
    printf("%zu contacts (%zu at the beginning), %zu passes\n", hits, at_once, misses);
    assert_true(test_scaled(60) < 60 || (hits > 10 && misses > 2 && at_once > 0));
}

TEST(a_head_on_contact_is_when_arithmetic_says) {
    const bmr_vec2 square[4] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    bmr_polygon *polygon = NULL;
    assert_int_equal(bmr_polygon_create(square, 4, NULL, &polygon), BMR_OK);
    const bmr_shape shape = {.polygon = polygon};
    const bmr_vec2 none = {0, 0}, from = {10, 0.5}, velocity = {-4, 0};
    bmr_motion *rest = screw(none, 0.0, none, 0.0), *comes = screw(from, 0.0, velocity, 0.0);
    double time = -1.0;
    assert_int_equal(bmr_time_of_contact(&shape, rest, &shape, comes, 0.0, 5.0, 1e-3, NULL, &time), BMR_OK);
    assert_true(fabs(time - (8.0 - 1e-3) / 4.0) <= 1e-9);
    assert_int_equal(bmr_time_of_contact(&shape, rest, &shape, comes, 0.0, 1.9, 1e-3, NULL, &time), BMR_OK);
    assert_true(time == INFINITY);
    assert_int_equal(bmr_time_of_contact(&shape, rest, &shape, comes, 3.0, 9.0, 1e-3, NULL, &time), BMR_OK);
    assert_true(time == 3.0); // in each other from the beginning
    time = -1.0;
    const double nan = (double)NAN;
    assert_int_equal(bmr_time_of_contact(NULL, rest, &shape, comes, 0.0, 5.0, 1e-3, NULL, &time),
                     BMR_ERROR_NULL_ARGUMENT);
    assert_int_equal(bmr_time_of_contact(&shape, rest, &shape, NULL, 0.0, 5.0, 1e-3, NULL, &time),
                     BMR_ERROR_NULL_ARGUMENT);
    assert_int_equal(bmr_time_of_contact(&shape, rest, &shape, comes, 0.0, 5.0, 1e-3, NULL, NULL),
                     BMR_ERROR_NULL_ARGUMENT);
    assert_int_equal(bmr_time_of_contact(&shape, rest, &shape, comes, nan, 5.0, 1e-3, NULL, &time),
                     BMR_ERROR_NOT_FINITE);
    assert_int_equal(bmr_time_of_contact(&shape, rest, &shape, comes, 6.0, 5.0, 1e-3, NULL, &time),
                     BMR_ERROR_OUT_OF_RANGE);
    assert_int_equal(bmr_time_of_contact(&shape, rest, &shape, comes, 0.0, 5.0, 0.0, NULL, &time),
                     BMR_ERROR_OUT_OF_RANGE);
    assert_int_equal(bmr_time_of_contact(&shape, rest, &shape, comes, 0.0, 5.0, nan, NULL, &time),
                     BMR_ERROR_OUT_OF_RANGE);
    assert_true(time == -1.0);
    bmr_motion_destroy(rest);
    bmr_motion_destroy(comes);
    bmr_polygon_destroy(polygon, NULL);
}
