// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_MIXED_SCENE_H
#define BOOMERANG_TEST_MIXED_SCENE_H

#include "checks.h"
#include "hierarchies.h"
#include "hierarchy/mixed_cells.h"
#include "motions.h"

/// @file
/// Two polygons whose mixed hierarchy is looked at, for the tests of section 4.

#define TWO_PI 6.283185307179586
static const bmr_hierarchy_kind kinds[] = {BMR_HIERARCHY_COMPASS, BMR_HIERARCHY_DUDLEY};

/// Two polygons with their hierarchies and the tiling at one rotation.
typedef struct scene {
    bmr_polygon *polygons[2];
    bmr_hierarchy *hierarchies[2];
    double angle;
    bmr_mixed mixed;
    bmr_mixed_tiling *tiling;
} scene;

static inline scene scene_of(bmr_polygon *a, bmr_polygon *b, bmr_hierarchy_kind kind, double angle,
                             double offset) {
    scene s = {.polygons = {a, b}, .angle = angle};
    for (int i = 0; i < 2; ++i)
        s.hierarchies[i] = built((int)kind, s.polygons[i]);
    s.mixed = bmr_mixed_make(s.hierarchies[0], s.hierarchies[1], cos(angle), sin(angle), offset);
    assert_int_equal(bmr_mixed_tiling_create(&s.mixed, NULL, &s.tiling), BMR_OK);
    return s;
}

static inline void scene_turn(scene *s, double angle) {
    s->angle = angle;
    s->mixed.c = cos(angle);
    s->mixed.s = sin(angle);
    bmr_mixed_tiling_destroy(s->tiling, NULL);
    assert_int_equal(bmr_mixed_tiling_create(&s->mixed, NULL, &s->tiling), BMR_OK);
}

static inline void scene_destroy(scene *s) {
    bmr_mixed_tiling_destroy(s->tiling, NULL);
    for (int i = 0; i < 2; ++i) {
        bmr_hierarchy_destroy(s->hierarchies[i], NULL);
        bmr_polygon_destroy(s->polygons[i], NULL);
    }
}

#define own_scene OWNED(scene_destroy) scene

/// An angle of 0 a third of the time, a compass angle another third: aligned hierarchies.
static inline double some_angle(test_random *random) {
    const uint32_t way = test_random_below(random, 3);
    if (way == 0)
        return 0.0;
    return way == 1 ? TWO_PI / 64.0 * test_random_below(random, 64) : test_random_uniform(random, 0, TWO_PI);
}

static inline scene random_scene(bmr_hierarchy_kind kind, size_t n, size_t m, test_random *random) {
    const test_family f = (test_family)test_random_below(random, TEST_FAMILY_COUNT);
    const test_family g = (test_family)test_random_below(random, TEST_FAMILY_COUNT);
    bmr_polygon *a = test_polygon(f, n, random), *b = test_polygon(g, m, random);
    return scene_of(a, b, kind, some_angle(random), 0.0);
}

static inline double size_of(const scene *s) {
    return s->polygons[0]->radius + s->polygons[1]->radius;
}

#endif
