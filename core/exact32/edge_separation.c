// SPDX-License-Identifier: MIT
#include "exact32/exact32.h"

#include "max_edge.h"

// Regrouping any formula breaks the contract of the header. Box2D's minimum over vertices starts at FLT_MAX
// and replaces on "less", so a NaN never enters it; every form here keeps to that.

bmr_transform32 bmr_exact32_relative(const bmr_transform32 *other, const bmr_transform32 *reference) {
    bmr_transform32 r;
    r.s = other->c * reference->s - other->s * reference->c;
    r.c = other->c * reference->c + other->s * reference->s;
    const float x = reference->p.x - other->p.x, y = reference->p.y - other->p.y;
    r.p.x = other->c * x + other->s * y;
    r.p.y = -other->s * x + other->c * y;
    return r;
}

float bmr_exact32_edge_separation_scalar(const bmr_polygon32 *reference, int32_t edge,
                                         const bmr_polygon32 *other, const bmr_transform32 *frame) {
    const bmr_vec32 n = turn(frame, reference->normals[edge]);
    const bmr_vec32 v = move(frame, reference->vertices[edge]);
    float least = FLT_MAX;
    for (int32_t j = 0; j < other->count; ++j) {
        const float s = n.x * (other->vertices[j].x - v.x) + n.y * (other->vertices[j].y - v.y);
        if (s < least)
            least = s;
    }
    return least;
}

float bmr_exact32_edge_separation(const bmr_polygon32 *reference, int32_t edge, const bmr_polygon32 *other,
                                  const bmr_transform32 *frame) {
    const bmr_vec32 n = turn(frame, reference->normals[edge]);
    const bmr_vec32 v = move(frame, reference->vertices[edge]);
    const float4 nx = all4(n.x), ny = all4(n.y), vx = all4(v.x), vy = all4(v.y);
    const float4 far_away = all4(FLT_MAX);
    float4 least = far_away;
    for (int32_t group = 0; 4 * group < other->count; ++group) {
        const mask4 mask = first_lanes4(other->count, group);
        const quad q = load_quad(other->vertices + 4 * group, mask);
        const float4 s = add4(mul4(nx, sub4(q.x, vx)), mul4(ny, sub4(q.y, vy)));
        least = min4(select4(mask, s, far_away), least); // a NaN in s gives `least` back
    }
    return least_of4(least);
}

/// The first four points' minimum into `least`, lanes past `count` left out.
static inline float4 lower(float4 least, const bmr_vec32 *points, int32_t count, float4 nx, float4 ny,
                           float4 vx, float4 vy) {
    if (count >= 4) { // no lane to leave out: the common case of boxes and octagons
        const quad q = load_four(points);
        const float4 s = add4(mul4(nx, sub4(q.x, vx)), mul4(ny, sub4(q.y, vy)));
        return min4(s, least);
    }
    const mask4 mask = first_lanes4(count, 0);
    const quad q = load_quad(points, mask);
    const float4 s = add4(mul4(nx, sub4(q.x, vx)), mul4(ny, sub4(q.y, vy)));
    return min4(select4(mask, s, all4(FLT_MAX)), least);
}

/// One edge in the frame of the other polygon: each line is two or four of the scalar formulas side by side.
typedef struct posed_edge {
    float4 d; ///< dx, dy, s, c of what the frame is made of
    float4 a; ///< normal and vertex in their own frame
    float4 n; ///< the normal, and the vertex before it is moved
    float4 v; ///< (unused, unused), vertex
    float4 at_other;
} posed_edge;

static inline posed_edge pose_edge(const bmr_vec32 *vertex, const bmr_vec32 *normal,
                                   const bmr_transform32 *reference, const bmr_transform32 *other) {
    posed_edge e;
    e.at_other = load4(&other->p.x);
    const float4 at_reference = load4(&reference->p.x);
    e.d = low_high4(sub4(at_reference, e.at_other), at_reference);
    const float4 f = relative_of(e.at_other, e.d); // px, py, s, c
    e.a = load_pairs4(&normal->x, &vertex->x);
    e.n = add4(mul4(splat4(f, 3), e.a), mul4(splat4(f, 2), quarter_left(e.a)));
    e.v = add4(e.n, lows4(f, f));
    return e;
}

static inline float least_separation(const posed_edge *e, const bmr_vec32 *points, int32_t count) {
    const float4 nx = splat4(e->n, 0), ny = splat4(e->n, 1), vx = splat4(e->v, 2), vy = splat4(e->v, 3);
    float4 least = lower(all4(FLT_MAX), points, count, nx, ny, vx, vy);
    if (count > 4)
        least = lower(least, points + 4, count - 4, nx, ny, vx, vy);
    return least_of4(least);
}

float bmr_exact32_posed_separation(const bmr_vec32 *vertex, const bmr_vec32 *normal,
                                   const bmr_transform32 *reference, const bmr_vec32 *points, int32_t count,
                                   const bmr_transform32 *other) {
    const posed_edge e = pose_edge(vertex, normal, reference, other);
    return least_separation(&e, points, count);
}

float bmr_exact32_max_separation(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                 const bmr_transform32 *frame, int32_t *edge) {
    const max_edge found = find_max_edge(reference, other, load4(&frame->p.x));
    *edge = found.edge;
    return found.separation;
}

float bmr_exact32_max_separation_scalar(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                        const bmr_transform32 *frame, int32_t *edge) {
    float best = -FLT_MAX;
    *edge = 0;
    for (int32_t i = 0; i < reference->count; ++i) {
        const float s = bmr_exact32_edge_separation_scalar(reference, i, other, frame);
        if (s > best) {
            best = s;
            *edge = i;
        }
    }
    return best;
}
