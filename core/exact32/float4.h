// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_EXACT32_FLOAT4_H
#define BOOMERANG_EXACT32_FLOAT4_H

#include <math.h>
#include <stdint.h>

/// @file
/// Four floats side by side: as gcc and clang have them for SSE2 and for NEON on ARM64, or in plain C. No
/// other file knows which.
///
/// Every operation rounds each lane once and gives the same bits in all forms, except that a NaN may
/// have another payload. tests/claims/test_float4.c compares them. So code that is written with these has the
/// same order of operations, and the same bits, on every processor. (Compile it with -ffp-contract=off:
/// compilers take NEON's product and sum for a * b + c, and would fuse them.)
///
/// Lanes are numbered from 0, the first in memory. Comparisons give a mask: all bits of a lane, or none.
///
/// Who defines BMR_FLOAT4_PLAIN gets plain C on any processor. Where plain C is in use, BMR_FLOAT4_NATIVE is
/// 0; some code is then faster one float after the other, and does that instead.

#if defined(BMR_FLOAT4_PLAIN) || !(defined(__GNUC__) || defined(__clang__))
#    define BMR_FLOAT4_NATIVE 0
#elif defined(__SSE2__)
#    define BMR_FLOAT4_NATIVE 1
#    define BMR_FLOAT4_SSE2
#    include <emmintrin.h>
#elif defined(__aarch64__) && defined(__ARM_NEON) && !defined(__AARCH64EB__)
#    define BMR_FLOAT4_NATIVE 1
#    include <arm_neon.h>
#else
#    define BMR_FLOAT4_NATIVE 0
#endif

/// Inlined always: where gcc is left to choose, it copies registers without need, three instructions for each
/// remembered edge that is checked.
#if defined(__GNUC__)
#    define FLOAT4_INLINE static inline __attribute__((always_inline))
#elif defined(_MSC_VER)
#    define FLOAT4_INLINE static __forceinline
#else
#    define FLOAT4_INLINE static inline
#endif

/// Which bit is the lowest that is set. There must be one.
FLOAT4_INLINE int lowest_bit(unsigned bits) {
#if defined(__GNUC__)
    return __builtin_ctz(bits);
#else
    int bit = 0;
    while ((bits >> bit & 1u) == 0u)
        ++bit;
    return bit;
#endif
}

/// For first_lanes4: a row for each count.
static const int32_t lane_rows4[9][8] = {
    {0, 0, 0, 0, 0, 0, 0, 0},       {-1, 0, 0, 0, 0, 0, 0, 0},       {-1, -1, 0, 0, 0, 0, 0, 0},
    {-1, -1, -1, 0, 0, 0, 0, 0},    {-1, -1, -1, -1, 0, 0, 0, 0},    {-1, -1, -1, -1, -1, 0, 0, 0},
    {-1, -1, -1, -1, -1, -1, 0, 0}, {-1, -1, -1, -1, -1, -1, -1, 0}, {-1, -1, -1, -1, -1, -1, -1, -1},
};

#if BMR_FLOAT4_NATIVE

typedef float float4 __attribute__((vector_size(16)));
typedef int32_t mask4 __attribute__((vector_size(16)));
/// The same at any address.
typedef float float4_anywhere_ __attribute__((vector_size(16), aligned(4), may_alias));
typedef int32_t mask4_anywhere_ __attribute__((vector_size(16), aligned(4), may_alias));

/// Lanes of a (0 to 3) and of b (4 to 7).
#    if defined(__clang__) || __GNUC__ >= 12
#        define lanes4_(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l)
#    else
#        define lanes4_(a, b, i, j, k, l) __builtin_shuffle(a, b, (mask4){i, j, k, l})
#    endif

