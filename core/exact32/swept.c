// SPDX-License-Identifier: MIT
#include "exact32/swept32.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

#if defined(__SSE2__)
#    include <emmintrin.h>
#endif

// A search that has not found its direction after so many steps is left: the hulls have at most 8 vertices
// each, and nearly all searches end after three.
enum { MOST_STEPS = 8 };

// A step that gains less than this part of the distance has arrived.
static const float least_gain = 1e-3f;

// The series of sine and cosine in turn_back are good to the last bit of a float up to this angle.
static const float most_turn = 0.25f;

static float dot(bmr_vec32 a, bmr_vec32 b) {
    return a.x * b.x + a.y * b.y;
}

static bmr_vec32 minus(bmr_vec32 a, bmr_vec32 b) {
    const bmr_vec32 r = {a.x - b.x, a.y - b.y};
    return r;
}

#if defined(__SSE2__)

static __m128 rotate_left(__m128 low, __m128 high) { // low[1], low[2], low[3], high[0]
    const __m128 t = _mm_move_ss(low, high);
    return _mm_shuffle_ps(t, t, _MM_SHUFFLE(0, 3, 2, 1));
}

static __m128 blend(__m128 mask, __m128 inside, __m128 outside) {
    return _mm_or_ps(_mm_and_ps(mask, inside), _mm_andnot_ps(mask, outside));
}

static __m128 length2(__m128 x, __m128 y) {
    return _mm_add_ps(_mm_mul_ps(x, x), _mm_mul_ps(y, y));
}

static float least_of(__m128 v) {
    v = _mm_min_ps(v, _mm_movehl_ps(v, v));
    return _mm_cvtss_f32(_mm_min_ss(v, _mm_shuffle_ps(v, v, 1)));
}

static float most_of(__m128 v) {
    v = _mm_max_ps(v, _mm_movehl_ps(v, v));
    return _mm_cvtss_f32(_mm_max_ss(v, _mm_shuffle_ps(v, v, 1)));
}

static float root(float v) {
    return _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(v)));
}

/// The points, x and y apart; the lanes of `inside` hold one each, the others repeat the first.
typedef struct lanes8 {
    __m128 x[2], y[2], inside[2];
} lanes8;

static lanes8 load(const bmr_vec32 *points, int32_t count) {
    lanes8 l;
    const __m128i n = _mm_set1_epi32(count);
    l.inside[0] = _mm_castsi128_ps(_mm_cmpgt_epi32(n, _mm_set_epi32(3, 2, 1, 0)));
    l.inside[1] = _mm_castsi128_ps(_mm_cmpgt_epi32(n, _mm_set_epi32(7, 6, 5, 4)));
    const __m128 x0 = _mm_set1_ps(points[0].x), y0 = _mm_set1_ps(points[0].y);
    if (count < 3) { // not in an array of 8
        const bmr_vec32 *second = points + (count - 1);
        l.x[0] = _mm_movelh_ps(_mm_unpacklo_ps(x0, _mm_set1_ps(second->x)), x0);
        l.y[0] = _mm_movelh_ps(_mm_unpacklo_ps(y0, _mm_set1_ps(second->y)), y0);
        l.x[1] = x0;
        l.y[1] = y0;
        return l;
    }
    for (int g = 0; g < 2; ++g) {
        const __m128 p = _mm_loadu_ps(&points[4 * g].x), q = _mm_loadu_ps(&points[4 * g + 2].x);
        l.x[g] = blend(l.inside[g], _mm_shuffle_ps(p, q, _MM_SHUFFLE(2, 0, 2, 0)), x0);
        l.y[g] = blend(l.inside[g], _mm_shuffle_ps(p, q, _MM_SHUFFLE(3, 1, 3, 1)), y0);
    }
    return l;
}

