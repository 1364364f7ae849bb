// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_CONVEX32_EDGE_SEARCH_H
#define BOOMERANG_CONVEX32_EDGE_SEARCH_H

#include "convex32/convex32_collide.h"
#include "convex32/directions.h"
#include "exact32/clip.h"

/// @file
/// The search for the edge of largest separation, and what collide.c and its neighbours share with it.
///
/// Box2D looks at all edges and takes the first whose separation, in float, is the largest. So does the
/// search, though it looks at few edges: those that it leaves out separate by less for certain, rounding
/// included. The answer has the bits of the full loops, whatever the hint was.

/// One edge of the reference as the other polygon sees it: all in the other's frame.
typedef struct edge_view {
    uint32_t edge;
    uint32_t vertex; ///< of the other: least separated from the edge, to rounding
    float separation;
    float noise; ///< the separation is off by less, and so are products with the vectors below
    bmr_vec32 normal;
    bmr_vec32 place;   ///< where the edge begins
    bmr_vec32 nearest; ///< where `vertex` is
} edge_view;

/// The other may be one or two points, without normals: a circle's centre, an edge.
typedef struct edge_search {
    const bmr_convex32 *reference, *other;
    bmr_transform32 frame; ///< of the reference in the other's
    float frame_size;      ///< |x| + |y| of its place
    float tolerance;       ///< 0: the caller does not want edge_found.rest
} edge_search;

typedef struct edge_found {
    edge_view best;
    /// No edge of the other polygon separates by more than the larger of this and best.separation. Computed
    /// only where the tolerance is above 0.
    float rest;
} edge_found;

/// The first edge of largest separation. If the largest separation is less than `floor`, the search may stop
/// early, at any edge that separates by less than `floor`. Hints may be any numbers.
void bmr_convex32_seek(const edge_search *search, uint32_t edge_hint, uint32_t vertex_hint, float floor,
                       edge_found *found);

/// One edge, as the search sees it.
edge_view bmr_convex32_view(const edge_search *search, uint32_t edge, uint32_t vertex_hint);

static inline edge_search edge_search_of(const bmr_convex32 *reference, const bmr_convex32 *other,
                                         bmr_transform32 frame, float tolerance) {
    const edge_search s = {reference, other, frame, fabsf(frame.p.x) + fabsf(frame.p.y), tolerance};
    return s;
}

static inline bmr_vec32 negative(bmr_vec32 a) {
    const bmr_vec32 r = {-a.x, -a.y};
    return r;
}

/// How many steps on from `from` is `to`?
static inline uint32_t steps32(uint32_t from, uint32_t to, uint32_t count) {
    return to >= from ? to - from : to + count - from;
}

/// Called by farthest32 when the vertex at `start` is not the farthest along u: climbs from there for a few
/// steps. Where these are not enough, it calls the next one.
uint32_t bmr_convex32_walk_farthest(const bmr_convex32 *polygon, bmr_vec32 u, uint32_t start);
/// The vertex farthest along u from scratch: climbs from the one that the polygon's table of directions has
/// for u. A polygon without a table is climbed from `start`.
uint32_t bmr_convex32_find_farthest(const bmr_convex32 *polygon, bmr_vec32 u, uint32_t start);

/// The vertex farthest along u. Edges are judged by their own vectors, which hardly round, where products
/// with far vertices would: to rounding it is the real one.
static inline uint32_t farthest32(const bmr_convex32 *polygon, bmr_vec32 u, uint32_t hint) {
    const bmr_vec32 *const v = polygon->vertices;
    const uint32_t at = hint < polygon->count ? hint : 0;
    if (dot(u, minus(v[convex32_next(polygon, at)], v[at])) <= 0.0f &&
        dot(u, minus(v[convex32_previous(polygon, at)], v[at])) <= 0.0f)
        return at;
    return bmr_convex32_walk_farthest(polygon, u, at);
}

/// The edge of the polygon whose normal is nearest to u, its own frame, and the hint where that or a
/// neighbour of it is. For a place to start.
static inline uint32_t edge_towards(const bmr_convex32 *polygon, bmr_vec32 u, uint32_t hint) {
    const bmr_vec32 *const n = polygon->normals;
    const uint32_t at = hint < polygon->count ? hint : 0;
    if (dot(n[at], u) > 0.0f && cross(n[convex32_previous(polygon, at)], u) >= 0.0f &&
        cross(u, n[convex32_next(polygon, at)]) >= 0.0f)
        return at;
    const uint32_t vertex = bmr_convex32_find_farthest(polygon, u, at),
                   last = convex32_previous(polygon, vertex);
    return dot(u, minus(n[vertex], n[last])) >= 0.0f ? vertex : last;
}

static inline int16_t axis_coordinate(float x) {
    const float scaled = x * 32767.0f + (x < 0.0f ? -0.5f : 0.5f);
    return scaled > -32768.0f && scaled < 32768.0f ? (int16_t)scaled : 0;
}

/// A unit vector, in the world.
static inline void remember_axis(bmr_convex32_memory *memory, bmr_vec32 axis) {
    memory->axis_x = axis_coordinate(axis.x);
    memory->axis_y = axis_coordinate(axis.y);
}

static inline bool remembers_axis(const bmr_convex32_memory *memory) {
    return memory->axis_x != 0 || memory->axis_y != 0;
}

/// 32767 long.
static inline bmr_vec32 remembered_axis(const bmr_convex32_memory *memory) {
    const bmr_vec32 axis = {(float)memory->axis_x, (float)memory->axis_y};
    return axis;
}

/// A point well inside, but for shapes whose vertices are crowded.
static inline bmr_vec32 about_middle(const bmr_convex32 *polygon) {
    const bmr_vec32 *const v = polygon->vertices;
    const uint32_t third = polygon->count / 3;
    const bmr_vec32 middle = {(v[0].x + v[third].x + v[2 * third].x) / 3.0f,
                              (v[0].y + v[third].y + v[2 * third].y) / 3.0f};
    return middle;
}

/// The edge of `polygon`, its normals turned, whose normal has the least product with `normal`: the first of
/// equals, to the bit. `hint` is about where the polygon is farthest the other way.
uint32_t bmr_convex32_edge_against(const bmr_convex32 *polygon, const bmr_transform32 *turned,
                                   bmr_vec32 normal, uint32_t hint);

static const bmr_transform32 bmr_convex32_here = {{0.0f, 0.0f}, 0.0f, 1.0f};

#endif
