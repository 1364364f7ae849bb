// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_OUTLINE_PIECES_H
#define BMR_TEST_OUTLINE_PIECES_H

#include "checks.h"
#include "convex32/convex32_pieces.h"

/// @file
/// Pieces of outlines, corner by corner. In C.

/// `inner`: so is the edge that begins here. The outline goes on to (to_x, to_y) where the piece does not.
static inline bmr_piece_corner32 corner(float x, float y, bool inner, float to_x, float to_y) {
    const bmr_piece_corner32 c = {{x, y}, {to_x, to_y}, inner};
    return c;
}

static inline bmr_convex32_block *made_piece(const bmr_piece_corner32 *corners, size_t count) {
    bmr_convex32_block *block = NULL;
    assert_int_equal(bmr_convex32_create_piece(corners, count, NULL, &block), BMR_OK);
    return block;
}

/// No piece: a regular polygon.
static inline bmr_convex32_block *polygon_of(uint32_t count, float radius) {
    bmr_vec32 v[64];
    for (uint32_t i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * ((double)i + 0.5) / (double)count;
        v[i].x = radius * (float)cos(angle);
        v[i].y = radius * (float)sin(angle);
    }
    return made_convex32(v, count);
}

#endif
