// SPDX-License-Identifier: MIT
#include "boomerang/exact32.h"

#include <float.h>

#if defined(__SSE2__)
#    include <emmintrin.h>
#endif

// The formulas below are written out with the parentheses that fix their rounding; regrouping any of them
// breaks the contract of the header. Box2D's minimum over vertices starts at FLT_MAX and replaces on "less",
// so a NaN never enters it; every form here keeps to that.

static bmr_vec32 turn(const bmr_transform32 *t, bmr_vec32 v) {
    const bmr_vec32 r = {t->c * v.x - t->s * v.y, t->s * v.x + t->c * v.y};
    return r;
}

static bmr_vec32 move(const bmr_transform32 *t, bmr_vec32 v) {
    const bmr_vec32 r = {(t->c * v.x - t->s * v.y) + t->p.x, (t->s * v.x + t->c * v.y) + t->p.y};
    return r;
}

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

/// All bits set in the lanes below `count` of two groups of four.
static const int32_t lane_masks[9][8] = {
    {0, 0, 0, 0, 0, 0, 0, 0},       {-1, 0, 0, 0, 0, 0, 0, 0},       {-1, -1, 0, 0, 0, 0, 0, 0},
    {-1, -1, -1, 0, 0, 0, 0, 0},    {-1, -1, -1, -1, 0, 0, 0, 0},    {-1, -1, -1, -1, -1, 0, 0, 0},
    {-1, -1, -1, -1, -1, -1, 0, 0}, {-1, -1, -1, -1, -1, -1, -1, 0}, {-1, -1, -1, -1, -1, -1, -1, -1},
};

/// Four points, x and y apart. Lanes outside `mask` are zero: what lies past a polygon's count is never
/// computed with.
typedef struct quad {
    __m128 x, y;
} quad;

static quad load_quad(const bmr_vec32 *points, __m128 mask) {
    const __m128 a = _mm_loadu_ps(&points[0].x), b = _mm_loadu_ps(&points[2].x);
    quad q;
    q.x = _mm_and_ps(_mm_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0)), mask);
    q.y = _mm_and_ps(_mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1)), mask);
    return q;
}

static __m128 lanes(int32_t count, int32_t group) {
    return _mm_castsi128_ps(_mm_loadu_si128((const __m128i *)(const void *)&lane_masks[count][4 * group]));
}

static __m128 blend(__m128 mask, __m128 inside, __m128 outside) {
    return _mm_or_ps(_mm_and_ps(mask, inside), _mm_andnot_ps(mask, outside));
}

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
        const __m128 a = _mm_loadu_ps(&points[0].x), b = _mm_loadu_ps(&points[2].x);
        const __m128 x = _mm_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0)),
                     y = _mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1));
        const __m128 s = _mm_add_ps(_mm_mul_ps(nx, _mm_sub_ps(x, vx)), _mm_mul_ps(ny, _mm_sub_ps(y, vy)));
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
    // Each line is two or four of the scalar formulas side by side; a difference is a sum with the sign bit
    // of one product's factor turned, which rounds the same.
    const __m128 second_third = _mm_castsi128_ps(_mm_set_epi32(0, (int)0x80000000u, (int)0x80000000u, 0));
    const __m128 evens = _mm_castsi128_ps(_mm_set_epi32(0, (int)0x80000000u, 0, (int)0x80000000u));
    const __m128 r = _mm_loadu_ps(&reference->p.x), o = _mm_loadu_ps(&other->p.x); // px, py, s, c
    const __m128 os = _mm_shuffle_ps(o, o, _MM_SHUFFLE(2, 2, 2, 2)),
                 oc = _mm_shuffle_ps(o, o, _MM_SHUFFLE(3, 3, 3, 3));
    const __m128 d = _mm_shuffle_ps(_mm_sub_ps(r, o), r, _MM_SHUFFLE(3, 2, 1, 0)); // dx, dy, rs, rc
    const __m128 e =
        _mm_xor_ps(_mm_shuffle_ps(d, d, _MM_SHUFFLE(2, 3, 0, 1)), second_third); // dy, -dx, -rc, rs
    const __m128 f = _mm_add_ps(_mm_mul_ps(oc, d), _mm_mul_ps(os, e));           // the frame: px, py, s, c
    const __m128 s = _mm_shuffle_ps(f, f, _MM_SHUFFLE(2, 2, 2, 2)),
                 c = _mm_shuffle_ps(f, f, _MM_SHUFFLE(3, 3, 3, 3));
    const __m128 zero = _mm_setzero_ps();
    const __m128 a = _mm_loadh_pi(_mm_loadl_pi(zero, (const __m64 *)(const void *)normal),
                                  (const __m64 *)(const void *)vertex);
    const __m128 b = _mm_xor_ps(_mm_shuffle_ps(a, a, _MM_SHUFFLE(2, 3, 0, 1)), evens); // -ny, nx, -vy, vx
    const __m128 n = _mm_add_ps(_mm_mul_ps(c, a), _mm_mul_ps(s, b)); // nx, ny, and v before it is moved
    const __m128 v = _mm_add_ps(n, _mm_movelh_ps(f, f));             // (unused), vx, vy
    const __m128 nx = _mm_shuffle_ps(n, n, _MM_SHUFFLE(0, 0, 0, 0)),
                 ny = _mm_shuffle_ps(n, n, _MM_SHUFFLE(1, 1, 1, 1));
    const __m128 vx = _mm_shuffle_ps(v, v, _MM_SHUFFLE(2, 2, 2, 2)),
                 vy = _mm_shuffle_ps(v, v, _MM_SHUFFLE(3, 3, 3, 3));
    __m128 least = lower(_mm_set1_ps(FLT_MAX), points, count, nx, ny, vx, vy);
    if (count > 4)
        least = lower(least, points + 4, count - 4, nx, ny, vx, vy);
    least = _mm_min_ps(least, _mm_movehl_ps(least, least));
    least = _mm_min_ss(least, _mm_shuffle_ps(least, least, 1));
    return _mm_cvtss_f32(least);
}

