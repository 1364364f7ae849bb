// SPDX-License-Identifier: MIT
// How rays come into pieces of outlines, and past the ends of their inner edges.
#include "checks.h"
#include "convex32/convex32_pieces.h"

static bmr_piece_corner32 corner(float x, float y, bool inner) {
    const bmr_piece_corner32 c = {{x, y}, {x, y}, inner};
    return c;
}

/// A unit square, the left side of which (its last edge) is inner.
static bmr_convex32_block *right_half(void) {
    const bmr_piece_corner32 corners[] = {corner(0.0f, -1.0f, false), corner(1.0f, -1.0f, false),
                                          corner(1.0f, 0.0f, false), corner(0.0f, 0.0f, true)};
    bmr_convex32_block *block = NULL;
    assert_int_equal(bmr_convex32_create_piece(corners, 4, NULL, &block), BMR_OK);
    return block;
}

/// How a ray comes in that hits edge `edge` of the piece at half of its way, if not told otherwise.
typedef struct entry_told {
    bmr_entry32 entry;
    double fraction;
    bmr_vec32 corner;
} entry_told;

static entry_told enter(const bmr_convex32_block *piece, float x1, float y1, float x2, float y2,
                        uint32_t edge) {
    const bmr_vec32 p1 = {x1, y1}, p2 = {x2, y2};
    const bmr_piece_ray32 ray = bmr_convex32_piece_ray(p1, p2, 2.0f);
    entry_told told = {BMR_ENTRY_FACE, 0.5, {9.0f, 9.0f}};
    told.entry = bmr_convex32_entry(piece, &ray, edge, &told.fraction, &told.corner);
    return told;
}

TEST(a_ray_comes_in_by_faces_and_past_ends_of_inner_edges) {
    own_convex32 *piece = right_half();
    assert_int_equal(enter(piece, 0.5f, 0.5f, 0.5f, -0.5f, 2).entry, BMR_ENTRY_FACE);
    assert_int_equal(enter(piece, -0.5f, -0.5f, 0.5f, -0.5f, 3).entry, BMR_ENTRY_INNER);
    assert_int_equal(enter(piece, -0.5f, 0.499f, 0.5f, -0.501f, 3).entry, BMR_ENTRY_INNER);
    const entry_told through = enter(piece, -0.5f, 0.5f, 0.5f, -0.5f, 3);
    assert_int_equal(through.entry, BMR_ENTRY_CORNER);
    assert_true(through.corner.x == 0.0f && through.corner.y == 0.0f && through.fraction == 0.5);
    // Along the inner edge rounding says anything of where; it comes in at the end that is first.
    const entry_told down = enter(piece, 0.0f, 0.25f, 0.0f, -1.25f, 3);
    assert_int_equal(down.entry, BMR_ENTRY_CORNER);
    assert_true(down.corner.y == 0.0f && fabs(down.fraction - 1.0 / 6.0) < 1e-12);
    // From afar rounding is more.
    assert_int_equal(enter(piece, -1e5f, 1e5f + 0.1f, 1e5f, -1e5f + 0.1f, 3).entry, BMR_ENTRY_CORNER);
    // It passes the far end, after it has come in far from any.
    assert_int_equal(enter(piece, -4.5e-6f, 0.0f, 4.5e-6f, -1.5f, 3).entry, BMR_ENTRY_INNER);
    assert_int_equal(enter(piece, -0.5f, 0.0f, 0.5f, -2.0f, 3).entry, BMR_ENTRY_CORNER);
    assert_int_equal(enter(piece, -1.0f, 0.0f, 1.0f, -0.5f, 3).entry, BMR_ENTRY_INNER);
}

TEST(a_ray_comes_through_what_is_inside_of_faces_or_beside_seams) {
    own_convex32 *piece = right_half();
    const bmr_vec32 beside[] = {{-1e-6f, -0.5f}, {1e-6f, -0.5f}, {0.5f, -1e-6f}, {0.5f, 1e-6f},
                                {0.5f, -0.5f},   {-0.1f, -0.5f}, {0.5f, 0.1f}};
    const bool through[] = {true, true, false, false, true, false, false};
    for (size_t i = 0; i < sizeof beside / sizeof *beside; ++i) {
        const bmr_vec32 far_on = {5.0f, -5.0f};
        const bmr_piece_ray32 ray = bmr_convex32_piece_ray(beside[i], far_on, 2.0f);
        // At its begin: nothing before that is asked.
        assert_int_equal(bmr_convex32_comes_through(piece, &ray, 0.0), through[i]);
        assert_int_equal(bmr_convex32_comes_through(piece, &ray, 1e-6), through[i]);
    }
}