/// radius, width and edge of the placed points.
static void measure(bmr_swept32 *shape, const lanes8 *l, int32_t count) {
    const __m128 r0 = length2(l->x[0], l->y[0]), r1 = length2(l->x[1], l->y[1]);
    // A NaN would slip through the maxima below.
    const int broken = _mm_movemask_ps(_mm_cmpunord_ps(r0, r1));
    shape->radius = broken ? INFINITY : root(most_of(_mm_max_ps(r0, r1)));
    if (count < 2) {
        shape->width = 0.0f;
        shape->edge = FLT_MAX;
        return;
    }
    const float dx = most_of(_mm_max_ps(l->x[0], l->x[1])) - least_of(_mm_min_ps(l->x[0], l->x[1]));
    const float dy = most_of(_mm_max_ps(l->y[0], l->y[1])) - least_of(_mm_min_ps(l->y[0], l->y[1]));
    shape->width = root(dx * dx + dy * dy);
    // The side after the last point ends in a lane that repeats the first.
    const __m128 e0 = length2(_mm_sub_ps(rotate_left(l->x[0], l->x[1]), l->x[0]),
                              _mm_sub_ps(rotate_left(l->y[0], l->y[1]), l->y[0]));
    const __m128 e1 = length2(_mm_sub_ps(rotate_left(l->x[1], l->x[0]), l->x[1]),
                              _mm_sub_ps(rotate_left(l->y[1], l->y[0]), l->y[1]));
    const __m128 far_away = _mm_set1_ps(FLT_MAX);
    shape->edge =
        root(least_of(_mm_min_ps(blend(l->inside[0], e0, far_away), blend(l->inside[1], e1, far_away))));
}

static void place(bmr_swept32 *shape, const bmr_vec32 *points, int32_t count, const bmr_motion32 *motion) {
    lanes8 l = load(points, count);
    const __m128 s = _mm_set1_ps(motion->s), c = _mm_set1_ps(motion->c);
    const __m128 cx = _mm_set1_ps(motion->center.x), cy = _mm_set1_ps(motion->center.y);
    for (int g = 0; g < 2; ++g) {
        const __m128 x = _mm_sub_ps(l.x[g], cx), y = _mm_sub_ps(l.y[g], cy);
        l.x[g] = _mm_sub_ps(_mm_mul_ps(c, x), _mm_mul_ps(s, y));
        l.y[g] = _mm_add_ps(_mm_mul_ps(s, x), _mm_mul_ps(c, y));
        _mm_storeu_ps(shape->x + 4 * g, l.x[g]);
        _mm_storeu_ps(shape->y + 4 * g, l.y[g]);
    }
    measure(shape, &l, count);
}

typedef struct along8 {
    __m128 v[2];
} along8;

static along8 along(const float *x, const float *y, bmr_vec32 n) {
    const __m128 nx = _mm_set1_ps(n.x), ny = _mm_set1_ps(n.y);
    along8 r;
    for (int g = 0; g < 2; ++g)
        r.v[g] = _mm_add_ps(_mm_mul_ps(nx, _mm_loadu_ps(x + 4 * g)), _mm_mul_ps(ny, _mm_loadu_ps(y + 4 * g)));
    return r;
}

/// Least of b's points along n less the most of a's.
static inline float gap(const bmr_swept32 *a, const bmr_swept32 *b, bmr_vec32 n) {
    const along8 pa = along(a->x, a->y, n), pb = along(b->x, b->y, n);
    const __m128 most = _mm_max_ps(pa.v[0], pa.v[1]), least = _mm_min_ps(pb.v[0], pb.v[1]);
    const __m128 minus_most = _mm_sub_ps(_mm_setzero_ps(), most);
    __m128 both = _mm_min_ps(_mm_unpacklo_ps(least, minus_most), _mm_unpackhi_ps(least, minus_most));
    both = _mm_min_ps(both, _mm_movehl_ps(both, both));
    return _mm_cvtss_f32(_mm_add_ss(both, _mm_shuffle_ps(both, both, 1)));
}

static int first_lane(int mask) {
    return __builtin_ctz((unsigned)mask | 0x80u);
}

/// Which point of the shape is farthest along n.
static bmr_vec32 farthest(const bmr_swept32 *shape, bmr_vec32 n) {
    const along8 p = along(shape->x, shape->y, n);
    const __m128 most = _mm_set1_ps(most_of(_mm_max_ps(p.v[0], p.v[1])));
    const int i = first_lane(_mm_movemask_ps(_mm_cmpeq_ps(p.v[0], most)) |
                             _mm_movemask_ps(_mm_cmpeq_ps(p.v[1], most)) << 4);
    const bmr_vec32 r = {shape->x[i], shape->y[i]};
    return r;
}

#else

static float root(float v) {
    return sqrtf(v);
}

