// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONTACT_LANES_H
#define BOOMERANG_GLUE_CONTACT_LANES_H

#include "exact32/float4.h"

namespace bmr {

/// Turns the signs of all lanes, of zeros, too.
FLOAT4_INLINE float4 Negative(float4 v) {
    return flip_low4(exchange4(flip_low4(exchange4(v))));
}

/// A vector of each of four contacts. Each operation is that of b2Vec2, in its order.
struct Vec4 {
    float4 x, y;
};
FLOAT4_INLINE Vec4 Plus(const Vec4 &a, const Vec4 &b) {
    return {add4(a.x, b.x), add4(a.y, b.y)};
}
FLOAT4_INLINE Vec4 Minus(const Vec4 &a, const Vec4 &b) {
    return {sub4(a.x, b.x), sub4(a.y, b.y)};
}
FLOAT4_INLINE Vec4 Times(float4 s, const Vec4 &a) {
    return {mul4(s, a.x), mul4(s, a.y)};
}
FLOAT4_INLINE float4 Dot(const Vec4 &a, const Vec4 &b) {
    return add4(mul4(a.x, b.x), mul4(a.y, b.y));
}
FLOAT4_INLINE float4 Cross(const Vec4 &a, const Vec4 &b) {
    return sub4(mul4(a.x, b.y), mul4(a.y, b.x));
}
FLOAT4_INLINE Vec4 Select(mask4 m, const Vec4 &inside, const Vec4 &outside) {
    return {select4(m, inside.x, outside.x), select4(m, inside.y, outside.y)};
}

/// Four floats of each of four contacts: one float of all of them in a register.
struct Rows {
    float4 a, b, c, d;
};
FLOAT4_INLINE Rows Transposed(float4 p, float4 q, float4 r, float4 s) {
    const float4 pq = zip_low4(p, q), rs = zip_low4(r, s), alsoPq = zip_high4(p, q), alsoRs = zip_high4(r, s);
    return {lows4(pq, rs), highs4(pq, rs), lows4(alsoPq, alsoRs), highs4(alsoPq, alsoRs)};
}
/// The same two floats of each of four contacts.
FLOAT4_INLINE Vec4 ReadPairs(const float *a, const float *b, const float *c, const float *d) {
    const float4 low = load_pairs4(a, b), high = load_pairs4(c, d);
    return {evens4(low, high), odds4(low, high)};
}

/// Where four bodies are, or how fast: a vector and an angle, as b2Position and b2Velocity have them.
struct Motion4 {
    Vec4 v;
    float4 w;

    mask4 IsNan() const { return either4(unordered4(v.x, v.y), unordered4(w, w)); }
};
FLOAT4_INLINE Motion4 ReadMotions(const float *a, const float *b, const float *c, const float *d) {
    return {ReadPairs(a, b, c, d), of4(a[2], b[2], c[2], d[2])};
}
/// Of the first `count` bodies alone.
FLOAT4_INLINE void WriteMotions(const Motion4 &motions, float *const *bodies, uint32_t count) {
    const float4 low = zip_low4(motions.v.x, motions.v.y), high = zip_high4(motions.v.x, motions.v.y);
    float w[4];
    store4(w, motions.w);
    for (uint32_t i = 0; i < 4 && i < count; ++i) {
        if (i % 2 == 0)
            store_low4(bodies[i], i < 2 ? low : high);
        else
            store_high4(bodies[i], i < 2 ? low : high);
        bodies[i][2] = w[i];
    }
}

} // namespace bmr

#endif