TEST(a_corner_is_entered_by_the_face_that_is_run_against) {
    own_convex32 *piece = right_half();
    const bmr_vec32 right_corner = {1.0f, 0.0f}, left_corner = {0.0f, 0.0f}, middle = {0.5f, 0.0f};
    const bmr_vec32 steep = {2.0f, 2.0f}, flat = {4.0f, 1.0f}, below = {2.0f, -1.0f}, on = {2.0f, 0.0f};
    const bmr_vec32 hardly_above = {2.0f, 1e-6f}, other_side = {-2.0f, 0.5f};
    const struct {
        bmr_vec32 p1, corner, normal; ///< {0, 0}: none is
    } cases[] = {{steep, right_corner, {0.0f, 1.0f}},     {flat, right_corner, {1.0f, 0.0f}},
                 {below, right_corner, {1.0f, 0.0f}},     {steep, left_corner, {0.0f, 1.0f}},
                 {steep, middle, {0.0f, 1.0f}},           {below, left_corner, {0.0f, 0.0f}},
                 {on, left_corner, {0.0f, 0.0f}},         {hardly_above, left_corner, {0.0f, 0.0f}},
                 {other_side, left_corner, {0.0f, 1.0f}}, {steep, {1.5f, 0.0f}, {0.0f, 0.0f}},
                 {steep, {0.5f, 0.1f}, {0.0f, 0.0f}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const bmr_vec32 p1 = cases[i].p1, c = cases[i].corner;
        const bmr_vec32 p2 = {p1.x + 2.0f * (c.x - p1.x) - 0.001f, p1.y + 2.0f * (c.y - p1.y)};
        const bmr_piece_ray32 ray = bmr_convex32_piece_ray(p1, p2, 2.0f);
        bmr_vec32 normal = {0.0f, 0.0f};
        double against = 0.0;
        bmr_convex32_face_against(piece, &ray, c, &against, &normal);
        assert_true(normal.x == cases[i].normal.x && normal.y == cases[i].normal.y);
        assert_int_equal(against < 0.0, normal.x + normal.y != 0.0f);
    }
}

TEST(an_edge_of_several_knows_its_parts) {
    // Below: a face, another in line with it, two inner edges, a face; on the right two inner edges.
    const bmr_piece_corner32 corners[] = {
        corner(0.0f, 0.0f, false), corner(1.0f, 0.0f, false), corner(2.0f, 0.0f, true),
        corner(3.0f, 0.0f, true),  corner(4.0f, 0.0f, false), corner(6.0f, 0.0f, true),
        corner(6.0f, 1.0f, true),  corner(6.0f, 2.0f, false), corner(0.0f, 2.0f, false)};
    enum { COUNT = sizeof corners / sizeof *corners };
    const struct {
        bmr_vec32 from;
        bool inner;
    } parts[] = {{{0.0f, 0.0f}, false}, {{2.0f, 0.0f}, true}, {{3.0f, 0.0f}, true},
                 {{4.0f, 0.0f}, false}, {{6.0f, 0.0f}, true}, {{6.0f, 1.0f}, true}};
    for (size_t first = 0; first < COUNT; ++first) { // wherever the list begins
        bmr_piece_corner32 turned[COUNT];
        for (size_t i = 0; i < COUNT; ++i)
            turned[i] = corners[(first + i) % COUNT];
        own_convex32 *block = NULL;
        assert_int_equal(bmr_convex32_create_piece(turned, COUNT, NULL, &block), BMR_OK);
        assert_int_equal(block->polygon.count, 4);
        assert_int_equal(block->seams.part_count, 6);
        uint32_t bottom = 0;
        while (block->polygon.normals[bottom].y != -1.0f)
            ++bottom;
        for (uint32_t i = 0; i < 6; ++i) {
            const uint32_t edge = (bottom + (i < 4 ? 0 : 1)) % 4;
            uint32_t at = 0; // in order of the edges
            while (block->seams.parts[at].edge != edge)
                ++at;
            const bmr_edge_part32 *const part = &block->seams.parts[at + (i < 4 ? i : i - 4)];
            assert_true(part->edge == edge && part->inner == parts[i].inner);
            assert_true(part->from.x == parts[i].from.x && part->from.y == parts[i].from.y);
        }
        assert_int_equal(block->seams.inner[bottom], 0);
        assert_int_equal(block->seams.inner[(bottom + 1) % 4], 1);
        // A ray comes in by the parts that are faces, and past ends of inner ones.
        const float from[] = {1.0f, 1.99f, 2.0f, 2.5f, 3.0f, 3.5f, 4.0f, 4.01f};
        const bmr_entry32 entries[] = {BMR_ENTRY_FACE,   BMR_ENTRY_FACE,  BMR_ENTRY_CORNER, BMR_ENTRY_INNER,
                                       BMR_ENTRY_CORNER, BMR_ENTRY_INNER, BMR_ENTRY_FACE,   BMR_ENTRY_FACE};
        for (size_t i = 0; i < sizeof from / sizeof *from; ++i)
            assert_int_equal(enter(block, from[i], -1.0f, from[i], 1.0f, bottom).entry, entries[i]);
    }
}