FLOAT4_INLINE float4 load4(const float *four) {
    return *(const float4_anywhere_ *)four;
}
/// Two floats from each place.
#    if defined(BMR_FLOAT4_SSE2)
FLOAT4_INLINE float4 load_pairs4(const float *low, const float *high) {
    return _mm_loadh_pi(_mm_loadl_pi(_mm_setzero_ps(), (const __m64 *)(const void *)low),
                        (const __m64 *)(const void *)high);
}
FLOAT4_INLINE void store_low4(float *two, float4 v) {
    _mm_storel_pi((__m64 *)(void *)two, v);
}
FLOAT4_INLINE void store_high4(float *two, float4 v) {
    _mm_storeh_pi((__m64 *)(void *)two, v);
}
FLOAT4_INLINE float4 sqrt4(float4 v) {
    return _mm_sqrt_ps(v);
}
FLOAT4_INLINE float root_of4(float x) {
    return _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(x)));
}
/// a < b ? a : b, so b where either is a NaN, and where both are zeros.
FLOAT4_INLINE float4 min4(float4 a, float4 b) {
    return _mm_min_ps(a, b);
}
/// a > b ? a : b
FLOAT4_INLINE float4 max4(float4 a, float4 b) {
    return _mm_max_ps(a, b);
}
/// Where either is a NaN.
FLOAT4_INLINE mask4 unordered4(float4 a, float4 b) {
    return (mask4)_mm_cmpunord_ps(a, b);
}
/// Lane i is bit i.
FLOAT4_INLINE unsigned bits4(mask4 m) {
    return (unsigned)_mm_movemask_ps((__m128)m);
}
FLOAT4_INLINE int any4(mask4 m) {
    return bits4(m) != 0;
}
FLOAT4_INLINE int every4(mask4 m) {
    return bits4(m) == 15;
}
#    else
FLOAT4_INLINE float4 load_pairs4(const float *low, const float *high) {
    return vcombine_f32(vld1_f32(low), vld1_f32(high));
}
FLOAT4_INLINE void store_low4(float *two, float4 v) {
    vst1_f32(two, vget_low_f32(v));
}
FLOAT4_INLINE void store_high4(float *two, float4 v) {
    vst1_f32(two, vget_high_f32(v));
}
FLOAT4_INLINE float4 sqrt4(float4 v) {
    return vsqrtq_f32(v);
}
FLOAT4_INLINE float root_of4(float x) {
    return vget_lane_f32(vsqrt_f32(vdup_n_f32(x)), 0);
}
// (vminq and vmaxq give a NaN where there is one, and order the zeros.)
FLOAT4_INLINE float4 min4(float4 a, float4 b) {
    return vbslq_f32((uint32x4_t)(a < b), a, b);
}
FLOAT4_INLINE float4 max4(float4 a, float4 b) {
    return vbslq_f32((uint32x4_t)(a > b), a, b);
}
FLOAT4_INLINE mask4 unordered4(float4 a, float4 b) {
    return (a != a) | (b != b);
}
FLOAT4_INLINE unsigned bits4(mask4 m) {
    static const uint32_t weights[4] = {1, 2, 4, 8};
    return vaddvq_u32(vandq_u32((uint32x4_t)m, vld1q_u32(weights)));
}
FLOAT4_INLINE int any4(mask4 m) {
    return vmaxvq_u32((uint32x4_t)m) != 0;
}
FLOAT4_INLINE int every4(mask4 m) {
    return vminvq_u32((uint32x4_t)m) != 0;
}
#    endif
FLOAT4_INLINE void store4(float *four, float4 v) {
    *(float4_anywhere_ *)four = v;
}
FLOAT4_INLINE float4 of4(float a, float b, float c, float d) {
    const float4 r = {a, b, c, d};
    return r;
}
FLOAT4_INLINE float4 all4(float x) {
    return of4(x, x, x, x);
}
FLOAT4_INLINE float4 zero4(void) {
    return all4(0.0f);
}
FLOAT4_INLINE float first_of4(float4 v) {
    return v[0];
}

