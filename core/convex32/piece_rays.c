// SPDX-License-Identifier: MIT
#include <math.h>

#include "convex32/convex32_pieces.h"
#include "convex32/directions.h"

/// Of the distance of the ray's begin from what it hits: the products and sums of bmr_convex32_ray round to
/// 2^-24 each, and there are about ten of them, of two edges.
#define ROUNDING 0x1p-20
/// How far before a corner one looks where the ray comes from, in noises. There, faces that the ray meets at
/// more than a degree are farther from it than the noise.
#define BEFORE 64.0

typedef struct point {
    double x, y;
} point;

static inline point from_to(point a, bmr_vec32 b) {
    const point r = {(double)b.x - a.x, (double)b.y - a.y};
    return r;
}

static inline point of_vec(bmr_vec32 v) {
    const point r = {(double)v.x, (double)v.y};
    return r;
}

static inline point place_on(const bmr_piece_ray32 *ray, double fraction) {
    const point r = {ray->x + fraction * ray->dx, ray->y + fraction * ray->dy};
    return r;
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
static inline double along(const stretch *s, point place) {
    return (double)s->normal.x * ((place.y - (double)s->from.y)) -
           (double)s->normal.y * ((place.x - (double)s->from.x));
}

static inline double outside(const stretch *s, point place) {
    return (double)s->normal.x * (place.x - (double)s->from.x) +
           (double)s->normal.y * (place.y - (double)s->from.y);
}

/// The stretch of the edge that is beside the place.
static stretch stretch_beside(const bmr_convex32_block *piece, uint32_t edge, point place) {
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
    const point begin = {ray->x, ray->y};
    const bmr_vec32 ends[2] = {s.from, s.to};
    bmr_entry32 entry = BMR_ENTRY_INNER;
    for (int i = 0; i < 2; ++i) {
        const point way = from_to(begin, ends[i]);
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
    const point place = place_on(ray, fmax(0.0, fraction - BEFORE * ray->noise / ray->length));
    for (uint32_t i = 0; i < piece->polygon.count; ++i) {
        const stretch s = stretch_beside(piece, i, place);
        if (outside(&s, place) > (s.inner ? ray->noise : -ray->noise))
            return false;
    }
    return true;
}

void bmr_convex32_face_against(const bmr_convex32_block *piece, const bmr_piece_ray32 *ray, bmr_vec32 corner,
                               double *against, bmr_vec32 *normal) {
    const point begin = {ray->x, ray->y}, at = of_vec(corner);
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
                along(&s, of_vec(s.to)) - along(&s, at) < -ray->noise)
                continue;
            *against = faced;
            *normal = s.normal;
        }
    }
}
