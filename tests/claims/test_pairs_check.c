// SPDX-License-Identifier: MIT

#include "checks.h"
#include <math.h>

#include "boomerang/pair.h"
#include "motions.h"
#include "polygons.h"

#define BODIES 12u
#define PAIRS (BODIES * (BODIES - 1) / 2)

/// Bodies in the world, and a pair of every two of them.
typedef struct world {
    bmr_polygon *polygon;
    bmr_shape shape;
    bmr_pose poses[BODIES];
    bmr_pair pairs[PAIRS];
    bmr_pair_bodies bodies[PAIRS];
} world;

static void world_make(world *w, test_random *random) {
    w->polygon = test_polygon(TEST_ELLIPSE, 12, random);
    const bmr_shape shape = {.polygon = w->polygon};
    w->shape = shape;
    size_t pair = 0;
    for (uint32_t a = 0; a < BODIES; ++a) {
        const bmr_vec2 at = {3.0 * (a % 4) + 1e3, 2.5 * (a / 4)};
        w->poses[a] = bmr_pose_from_angle(at, 0.7 * a);
        for (uint32_t b = a + 1; b < BODIES; ++b, ++pair) {
            bmr_pair_init(&w->pairs[pair]);
            w->bodies[pair].a = a;
            w->bodies[pair].b = b;
        }
    }
}

/// Which pairs bmr_pair_check alone does not hold.
static size_t one_by_one(const world *w, double margin, size_t *failed) {
    size_t count = 0;
    for (size_t i = 0; i < PAIRS; ++i) {
        const bmr_pose pose = bmr_pose_relative(&w->poses[w->bodies[i].a], &w->poses[w->bodies[i].b]);
        double gap;
        if (!(isfinite(pose.position.x) && isfinite(pose.c) &&
              bmr_pair_check(&w->pairs[i], &pose, margin, &gap)))
            failed[count++] = i;
    }
    return count;
}

TEST(it_finds_the_pairs_that_one_check_after_the_other_finds) {
    test_random random = {9};
    world w;
    world_make(&w, &random);
    bmr_pair_def def = bmr_default_pair_def();
    def.margin = 0.01;
    size_t failed[PAIRS], expected[PAIRS], count = 0, some = 0, none = 0;
    for (int step = 0; step < 200; ++step) {
        assert_int_equal(
            bmr_pairs_check(w.pairs, w.bodies, PAIRS, w.poses, BODIES, def.margin, failed, &count), BMR_OK);
        assert_int_equal(count, one_by_one(&w, def.margin, expected));
        assert_memory_equal(failed, expected, count * sizeof *failed);
        assert_true(step > 0 || count == PAIRS); // nothing is known of a new pair
        some += count > 0;
        none += count < PAIRS;
        for (size_t k = 0; k < count; ++k) {
            const bmr_pair_bodies two = w.bodies[failed[k]];
            const bmr_pose pose = bmr_pose_relative(&w.poses[two.a], &w.poses[two.b]);
            bmr_pair_advance(&w.pairs[failed[k]], &def, &w.shape, &w.shape, &pose, NULL, NULL);
        }
        for (uint32_t i = 0; i < BODIES; ++i) {
            const bmr_vec2 at = w.poses[i].position;
            const bmr_vec2 next = {at.x + 0.2 * sin(0.1 * step + i), at.y + 0.2 * cos(0.13 * step - i)};
            w.poses[i] = bmr_pose_from_angle(next, 0.7 * i + 0.01 * step);
        }
    }
    assert_true(some > 10 && none > 10);
    w.poses[3].position.x = (double)NAN; // its pairs are none that anything is known of
    assert_int_equal(bmr_pairs_check(w.pairs, w.bodies, PAIRS, w.poses, BODIES, 0.0, failed, &count), BMR_OK);
    size_t of_it = 0;
    for (size_t k = 0; k < count; ++k)
        of_it += w.bodies[failed[k]].a == 3 || w.bodies[failed[k]].b == 3;
    assert_int_equal(of_it, BODIES - 1);
    bmr_polygon_destroy(w.polygon, NULL);
}

TEST(bad_arguments_are_told_and_touch_no_count) {
    test_random random = {9};
    world w;
    world_make(&w, &random);
    size_t failed[PAIRS], count = 77;
    assert_int_equal(bmr_pairs_check(NULL, w.bodies, PAIRS, w.poses, BODIES, 0.0, failed, &count),
                     BMR_ERROR_NULL_ARGUMENT);
    assert_int_equal(bmr_pairs_check(w.pairs, NULL, PAIRS, w.poses, BODIES, 0.0, failed, &count),
                     BMR_ERROR_NULL_ARGUMENT);
    assert_int_equal(bmr_pairs_check(w.pairs, w.bodies, PAIRS, NULL, BODIES, 0.0, failed, &count),
                     BMR_ERROR_NULL_ARGUMENT);
    assert_int_equal(bmr_pairs_check(w.pairs, w.bodies, PAIRS, w.poses, BODIES, 0.0, NULL, &count),
                     BMR_ERROR_NULL_ARGUMENT);
    assert_int_equal(bmr_pairs_check(w.pairs, w.bodies, PAIRS, w.poses, BODIES, 0.0, failed, NULL),
                     BMR_ERROR_NULL_ARGUMENT);
    assert_int_equal(bmr_pairs_check(w.pairs, w.bodies, PAIRS, w.poses, BODIES - 1, 0.0, failed, &count),
                     BMR_ERROR_OUT_OF_RANGE);
    assert_int_equal(bmr_pairs_check(w.pairs, w.bodies, PAIRS, w.poses, BODIES, -1.0, failed, &count),
                     BMR_ERROR_OUT_OF_RANGE);
    assert_int_equal(bmr_pairs_check(w.pairs, w.bodies, PAIRS, w.poses, BODIES, (double)NAN, failed, &count),
                     BMR_ERROR_OUT_OF_RANGE);
    assert_int_equal(count, 77);
    assert_int_equal(bmr_pairs_check(w.pairs, w.bodies, 0, w.poses, 0, 0.0, failed, &count), BMR_OK);
    assert_int_equal(count, 0);
    bmr_polygon_destroy(w.polygon, NULL);
}
