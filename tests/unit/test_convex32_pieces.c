// SPDX-License-Identifier: MIT
// Pieces of outlines: what they know of their seams, and where they leave contacts to their neighbours.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "convex32/convex32_pieces.h"
#include "failing_allocator.h"

static const float skins = 0.02f, tolerance = 0.0005f;
static const bmr_transform32 here = {{0.0f, 0.0f}, 0.0f, 1.0f};

static bmr_piece_corner32 corner(float x, float y, bool inner, float to_x, float to_y) {
    const bmr_piece_corner32 c = {{x, y}, {to_x, to_y}, inner};
    return c;
}

static bmr_transform32 at(float x, float y) {
    const bmr_transform32 pose = {{x, y}, 0.0f, 1.0f};
    return pose;
}

/// The right one of two squares of a flat ground, or of one that goes on to the left at another height: its
/// left side is inner. The outline goes on from its upper left corner to (-1, before), and comes to its lower
/// one from as far the other way.
static bmr_convex32_block *right_half(float before) {
    const bmr_piece_corner32 corners[] = {
        corner(0.0f, -1.0f, false, -1.0f, -1.0f - before), corner(1.0f, -1.0f, false, 0.0f, 0.0f),
        corner(1.0f, 0.0f, false, 0.0f, 0.0f), corner(0.0f, 0.0f, true, -1.0f, before)};
    bmr_convex32_block *block = NULL;
    assert_int_equal(bmr_convex32_create_piece(corners, 4, NULL, &block), BMR_OK);
    return block;
}

static bmr_convex32_block *polygon_of(uint32_t count, float radius) {
    bmr_vec32 v[64];
    for (uint32_t i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * ((double)i + 0.5) / (double)count;
        v[i].x = radius * (float)cos(angle);
        v[i].y = radius * (float)sin(angle);
    }
    bmr_convex32_block *block = NULL;
    assert_int_equal(bmr_convex32_create(v, count, NULL, &block), BMR_OK);
    return block;
}

/// The manifold of the piece and another polygon; its normal in the world, from the piece.
static bmr_manifold32 collide(const bmr_convex32_block *piece, const bmr_convex32_block *other,
                              bmr_transform32 pose, bmr_vec32 *normal) {
    bmr_manifold32 m;
    memset(&m, 0, sizeof m);
    bmr_convex32_memory memory = {0, 0, 0, 0};
    bmr_convex32_collide(&m, &piece->polygon, &here, &other->polygon, &pose, skins, tolerance, &memory);
    const float sign = m.type == BMR_MANIFOLD_FACE_A ? 1.0f : -1.0f;
    normal->x = sign * m.normal.x;
    normal->y = sign * m.normal.y;
    return m;
}

static bmr_manifold32 touch_circle(const bmr_convex32_block *piece, float x, float y, float radius) {
    bmr_manifold32 m;
    memset(&m, 0, sizeof m);
    bmr_convex32_memory memory = {0, 0, 0, 0};
    const bmr_vec32 centre = {x, y};
    bmr_convex32_collide_circle(&m, &piece->polygon, &here, centre, &here, radius + 0.5f * skins, &memory);
    return m;
}

static void corners_turn_as_the_outline_does(void **state) {
    (void)state;
    const bmr_vec32 up = {0.0f, 1.0f}, left_up = {-0.6f, 0.8f}, left = {-1.0f, 0.0f}, down = {0.0f, -1.0f};
    const bmr_vec32 left_down = {-0.6f, -0.8f};
    bmr_convex32_block *flat = right_half(0.0f), *falling = right_half(-2.0f), *rising = right_half(2.0f);
    for (int i = 0; i < 3; ++i) {
        const bmr_convex32_block *const block = i == 0 ? flat : i == 1 ? falling : rising;
        assert_int_equal(block->polygon.count, 4);
        assert_true(bmr_convex32_admits(&block->polygon, 3, up, 1e-3f));
        assert_int_equal(bmr_convex32_admits(&block->polygon, 3, left_up, 1e-3f), i == 1);
        assert_false(bmr_convex32_admits(&block->polygon, 3, left, 1e-3f));
        assert_true(bmr_convex32_admits(&block->polygon, 0, down, 1e-3f));
        assert_int_equal(bmr_convex32_admits(&block->polygon, 0, left_down, 1e-3f), i == 1);
        const bmr_vec32 right_down = {0.6f, -0.8f};
        assert_false(bmr_convex32_admits(&block->polygon, 0, right_down, 1e-3f));
        // The corner between two faces is as of any polygon; the inner edge is the last.
        const bmr_vec32 right_up = {0.6f, 0.8f};
        assert_true(bmr_convex32_admits(&block->polygon, 2, right_up, 1e-3f));
        assert_int_equal(block->seams.inner[3], 1);
        assert_int_equal(block->seams.inner[0] + block->seams.inner[1] + block->seams.inner[2], 0);
        bmr_convex32_destroy((bmr_convex32_block *)block, NULL);
    }
}

