// SPDX-License-Identifier: MIT
#include "exact32/swept32.h"

#include <float.h>
#include <math.h>

#include "float4.h"

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

/// Four points along n.
static float4 four_along(const bmr_vec32 *first, const bmr_vec32 *third, float4 nx, float4 ny, float4 *far) {
    const float4 p = load4(&first->x), q = load4(&third->x);
    *far = max4(*far, max4(abs4(p), abs4(q)));
    return add4(mul4(nx, evens4(p, q)), mul4(ny, odds4(p, q)));
}

/// Three points or more. The last four are taken together, whether some of them were among the first four or
/// not.
static float most_of_many(const bmr_vec32 *points, int32_t count, bmr_vec32 n, float *reach) {
    const float4 nx = all4(n.x), ny = all4(n.y);
    const bmr_vec32 *last = points + count - 2;
    float4 far = zero4();
    float4 most = four_along(points, count > 4 ? points + 2 : last, nx, ny, &far);
    mask4 unordered = unordered4(most, most);
    if (count > 4) {
        const float4 rest = four_along(last - 2, last, nx, ny, &far);
        unordered = unordered4(most, rest);
        most = max4(most, rest);
    }
    *reach = any4(unordered) ? INFINITY : larger(*reach, most_of4(far));
    return most_of4(most);
}

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
