// SPDX-License-Identifier: MIT
#include "edge_search.h"

/// No remembered direction is longer: its length was 32767 before its coordinates were rounded.
#define LONGEST_AXIS 32768.0f

/// What a gap along a remembered direction may be off by, as a part of the sum of all coordinates that go
/// into it: each is rounded at most six times on the way (twice in the turned direction), and the sum once
/// more where it is compared, by 2^-24 each time.
///
/// The product of the turned direction with an edge is off by less than the same part of the edge's |x| +
/// |y|: by 2^-24 twice for the direction, and three times for the difference, the product and the sum.
static const float noise = 0x1p-21f * LONGEST_AXIS;

typedef struct gap {
    float certain; ///< so much, times the direction's length, are they apart along it
    uint32_t vertex_a, vertex_b;
} gap;

/// Is the vertex certainly the farthest along u, rounding included? It is if both its edges descend: the
/// polygon is convex. The same formulas as in the lanes below.
static bool certainly_farthest(const bmr_convex32 *polygon, uint32_t at, bmr_vec32 u) {
    const bmr_vec32 here = polygon->vertices[at];
    const bmr_vec32 next = minus(polygon->vertices[convex32_next(polygon, at)], here),
                    last = minus(polygon->vertices[convex32_previous(polygon, at)], here);
    return dot(u, next) < -noise * convex32_size(next) && dot(u, last) < -noise * convex32_size(last);
}

/// At least the largest |x| + |y| of a vertex.
static float size_of(const bmr_convex32 *polygon) {
    if (polygon->buckets)
        return convex32_size(polygon->extent);
    float most = 0.0f;
    for (uint32_t i = 0; i < polygon->count; ++i) {
        const float size = convex32_size(polygon->vertices[i]);
        most = size > most ? size : most;
    }
    return most;
}

/// Finds the vertex that is farthest along u, starting from *at. Returns the size that is to be added to
/// those whose rounding is allowed for: 0 where the vertex is certainly the farthest. Where an edge lies
/// across u up to rounding, the vertex may be its other end, or the polygon may go on behind it. Then the
/// vertex of the largest product of all is taken. Two products are off by 2^-24 four times each, the
/// direction included, which is no more than the noise of twice the polygon's size.
static float find_end(const bmr_convex32 *polygon, bmr_vec32 u, uint32_t *at) {
    *at = bmr_convex32_find_farthest(polygon, u, *at);
    if (certainly_farthest(polygon, *at, u))
        return 0.0f;
    *at = bmr_convex32_support_from(polygon, u, *at);
    return 2.0f * size_of(polygon);
}

/// The vertex that is farthest along u (which is in both halves of the register): some steps from the hint,
/// and where these are not enough, find_end.
static inline uint32_t end_along(const bmr_convex32 *polygon, float4 u, uint32_t hint, float *unsure) {
    enum { NEAR_STEPS = 2 };
    const bmr_vec32 *const v = polygon->vertices;
    uint32_t at = hint < polygon->count ? hint : 0;
    for (int steps = 0; steps < NEAR_STEPS; ++steps) {
        const uint32_t next = convex32_next(polygon, at), last = convex32_previous(polygon, at);
        const float4 ways = sub4(load_two(v + next, v + last), load_two(v + at, v + at));
        const float4 slopes = dots(u, ways), sizes = abs4(ways);
        const float4 size = add4(sizes, swap4(sizes));
        if (every4(less4(slopes, mul4(all4(-noise), size))))
            return at;
        const unsigned ascends = bits4(less4(zero4(), slopes));
        if (ascends == 0u)
            break;
        at = (ascends & 1u) != 0u ? next : last;
    }
    const bmr_vec32 direction_of_u = {first_of4(u), first_of4(splat4(u, 1))};
    *unsure += find_end(polygon, direction_of_u, &at);
    return at;
}

