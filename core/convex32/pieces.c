// SPDX-License-Identifier: MIT
#include <math.h>

#include "boomerang/polygon.h"
#include "convex32/build.h"
#include "convex32/convex32_pieces.h"
#include "convex32/edge_search.h"
#include "geometry/memory.h"

/// The corners as they were given, and those of them that become vertices, in order. (A straight corner's
/// edge goes on as part of the one ahead of it.)
typedef struct draft {
    const bmr_piece_corner32 *corners;
    size_t given;
    const bmr_vec32 *vertices;
    const uint32_t *kept; ///< their corners
    size_t count;         ///< of those that are kept
} draft;

/// Is the edge that ends at this vertex a face where it does, as it was given?
static inline bool is_face_before(const draft *d, uint32_t i) {
    const uint32_t first = d->kept[i];
    return !d->corners[first > 0 ? first - 1 : d->given - 1].inner;
}

/// The parts of the edge from vertex i to the next: inner edges one by one, for the outline may have a corner
/// between two of them, and stretches of faces. Returns how many; writes them where `parts` is not NULL.
static uint32_t write_parts(const draft *d, uint32_t i, bmr_edge_part32 *parts, bool *all_inner) {
    const size_t end = d->kept[i + 1 < d->count ? i + 1 : 0];
    uint32_t count = 0;
    bool inner = false;
    *all_inner = true;
    for (size_t k = d->kept[i]; count == 0 || k != end; k = k + 1 < d->given ? k + 1 : 0) {
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

static bmr_error make_piece(const draft *d, const bmr_allocator *allocator, bmr_convex32_block **block) {
    const size_t count = d->count;
    if (convex32_box_side(d->vertices, count) < BMR_MIN_SIDE)
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
    const bmr_error error = convex32_make(d->vertices, count, more, allocator, &made);
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
    uint32_t *const numbers = (uint32_t *)(vertices + count);
    for (size_t i = 0; i < count; ++i) {
        vertices[i] = corners[i].vertex;
        numbers[i] = (uint32_t)i;
    }
    bmr_error error = convex32_check_points(vertices, count);
    if (error == BMR_OK) {
        const size_t kept = convex32_drop_straight(vertices, numbers, count);
        const draft d = {corners, count, vertices, numbers, kept};
        error = kept < 3 ? BMR_ERROR_TOO_FEW_POINTS : make_piece(&d, allocator, block);
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

/// Of the distance of the ray's begin from what it hits: the products and sums of bmr_convex32_ray round to
/// 2^-24 each, and there are about ten of them, of two edges.
#define ROUNDING 0x1p-20
/// How far before a corner one looks where the ray comes from, in noises. There, faces that the ray meets at
/// more than a degree are farther from it than the noise.
#define BEFORE 64.0

static inline bmr_vec2 place_on(const bmr_piece_ray32 *ray, double fraction) {
    return bmr_vec2_make(ray->x + fraction * ray->dx, ray->y + fraction * ray->dy);
}

/// An edge, or a part of one that has several.
typedef struct stretch {
    bmr_vec32 from, to;
    bmr_vec32 normal;
    bool inner;
} stretch;

static inline stretch whole_edge(const bmr_convex32_block *piece, uint32_t edge) {
    const bmr_convex32 *const p = &piece->polygon;
    const stretch s = {p->vertices[edge], p->vertices[convex32_next(p, edge)], p->normals[edge],
                       piece->seams.inner[edge] != 0};
    return s;
}

/// How many parts has the edge (0: it is one itself), and which is the first?
static uint32_t parts_of(const bmr_seams32 *seams, uint32_t edge, uint32_t *first) {
    uint32_t low = 0, high = seams->part_count, count = 0;
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        if (seams->parts[middle].edge < edge)
            low = middle + 1;
        else
            high = middle;
    }
    *first = low;
    while (low + count < seams->part_count && seams->parts[low + count].edge == edge)
        ++count;
    return count;
}

static stretch part_of(const bmr_convex32_block *piece, uint32_t edge, uint32_t first, uint32_t count,
                       uint32_t k) {
    stretch s = whole_edge(piece, edge);
    const bmr_edge_part32 *const parts = piece->seams.parts + first;
    s.from = parts[k].from;
    s.to = k + 1 < count ? parts[k + 1].from : s.to;
    s.inner = parts[k].inner;
    return s;
}

/// How far along the stretch, from its begin, is the place?
static inline double along(const stretch *s, bmr_vec2 place) {
    return (double)s->normal.x * ((place.y - (double)s->from.y)) -
           (double)s->normal.y * ((place.x - (double)s->from.x));
}

static inline double outside(const stretch *s, bmr_vec2 place) {
    return (double)s->normal.x * (place.x - (double)s->from.x) +
           (double)s->normal.y * (place.y - (double)s->from.y);
}

/// The stretch of the edge that is beside the place.
static stretch stretch_beside(const bmr_convex32_block *piece, uint32_t edge, bmr_vec2 place) {
    uint32_t first;
    const uint32_t count = parts_of(&piece->seams, edge, &first);
    stretch s = whole_edge(piece, edge);
    for (uint32_t k = 0; k < count; ++k) {
        const stretch part = part_of(piece, edge, first, count, k);
        if (k == 0 || along(&part, place) >= 0.0)
            s = part;
    }
    return s;
}

bmr_piece_ray32 bmr_convex32_piece_ray(bmr_vec32 p1, bmr_vec32 p2, float reach) {
    // As bmr_convex32_ray has it, rounding included.
    const float dx = p2.x - p1.x, dy = p2.y - p1.y;
    bmr_piece_ray32 ray = {(double)p1.x, (double)p1.y, (double)dx, (double)dy, 0.0, 0.0};
    ray.length = sqrt(ray.dx * ray.dx + ray.dy * ray.dy);
    ray.noise = ROUNDING * (fabs(ray.x) + fabs(ray.y) + (double)reach);
    return ray;
}

bmr_entry32 bmr_convex32_entry(const bmr_convex32_block *piece, const bmr_piece_ray32 *ray, uint32_t edge,
                               double *fraction, bmr_vec32 *corner) {
    const double hit = *fraction;
    const stretch s = stretch_beside(piece, edge, place_on(ray, hit));
    if (!s.inner)
        return BMR_ENTRY_FACE;
    const bmr_vec2 begin = {ray->x, ray->y};
    const bmr_vec32 ends[2] = {s.from, s.to};
    bmr_entry32 entry = BMR_ENTRY_INNER;
    for (int i = 0; i < 2; ++i) {
        const bmr_vec2 way = bmr_sub(convex32_wide(ends[i]), begin);
        const double off = fabs(way.x * ray->dy - way.y * ray->dx) / ray->length;
        const double at = (way.x * ray->dx + way.y * ray->dy) / (ray->dx * ray->dx + ray->dy * ray->dy);
        // An end that lies farther on is not where it came in.
        if (off <= ray->noise && (at - hit) * ray->length <= BEFORE * ray->noise &&
            (entry == BMR_ENTRY_INNER || at < *fraction)) {
            entry = BMR_ENTRY_CORNER;
            *fraction = fmax(0.0, fmin(at, *fraction));
            *corner = ends[i];
        }
    }
    return entry;
}

bool bmr_convex32_comes_through(const bmr_convex32_block *piece, const bmr_piece_ray32 *ray,
                                double fraction) {
    const bmr_vec2 place = place_on(ray, fmax(0.0, fraction - BEFORE * ray->noise / ray->length));
    for (uint32_t i = 0; i < piece->polygon.count; ++i) {
        const stretch s = stretch_beside(piece, i, place);
        if (outside(&s, place) > (s.inner ? ray->noise : -ray->noise))
            return false;
    }
    return true;
}

void bmr_convex32_face_against(const bmr_convex32_block *piece, const bmr_piece_ray32 *ray, bmr_vec32 corner,
                               double *against, bmr_vec32 *normal) {
    const bmr_vec2 begin = {ray->x, ray->y}, at = convex32_wide(corner);
    for (uint32_t i = 0; i < piece->polygon.count; ++i) {
        const stretch edge = whole_edge(piece, i);
        const double faced = (double)edge.normal.x * ray->dx + (double)edge.normal.y * ray->dy;
        if (!(faced < *against) || fabs(outside(&edge, at)) > ray->noise ||
            !(outside(&edge, begin) > ray->noise))
            continue;
        uint32_t first;
        const uint32_t count = parts_of(&piece->seams, i, &first);
        for (uint32_t k = 0; k == 0 || k < count; ++k) {
            const stretch s = count > 0 ? part_of(piece, i, first, count, k) : edge;
            if (s.inner || along(&s, at) < -ray->noise ||
                along(&s, convex32_wide(s.to)) - along(&s, at) < -ray->noise)
                continue;
            *against = faced;
            *normal = s.normal;
        }
    }
}
