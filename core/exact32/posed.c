// SPDX-License-Identifier: MIT
#include "exact32/clip.h"
#include "exact32/swept32.h"

static float larger(float a, float b) {
    return a > b ? a : b;
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
    const bmr_vec32 p = move_back(at, point);
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
    const bmr_vec32 local = turn_back(at, n);
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