static void a_corner_between_inner_edges_admits_nothing(void **state) {
    (void)state;
    const bmr_piece_corner32 corners[] = {corner(0.0f, 0.0f, true, 0.0f, 0.0f),
                                          corner(1.0f, 0.0f, false, 0.0f, -1.0f),
                                          corner(0.0f, 1.0f, true, -1.0f, 0.0f)};
    bmr_convex32_block *block = NULL;
    assert_int_equal(bmr_convex32_create_piece(corners, 3, NULL, &block), BMR_OK);
    for (int i = 0; i < 16; ++i) {
        const bmr_vec32 d = {cosf(0.4f * (float)i), sinf(0.4f * (float)i)};
        assert_false(bmr_convex32_admits(&block->polygon, 0, d, 1e-3f));
    }
    bmr_convex32_destroy(block, NULL);
}

static void straight_corners_are_left_out_and_faces_stay_faces(void **state) {
    (void)state;
    // Below an inner edge and a face in one line, above a face and an inner edge; on the right two inner
    // edges.
    const bmr_piece_corner32 corners[] = {
        corner(0.0f, 0.0f, true, 0.0f, -1.0f), corner(1.0f, 0.0f, false, 1.0f, -1.0f),
        corner(2.0f, 0.0f, true, 3.0f, 0.0f),  corner(2.0f, 1.0f, true, 0.0f, 0.0f),
        corner(2.0f, 2.0f, false, 3.0f, 2.0f), corner(1.0f, 2.0f, true, 1.0f, 3.0f),
        corner(0.0f, 2.0f, false, -1.0f, 2.0f)};
    bmr_convex32_block *block = NULL;
    assert_int_equal(bmr_convex32_create_piece(corners, 7, NULL, &block), BMR_OK);
    assert_int_equal(block->polygon.count, 4);
    assert_int_equal(bmr_convex32_audit(&block->polygon), BMR_OK);
    const uint8_t inner[] = {0, 1, 0, 0};
    assert_memory_equal(block->seams.inner, inner, 4);
    bmr_convex32_destroy(block, NULL);
    // Also where the list begins in the middle of a line.
    for (size_t first = 1; first < 7; ++first) {
        bmr_piece_corner32 turned[7];
        memcpy(turned, corners + first, (7 - first) * sizeof *turned);
        memcpy(turned + 7 - first, corners, first * sizeof *turned);
        assert_int_equal(bmr_convex32_create_piece(turned, 7, NULL, &block), BMR_OK);
        assert_int_equal(block->polygon.count, 4);
        for (uint32_t i = 0; i < 4; ++i)
            assert_int_equal(block->seams.inner[i], block->polygon.normals[i].x > 0.5f);
        bmr_convex32_destroy(block, NULL);
    }
}

static void what_is_no_piece_is_an_error(void **state) {
    (void)state;
    bmr_convex32_block *block = NULL, *const before = block;
    const bmr_piece_corner32 line[] = {corner(0.0f, 0.0f, false, 0.0f, 0.0f),
                                       corner(1.0f, 0.0f, false, 0.0f, 0.0f),
                                       corner(2.0f, 0.0f, true, 0.0f, 0.0f)};
    bmr_piece_corner32 odd[3], *const none = NULL;
    memcpy(odd, line, sizeof odd);
    odd[1].vertex.y = NAN;
    assert_int_equal(bmr_convex32_create_piece(line, 3, NULL, &block), BMR_ERROR_TOO_FEW_POINTS);
    assert_int_equal(bmr_convex32_create_piece(line, 2, NULL, &block), BMR_ERROR_TOO_FEW_POINTS);
    assert_int_equal(bmr_convex32_create_piece(odd, 3, NULL, &block), BMR_ERROR_NOT_FINITE);
    odd[1].vertex.y = 1e10f;
    assert_int_equal(bmr_convex32_create_piece(odd, 3, NULL, &block), BMR_ERROR_OUT_OF_RANGE);
    assert_int_equal(bmr_convex32_create_piece(none, 3, NULL, &block), BMR_ERROR_NULL_ARGUMENT);
    assert_int_equal(bmr_convex32_create_piece(line, 3, NULL, NULL), BMR_ERROR_NULL_ARGUMENT);
    assert_int_equal(bmr_convex32_create_piece(line, 70000, NULL, &block), BMR_ERROR_TOO_MANY_POINTS);
    assert_ptr_equal(block, before);
}

