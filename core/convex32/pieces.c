// SPDX-License-Identifier: MIT
#include "convex32/convex32_pieces.h"

#include <string.h>

#include "boomerang/polygon.h"
#include "convex32/build.h"
#include "convex32/edge_search.h"
#include "geometry/memory.h"

/// A corner on its way to a vertex.
typedef struct draft {
    bmr_piece_corner32 corner;
    bool face_before; ///< the edge that ends here, as it was given, is a face
    bool face;        ///< one of those that are one edge now is
} draft;

/// Drops what turns by no more than rounding, in place; what is left may be fewer than three.
static size_t drop_straight(draft *d, size_t count) {
    size_t size = 0;
    // A straight corner's edge goes on as part of the one ahead of it.
    for (size_t i = 0; i < count; ++i) {
        while (size >= 2 &&
               !convex32_turns(d[size - 2].corner.vertex, d[size - 1].corner.vertex, d[i].corner.vertex)) {
            d[size - 2].face = d[size - 2].face || d[size - 1].face;
            --size;
        }
        d[size++] = d[i];
    }
    size_t first = 0;
    for (bool changed = true; changed && size - first >= 3;) { // where the last meet the first
        changed = true;
        if (!convex32_turns(d[size - 2].corner.vertex, d[size - 1].corner.vertex, d[first].corner.vertex)) {
            d[size - 2].face = d[size - 2].face || d[size - 1].face;
            --size;
        } else if (!convex32_turns(d[size - 1].corner.vertex, d[first].corner.vertex,
                                   d[first + 1].corner.vertex)) {
            d[size - 1].face = d[size - 1].face || d[first].face;
            ++first;
        } else {
            changed = false;
        }
    }
    memmove(d, d + first, (size - first) * sizeof *d);
    return size - first;
}

/// Does the outline turn to the left, from one edge's normal to the next's?
static bool turns_left(bmr_vec32 before, bmr_vec32 after) {
    const double turn = convex32_turn(before, after);
    return turn > 0.0 ||
           (turn == 0.0 && (double)before.x * (double)after.x + (double)before.y * (double)after.y < 0.0);
}

/// What the piece admits at vertex i.
static void write_turn(const bmr_convex32 *p, const draft *d, uint32_t i, bmr_vec32 *low, bmr_vec32 *high) {
    const bmr_piece_corner32 *const cut = &d[i].corner;
    const bmr_vec32 before = p->normals[convex32_previous(p, i)], after = p->normals[i];
    if (d[i].face_before && !cut->inner) {
        *low = before;
        *high = after;
    } else if (d[i].face_before) {
        const bmr_vec32 beyond = convex32_edge_normal(cut->vertex, cut->neighbour);
        *low = before;
        *high = turns_left(before, beyond) ? beyond : before;
    } else if (!cut->inner) {
        const bmr_vec32 beyond = convex32_edge_normal(cut->neighbour, cut->vertex);
        *low = turns_left(beyond, after) ? beyond : after;
        *high = after;
    } else {
        const bmr_vec32 none = {0.0f, 0.0f};
        *low = *high = none;
    }
}

static bmr_error make_piece(const draft *d, size_t count, bmr_vec32 *vertices, const bmr_allocator *allocator,
                            bmr_convex32_block **block) {
    for (size_t i = 0; i < count; ++i)
        vertices[i] = d[i].corner.vertex;
    if (convex32_box_side(vertices, count) < BMR_MIN_EXTENT)
        return BMR_ERROR_OUT_OF_RANGE;
    const size_t more = count * (2 * sizeof(bmr_vec32) + sizeof(uint8_t)) + sizeof(bmr_vec32);
    bmr_convex32_block *made;
    const bmr_error error = convex32_make(vertices, count, more, allocator, &made);
    if (error != BMR_OK)
        return error == BMR_ERROR_NOT_CONVEX ? BMR_ERROR_TOO_FEW_POINTS : error;
    // The table of directions is made of halves of words.
    const size_t used = (bmr_convex32_bytes(count) + sizeof(bmr_vec32) - 1) / sizeof(bmr_vec32);
    bmr_vec32 *const low = (bmr_vec32 *)(void *)made + used, *const high = low + count;
    uint8_t *const inner = (uint8_t *)(high + count);
    bool has_inner = false;
    for (uint32_t i = 0; i < count; ++i) {
        write_turn(&made->polygon, d, i, low + i, high + i);
        inner[i] = !d[i].face;
        has_inner = has_inner || inner[i];
    }
    const bmr_seams32 seams = {low, high, inner};
    if (has_inner) {
        made->seams = seams;
        made->polygon.seams = &made->seams;
    }
    *block = made;
    return BMR_OK;
}

bmr_error bmr_convex32_create_piece(const bmr_piece_corner32 *corners, size_t count,
                                    const bmr_allocator *allocator, bmr_convex32_block **block) {
    if (!block || (!corners && count > 0))
        return BMR_ERROR_NULL_ARGUMENT;
    if (count < 3)
        return BMR_ERROR_TOO_FEW_POINTS;
    if (count > BMR_CONVEX32_MOST)
        return BMR_ERROR_TOO_MANY_POINTS;
    const size_t size = count * (sizeof(draft) + sizeof(bmr_vec32));
    draft *const drafts = bmr_allocate(allocator, size);
    if (!drafts)
        return BMR_ERROR_NO_MEMORY;
    bmr_vec32 *const vertices = (bmr_vec32 *)(drafts + count);
    for (size_t i = 0; i < count; ++i) {
        const draft d = {corners[i], !corners[i > 0 ? i - 1 : count - 1].inner, !corners[i].inner};
        drafts[i] = d;
        vertices[i] = corners[i].vertex;
    }
    bmr_error error = convex32_check_points(vertices, count);
    if (error == BMR_OK) {
        const size_t kept = drop_straight(drafts, count);
        error = kept < 3 ? BMR_ERROR_TOO_FEW_POINTS : make_piece(drafts, kept, vertices, allocator, block);
    }
    bmr_release(allocator, drafts, size);
    return error;
}

bool bmr_convex32_admits(const bmr_convex32 *polygon, uint32_t vertex, bmr_vec32 direction, float tolerance) {
    if (!polygon->seams)
        return true;
    const bmr_vec32 low = polygon->seams->low[vertex], high = polygon->seams->high[vertex];
    return cross(low, direction) >= -tolerance && cross(direction, high) >= -tolerance &&
           (dot(low, direction) > 0.0f || dot(high, direction) > 0.0f);
}

bool bmr_convex32_enters_piece(const bmr_convex32 *polygon, bmr_vec32 p1, bmr_vec32 p2, float fraction,
                               float near, uint32_t *edge) {
    if (!polygon->seams || !polygon->seams->inner[*edge])
        return true;
    const bmr_vec32 along = minus(p2, p1);
    const bmr_vec32 at = {p1.x + fraction * along.x, p1.y + fraction * along.y};
    const uint32_t next = convex32_next(polygon, *edge);
    const uint32_t faces[2] = {convex32_previous(polygon, *edge), next}, ends[2] = {*edge, next};
    for (int i = 0; i < 2; ++i) {
        const bmr_vec32 away = minus(at, polygon->vertices[ends[i]]);
        if (!polygon->seams->inner[faces[i]] && dot(along, polygon->normals[faces[i]]) < 0.0f &&
            dot(away, away) <= near * near) {
            *edge = faces[i];
            return true;
        }
    }
    return false;
}
