// SPDX-License-Identifier: MIT
#include "exact32/swept32.h"

#include <float.h>
#include <math.h>

#if defined(__SSE2__)
#    include <emmintrin.h>
#endif

static float larger(float a, float b) {
    return a > b ? a : b;
}

static bmr_vec32 into_frame(const bmr_transform32 *at, bmr_vec32 p) {
    const float x = p.x - at->p.x, y = p.y - at->p.y;
    const bmr_vec32 r = {at->c * x + at->s * y, at->c * y - at->s * x};
    return r;
}

#if defined(__SSE2__)

/// How far outside four sides' lines the point is, two that begin at `first` and two at `third`; raises `far`
/// to their vertices' coordinates.
static __m128 four_outside(const bmr_polygon32 *polygon, int32_t first, int32_t third, bmr_vec32 p,
                           __m128 *far) {
    const __m128 magnitude = _mm_castsi128_ps(_mm_set1_epi32(0x7fffffff));
    const bmr_vec32 *v = polygon->vertices, *end = third + 2 < polygon->count ? v + third + 2 : v;
    const __m128 v0 = _mm_loadu_ps(&v[first].x), v1 = _mm_loadu_ps(&v[third].x);
    const __m128 e0 = _mm_sub_ps(_mm_loadu_ps(&v[first + 1].x), v0);
    const __m128 e1 = _mm_sub_ps(_mm_movelh_ps(_mm_movehl_ps(v1, v1), _mm_loadu_ps(&end->x)), v1);
    *far = _mm_max_ps(*far, _mm_max_ps(_mm_and_ps(v0, magnitude), _mm_and_ps(v1, magnitude)));
    const __m128 dx = _mm_sub_ps(_mm_set1_ps(p.x), _mm_shuffle_ps(v0, v1, _MM_SHUFFLE(2, 0, 2, 0)));
    const __m128 dy = _mm_sub_ps(_mm_set1_ps(p.y), _mm_shuffle_ps(v0, v1, _MM_SHUFFLE(3, 1, 3, 1)));
    const __m128 ex = _mm_shuffle_ps(e0, e1, _MM_SHUFFLE(2, 0, 2, 0)),
                 ey = _mm_shuffle_ps(e0, e1, _MM_SHUFFLE(3, 1, 3, 1));
    const __m128 length = _mm_sqrt_ps(_mm_add_ps(_mm_mul_ps(ex, ex), _mm_mul_ps(ey, ey)));
    return _mm_div_ps(_mm_sub_ps(_mm_mul_ps(ey, dx), _mm_mul_ps(ex, dy)),
                      _mm_max_ps(length, _mm_set1_ps(FLT_MIN)));
}

float bmr_posed32_depth(const bmr_polygon32 *polygon, const bmr_transform32 *at, bmr_vec32 point,
                        float *reach) {
    const bmr_vec32 p = into_frame(at, point);
    const int32_t last = polygon->count - 2;
    __m128 far = _mm_setzero_ps();
    // The last four sides are taken together, whether some of them were among the first four or not.
    __m128 most = four_outside(polygon, 0, last > 2 ? 2 : last, p, &far);
    __m128 unordered = _mm_cmpunord_ps(most, most);
    if (last > 2) {
        const __m128 rest = four_outside(polygon, last - 2, last, p, &far);
        unordered = _mm_cmpunord_ps(most, rest);
        most = _mm_max_ps(most, rest);
    }
    most = _mm_max_ps(most, _mm_movehl_ps(most, most));
    most = _mm_max_ss(most, _mm_shuffle_ps(most, most, 1));
    far = _mm_max_ps(far, _mm_movehl_ps(far, far));
    far = _mm_max_ss(far, _mm_shuffle_ps(far, far, 1));
    *reach = larger(*reach, _mm_cvtss_f32(far));
    return _mm_movemask_ps(unordered) != 0 ? NAN : -_mm_cvtss_f32(most);
}

float bmr_points32_reach(const bmr_vec32 *points, int32_t count) {
    const __m128 magnitude = _mm_castsi128_ps(_mm_set1_epi32(0x7fffffff));
    const bmr_vec32 *last = points + count - 2;
    const __m128 p0 = _mm_loadu_ps(&points[0].x), p1 = _mm_loadu_ps(&(count > 4 ? points + 2 : last)->x);
    const __m128 p2 = _mm_loadu_ps(&(count > 4 ? last - 2 : last)->x), p3 = _mm_loadu_ps(&last->x);
    const __m128 broken = _mm_or_ps(_mm_cmpunord_ps(p0, p1), _mm_cmpunord_ps(p2, p3));
    __m128 far = _mm_max_ps(_mm_max_ps(_mm_and_ps(p0, magnitude), _mm_and_ps(p1, magnitude)),
                            _mm_max_ps(_mm_and_ps(p2, magnitude), _mm_and_ps(p3, magnitude)));
    far = _mm_max_ps(far, _mm_movehl_ps(far, far));
    far = _mm_max_ss(far, _mm_shuffle_ps(far, far, 1));
    return _mm_movemask_ps(broken) != 0 ? INFINITY : _mm_cvtss_f32(far);
}

#else

float bmr_posed32_depth(const bmr_polygon32 *polygon, const bmr_transform32 *at, bmr_vec32 point,
                        float *reach) {
    const bmr_vec32 p = into_frame(at, point);
    float most = -FLT_MAX;
    bool broken = false;
    for (int32_t i = 0; i < polygon->count; ++i) {
        const bmr_vec32 v = polygon->vertices[i], w = polygon->vertices[i + 1 < polygon->count ? i + 1 : 0];
        const float ex = w.x - v.x, ey = w.y - v.y;
        const float o = (ey * (p.x - v.x) - ex * (p.y - v.y)) / larger(sqrtf(ex * ex + ey * ey), FLT_MIN);
        most = larger(most, o);
        broken = broken || !(o == o);
        *reach = larger(*reach, larger(fabsf(v.x), fabsf(v.y)));
    }
    return broken ? NAN : -most;
}

float bmr_points32_reach(const bmr_vec32 *points, int32_t count) {
    float far = 0.0f;
    for (int32_t i = 0; i < count; ++i) {
        const float x = fabsf(points[i].x), y = fabsf(points[i].y);
        if (!(x <= FLT_MAX && y <= FLT_MAX))
            return INFINITY;
        far = larger(far, larger(x, y));
    }
    return far;
}

#endif
