// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_INTERVAL_H
#define BOOMERANG_TEST_INTERVAL_H

#include <algorithm>
#include <cmath>
#include <limits>

/// @file
/// Intervals of reals, rounded outwards, and what float arithmetic makes of a real that lies in one.

namespace interval {

inline double Up(double x) {
    return std::nextafter(x, std::numeric_limits<double>::infinity());
}
inline double Down(double x) {
    return std::nextafter(x, -std::numeric_limits<double>::infinity());
}

struct Interval {
    double low, high;

    Interval(double x) : low(x), high(x) {} // NOLINT(google-explicit-constructor): numbers are intervals
    Interval(double from, double to) : low(from), high(to) {}

    double Largest() const { return std::max(std::fabs(low), std::fabs(high)); }
    bool Holds(double x) const { return low <= x && x <= high; }
};

inline Interval operator+(Interval a, Interval b) {
    return {Down(a.low + b.low), Up(a.high + b.high)};
}
inline Interval operator-(Interval a) {
    return {-a.high, -a.low};
}
inline Interval operator-(Interval a, Interval b) {
    return a + -b;
}
inline Interval operator*(Interval a, Interval b) {
    const double p[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    return {Down(*std::min_element(p, p + 4)), Up(*std::max_element(p, p + 4))};
}
/// `b` without zero.
inline Interval operator/(Interval a, Interval b) {
    return a * Interval(Down(1.0 / b.high), Up(1.0 / b.low));
}
inline Interval Abs(Interval a) {
    return {a.low > 0.0 ? a.low : a.high < 0.0 ? -a.high : 0.0, a.Largest()};
}
inline Interval Union(Interval a, Interval b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

/// Sine and cosine of the angles from k to k + 1 of n equal parts of a turn. (n a multiple of 4: no extreme
/// lies inside a part.)
struct Directions {
    Interval c, s;

    Directions(int k, int n) : c(Of(k, k + 1, n, true)), s(Of(k, k + 1, n, false)) {}

private:
    static Interval Of(int from, int to, int n, bool cosine) {
        const auto at = [n, cosine](int k) {
            const double angle = 6.283185307179586 * k / n;
            const double x = cosine ? std::cos(angle) : std::sin(angle);
            return Interval(x - 1e-15, x + 1e-15);
        };
        return Union(at(from), at(to));
    }
};

/// Half a unit in the last place of 1, what one float operation may be off by relatively.
constexpr double kUnit = 0x1p-24;

/// A float that stands for a real: the real lies in `exact`, the float is within `error` of it.
struct Value {
    Interval exact;
    double error;

    Value(Interval real, double off = 0.0) : exact(real), error(off) {} // NOLINT(google-explicit-constructor)

    /// Of the float.
    double Largest() const { return Up(exact.Largest() + error); }
};

/// The result of one float operation: what came in was off, and it is rounded.
inline Value RoundedOnce(Interval exact, double inherited) {
    return {exact, Up(inherited + Up(kUnit * Up(exact.Largest() + inherited)))};
}
inline Value operator+(Value a, Value b) {
    return RoundedOnce(a.exact + b.exact, Up(a.error + b.error));
}
inline Value operator-(Value a) {
    return {-a.exact, a.error};
}
inline Value operator-(Value a, Value b) {
    return a + -b;
}
inline Value operator*(Value a, Value b) {
    const double inherited = Up(Up(a.exact.Largest() * b.error) + Up(b.Largest() * a.error));
    return RoundedOnce(a.exact * b.exact, inherited);
}

struct Vector {
    Value x, y;
};

/// Length of what a vector of floats is off by.
inline double Off(const Vector &v) {
    return Up(std::hypot(v.x.error, v.y.error));
}
inline Vector operator+(const Vector &a, const Vector &b) {
    return {a.x + b.x, a.y + b.y};
}
inline Vector operator-(const Vector &a, const Vector &b) {
    return {a.x - b.x, a.y - b.y};
}
inline Value Dot(const Vector &a, const Vector &b) {
    return a.x * b.x + a.y * b.y;
}
/// Turned by the rotation (c, s), as it is.
inline Vector Turned(const Directions &q, const Vector &v) {
    const Value c(q.c), s(q.s);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

} // namespace interval

#endif
