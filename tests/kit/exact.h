// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_EXACT_H
#define BMR_TEST_EXACT_H

#include <algorithm>
#include <cmath>
#include <vector>

#include <gmpxx.h>

#include "boomerang/vector.h"

/// @file
/// Rational arithmetic, and a filter before it: what is true of points given as doubles. Nothing of core's.

#if defined(__GLIBC__)
extern "C" {
void *__libc_malloc(size_t size);
void *__libc_realloc(void *memory, size_t size);
void __libc_free(void *memory);
}
#endif

namespace exact {

#if defined(__GLIBC__)
/// Fractions have their memory from the C library itself: a sanitizer that is asked for each takes longer
/// than the arithmetic. Include gmpxx.h through this file alone: a fraction that another file
/// makes earlier would be freed by the wrong allocator.
inline const bool kAllocatorIsSet = [] {
    mp_set_memory_functions(
        __libc_malloc, [](void *memory, size_t, size_t size) { return __libc_realloc(memory, size); },
        [](void *memory, size_t) { __libc_free(memory); });
    return true;
}();
#endif

/// The side of c as seen from a towards b: 1 left, -1 right, 0 on the line. All finite.
inline int Orientation(bmr_vec2 a, bmr_vec2 b, bmr_vec2 c) {
    // Sure where the result is far above what long double may be off by. Small numbers are left to the
    // fractions.
    const long double ux = static_cast<long double>(b.x) - a.x, uy = static_cast<long double>(b.y) - a.y;
    const long double vx = static_cast<long double>(c.x) - a.x, vy = static_cast<long double>(c.y) - a.y;
    const long double left = ux * vy, right = uy * vx, value = left - right;
    const long double size = std::fabs(left) + std::fabs(right);
    if (std::fabs(value) > 1e-17L * size && size > 1e-600L && size < 1e600L)
        return value > 0.0L ? 1 : -1;
    const mpq_class fraction = (mpq_class(b.x) - mpq_class(a.x)) * (mpq_class(c.y) - mpq_class(a.y)) -
                               (mpq_class(b.y) - mpq_class(a.y)) * (mpq_class(c.x) - mpq_class(a.x));
    return sgn(fraction);
}

/// Are these, in this order, strictly convex and counter-clockwise, once around? One point is, two different
/// ones are.
inline bool IsConvex(const std::vector<bmr_vec2> &v) {
    const size_t n = v.size();
    if (n < 3)
        return n == 1 || (n == 2 && (v[0].x != v[1].x || v[0].y != v[1].y));
    size_t rises = 0; // edges that begin to go up after those that go down: one, once around
    const auto up = [](bmr_vec2 p, bmr_vec2 q) { return q.y > p.y || (q.y == p.y && q.x > p.x); };
    for (size_t i = 0; i < n; ++i) {
        const bmr_vec2 a = v[i], b = v[(i + 1) % n], c = v[(i + 2) % n];
        if (Orientation(a, b, c) <= 0)
            return false;
        rises += !up(a, b) && up(b, c) ? 1 : 0;
    }
    return rises == 1;
}

/// The corners of the convex hull, in order.
inline std::vector<bmr_vec2> HullOf(std::vector<bmr_vec2> points) {
    const auto same = [](bmr_vec2 p, bmr_vec2 q) { return p.x == q.x && p.y == q.y; };
    std::sort(points.begin(), points.end(),
              [](bmr_vec2 p, bmr_vec2 q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
    if (points.size() < 3)
        return points;
    std::vector<bmr_vec2> hull;
    for (int side = 0; side < 2; ++side) { // below, then above
        const size_t begin = hull.size();
        for (const bmr_vec2 p : points) {
            while (hull.size() >= begin + 2 && Orientation(hull[hull.size() - 2], hull.back(), p) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

/// Is the point in or on the convex polygon?
inline bool Holds(const std::vector<bmr_vec2> &v, bmr_vec2 p) {
    const size_t n = v.size();
    if (n == 1)
        return v[0].x == p.x && v[0].y == p.y;
    for (size_t i = 0; i < n; ++i)
        if (Orientation(v[i], v[(i + 1) % n], p) < 0)
            return false;
    if (n == 2) { // on the line; between?
        const auto between = [](double x, double a, double b) {
            return (a <= x && x <= b) || (b <= x && x <= a);
        };
        return between(p.x, v[0].x, v[1].x) && between(p.y, v[0].y, v[1].y);
    }
    return true;
}

} // namespace exact

#endif
