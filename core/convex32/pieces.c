// SPDX-License-Identifier: MIT
#include "convex32/convex32_pieces.h"

#include <string.h>

#include "boomerang/polygon.h"
#include "convex32/build.h"
#include "convex32/edge_search.h"
#include "geometry/memory.h"

/// The corners as they were given, and those of them that become vertices, in order.
typedef struct draft {
    const bmr_piece_corner32 *corners;
    size_t given;
    uint32_t *kept;
    size_t count; ///< of those that are kept
} draft;

static inline bmr_vec32 kept_vertex(const draft *d, size_t i) {
    return d->corners[d->kept[i]].vertex;
}

static inline size_t next_corner(const draft *d, size_t i) {
    return i + 1 < d->given ? i + 1 : 0;
}

/// Is the edge that ends at this vertex a face where it does, as it was given?
static inline bool is_face_before(const draft *d, uint32_t i) {
    const uint32_t first = d->kept[i];
    return !d->corners[first > 0 ? first - 1 : d->given - 1].inner;
}

/// Drops what turns by no more than rounding; what is left may be fewer than three. (A straight corner's edge
/// goes on as part of the one ahead of it.)
static void drop_straight(draft *d) {
    size_t size = 0;
    for (size_t i = 0; i < d->given; ++i) {
        while (size >= 2 &&
               !convex32_turns(kept_vertex(d, size - 2), kept_vertex(d, size - 1), d->corners[i].vertex))
            --size;
        d->kept[size++] = (uint32_t)i;
    }
    size_t first = 0;
    for (bool changed = true; changed && size - first >= 3;) { // where the last meet the first
        changed = true;
        if (!convex32_turns(kept_vertex(d, size - 2), kept_vertex(d, size - 1), kept_vertex(d, first)))
            --size;
        else if (!convex32_turns(kept_vertex(d, size - 1), kept_vertex(d, first), kept_vertex(d, first + 1)))
            ++first;
        else
            changed = false;
    }
    memmove(d->kept, d->kept + first, (size - first) * sizeof *d->kept);
    d->count = size - first;
}

/// The parts of the edge from vertex i to the next: inner edges one by one, for the outline may have a corner
/// between two of them, and stretches of faces. Returns how many; writes them where `parts` is not NULL.
static uint32_t write_parts(const draft *d, uint32_t i, bmr_edge_part32 *parts, bool *all_inner) {
    const size_t end = d->kept[i + 1 < d->count ? i + 1 : 0];
    uint32_t count = 0;
    bool inner = false;
    *all_inner = true;
    for (size_t k = d->kept[i]; count == 0 || k != end; k = next_corner(d, k)) {
        if (count > 0 && !d->corners[k].inner && !inner)
            continue;
        inner = d->corners[k].inner;
        *all_inner = *all_inner && inner;
        if (parts) {
            const bmr_edge_part32 part = {d->corners[k].vertex, i, inner};
            parts[count] = part;
        }
        ++count;
    }
    return count;
}

/// Does the outline turn to the left, from one edge's normal to the next's?
static bool turns_left(bmr_vec32 before, bmr_vec32 after) {
    const double turn = convex32_turn(before, after);
    return turn > 0.0 ||
           (turn == 0.0 && (double)before.x * (double)after.x + (double)before.y * (double)after.y < 0.0);
}

/// What the piece admits at vertex i.
static void write_turn(const bmr_convex32 *p, const draft *d, uint32_t i, bmr_vec32 *low, bmr_vec32 *high) {
    const bmr_piece_corner32 *const cut = &d->corners[d->kept[i]];
    const bool face_before = is_face_before(d, i);
    const bmr_vec32 before = p->normals[convex32_previous(p, i)], ahead = p->normals[i];
    if (face_before && !cut->inner) {
        *low = before;
        *high = ahead;
    } else if (face_before) {
        const bmr_vec32 beyond = convex32_edge_normal(cut->vertex, cut->neighbour);
        *low = before;
        *high = turns_left(before, beyond) ? beyond : before;
    } else if (!cut->inner) {
        const bmr_vec32 beyond = convex32_edge_normal(cut->neighbour, cut->vertex);
        *low = turns_left(beyond, ahead) ? beyond : ahead;
        *high = ahead;
    } else {
        const bmr_vec32 none = {0.0f, 0.0f};
        *low = *high = none;
    }
}

static bmr_error make_piece(const draft *d, bmr_vec32 *vertices, const bmr_allocator *allocator,
                            bmr_convex32_block **block) {
    const size_t count = d->count;
    for (size_t i = 0; i < count; ++i)
        vertices[i] = kept_vertex(d, i);
    if (convex32_box_side(vertices, count) < BMR_MIN_SIDE)
        return BMR_ERROR_OUT_OF_RANGE;
    uint32_t part_count = 0;
    bool all_inner;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t of_edge = write_parts(d, i, NULL, &all_inner);
        part_count += of_edge > 1 ? of_edge : 0;
    }
    const size_t more = count * (2 * sizeof(bmr_vec32) + sizeof(uint8_t)) + sizeof(bmr_vec32) +
                        part_count * sizeof(bmr_edge_part32);
    bmr_convex32_block *made;
    const bmr_error error = convex32_make(vertices, count, more, allocator, &made);
    if (error != BMR_OK)
        return error == BMR_ERROR_NOT_CONVEX ? BMR_ERROR_TOO_FEW_POINTS : error;
    // The table of directions is made of halves of words.
    const size_t used = (bmr_convex32_bytes(count) + sizeof(bmr_vec32) - 1) / sizeof(bmr_vec32);
    bmr_vec32 *const low = (bmr_vec32 *)(void *)made + used, *const high = low + count;
    bmr_edge_part32 *const parts = (bmr_edge_part32 *)(void *)(high + count);
    uint8_t *const inner = (uint8_t *)(parts + part_count);
    bool has_inner = false;
    uint32_t written = 0;
    for (uint32_t i = 0; i < count; ++i) {
        write_turn(&made->polygon, d, i, low + i, high + i);
        if (write_parts(d, i, NULL, &all_inner) > 1)
            written += write_parts(d, i, parts + written, &all_inner);
        inner[i] = all_inner;
        has_inner = has_inner || all_inner;
    }
    const bmr_seams32 seams = {low, high, inner, parts, part_count};
    made->seams = seams;
    if (has_inner)
        made->polygon.seams = &made->seams;
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
    const size_t size = count * (sizeof(bmr_vec32) + sizeof(uint32_t));
    bmr_vec32 *const vertices = bmr_allocate(allocator, size);
    if (!vertices)
        return BMR_ERROR_NO_MEMORY;
    for (size_t i = 0; i < count; ++i)
        vertices[i] = corners[i].vertex;
    bmr_error error = convex32_check_points(vertices, count);
    if (error == BMR_OK) {
        draft d = {corners, count, (uint32_t *)(vertices + count), 0};
        drop_straight(&d);
        error = d.count < 3 ? BMR_ERROR_TOO_FEW_POINTS : make_piece(&d, vertices, allocator, block);
    }
    bmr_release(allocator, vertices, size);
    return error;
}

bool bmr_convex32_admits(const bmr_convex32 *polygon, uint32_t vertex, bmr_vec32 direction, float tolerance) {
    if (!polygon->seams)
        return true;
    const bmr_vec32 low = polygon->seams->low[vertex], high = polygon->seams->high[vertex];
    return cross(low, direction) >= -tolerance && cross(direction, high) >= -tolerance &&
           (dot(low, direction) > 0.0f || dot(high, direction) > 0.0f);
}