static void without_memory_nothing_is_made(void **state) {
    (void)state;
    const bmr_piece_corner32 corners[] = {corner(0.0f, 0.0f, true, 0.0f, 0.0f),
                                          corner(1.0f, 0.0f, false, 0.0f, -1.0f),
                                          corner(0.0f, 1.0f, true, -1.0f, 0.0f)};
    for (size_t fail_at = 0; fail_at < 3; ++fail_at) {
        test_heap heap;
        test_heap_init(&heap, fail_at);
        bmr_convex32_block *block = NULL;
        const bmr_error error = bmr_convex32_create_piece(corners, 3, &heap.allocator, &block);
        assert_int_equal(error, fail_at < 2 ? BMR_ERROR_NO_MEMORY : BMR_OK);
        bmr_convex32_destroy(block, &heap.allocator);
        assert_int_equal(heap.blocks, 0);
        assert_int_equal(heap.wrong_sizes, 0);
    }
}

static void a_polygon_is_pushed_by_faces_alone(void **state) {
    (void)state;
    bmr_convex32_block *piece = right_half(0.0f), *wheel = polygon_of(64, 0.5f);
    bmr_vec32 normal;
    int touching = 0;
    // A wheel on the ground rolls over the seam: what the piece says of it is up, or nothing. (As a polygon
    // of its own it says otherwise: the control.)
    bool told_otherwise = false;
    for (int i = -80; i <= 80; ++i) {
        const bmr_transform32 pose = at(0.005f * (float)i, 0.508f);
        const bmr_manifold32 m = collide(piece, wheel, pose, &normal);
        if (m.count > 0) {
            ++touching;
            assert_true(normal.y > 0.998f);
        }
        bmr_convex32_block plain = *piece;
        plain.polygon.seams = NULL;
        if (collide(&plain, wheel, pose, &normal).count > 0 && normal.y < 0.99f)
            told_otherwise = true;
    }
    assert_true(touching >= 80);
    assert_true(told_otherwise);
    // Where the ground falls off behind the seam the corner is one, to the outline's own extent.
    bmr_convex32_block *edge = right_half(-2.0f);
    const bmr_manifold32 m = collide(edge, wheel, at(-0.30f, 0.40f), &normal);
    assert_true(m.count > 0 && normal.x < -0.5f && normal.y > 0.5f);
    bmr_convex32_destroy(edge, NULL);
    bmr_convex32_destroy(wheel, NULL);
    bmr_convex32_destroy(piece, NULL);
}

static void what_is_behind_an_inner_edge_is_left_to_the_piece_there(void **state) {
    (void)state;
    // A box pushes against the inner side of the piece, deep below its surface.
    bmr_convex32_block *piece = right_half(0.0f), *box = polygon_of(4, 0.2f);
    bmr_vec32 normal;
    const float half = 0.2f * sqrtf(0.5f);
    for (int i = 0; i < 10; ++i) {
        const float gap = 0.01f - 0.002f * (float)i;
        assert_int_equal(collide(piece, box, at(-half - gap, -0.5f), &normal).count, 0);
    }
    // In the ground as deep as it is wide, and over both pieces: one of them has to answer.
    assert_true(collide(piece, box, at(-0.05f, -0.16f), &normal).count > 0);
    assert_true(normal.y > 0.99f);
    bmr_convex32_destroy(box, NULL);
    bmr_convex32_destroy(piece, NULL);
}

static void straight_stretches_with_seams_carry_each_other(void **state) {
    (void)state;
    // Two such grounds lie on each other, the upper one a little askew: each piece's corner at its seam
    // belongs to a straight stretch.
    bmr_convex32_block *ground = right_half(0.0f);
    const bmr_piece_corner32 corners[] = {
        corner(-0.5f, 0.0f, false, -1.5f, 0.0f), corner(0.5f, 0.0f, false, 0.0f, 0.0f),
        corner(0.5f, 1.0f, false, 0.0f, 0.0f), corner(-0.5f, 1.0f, true, -1.5f, 1.0f)};
    bmr_convex32_block *upper = NULL;
    assert_int_equal(bmr_convex32_create_piece(corners, 4, NULL, &upper), BMR_OK);
    for (int i = -4; i <= 4; ++i) {
        const float turn = 0.004f * (float)i;
        const bmr_transform32 pose = {{0.4f, 0.005f}, sinf(turn), cosf(turn)};
        bmr_vec32 normal;
        assert_true(collide(ground, upper, pose, &normal).count > 0);
        assert_true(normal.y > 0.99f);
    }
    bmr_convex32_destroy(upper, NULL);
    bmr_convex32_destroy(ground, NULL);
}

