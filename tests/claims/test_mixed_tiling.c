// SPDX-License-Identifier: MIT
#include "checks.h"
#include "compass_fixture.h"
#include "failing_allocator.h"
#include "hierarchies.h"
#include "hierarchy/mixed.h"
#include "hierarchy/mixed_cells.h"

/// @file
/// The mixed hierarchy of a diamond and a square, whose cells can be written down by hand.

#define HALF 0.25 // of the square's side

typedef struct scene {
    bmr_polygon *polygons[2];
    bmr_hierarchy *hierarchies[2];
} scene;

static scene diamond_and_square(void) {
    static const bmr_vec2 diamond[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    bmr_vec2 square[4];
    scene s;
    assert_int_equal(bmr_polygon_create(diamond, 4, NULL, &s.polygons[0]), BMR_OK);
    assert_int_equal(bmr_polygon_create(square, test_box_points(HALF, HALF, square), NULL, &s.polygons[1]),
                     BMR_OK);
    for (int i = 0; i < 2; ++i)
        s.hierarchies[i] = built(BMR_HIERARCHY_COMPASS, s.polygons[i]);
    return s;
}

static void scene_destroy(scene *s) {
    for (int i = 0; i < 2; ++i) {
        bmr_hierarchy_destroy(s->hierarchies[i], NULL);
        bmr_polygon_destroy(s->polygons[i], NULL);
    }
}

#define own_scene OWNED(scene_destroy) scene

static bmr_mixed mixed_of(const scene *s, double angle, double offset) {
    return bmr_mixed_make(s->hierarchies[0], s->hierarchies[1], cos(angle), sin(angle), offset);
}

/// The cell at a point, found from its upper right.
static bmr_mixed_cell cell_at(const bmr_mixed *mixed, double x, double y) {
    bmr_mixed_cell cell;
    unsigned touched = 0;
    assert_true(bmr_mixed_locate(mixed, bmr_vec2_make(x, y), bmr_vec2_make(0.61, 0.79), &cell, &touched));
    return cell;
}

TEST(what_is_no_cell_has_neither_sides_nor_height_nor_neighbours) {
    own_scene s = diamond_and_square();
    const bmr_mixed mixed = mixed_of(&s, 0.3, 0.0);
    double slack;
    const bmr_mixed_cell outside = bmr_mixed_outside(&mixed, bmr_vec2_make(5.0, 1.0), &slack);
    assert_int_equal(outside.kind, BMR_MIXED_OUTSIDE);
    assert_true(slack > 0.0);
    const bmr_mixed_cell inside = {BMR_NO_EDGE, {BMR_NO_EDGE, BMR_NO_EDGE}, BMR_MIXED_INSIDE, 0, {0, 0}};
    assert_false(bmr_mixed_exists(&mixed, &inside));
    assert_false(bmr_mixed_holds(&mixed, &inside, bmr_vec2_make(0.0, 0.0)));
    bmr_mixed_side sides[BMR_MIXED_MAX_SIDES];
    assert_int_equal(bmr_mixed_sides(&mixed, &inside, sides), 0);
    const bmr_mixed_ray ray = {{5.0, 1.0}, {-1.0, 0.0}};
    unsigned touched = 0;
    for (int k = 0; k < 2; ++k) {
        const bmr_mixed_cell *cell = k == 0 ? &inside : &outside;
        bmr_vec2 corners[BMR_MIXED_MAX_SIDES];
        assert_int_equal(bmr_mixed_polygon(&mixed, cell, corners), 0);
        assert_true(bmr_mixed_height(&mixed, cell) == 0.0);
        const bmr_mixed_cell next = bmr_mixed_next(&mixed, cell, BMR_MIXED_INNER, &ray, &touched);
        assert_memory_equal(&next, cell, sizeof next);
    }
    assert_int_equal(touched, 0);
}

TEST(a_way_of_no_length_stays_and_one_that_passes_by_is_outside) {
    own_scene s = diamond_and_square();
    const bmr_mixed mixed = mixed_of(&s, 0.3, 0.0);
    const bmr_mixed_cell at = cell_at(&mixed, 1.1, 1.1);
    bmr_mixed_cell cell = at;
    unsigned touched = 0;
    const bmr_vec2 here = {1.1, 1.1};
    assert_true(bmr_mixed_walk(&mixed, &cell, here, here, &touched));
    assert_memory_equal(&cell, &at, sizeof at);
    assert_int_equal(touched, 0);
    const bmr_mixed_ray past = {{5.0, 5.0}, {-1.0, 0.0}}, into = {{5.0, 0.0}, {-1.0, 0.0}};
    assert_int_equal(bmr_mixed_enter(&mixed, &past, &touched).kind, BMR_MIXED_OUTSIDE);
    assert_int_not_equal(bmr_mixed_enter(&mixed, &into, &touched).kind, BMR_MIXED_OUTSIDE);
}

TEST(a_tiling_remembers_its_rotation) {
    own_scene s = diamond_and_square();
    const bmr_mixed mixed = mixed_of(&s, 0.3, 0.125);
    bmr_mixed_tiling *tiling = NULL;
    assert_int_equal(bmr_mixed_tiling_create(&mixed, NULL, &tiling), BMR_OK);
    const bmr_mixed *kept = bmr_mixed_tiling_mixed(tiling);
    assert_true(kept->c == mixed.c && kept->s == mixed.s && kept->offset == 0.125);
    assert_ptr_equal(kept->hierarchies[0], s.hierarchies[0]);
    assert_ptr_equal(kept->hierarchies[1], s.hierarchies[1]);
    bmr_mixed_tiling_destroy(tiling, NULL);
}

TEST(a_tiling_is_one_block_of_the_bytes_it_says_and_needs_both_hierarchies) {
    own_scene s = diamond_and_square();
    bmr_mixed_tiling *tiling = NULL;
    const bmr_mixed half = bmr_mixed_make(s.hierarchies[0], NULL, 1.0, 0.0, 0.0),
                    mixed = mixed_of(&s, 0.3, 0.0);
    assert_int_equal(bmr_mixed_tiling_create(&half, NULL, &tiling), BMR_ERROR_NULL_ARGUMENT);
    test_heap heap;
    test_heap_init(&heap, SIZE_MAX);
    assert_int_equal(bmr_mixed_tiling_create(&mixed, &heap.allocator, &tiling), BMR_OK);
    assert_int_equal(heap.blocks, 1);
    assert_int_equal(heap.bytes, bmr_mixed_tiling_bytes(tiling));
    bmr_mixed_tiling_destroy(tiling, &heap.allocator);
    bmr_mixed_tiling_destroy(NULL, &heap.allocator);
}