FLOAT4_INLINE float4 add4(float4 a, float4 b) {
    return a + b;
}
FLOAT4_INLINE float4 sub4(float4 a, float4 b) {
    return a - b;
}
FLOAT4_INLINE float4 mul4(float4 a, float4 b) {
    return a * b;
}
FLOAT4_INLINE float4 div4(float4 a, float4 b) {
    return a / b;
}
FLOAT4_INLINE float4 abs4(float4 v) {
    return (float4)((mask4)v & 0x7fffffff);
}
/// The sign bits are turned where the argument is INT32_MIN, not 0.
FLOAT4_INLINE float4 flip4_(float4 v, int32_t i, int32_t j, int32_t k, int32_t l) {
    const mask4 signs = {i, j, k, l};
    return (float4)((mask4)v ^ signs);
}

/// All four lanes hold this lane (a constant).
#    define splat4(v, lane) lanes4_(v, v, lane, lane, lane, lane)
/// a's lane twice, then b's.
#    define splat_two4(a, b, lane) lanes4_(a, b, lane, lane, (lane) + 4, (lane) + 4)

FLOAT4_INLINE mask4 less4(float4 a, float4 b) {
    return a < b;
}
FLOAT4_INLINE mask4 at_most4(float4 a, float4 b) {
    return a <= b;
}
FLOAT4_INLINE mask4 equal4(float4 a, float4 b) {
    return a == b;
}
FLOAT4_INLINE mask4 both4(mask4 a, mask4 b) {
    return a & b;
}
FLOAT4_INLINE mask4 either4(mask4 a, mask4 b) {
    return a | b;
}
/// The lanes of group `group` (0 or 1) of two that are below `count` (0 to 8), counted through both.
FLOAT4_INLINE mask4 first_lanes4(int32_t count, int32_t group) {
    return *(const mask4_anywhere_ *)&lane_rows4[count][4 * group];
}
FLOAT4_INLINE float4 select4(mask4 m, float4 inside, float4 outside) {
    return (float4)((m & (mask4)inside) | (~m & (mask4)outside));
}
/// Zero outside.
FLOAT4_INLINE float4 keep4(mask4 m, float4 v) {
    return (float4)(m & (mask4)v);
}

#else

#    include <string.h>

typedef struct float4 {
    float lane[4];
} float4;
typedef struct mask4 {
    uint32_t lane[4];
} mask4;

FLOAT4_INLINE float4 of4(float a, float b, float c, float d) {
    const float4 r = {{a, b, c, d}};
    return r;
}
FLOAT4_INLINE float4 load4(const float *four) {
    float4 r;
    memcpy(r.lane, four, sizeof r.lane);
    return r;
}
FLOAT4_INLINE float4 load_pairs4(const float *low, const float *high) {
    float4 r;
    memcpy(r.lane, low, sizeof r.lane / 2);
    memcpy(r.lane + 2, high, sizeof r.lane / 2);
    return r;
}
FLOAT4_INLINE void store4(float *four, float4 v) {
    memcpy(four, v.lane, sizeof v.lane);
}
FLOAT4_INLINE void store_low4(float *two, float4 v) {
    memcpy(two, v.lane, sizeof v.lane / 2);
}
FLOAT4_INLINE void store_high4(float *two, float4 v) {
    memcpy(two, v.lane + 2, sizeof v.lane / 2);
}
FLOAT4_INLINE float4 all4(float x) {
    return of4(x, x, x, x);
}
FLOAT4_INLINE float4 zero4(void) {
    return all4(0.0f);
}
FLOAT4_INLINE float first_of4(float4 v) {
    return v.lane[0];
}

/// The same expression of x and y, lane by lane.
#    define BMR_EACH_LANE_(expression)                                                                       \
        float4 r;                                                                                            \
        for (int i = 0; i < 4; ++i) {                                                                        \
            const float x = a.lane[i], y = b.lane[i];                                                        \
            r.lane[i] = (expression);                                                                        \
        }                                                                                                    \
        return r
