// SPDX-License-Identifier: MIT
#include "edge_search.h"
#include "exact32/clip_lanes.h"

/// More than the length of a remembered direction, whose coordinates were rounded.
static const float longest_axis = 32768.0f;

/// Of the sum of all coordinates that go in, each of which is rounded five times at most on the way: 2^-24
/// each, and the sines and cosines are themselves off by as much.
static const float noise_of_size = 0x1p-21f;

typedef struct gap {
    float certain; ///< so much, times the direction's length, are they apart along it
    uint32_t vertex_a, vertex_b;
} gap;

#if defined(__SSE2__)

/// In lane 0: the sum of all four, the outer pairs first.
static inline float sum_of(__m128 v) {
    const __m128 halves = _mm_add_ps(v, _mm_movehl_ps(v, v));
    return _mm_cvtss_f32(_mm_add_ss(halves, SPLAT(halves, 1)));
}

/// Is neither neighbour farther along u, which is in both halves?
static inline bool is_farthest(const bmr_convex32 *polygon, uint32_t at, __m128 u) {
    const bmr_vec32 *const v = polygon->vertices;
    const __m128 ways =
        _mm_sub_ps(load_two(v + convex32_next(polygon, at), v + convex32_previous(polygon, at)),
                   load_two(v + at, v + at));
    return _mm_movemask_ps(_mm_cmple_ps(dots(u, ways), _mm_setzero_ps())) == 15;
}

static inline gap gap_along(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                            const bmr_transform32 *pose_b, bmr_vec32 axis, uint32_t hint_a, uint32_t hint_b) {
    const __m128 at_a = _mm_loadu_ps(&pose_a->p.x), at_b = _mm_loadu_ps(&pose_b->p.x);
    const __m128 both = _mm_setr_ps(axis.x, axis.y, -axis.x, -axis.y);
    const __m128 right = _mm_setr_ps(axis.y, -axis.x, -axis.y, axis.x);
    const __m128 s = _mm_shuffle_ps(at_a, at_b, _MM_SHUFFLE(2, 2, 2, 2));
    const __m128 c = _mm_shuffle_ps(at_a, at_b, _MM_SHUFFLE(3, 3, 3, 3));
    // The axis in a's frame, and backwards in b's.
    const __m128 local = _mm_add_ps(_mm_mul_ps(c, both), _mm_mul_ps(s, right));
    gap g;
    g.vertex_a = hint_a < a->count ? hint_a : 0;
    g.vertex_b = hint_b < b->count ? hint_b : 0;
    const __m128 in_a = _mm_movelh_ps(local, local), in_b = _mm_movehl_ps(local, local);
    if (!is_farthest(a, g.vertex_a, in_a)) {
        const bmr_vec32 u = {_mm_cvtss_f32(in_a), _mm_cvtss_f32(SPLAT(in_a, 1))};
        g.vertex_a = bmr_convex32_walk_farthest(a, u, g.vertex_a);
    }
    if (!is_farthest(b, g.vertex_b, in_b)) {
        const bmr_vec32 u = {_mm_cvtss_f32(in_b), _mm_cvtss_f32(SPLAT(in_b, 1))};
        g.vertex_b = bmr_convex32_walk_farthest(b, u, g.vertex_b);
    }
    const __m128 magnitude = _mm_castsi128_ps(_mm_set1_epi32(0x7fffffff));
    const __m128 points = load_two(a->vertices + g.vertex_a, b->vertices + g.vertex_b);
    const __m128 way = _mm_movelh_ps(_mm_sub_ps(at_b, at_a), _mm_setzero_ps());
    const float size = sum_of(_mm_add_ps(_mm_and_ps(points, magnitude), _mm_and_ps(way, magnitude)));
    const float most = sum_of(_mm_sub_ps(_mm_mul_ps(both, way), _mm_mul_ps(local, points)));
    g.certain = most - (noise_of_size * longest_axis) * size;
    return g;
}

#else

/// Along a direction of about longest_axis, in the world. The sums are those of the lanes above.
static inline gap gap_along(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                            const bmr_transform32 *pose_b, bmr_vec32 axis, uint32_t hint_a, uint32_t hint_b) {
    const bmr_vec32 in_a = turn_back(pose_a, axis), in_b = turn_back(pose_b, negative(axis));
    gap g;
    g.vertex_a = farthest32(a, in_a, hint_a);
    g.vertex_b = farthest32(b, in_b, hint_b);
    const bmr_vec32 p = a->vertices[g.vertex_a], q = b->vertices[g.vertex_b];
    const bmr_vec32 way = minus(pose_b->p, pose_a->p);
    const float size =
        ((fabsf(p.x) + fabsf(way.x)) + fabsf(q.x)) + ((fabsf(p.y) + fabsf(way.y)) + fabsf(q.y));
    const float most =
        ((axis.x * way.x - in_a.x * p.x) - in_b.x * q.x) + ((axis.y * way.y - in_a.y * p.y) - in_b.y * q.y);
    g.certain = most - (noise_of_size * longest_axis) * size;
    return g;
}

#endif

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
/// ones, and across the line between what the two looks found, which is right where that is part of an edge,
/// or nearly so.
static bool apart_otherwise(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                            const bmr_transform32 *pose_b, float reach, bmr_convex32_memory *memory,
                            const gap *first) {
    const bmr_vec32 first_way = between(a, pose_a, b, pose_b, first);
    bmr_vec32 way = first_way, axis = first_way;
    float most = first->certain;
    gap last = *first;
    for (int looks = 0; looks < 2 && dot(way, way) > reach * reach; ++looks) {
        bmr_convex32_memory turned;
        remember_axis(&turned, direction(axis));
        last = gap_along(a, pose_a, b, pose_b, remembered_axis(&turned), last.vertex_a, last.vertex_b);
        turned.support_a = (uint16_t)last.vertex_a;
        turned.support_b = (uint16_t)last.vertex_b;
        if (last.certain > most) {
            most = last.certain;
            *memory = turned;
        }
        if (last.certain > reach * longest_axis)
            return true;
        way = between(a, pose_a, b, pose_b, &last);
        axis = quarter_right(minus(way, first_way));
        if (dot(axis, first_way) < 0.0f)
            axis = negative(axis);
    }
    return false;
}

bool bmr_convex32_apart(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                        const bmr_transform32 *pose_b, float reach, bmr_convex32_memory *memory) {
    if (!remembers_axis(memory))
        remember_axis(memory, direction(minus(move(pose_b, about_middle(b)), move(pose_a, about_middle(a)))));
    const gap first =
        gap_along(a, pose_a, b, pose_b, remembered_axis(memory), memory->support_a, memory->support_b);
    memory->support_a = (uint16_t)first.vertex_a;
    memory->support_b = (uint16_t)first.vertex_b;
    if (first.certain > reach * longest_axis)
        return true;
    return apart_otherwise(a, pose_a, b, pose_b, reach, memory, &first);
}
