// SPDX-License-Identifier: MIT
#include <float.h>

#include "boomerang/motion.h"
#include "checks.h"
#include "kinetic/motion.h"
#include "motions.h"
#include "polygons.h"

#define PI 3.14159265358979323846

static bmr_pose pose_of(double x, double y, double angle) {
    const bmr_pose pose = {{x, y}, cos(angle), sin(angle)};
    return pose;
}

static bool near_pose(bmr_pose a, bmr_pose b, double room) {
    return fabs(a.position.x - b.position.x) <= room && fabs(a.position.y - b.position.y) <= room &&
           fabs(a.c - b.c) <= room && fabs(a.s - b.s) <= room;
}

static bmr_motion_piece algebraic(double origin) {
    return test_algebraic(origin, (bmr_algebraic_piece){.degree = 0});
}

static bmr_motion *made(const bmr_motion_piece *piece, const bmr_allocator *allocator) {
    bmr_motion *motion = NULL;
    assert_int_equal(bmr_motion_create(piece, allocator, &motion), BMR_OK);
    return motion;
}

TEST(samples_are_met_and_joined_the_short_way_round) {
    const double times[] = {0.0, 1.0, 3.0};
    const bmr_pose poses[] = {pose_of(0.0, 0.0, 3.0), pose_of(1.0, 2.0, -3.0), pose_of(5.0, 2.0, -2.0)};
    own_motion *motion = NULL;
    assert_int_equal(bmr_motion_create_sampled(times, poses, 3, NULL, &motion), BMR_OK);
    for (size_t i = 0; i < 3; i++)
        assert_true(near_pose(bmr_motion_pose(motion, times[i], NULL, NULL), poses[i], 1e-15));
    // From 3 to -3 radians the short way leads over pi.
    const bmr_pose middle = bmr_motion_pose(motion, 0.5, NULL, NULL);
    assert_true(near_pose(middle, pose_of(0.5, 1.0, PI), 1e-15));
    bmr_vec2 velocity;
    double spin;
    bmr_motion_pose(motion, 2.0, &velocity, &spin);
    assert_true(velocity.x == 2.0 && velocity.y == 0.0 && fabs(spin - 0.5) < 1e-15);
    // At rest outside.
    assert_true(near_pose(bmr_motion_pose(motion, -7.0, &velocity, &spin), poses[0], 1e-15) && spin == 0.0);
    assert_true(near_pose(bmr_motion_pose(motion, 7.0, &velocity, &spin), poses[2], 1e-15) && spin == 0.0);
}

static bmr_motion_piece random_piece(test_random *random) {
    if (test_random_below(random, 4) == 0) {
        const bmr_vec2 velocity = {test_random_uniform(random, -2.0, 2.0),
                                   test_random_uniform(random, -2.0, 2.0)};
        return bmr_piece_screw(test_random_uniform(random, -1.0, 1.0), pose_of(1.0, 2.0, 0.5), velocity,
                               test_random_uniform(random, -4.0, 4.0));
    }
    bmr_motion_piece piece = algebraic(test_random_uniform(random, -1.0, 1.0));
    bmr_algebraic_piece *w = &piece.as.algebraic;
    w->degree = test_random_below(random, BMR_MOTION_MAX_DEGREE + 1);
    w->rotation_degree = test_random_below(random, 5);
    for (size_t k = 0; k <= BMR_MOTION_MAX_DEGREE; k++) {
        w->x[k] = test_random_uniform(random, -1.0, 1.0);
        w->y[k] = test_random_uniform(random, -1.0, 1.0);
        w->a[k] = test_random_uniform(random, -1.0, 1.0);
        w->b[k] = test_random_uniform(random, -1.0, 1.0);
    }
    return piece;
}

