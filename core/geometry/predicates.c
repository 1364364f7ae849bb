// SPDX-License-Identifier: MIT
#include "geometry/predicates.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

/// Relative error of the determinant in doubles: each product has met three roundings (two differences and
/// its own), their difference one more: (3 + small) half-ulps of the sum of magnitudes. Four are on the safe
/// side.
#define FILTER_BOUND (4.0 * 0.5 * DBL_EPSILON)
/// What underflow can cost on top, generously: two products, each off by less than the smallest denormal.
#define FILTER_UNDERFLOW DBL_MIN

/// The exact path adds the six products of the expanded determinant in one long fixed-point number of base
/// 2^32. A lane holds a digit, not yet normalised: 6 * 9 * 2 digits below 2^32 cannot overflow 63 bits, so
/// carries wait for the end. A double is an integer of 53 bits times 2^e, -1074 <= e <= 971. Lane 0 of a
/// factor stands for 2^-1088 (34 * 32); so a factor's highest digit is in lane (971 + 1088) / 32 + 2 = 66 and
/// a product's in lane 2 * 66 + 1.
#define FACTOR_BIAS 1088
#define FACTOR_DIGITS 3
#define LANES 134

typedef struct digits {
    uint32_t digit[FACTOR_DIGITS];
    int lane;
    int sign;
} digits;

static digits to_digits(double x) {
    digits d = {{0, 0, 0}, 0, 0};
    if (x == 0.0)
        return d;
    int exponent;
    const double fraction = frexp(fabs(x), &exponent); // in [1/2, 1), also for denormals
    // Denormals have fewer bits: keep e >= -1074, where the mantissa is still an integer.
    int e = exponent - 53;
    if (e < -1074)
        e = -1074;
    const uint64_t m = (uint64_t)ldexp(fraction, exponent - e);
    const int position = e + FACTOR_BIAS;
    const int shift = position % 32;
    d.lane = position / 32;
    d.sign = x > 0.0 ? 1 : -1;
    d.digit[0] = (uint32_t)(m << shift);
    d.digit[1] = (uint32_t)(m >> (32 - shift));
    d.digit[2] = shift > 0 ? (uint32_t)(m >> (64 - shift)) : 0;
    return d;
}

static void add_product(int64_t lanes[LANES], const digits *a, const digits *b, int sign) {
    const int64_t s = sign * a->sign * b->sign;
    int64_t *base = lanes + a->lane + b->lane;
    for (int i = 0; i < FACTOR_DIGITS; ++i)
        for (int j = 0; j < FACTOR_DIGITS; ++j) {
            const uint64_t p = (uint64_t)a->digit[i] * b->digit[j];
            base[i + j] += s * (int64_t)(p & UINT32_MAX);
            base[i + j + 1] += s * (int64_t)(p >> 32);
        }
}

static int sign_of(const int64_t lanes[LANES]) {
    int64_t carry = 0;
    int64_t rest = 0;
    for (int i = 0; i < LANES; ++i) {
        const int64_t sum = lanes[i] + carry;
        const int64_t digit = sum & (int64_t)UINT32_MAX; // non-negative: carries round towards minus infinity
        carry = (sum - digit) / ((int64_t)UINT32_MAX + 1);
        rest |= digit;
    }
    if (carry < 0)
        return -1;
    return carry > 0 || rest != 0;
}

static int exact_orientation(bmr_vec2 a, bmr_vec2 b, bmr_vec2 c) {
    const digits x[3] = {to_digits(a.x), to_digits(b.x), to_digits(c.x)};
    const digits y[3] = {to_digits(a.y), to_digits(b.y), to_digits(c.y)};
    int64_t lanes[LANES];
    memset(lanes, 0, sizeof lanes);
    // a x b + b x c + c x a
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        add_product(lanes, &x[i], &y[j], 1);
        add_product(lanes, &y[i], &x[j], -1);
    }
    return sign_of(lanes);
}

int bmr_orientation(bmr_vec2 a, bmr_vec2 b, bmr_vec2 c) {
    const double acx = a.x - c.x, bcx = b.x - c.x, acy = a.y - c.y, bcy = b.y - c.y;
    // A difference of doubles is 0 only if they are equal, so these zeros are exact (axis-parallel lines,
    // equal points).
    if ((acx == 0.0 || bcy == 0.0) && (acy == 0.0 || bcx == 0.0))
        return 0;
    const double left = acx * bcy, right = acy * bcx;
    const double determinant = left - right;
    const double bound = FILTER_BOUND * (fabs(left) + fabs(right)) + FILTER_UNDERFLOW;
    // Overflow makes the bound infinite or the determinant NaN: both comparisons fail, and the exact path
    // decides.
    if (determinant > bound)
        return 1;
    if (determinant < -bound)
        return -1;
    return exact_orientation(a, b, c);
}