static void measure(bmr_swept32 *shape, int32_t count) {
    float radius2 = 0.0f, edge2 = FLT_MAX, low_x = FLT_MAX, low_y = FLT_MAX, high_x = -FLT_MAX,
          high_y = -FLT_MAX;
    bool broken = false;
    for (int32_t i = 0; i < count; ++i) {
        const float x = shape->x[i], y = shape->y[i], r2 = x * x + y * y;
        const int32_t j = i + 1 < count ? i + 1 : 0;
        const float ex = shape->x[j] - x, ey = shape->y[j] - y;
        broken = broken || !(r2 <= FLT_MAX);
        radius2 = fmaxf(radius2, r2);
        edge2 = count > 1 ? fminf(edge2, ex * ex + ey * ey) : edge2;
        low_x = fminf(low_x, x);
        low_y = fminf(low_y, y);
        high_x = fmaxf(high_x, x);
        high_y = fmaxf(high_y, y);
    }
    const float dx = high_x - low_x, dy = high_y - low_y;
    shape->radius = broken ? INFINITY : root(radius2);
    shape->width = root(dx * dx + dy * dy);
    shape->edge = count > 1 ? root(edge2) : FLT_MAX;
}

static void place(bmr_swept32 *shape, const bmr_vec32 *points, int32_t count, const bmr_motion32 *motion) {
    for (int32_t i = 0; i < BMR_SWEPT32_MOST; ++i) {
        const bmr_vec32 p = minus(points[i < count ? i : 0], motion->center);
        shape->x[i] = motion->c * p.x - motion->s * p.y;
        shape->y[i] = motion->s * p.x + motion->c * p.y;
    }
    measure(shape, count);
}

static int farthest_lane(const bmr_swept32 *shape, bmr_vec32 n) {
    int best = 0;
    float most = n.x * shape->x[0] + n.y * shape->y[0];
    for (int i = 1; i < BMR_SWEPT32_MOST; ++i) {
        const float p = n.x * shape->x[i] + n.y * shape->y[i];
        if (p > most) {
            best = i;
            most = p;
        }
    }
    return best;
}

static bmr_vec32 farthest(const bmr_swept32 *shape, bmr_vec32 n) {
    const int i = farthest_lane(shape, n);
    const bmr_vec32 r = {shape->x[i], shape->y[i]};
    return r;
}

static float gap(const bmr_swept32 *a, const bmr_swept32 *b, bmr_vec32 n) {
    const bmr_vec32 back = {-n.x, -n.y};
    return dot(n, farthest(b, back)) - dot(n, farthest(a, n));
}

#endif

void bmr_swept32_make(bmr_swept32 *shape, const bmr_vec32 *points, int32_t count,
                      const bmr_motion32 *motion) {
    shape->end = motion->end;
    shape->back = minus(motion->start, motion->end);
    shape->turn = motion->turn;
    place(shape, points, count, motion);
}

/// What is the same for all directions.
typedef struct question {
    const bmr_swept32 *a, *b;
    bmr_vec32 between; ///< from a's centre to b's, at the end
    bmr_vec32 back;    ///< how much more that is at the start
    float apart, near; ///< asked for
    float swing;       ///< how far turning may bring points closer, at most
} question;

/// How much the motion of the centres alone brings b closer to a than at the end; not above zero. (A NaN
/// stays one.)
static float slide(const question *q, bmr_vec32 n) {
    const float s = dot(n, q->back);
    return s > 0.0f ? 0.0f : s;
}

/// The points at the start of the motion, by turning them back from the end.
static void turn_back(const bmr_swept32 *shape, bmr_swept32 *start) {
    const float t = shape->turn, t2 = t * t;
    const float s = -t * (1.0f - t2 * (1.0f / 6.0f) * (1.0f - t2 * (1.0f / 20.0f)));
    const float c = 1.0f - t2 * 0.5f * (1.0f - t2 * (1.0f / 12.0f) * (1.0f - t2 * (1.0f / 30.0f)));
    for (int i = 0; i < BMR_SWEPT32_MOST; ++i) {
        start->x[i] = c * shape->x[i] - s * shape->y[i];
        start->y[i] = s * shape->x[i] + c * shape->y[i];
    }
}

/// Between two poses that are both looked at, a turning point comes closer than at both by no more than the
/// height of its arc, radius times turn squared over eight: far less than by the turn itself.
static bool apart_at_both_ends(const question *q, bmr_vec32 n, float at_end) {
    const float ta = q->a->turn, tb = q->b->turn;
    if (!(fabsf(ta) <= most_turn) || !(fabsf(tb) <= most_turn))
        return false;
    const float needed = q->apart + 0.125f * (q->a->radius * ta * ta + q->b->radius * tb * tb);
    if (!(at_end > needed))
        return false;
    bmr_swept32 a, b;
    turn_back(q->a, &a);
    turn_back(q->b, &b);
    return dot(n, q->between) + dot(n, q->back) + gap(&a, &b, n) > needed;
}

