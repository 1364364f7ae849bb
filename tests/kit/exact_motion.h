// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_EXACT_MOTION_H
#define BOOMERANG_TEST_EXACT_MOTION_H

#include "boomerang/pose.h"
#include "exact.h"

/// @file
/// Points of moving bodies in rational arithmetic: where a pose's matrix puts them as it stands, and how far
/// apart they are. Nothing of core's but its types. Every number given is finite.

namespace exact {

struct Place {
    mpq_class x, y;
};
using Places = std::vector<Place>;

inline Place PlaceOf(bmr_vec2 p) {
    return {mpq_class(p.x), mpq_class(p.y)};
}
inline Place Way(const Place &from, const Place &to) {
    return {to.x - from.x, to.y - from.y};
}
inline mpq_class Product(const Place &a, const Place &b) {
    return a.x * b.x + a.y * b.y;
}
inline mpq_class Square(const mpq_class &x) {
    return x * x;
}
inline mpq_class Square(const Place &a) {
    return Product(a, a);
}
/// The vector, turned and scaled by the matrix of (c, s).
inline Place Turned(const mpq_class &c, const mpq_class &s, const Place &p) {
    return {c * p.x - s * p.y, s * p.x + c * p.y};
}
/// A point of the pose's frame, in the world.
inline Place At(const bmr_pose &pose, bmr_vec2 point) {
    const Place turned = Turned(mpq_class(pose.c), mpq_class(pose.s), PlaceOf(point));
    return {turned.x + mpq_class(pose.position.x), turned.y + mpq_class(pose.position.y)};
}
inline Places At(const bmr_pose &pose, const std::vector<bmr_vec2> &points) {
    Places places;
    for (const bmr_vec2 &point : points)
        places.push_back(At(pose, point));
    return places;
}

/// Is the square that of a length of at most `bound`?
inline bool IsAtMost(const mpq_class &square, const mpq_class &bound) {
    return bound >= 0 && square <= bound * bound;
}
inline bool IsMoreThan(const mpq_class &square, const mpq_class &bound) {
    return !IsAtMost(square, bound);
}

/// The least squared distance of a point of a and one of b.
inline mpq_class LeastSquare(const Places &a, const Places &b) {
    mpq_class least = -1;
    for (const Place &p : a)
        for (const Place &q : b) {
            const mpq_class square = Square(Way(p, q));
            if (least < 0 || square < least)
                least = square;
        }
    return least;
}

/// The least <d, q - p> of a point p of a and q of b.
inline mpq_class LeastAlong(const Place &d, const Places &a, const Places &b) {
    mpq_class high = Product(d, a.front()), low = Product(d, b.front());
    for (const Place &p : a)
        high = std::max<mpq_class>(high, Product(d, p));
    for (const Place &q : b)
        low = std::min<mpq_class>(low, Product(d, q));
    return low - high;
}

/// The largest double of which it is sure that it is at most x, or one or two below it.
inline double AtMost(const mpq_class &x) {
    double low = x.get_d();
    while (mpq_class(low) > x)
        low = std::nextafter(low, -INFINITY);
    return low;
}

/// The same of the square root of x >= 0.
inline double RootAtMost(const mpq_class &x) {
    double low = std::sqrt(x.get_d());
    while (mpq_class(low) * mpq_class(low) > x)
        low = std::nextafter(low, -INFINITY);
    return low;
}

/// A reach for points about a pivot: no less than the distance of any, and hardly more.
inline double ReachOf(const std::vector<bmr_vec2> &points, bmr_vec2 pivot) {
    double reach = 0.0;
    for (const bmr_vec2 &point : points) {
        const mpq_class square = Square(Way(PlaceOf(pivot), PlaceOf(point)));
        while (mpq_class(reach) * mpq_class(reach) < square)
            reach = std::fmax(std::nextafter(reach, INFINITY), std::sqrt(square.get_d()));
    }
    return reach;
}

} // namespace exact

#endif