FLOAT4_INLINE float4 add4(float4 a, float4 b) {
    BMR_EACH_LANE_(x + y);
}
FLOAT4_INLINE float4 sub4(float4 a, float4 b) {
    BMR_EACH_LANE_(x - y);
}
FLOAT4_INLINE float4 mul4(float4 a, float4 b) {
    BMR_EACH_LANE_(x * y);
}
FLOAT4_INLINE float4 div4(float4 a, float4 b) {
    BMR_EACH_LANE_(x / y);
}
FLOAT4_INLINE float4 min4(float4 a, float4 b) {
    BMR_EACH_LANE_(x < y ? x : y);
}
FLOAT4_INLINE float4 max4(float4 a, float4 b) {
    BMR_EACH_LANE_(x > y ? x : y);
}
#    undef BMR_EACH_LANE_
FLOAT4_INLINE float root_of4(float x) {
    return sqrtf(x);
}
FLOAT4_INLINE float4 sqrt4(float4 v) {
    return of4(root_of4(v.lane[0]), root_of4(v.lane[1]), root_of4(v.lane[2]), root_of4(v.lane[3]));
}
FLOAT4_INLINE float4 abs4(float4 v) {
    return of4(fabsf(v.lane[0]), fabsf(v.lane[1]), fabsf(v.lane[2]), fabsf(v.lane[3]));
}
FLOAT4_INLINE float4 flip4_(float4 v, int32_t i, int32_t j, int32_t k, int32_t l) {
    return of4(i ? -v.lane[0] : v.lane[0], j ? -v.lane[1] : v.lane[1], k ? -v.lane[2] : v.lane[2],
               l ? -v.lane[3] : v.lane[3]);
}

FLOAT4_INLINE float4 splat4(float4 v, int lane) {
    return all4(v.lane[lane]);
}
FLOAT4_INLINE float4 splat_two4(float4 a, float4 b, int lane) {
    return of4(a.lane[lane], a.lane[lane], b.lane[lane], b.lane[lane]);
}
/// Lanes of a (0 to 3) and of b (4 to 7).
#    define lane_of4_(a, b, i) ((i) < 4 ? (a).lane[(i)&3] : (b).lane[(i)&3])
#    define lanes4_(a, b, i, j, k, l)                                                                        \
        of4(lane_of4_(a, b, i), lane_of4_(a, b, j), lane_of4_(a, b, k), lane_of4_(a, b, l))

#    define BMR_EACH_LANE_(condition)                                                                        \
        mask4 r;                                                                                             \
        for (int i = 0; i < 4; ++i)                                                                          \
            r.lane[i] = (condition) ? 0xffffffffu : 0u;                                                      \
        return r
FLOAT4_INLINE mask4 less4(float4 a, float4 b) {
    BMR_EACH_LANE_(a.lane[i] < b.lane[i]);
}
FLOAT4_INLINE mask4 at_most4(float4 a, float4 b) {
    BMR_EACH_LANE_(a.lane[i] <= b.lane[i]);
}
FLOAT4_INLINE mask4 equal4(float4 a, float4 b) {
    BMR_EACH_LANE_(a.lane[i] == b.lane[i]);
}
FLOAT4_INLINE mask4 unordered4(float4 a, float4 b) {
    BMR_EACH_LANE_(a.lane[i] != a.lane[i] || b.lane[i] != b.lane[i]);
}
FLOAT4_INLINE mask4 both4(mask4 a, mask4 b) {
    BMR_EACH_LANE_((a.lane[i] & b.lane[i]) != 0);
}
FLOAT4_INLINE mask4 either4(mask4 a, mask4 b) {
    BMR_EACH_LANE_((a.lane[i] | b.lane[i]) != 0);
}
FLOAT4_INLINE mask4 first_lanes4(int32_t count, int32_t group) {
    BMR_EACH_LANE_(lane_rows4[count][4 * group + i] != 0);
}
#    undef BMR_EACH_LANE_
FLOAT4_INLINE unsigned bits4(mask4 m) {
    return (m.lane[0] & 1u) | (m.lane[1] & 2u) | (m.lane[2] & 4u) | (m.lane[3] & 8u);
}
FLOAT4_INLINE int any4(mask4 m) {
    return bits4(m) != 0;
}
FLOAT4_INLINE int every4(mask4 m) {
    return bits4(m) == 15;
}
FLOAT4_INLINE float4 select4(mask4 m, float4 inside, float4 outside) {
    float4 r;
    for (int i = 0; i < 4; ++i)
        r.lane[i] = m.lane[i] != 0 ? inside.lane[i] : outside.lane[i];
    return r;
}
FLOAT4_INLINE float4 keep4(mask4 m, float4 v) {
    return select4(m, v, zero4());
}