/// Separations of four edges of `reference` at once, lanes over edges.
static __m128 four_edges(const bmr_polygon32 *reference, int32_t group, const bmr_polygon32 *other,
                         const bmr_transform32 *frame) {
    const __m128 mask = lanes(reference->count, group);
    const quad m = load_quad(reference->normals + 4 * group, mask);
    const quad w = load_quad(reference->vertices + 4 * group, mask);
    const __m128 c = _mm_set1_ps(frame->c), s = _mm_set1_ps(frame->s);
    const __m128 nx = _mm_sub_ps(_mm_mul_ps(c, m.x), _mm_mul_ps(s, m.y));
    const __m128 ny = _mm_add_ps(_mm_mul_ps(s, m.x), _mm_mul_ps(c, m.y));
    const __m128 vx = _mm_add_ps(_mm_sub_ps(_mm_mul_ps(c, w.x), _mm_mul_ps(s, w.y)), _mm_set1_ps(frame->p.x));
    const __m128 vy = _mm_add_ps(_mm_add_ps(_mm_mul_ps(s, w.x), _mm_mul_ps(c, w.y)), _mm_set1_ps(frame->p.y));
    __m128 least = _mm_set1_ps(FLT_MAX);
    for (int32_t j = 0; j < other->count; ++j) {
        const __m128 dx = _mm_sub_ps(_mm_set1_ps(other->vertices[j].x), vx);
        const __m128 dy = _mm_sub_ps(_mm_set1_ps(other->vertices[j].y), vy);
        least = _mm_min_ps(_mm_add_ps(_mm_mul_ps(nx, dx), _mm_mul_ps(ny, dy)), least);
    }
    return blend(mask, least, _mm_set1_ps(-FLT_MAX));
}

float bmr_exact32_max_separation(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                 const bmr_transform32 *frame, int32_t *edge) {
    float best = -FLT_MAX;
    *edge = 0;
    for (int32_t group = 0; 4 * group < reference->count; ++group) {
        const __m128 s = four_edges(reference, group, other, frame);
        __m128 most = _mm_max_ps(s, _mm_movehl_ps(s, s));
        most = _mm_max_ss(most, _mm_shuffle_ps(most, most, 1));
        const float value = _mm_cvtss_f32(most);
        if (value > best) {
            const int hits = _mm_movemask_ps(_mm_cmpeq_ps(s, _mm_set1_ps(value)));
            best = value;
            *edge = 4 * group +
                    __builtin_ctz((unsigned)hits); // the first edge of equals, as a plain loop finds it
        }
    }
    return best;
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