static void a_circle_is_pushed_by_faces_and_corners_of_the_outline(void **state) {
    (void)state;
    bmr_convex32_block *flat = right_half(0.0f), *falling = right_half(-2.0f);
    assert_int_equal(touch_circle(flat, 0.1f, 0.3f, 0.3f).count, 1);
    assert_int_equal(touch_circle(flat, -0.1f, 0.28f, 0.3f).count, 0);
    const bmr_manifold32 m = touch_circle(falling, -0.1f, 0.28f, 0.3f);
    assert_int_equal(m.count, 1);
    assert_true(m.normal.x < -0.3f && m.normal.y > 0.9f);
    // Beside the inner edge there is nothing, and its middle is not pushed out of it.
    assert_int_equal(touch_circle(flat, -0.1f, -0.5f, 0.3f).count, 0);
    const bmr_manifold32 inside = touch_circle(flat, 0.02f, -0.1f, 0.3f);
    assert_int_equal(inside.count, 1);
    assert_true(inside.normal.y > 0.99f);
    bmr_convex32_destroy(falling, NULL);
    bmr_convex32_destroy(flat, NULL);
}

static void an_edge_is_touched_by_faces_alone(void **state) {
    (void)state;
    // The piece as a body on an edge, upside down: its inner side is on the right.
    bmr_convex32_block *piece = right_half(0.0f);
    const bmr_transform32 upside_down = {{0.0f, 0.01f}, 0.0f, -1.0f};
    const bmr_edge32 floor = {{6.0f, 0.0f}, {5.0f, 0.0f}, {-5.0f, 0.0f}, {-6.0f, 0.0f}, true};
    const bmr_edge32 wall = {{0.0f, 0.0f}, {0.01f, 0.5f}, {0.01f, 3.0f}, {0.0f, 0.0f}, false};
    const bmr_vec32 middle = {0.5f, -0.5f};
    bmr_manifold32 m;
    memset(&m, 0, sizeof m);
    bmr_convex32_memory memory = {0, 0, 0, 0};
    bmr_convex32_collide_edge(&m, &floor, &here, &piece->polygon, middle, &upside_down, skins, &memory);
    assert_int_equal(m.count, 2);
    assert_true(fabsf(m.normal.y) > 0.99f);
    bmr_convex32_collide_edge(&m, &wall, &here, &piece->polygon, middle, &upside_down, skins, &memory);
    assert_int_equal(m.count, 0);
    bmr_convex32_block plain = *piece; // the control
    plain.polygon.seams = NULL;
    bmr_convex32_collide_edge(&m, &wall, &here, &plain.polygon, middle, &upside_down, skins, &memory);
    assert_true(m.count > 0);
    bmr_convex32_destroy(piece, NULL);
}

static void a_ray_comes_in_by_faces_alone(void **state) {
    (void)state;
    bmr_convex32_block *piece = right_half(0.0f);
    const bmr_vec32 left = {-0.5f, -0.5f}, right = {0.5f, -0.5f}, above = {-0.5f, 0.499f};
    const bmr_vec32 below = {0.5f, -0.501f}, lower = {0.5f, -0.6f}, out = {0.5f, 0.501f};
    uint32_t edge = 3;
    assert_false(bmr_convex32_enters_piece(&piece->polygon, left, right, 0.5f, 0.005f, &edge));
    assert_false(bmr_convex32_enters_piece(&piece->polygon, left, lower, 0.5f, 0.005f, &edge));
    assert_false(bmr_convex32_enters_piece(&piece->polygon, left, out, 0.5f, 0.005f, &edge));
    // Through the corner: rounding may say that it comes by the inner edge.
    assert_true(bmr_convex32_enters_piece(&piece->polygon, above, below, 0.5f, 0.005f, &edge));
    assert_int_equal(edge, 2);
    assert_true(bmr_convex32_enters_piece(&piece->polygon, above, below, 0.5f, 0.005f, &edge));
    bmr_convex32_destroy(piece, NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(corners_turn_as_the_outline_does),
        cmocka_unit_test(a_corner_between_inner_edges_admits_nothing),
        cmocka_unit_test(straight_corners_are_left_out_and_faces_stay_faces),
        cmocka_unit_test(what_is_no_piece_is_an_error),
        cmocka_unit_test(without_memory_nothing_is_made),
        cmocka_unit_test(a_polygon_is_pushed_by_faces_alone),
        cmocka_unit_test(what_is_behind_an_inner_edge_is_left_to_the_piece_there),
        cmocka_unit_test(straight_stretches_with_seams_carry_each_other),
        cmocka_unit_test(a_circle_is_pushed_by_faces_and_corners_of_the_outline),
        cmocka_unit_test(an_edge_is_touched_by_faces_alone),
        cmocka_unit_test(a_ray_comes_in_by_faces_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