TEST(bounds_hold_and_are_not_idle) {
    test_random random = test_random_from(3);
    const size_t rounds = test_scaled(2000);
    double tightest = 0.0;
    size_t controls = 0;
    for (size_t round = 0; round < rounds; round++) {
        const bmr_motion_piece piece = random_piece(&random);
        const double from = test_random_uniform(&random, -1.5, 1.0);
        const double to = from + pow(10.0, test_random_uniform(&random, -5.0, 0.0));
        const double radius = test_random_uniform(&random, 0.0, 3.0);
        const double bound = bmr_motion_piece_speed(&piece, from, to, radius);
        size_t intervals = 0;
        const bmr_piece_rates rates = bmr_piece_bounds(&piece, from, to, &intervals);
        assert_true(intervals > 0 && intervals < 2048);
        double most = 0.0, spin_before = 0.0;
        const int looks = 100;
        for (int i = 0; i <= looks; i++) {
            const double t = from + (to - from) * i / looks;
            const bmr_instant now = bmr_piece_instant(&piece, t);
            const double speed = hypot(now.velocity.x, now.velocity.y);
            const double room = 1e-9 * (1.0 + fabs(now.spin));
            assert_true(speed <= rates.speed * (1.0 + 1e-9) + 1e-12);
            assert_true(now.spin <= rates.spin_high + room && now.spin >= rates.spin_low - room);
            // The difference quotient is the derivative somewhere in between.
            if (i > 0)
                assert_true(fabs(now.spin - spin_before) <=
                            rates.spin_change * (to - from) / looks * (1.0 + 1e-9) +
                                1e-12 * (1.0 + fabs(now.spin)));
            spin_before = now.spin;
            most = fmax(most, speed + fabs(now.spin) * radius);
        }
        assert_true(most <= bound * (1.0 + 1e-9) + 1e-12);
        tightest = fmax(tightest, most / bound);
        controls += most > 0.5 * bound; // half the bound would be none
        // From its expansion the piece is the same.
        if (bmr_piece_is_algebraic(&piece)) {
            bmr_motion_piece shifted = piece;
            shifted.kind = BMR_PIECE_ALGEBRAIC;
            shifted.origin = from;
            shifted.as.algebraic = bmr_piece_expand(&piece, from);
            assert_true(
                near_pose(bmr_piece_instant(&shifted, to).pose, bmr_piece_instant(&piece, to).pose, 1e-9));
        }
    }
    assert_true(tightest > 0.999 && controls > rounds / 2);
}

TEST(a_pair_is_as_fast_as_the_fastest_of_its_pieces) {
    const double times[] = {0.0, 1.0, 2.0};
    const bmr_vec2 origin = {0.0, 0.0};
    own_polygon *point = made_polygon(&origin, 1);
    for (int first = 1; first <= 5; first += 4) { // slow, then fast; fast, then slow
        const bmr_pose poses[] = {pose_of(0.0, 0.0, 0.0), pose_of(first, 0.0, 0.0), pose_of(6.0, 0.0, 0.0)};
        own_motion *motion = NULL;
        assert_int_equal(bmr_motion_create_sampled(times, poses, 3, NULL, &motion), BMR_OK);
        const bmr_pair_motion pair = {motion, motion, point, point};
        assert_true(fabs(bmr_pair_speed(&pair, 0.0, 2.0) - 10.0) <= 1e-9);
    }
}

TEST(rotations_are_made_of_unit_length) {
    bmr_motion_piece pieces[] = {algebraic(0.0),
                                 bmr_piece_screw(0.0, pose_of(0.0, 0.0, 1.0), bmr_vec2_make(1.0, 0.0), 2.0)};
    const double off = 1.0 + 5e-10; // as far as a piece may be off, to a half
    pieces[0].as.algebraic.start_c *= off;
    pieces[1].as.screw.start.c *= off;
    pieces[1].as.screw.start.s *= off;
    for (int i = 0; i < 2; i++) {
        own_motion *motion = made(&pieces[i], NULL);
        assert_int_equal(bmr_motion_change(motion, 1.0, &pieces[1 - i]), BMR_OK);
        for (double time = 0.5; time < 2.0; time += 1.0) {
            const bmr_pose pose = bmr_motion_pose(motion, time, NULL, NULL);
            assert_true(fabs(hypot(pose.c, pose.s) - 1.0) < 1e-14);
        }
    }
}

TEST(two_points_in_one_place_touch) {
    const bmr_vec2 origin = {0.0, 0.0};
    own_polygon *a = made_polygon(&origin, 1), *b = made_polygon(&origin, 1);
    for (int apart = 0; apart < 2; ++apart) {
        const bmr_pose here = bmr_pose_from_angle(bmr_vec2_make(0.3, 0.4), 1.0),
                       there = bmr_pose_from_angle(bmr_vec2_make(0.3 + 0.25 * apart, 0.4), 2.0);
        own_motion *first = made_motion(bmr_piece_rest(here)), *second = made_motion(bmr_piece_rest(there));
        const bmr_pair_motion pair = {first, second, a, b};
        assert_true(fabs(bmr_pair_separation(&pair, 0.5) - 0.25 * apart) <= 1e-15);
    }
}