/// Does the direction keep them apart during all of the motion? `found`: by how much it does if nothing
/// turns.
static inline bool keeps_apart(const question *q, bmr_vec32 n, float *found) {
    const float at_end = dot(n, q->between) + gap(q->a, q->b, n);
    *found = at_end + slide(q, n);
    return *found - q->swing > q->apart || (q->swing > 0.0f && apart_at_both_ends(q, n, at_end));
}

/// The point of the segment from p to q that is closest to the origin.
static bmr_vec32 closest_on_segment(bmr_vec32 p, bmr_vec32 q) {
    const bmr_vec32 e = minus(q, p);
    const float along_e = -dot(p, e), length2_e = dot(e, e);
    if (!(along_e > 0.0f))
        return p;
    if (along_e >= length2_e)
        return q;
    const float t = along_e / length2_e;
    const bmr_vec32 r = {p.x + t * e.x, p.y + t * e.y};
    return r;
}

/// The vertex of the difference b - a, swept along the motion of the centres, that is least along n.
static bmr_vec32 support(const question *q, bmr_vec32 n) {
    const bmr_vec32 back = {-n.x, -n.y};
    const bmr_vec32 pa = farthest(q->a, n), pb = farthest(q->b, back);
    const bool at_start = dot(n, q->back) < 0.0f;
    const bmr_vec32 w = {q->between.x + (at_start ? q->back.x : 0.0f) + pb.x - pa.x,
                         q->between.y + (at_start ? q->back.y : 0.0f) + pb.y - pa.y};
    return w;
}

/// The search: the distance of the origin from the swept difference, left as soon as a direction does or
/// cannot do.
static bmr_swept32_answer search(const question *q, bmr_vec32 n, bmr_vec32 *direction) {
    if (!(q->swing <= FLT_MAX)) // a radius is infinite; the supports below would pass a NaN over
        return BMR_SWEPT32_UNKNOWN;
    bmr_vec32 kept = support(q, n), other = kept, closest = kept;
    bool segment = false;
    for (int step = 0; step < MOST_STEPS; ++step) {
        const float length = root(dot(closest, closest));
        if (length <= q->near) // and no direction does better than the closest points known
            return BMR_SWEPT32_NEAR;
        n.x = closest.x / length;
        n.y = closest.y / length;
        float found;
        if (keeps_apart(q, n, &found)) {
            *direction = n;
            return BMR_SWEPT32_APART;
        }
        if (!(found < length * (1.0f - least_gain)))
            return BMR_SWEPT32_UNKNOWN;
        const bmr_vec32 w = support(q, n);
        const bmr_vec32 first = closest_on_segment(kept, w);
        const bmr_vec32 second = segment ? closest_on_segment(other, w) : first;
        if (dot(second, second) < dot(first, first)) {
            kept = other;
            closest = second;
        } else {
            closest = first;
        }
        other = w;
        segment = true;
    }
    return BMR_SWEPT32_UNKNOWN;
}

/// From somewhere within a to somewhere within b, at the end: the centres of motion may be far outside.
static bmr_vec32 between_middles(const question *q) {
    bmr_vec32 r = q->between;
    for (int i = 0; i < 4; ++i) {
        r.x += 0.25f * (q->b->x[i] - q->a->x[i]);
        r.y += 0.25f * (q->b->y[i] - q->a->y[i]);
    }
    return r;
}

static question ask(const bmr_swept32 *a, const bmr_swept32 *b, float apart, float near) {
    question q;
    q.a = a;
    q.b = b;
    q.between = minus(b->end, a->end);
    q.back = minus(b->back, a->back);
    q.apart = apart;
    q.near = near;
    q.swing = a->radius * fabsf(a->turn) + b->radius * fabsf(b->turn);
    return q;
}

bool bmr_swept32_apart_along(const bmr_swept32 *a, const bmr_swept32 *b, float apart, bmr_vec32 direction) {
    const question q = ask(a, b, apart, 0.0f);
    float found;
    return keeps_apart(&q, direction, &found);
}

bmr_swept32_answer bmr_swept32_compare(const bmr_swept32 *a, const bmr_swept32 *b, float apart, float near,
                                       bmr_vec32 *direction) {
    const question q = ask(a, b, apart, near);
    const bmr_vec32 hint = *direction;
    if (!(dot(hint, hint) > 0.0f))
        return search(&q, between_middles(&q), direction);
    float found;
    return keeps_apart(&q, hint, &found) ? BMR_SWEPT32_APART : search(&q, hint, direction);
}