static inline gap gap_along(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                            const bmr_transform32 *pose_b, bmr_vec32 axis, uint32_t hint_a, uint32_t hint_b) {
    const float4 at_a = load4(&pose_a->p.x), at_b = load4(&pose_b->p.x);
    const float4 both = of4(axis.x, axis.y, -axis.x, -axis.y);
    const float4 right = of4(axis.y, -axis.x, -axis.y, axis.x);
    const float4 s = splat_two4(at_a, at_b, 2);
    const float4 c = splat_two4(at_a, at_b, 3);
    // The axis in a's frame, and backwards in b's.
    const float4 local = add4(mul4(c, both), mul4(s, right));
    gap g;
    float unsure = 0.0f;
    g.vertex_a = end_along(a, lows4(local, local), hint_a, &unsure);
    g.vertex_b = end_along(b, highs4(local, local), hint_b, &unsure);
    const float4 points = load_two(a->vertices + g.vertex_a, b->vertices + g.vertex_b);
    const float4 way = lows4(sub4(at_b, at_a), zero4());
    const float size = sum_of4(add4(abs4(points), abs4(way)));
    const float most = sum_of4(sub4(mul4(both, way), mul4(local, points)));
    g.certain = most - noise * (size + unsure);
    return g;
}

/// For directions no longer than LONGEST_AXIS. What overflowed says nothing.
static inline bool exceeds(const gap *g, float reach) {
    return g->certain > reach * LONGEST_AXIS && g->certain <= FLT_MAX;
}

/// From a's vertex to b's, in the world.
static bmr_vec32 between(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                         const bmr_transform32 *pose_b, const gap *g) {
    const bmr_vec32 from = turn(pose_a, a->vertices[g->vertex_a]),
                    to = turn(pose_b, b->vertices[g->vertex_b]);
    const bmr_vec32 d = {(to.x - from.x) + (pose_b->p.x - pose_a->p.x),
                         (to.y - from.y) + (pose_b->p.y - pose_a->p.y)};
    return d;
}

/// Two more directions: along the line between the two vertices, which is right where they are the closest
/// ones, and across the line between what the two directions found, which is right where that is part of an
/// edge, or nearly so.
static bool apart_otherwise(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                            const bmr_transform32 *pose_b, float reach, bmr_convex32_memory *memory,
                            const gap *first) {
    const bmr_vec32 first_way = between(a, pose_a, b, pose_b, first);
    bmr_vec32 way = first_way, axis = first_way;
    float most = first->certain;
    gap last = *first;
    for (int tried = 0; tried < 2 && dot(way, way) > reach * reach; ++tried) {
        bmr_convex32_memory turned;
        remember_axis(&turned, direction(axis));
        last = gap_along(a, pose_a, b, pose_b, remembered_axis(&turned), last.vertex_a, last.vertex_b);
        turned.support_a = (uint16_t)last.vertex_a;
        turned.support_b = (uint16_t)last.vertex_b;
        if (last.certain > most) {
            most = last.certain;
            *memory = turned;
        }
        if (exceeds(&last, reach))
            return true;
        way = between(a, pose_a, b, pose_b, &last);
        axis = quarter_right(minus(way, first_way));
        if (dot(axis, first_way) < 0.0f)
            axis = negative(axis);
    }
    return false;
}

/// Is a direction remembered, and none that is longer than what is remembered here?
static inline bool remembers_unit_axis(const bmr_convex32_memory *memory) {
    const uint32_t square =
        (uint32_t)(memory->axis_x * memory->axis_x) + (uint32_t)(memory->axis_y * memory->axis_y);
    return square - 1u < 0x40000000u; // the square of LONGEST_AXIS; zero is none
}

bool bmr_convex32_apart(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                        const bmr_transform32 *pose_b, float reach, bmr_convex32_memory *memory) {
    if (!remembers_unit_axis(memory))
        remember_axis(memory, direction(minus(move(pose_b, about_middle(b)), move(pose_a, about_middle(a)))));
    const gap first =
        gap_along(a, pose_a, b, pose_b, remembered_axis(memory), memory->support_a, memory->support_b);
    memory->support_a = (uint16_t)first.vertex_a;
    memory->support_b = (uint16_t)first.vertex_b;
    if (exceeds(&first, reach))
        return true;
    return apart_otherwise(a, pose_a, b, pose_b, reach, memory, &first);
}