#endif

/// The sign bit is turned in lanes 0 and 2; in 1 and 3; in 1 and 2; in 0 and 1.
FLOAT4_INLINE float4 flip_even4(float4 v) {
    return flip4_(v, INT32_MIN, 0, INT32_MIN, 0);
}
FLOAT4_INLINE float4 flip_odd4(float4 v) {
    return flip4_(v, 0, INT32_MIN, 0, INT32_MIN);
}
FLOAT4_INLINE float4 flip_inner4(float4 v) {
    return flip4_(v, 0, INT32_MIN, INT32_MIN, 0);
}
FLOAT4_INLINE float4 flip_low4(float4 v) {
    return flip4_(v, INT32_MIN, INT32_MIN, 0, 0);
}
/// 1 0 3 2
FLOAT4_INLINE float4 swap4(float4 v) {
    return lanes4_(v, v, 1, 0, 3, 2);
}
/// 2 3 0 1
FLOAT4_INLINE float4 exchange4(float4 v) {
    return lanes4_(v, v, 2, 3, 0, 1);
}
/// a0 a1 b0 b1
FLOAT4_INLINE float4 lows4(float4 a, float4 b) {
    return lanes4_(a, b, 0, 1, 4, 5);
}
/// a2 a3 b2 b3
FLOAT4_INLINE float4 highs4(float4 a, float4 b) {
    return lanes4_(a, b, 2, 3, 6, 7);
}
/// a0 a1 b2 b3
FLOAT4_INLINE float4 low_high4(float4 a, float4 b) {
    return lanes4_(a, b, 0, 1, 6, 7);
}
/// a0 a2 b0 b2
FLOAT4_INLINE float4 evens4(float4 a, float4 b) {
    return lanes4_(a, b, 0, 2, 4, 6);
}
/// a1 a3 b1 b3
FLOAT4_INLINE float4 odds4(float4 a, float4 b) {
    return lanes4_(a, b, 1, 3, 5, 7);
}
/// a0 b0 a1 b1
FLOAT4_INLINE float4 zip_low4(float4 a, float4 b) {
    return lanes4_(a, b, 0, 4, 1, 5);
}
/// a2 b2 a3 b3
FLOAT4_INLINE float4 zip_high4(float4 a, float4 b) {
    return lanes4_(a, b, 2, 6, 3, 7);
}
/// a1 a2 a3 b0
FLOAT4_INLINE float4 slide4(float4 a, float4 b) {
    return lanes4_(a, b, 1, 2, 3, 4);
}

/// The least of all lanes: of 0 and 2 and of 1 and 3, then of these.
FLOAT4_INLINE float least_of4(float4 v) {
    const float4 two = min4(v, highs4(v, v));
    return first_of4(min4(two, splat4(two, 1)));
}
FLOAT4_INLINE float most_of4(float4 v) {
    const float4 two = max4(v, highs4(v, v));
    return first_of4(max4(two, splat4(two, 1)));
}
/// Lane 0 and 1; and of all lanes: 0 and 2, 1 and 3, then both.
FLOAT4_INLINE float sum_of_first4(float4 v) {
    return first_of4(add4(v, splat4(v, 1)));
}
FLOAT4_INLINE float sum_of4(float4 v) {
    return sum_of_first4(add4(v, highs4(v, v)));
}

#endif
