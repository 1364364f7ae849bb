// SPDX-License-Identifier: MIT
#include "boomerang/exact32.h"

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

#if defined(__SSE2__)

float bmr_exact32_edge_separation(const bmr_polygon32 *reference, int32_t edge, const bmr_polygon32 *other,
                                  const bmr_transform32 *frame) {
    const bmr_vec32 n = turn(frame, reference->normals[edge]);
    const bmr_vec32 v = move(frame, reference->vertices[edge]);
    const __m128 nx = _mm_set1_ps(n.x), ny = _mm_set1_ps(n.y), vx = _mm_set1_ps(v.x), vy = _mm_set1_ps(v.y);
    const __m128 far_away = _mm_set1_ps(FLT_MAX);
    __m128 least = far_away;
    for (int32_t group = 0; 4 * group < other->count; ++group) {
        const __m128 mask = lanes(other->count, group);
        const quad q = load_quad(other->vertices + 4 * group, mask);
        const __m128 s = _mm_add_ps(_mm_mul_ps(nx, _mm_sub_ps(q.x, vx)), _mm_mul_ps(ny, _mm_sub_ps(q.y, vy)));
        least = _mm_min_ps(blend(mask, s, far_away), least); // a NaN in s gives `least` back
    }
    least = _mm_min_ps(least, _mm_movehl_ps(least, least));
    least = _mm_min_ss(least, _mm_shuffle_ps(least, least, 1));
    return _mm_cvtss_f32(least);
}

/// The first four points' minimum into `least`, lanes past `count` left out.
static inline __m128 lower(__m128 least, const bmr_vec32 *points, int32_t count, __m128 nx, __m128 ny,
                           __m128 vx, __m128 vy) {
    if (count >= 4) { // no lane to leave out: the common case of boxes and octagons
        const quad q = load_four(points);
        const __m128 s = _mm_add_ps(_mm_mul_ps(nx, _mm_sub_ps(q.x, vx)), _mm_mul_ps(ny, _mm_sub_ps(q.y, vy)));
        return _mm_min_ps(s, least);
    }
    const __m128 mask = lanes(count, 0);
    const quad q = load_quad(points, mask);
    const __m128 s = _mm_add_ps(_mm_mul_ps(nx, _mm_sub_ps(q.x, vx)), _mm_mul_ps(ny, _mm_sub_ps(q.y, vy)));
    return _mm_min_ps(blend(mask, s, _mm_set1_ps(FLT_MAX)), least);
}

float bmr_exact32_posed_separation(const bmr_vec32 *vertex, const bmr_vec32 *normal,
                                   const bmr_transform32 *reference, const bmr_vec32 *points, int32_t count,
                                   const bmr_transform32 *other) {
    // Each line is two or four of the scalar formulas side by side.
    const __m128 f = relative(_mm_loadu_ps(&other->p.x), _mm_loadu_ps(&reference->p.x)); // px, py, s, c
    const __m128 s = SPLAT(f, 2), c = SPLAT(f, 3);
    const __m128 zero = _mm_setzero_ps();
    const __m128 a = _mm_loadh_pi(_mm_loadl_pi(zero, (const __m64 *)(const void *)normal),
                                  (const __m64 *)(const void *)vertex);
    const __m128 n =
        _mm_add_ps(_mm_mul_ps(c, a), _mm_mul_ps(s, quarter_left(a))); // nx, ny, and v before it is moved
    const __m128 v = _mm_add_ps(n, _mm_movelh_ps(f, f));              // (unused), vx, vy
    const __m128 nx = SPLAT(n, 0), ny = SPLAT(n, 1), vx = SPLAT(v, 2), vy = SPLAT(v, 3);
    __m128 least = lower(_mm_set1_ps(FLT_MAX), points, count, nx, ny, vx, vy);
    if (count > 4)
        least = lower(least, points + 4, count - 4, nx, ny, vx, vy);
    least = _mm_min_ps(least, _mm_movehl_ps(least, least));
    least = _mm_min_ss(least, _mm_shuffle_ps(least, least, 1));
    return _mm_cvtss_f32(least);
}

float bmr_exact32_max_separation(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                 const bmr_transform32 *frame, int32_t *edge) {
    const max_edge found = find_max_edge(reference, other, _mm_loadu_ps(&frame->p.x));
    *edge = found.edge;
    return found.separation;
}

#else

float bmr_exact32_edge_separation(const bmr_polygon32 *reference, int32_t edge, const bmr_polygon32 *other,
                                  const bmr_transform32 *frame) {
    return bmr_exact32_edge_separation_scalar(reference, edge, other, frame);
}

float bmr_exact32_posed_separation(const bmr_vec32 *vertex, const bmr_vec32 *normal,
                                   const bmr_transform32 *reference, const bmr_vec32 *points, int32_t count,
                                   const bmr_transform32 *other) {
    const bmr_polygon32 edge = {vertex, normal, 1}, rest = {points, points, count};
    const bmr_transform32 frame = bmr_exact32_relative(other, reference);
    return bmr_exact32_edge_separation_scalar(&edge, 0, &rest, &frame);
}

float bmr_exact32_max_separation(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                 const bmr_transform32 *frame, int32_t *edge) {
    return bmr_exact32_max_separation_scalar(reference, other, frame, edge);
}

#endif

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
