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

/// The most of the points along n, a direction in their frame; raises `reach` to their largest coordinate.
static float most_of_few(const bmr_vec32 *points, int32_t count, bmr_vec32 n, float *reach) {
    float most = -FLT_MAX, sum = 0.0f;
    for (int32_t i = 0; i < count; ++i) {
        const bmr_vec32 p = points[i];
        most = larger(most, n.x * p.x + n.y * p.y);
        *reach = larger(*reach, larger(fabsf(p.x), fabsf(p.y)));
        sum += p.x + p.y;
    }
    if (!(fabsf(sum) <= FLT_MAX))
        *reach = INFINITY;
    return most;
}

#if defined(__SSE2__)

/// Four points along n.
static __m128 four_along(const bmr_vec32 *first, const bmr_vec32 *third, __m128 nx, __m128 ny, __m128 *far) {
    const __m128 p = _mm_loadu_ps(&first->x), q = _mm_loadu_ps(&third->x);
    const __m128 magnitude = _mm_castsi128_ps(_mm_set1_epi32(0x7fffffff));
    *far = _mm_max_ps(*far, _mm_max_ps(_mm_and_ps(p, magnitude), _mm_and_ps(q, magnitude)));
    return _mm_add_ps(_mm_mul_ps(nx, _mm_shuffle_ps(p, q, _MM_SHUFFLE(2, 0, 2, 0))),
                      _mm_mul_ps(ny, _mm_shuffle_ps(p, q, _MM_SHUFFLE(3, 1, 3, 1))));
}

/// Three points or more. The last four are taken together, whether some of them were among the first four or
/// not.
static float most_of_many(const bmr_vec32 *points, int32_t count, bmr_vec32 n, float *reach) {
    const __m128 nx = _mm_set1_ps(n.x), ny = _mm_set1_ps(n.y);
    const bmr_vec32 *last = points + count - 2;
    __m128 far = _mm_setzero_ps();
    __m128 most = four_along(points, count > 4 ? points + 2 : last, nx, ny, &far);
    __m128 unordered = _mm_cmpunord_ps(most, most);
    if (count > 4) {
        const __m128 rest = four_along(last - 2, last, nx, ny, &far);
        unordered = _mm_cmpunord_ps(most, rest);
        most = _mm_max_ps(most, rest);
    }
    most = _mm_max_ps(most, _mm_movehl_ps(most, most));
    most = _mm_max_ss(most, _mm_shuffle_ps(most, most, 1));
    far = _mm_max_ps(far, _mm_movehl_ps(far, far));
    far = _mm_max_ss(far, _mm_shuffle_ps(far, far, 1));
    *reach = _mm_movemask_ps(unordered) != 0 ? INFINITY : larger(*reach, _mm_cvtss_f32(far));
    return _mm_cvtss_f32(most);
}

#else

static float most_of_many(const bmr_vec32 *points, int32_t count, bmr_vec32 n, float *reach) {
    return most_of_few(points, count, n, reach);
}

#endif

static float most_along(const bmr_vec32 *points, int32_t count, const bmr_transform32 *at, bmr_vec32 n,
                        float *reach) {
    const bmr_vec32 local = {at->c * n.x + at->s * n.y, at->c * n.y - at->s * n.x};
    return count < 3 ? most_of_few(points, count, local, reach) : most_of_many(points, count, local, reach);
}

float bmr_posed32_gap(const bmr_vec32 *a, int32_t count_a, const bmr_transform32 *at_a, const bmr_vec32 *b,
                      int32_t count_b, const bmr_transform32 *at_b, bmr_vec32 direction, float *reach) {
    const bmr_vec32 back = {-direction.x, -direction.y};
    *reach = 0.0f;
    const float between = direction.x * (at_b->p.x - at_a->p.x) + direction.y * (at_b->p.y - at_a->p.y);
    return between - most_along(a, count_a, at_a, direction, reach) -
           most_along(b, count_b, at_b, back, reach);
}
