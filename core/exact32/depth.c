// SPDX-License-Identifier: MIT
#include "exact32/swept32.h"

#include <float.h>
#include <math.h>

#include "float4.h"

static float larger(float a, float b) {
    return a > b ? a : b;
}

static bmr_vec32 into_frame(const bmr_transform32 *at, bmr_vec32 p) {
    const float x = p.x - at->p.x, y = p.y - at->p.y;
    const bmr_vec32 r = {at->c * x + at->s * y, at->c * y - at->s * x};
    return r;
}

/// How far outside four sides' lines the point is, two that begin at `first` and two at `third`; raises `far`
/// to their vertices' coordinates.
static float4 four_outside(const bmr_polygon32 *polygon, int32_t first, int32_t third, bmr_vec32 p,
                           float4 *far) {
    const bmr_vec32 *v = polygon->vertices, *end = third + 2 < polygon->count ? v + third + 2 : v;
    const float4 v0 = load4(&v[first].x), v1 = load4(&v[third].x);
    const float4 e0 = sub4(load4(&v[first + 1].x), v0);
    const float4 e1 = sub4(lows4(highs4(v1, v1), load4(&end->x)), v1);
    *far = max4(*far, max4(abs4(v0), abs4(v1)));
    const float4 dx = sub4(all4(p.x), evens4(v0, v1));
    const float4 dy = sub4(all4(p.y), odds4(v0, v1));
    const float4 ex = evens4(e0, e1), ey = odds4(e0, e1);
    const float4 length = sqrt4(add4(mul4(ex, ex), mul4(ey, ey)));
    return div4(sub4(mul4(ey, dx), mul4(ex, dy)), max4(length, all4(FLT_MIN)));
}

float bmr_posed32_depth(const bmr_polygon32 *polygon, const bmr_transform32 *at, bmr_vec32 point,
                        float *reach) {
    const bmr_vec32 p = into_frame(at, point);
    const int32_t last = polygon->count - 2;
    float4 far = zero4();
    // The last four sides are taken together, whether some of them were among the first four or not.
    float4 most = four_outside(polygon, 0, last > 2 ? 2 : last, p, &far);
    mask4 unordered = unordered4(most, most);
    if (last > 2) {
        const float4 rest = four_outside(polygon, last - 2, last, p, &far);
        unordered = unordered4(most, rest);
        most = max4(most, rest);
    }
    *reach = larger(*reach, most_of4(far));
    return any4(unordered) ? NAN : -most_of4(most);
}

float bmr_points32_reach(const bmr_vec32 *points, int32_t count) {
    const bmr_vec32 *last = points + count - 2;
    const float4 p0 = load4(&points[0].x), p1 = load4(&(count > 4 ? points + 2 : last)->x);
    const float4 p2 = load4(&(count > 4 ? last - 2 : last)->x), p3 = load4(&last->x);
    const mask4 broken = either4(unordered4(p0, p1), unordered4(p2, p3));
    const float4 far = max4(max4(abs4(p0), abs4(p1)), max4(abs4(p2), abs4(p3)));
    return any4(broken) ? INFINITY : most_of4(far);
}
