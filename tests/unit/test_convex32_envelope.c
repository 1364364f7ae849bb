// SPDX-License-Identifier: MIT
// Envelopes of big polygons hold them, and no more than they must.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "boomerang/convex32_envelope.h"

#define MOST 3000u
#define EDGES 64u

static bmr_vec32 points[MOST];

static void ellipse(uint32_t count, double width, double height, double turn) {
    for (uint32_t i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * i / count, x = width * cos(angle), y = height * sin(angle);
        points[i].x = (float)(x * cos(turn) - y * sin(turn) + 0.25 * width);
        points[i].y = (float)(x * sin(turn) + y * cos(turn));
    }
}

/// Of the envelope of `count` points on an ellipse, with every corner moved towards the middle by `shrink`.
static void look(uint32_t count, double height, double turn, double shrink, bool held) {
    ellipse(count, 1.0, height, turn);
    bmr_convex32_block *block = NULL;
    assert_int_equal(bmr_convex32_create(points, count, NULL, &block), BMR_OK);
    bmr_vec2 corners[EDGES];
    bmr_convex32_envelope(&block->polygon, EDGES, corners);
    for (uint32_t i = 0; i < EDGES; ++i) {
        corners[i].x = 0.25 + (corners[i].x - 0.25) * (1.0 - shrink);
        corners[i].y *= 1.0 - shrink;
    }
    bmr_polygon *outer = NULL;
    assert_int_equal(bmr_polygon_create(corners, EDGES, NULL, &outer), BMR_OK);
    assert_true(outer->count <= EDGES);
    int outside = 0;
    for (uint32_t i = 0; i < block->polygon.count; ++i) {
        const bmr_vec2 v = {(double)block->polygon.vertices[i].x, (double)block->polygon.vertices[i].y};
        outside += !bmr_polygon_contains(outer, v, 0.0);
    }
    assert_int_equal(outside == 0, held);
    assert_int_equal(bmr_convex32_held(&block->polygon, outer, 0.0), held);
    // All lie in the unit disk, whose own envelope has no corner farther out than this.
    for (uint32_t i = 0; i < outer->count; ++i)
        assert_true(hypot(outer->vertices[i].x - 0.25, outer->vertices[i].y) <
                    1.0 / cos(3.1415927 / EDGES) + 1e-6);
    bmr_polygon_destroy(outer, NULL);
    bmr_convex32_destroy(block, NULL);
}

static void an_envelope_holds_every_vertex(void **state) {
    (void)state;
    for (uint32_t count = 9; count <= MOST; count = count * 3 / 2)
        for (int i = 0; i < 20; ++i)
            look(count, 1.0 - 0.049 * i, 0.37 * i, 0.0, true);
}

static void control_one_that_is_smaller_does_not(void **state) {
    (void)state;
    for (uint32_t count = 9; count <= MOST; count = count * 3 / 2)
        for (int i = 0; i < 20; ++i)
            look(count, 1.0 - 0.049 * i, 0.37 * i, 1e-6, false);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_envelope_holds_every_vertex),
        cmocka_unit_test(control_one_that_is_smaller_does_not),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
