// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_EXACT32_FLOAT4_H
#define BOOMERANG_EXACT32_FLOAT4_H

#include <math.h>
#include <stdint.h>

/// @file
/// Four floats side by side: in SSE2, in NEON on ARM64, or in plain C. No other file knows which.
///
/// Every operation rounds each lane once and gives the same bits in all three forms, except that a NaN may
/// have another payload. tests/unit/test_float4.c compares them. So code that is written with these has the
/// same order of operations, and the same bits, on every processor. (Compile it with -ffp-contract=off:
/// compilers take NEON's product and sum for a * b + c, and would fuse them.)
///
/// Lanes are numbered from 0, the first in memory. Comparisons give a mask: all bits of a lane, or none.
///
/// Who defines BMR_FLOAT4_PLAIN gets plain C on any processor. Where plain C is in use, BMR_FLOAT4_NATIVE is
/// 0; some code is then faster one float after the other, and does that instead.

#if defined(BMR_FLOAT4_PLAIN)
#    define BMR_FLOAT4_NATIVE 0
#elif defined(__SSE2__) || defined(_M_X64)
#    define BMR_FLOAT4_NATIVE 1
#    define BMR_FLOAT4_SSE2
#    include <emmintrin.h>
#elif (defined(__aarch64__) && defined(__ARM_NEON) && !defined(__AARCH64EB__)) || defined(_M_ARM64)
#    define BMR_FLOAT4_NATIVE 1
#    define BMR_FLOAT4_NEON
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

#if defined(BMR_FLOAT4_SSE2)

typedef __m128 float4, mask4;

FLOAT4_INLINE float4 load4(const float *four) {
    return _mm_loadu_ps(four);
}
/// Two floats from each place.
FLOAT4_INLINE float4 load_pairs4(const float *low, const float *high) {
    return _mm_loadh_pi(_mm_loadl_pi(_mm_setzero_ps(), (const __m64 *)(const void *)low),
                        (const __m64 *)(const void *)high);
}
FLOAT4_INLINE void store4(float *four, float4 v) {
    _mm_storeu_ps(four, v);
}
FLOAT4_INLINE void store_low4(float *two, float4 v) {
    _mm_storel_pi((__m64 *)(void *)two, v);
}
FLOAT4_INLINE void store_high4(float *two, float4 v) {
    _mm_storeh_pi((__m64 *)(void *)two, v);
}
FLOAT4_INLINE float4 all4(float x) {
    return _mm_set1_ps(x);
}
FLOAT4_INLINE float4 of4(float a, float b, float c, float d) {
    return _mm_setr_ps(a, b, c, d);
}
FLOAT4_INLINE float4 zero4(void) {
    return _mm_setzero_ps();
}
FLOAT4_INLINE float first_of4(float4 v) {
    return _mm_cvtss_f32(v);
}

FLOAT4_INLINE float4 add4(float4 a, float4 b) {
    return _mm_add_ps(a, b);
}
FLOAT4_INLINE float4 sub4(float4 a, float4 b) {
    return _mm_sub_ps(a, b);
}
FLOAT4_INLINE float4 mul4(float4 a, float4 b) {
    return _mm_mul_ps(a, b);
}
FLOAT4_INLINE float4 div4(float4 a, float4 b) {
    return _mm_div_ps(a, b);
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
FLOAT4_INLINE float4 abs4(float4 v) {
    return _mm_and_ps(v, _mm_castsi128_ps(_mm_set1_epi32(0x7fffffff)));
}
/// The sign bit is turned in lanes 0 and 2; in 1 and 3; in 1 and 2; in 0 and 1.
FLOAT4_INLINE float4 flip_even4(float4 v) {
    return _mm_xor_ps(v, _mm_castsi128_ps(_mm_set_epi32(0, INT32_MIN, 0, INT32_MIN)));
}
FLOAT4_INLINE float4 flip_odd4(float4 v) {
    return _mm_xor_ps(v, _mm_castsi128_ps(_mm_set_epi32(INT32_MIN, 0, INT32_MIN, 0)));
}
FLOAT4_INLINE float4 flip_inner4(float4 v) {
    return _mm_xor_ps(v, _mm_castsi128_ps(_mm_set_epi32(0, INT32_MIN, INT32_MIN, 0)));
}
FLOAT4_INLINE float4 flip_low4(float4 v) {
    return _mm_xor_ps(v, _mm_castsi128_ps(_mm_set_epi32(0, 0, INT32_MIN, INT32_MIN)));
}

/// All four lanes hold this lane (a constant).
#    define splat4(v, lane) _mm_shuffle_ps(v, v, _MM_SHUFFLE(lane, lane, lane, lane))
/// a's lane twice, then b's.
#    define splat_two4(a, b, lane) _mm_shuffle_ps(a, b, _MM_SHUFFLE(lane, lane, lane, lane))
/// 1 0 3 2
FLOAT4_INLINE float4 swap4(float4 v) {
    return _mm_shuffle_ps(v, v, _MM_SHUFFLE(2, 3, 0, 1));
}
/// 2 3 0 1
FLOAT4_INLINE float4 exchange4(float4 v) {
    return _mm_shuffle_ps(v, v, _MM_SHUFFLE(1, 0, 3, 2));
}
/// a0 a1 b0 b1
FLOAT4_INLINE float4 lows4(float4 a, float4 b) {
    return _mm_movelh_ps(a, b);
}
/// a2 a3 b2 b3
FLOAT4_INLINE float4 highs4(float4 a, float4 b) {
    return _mm_movehl_ps(b, a);
}
/// a0 a1 b2 b3
FLOAT4_INLINE float4 low_high4(float4 a, float4 b) {
    return _mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 2, 1, 0));
}
/// a0 a2 b0 b2
FLOAT4_INLINE float4 evens4(float4 a, float4 b) {
    return _mm_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0));
}
/// a1 a3 b1 b3
FLOAT4_INLINE float4 odds4(float4 a, float4 b) {
    return _mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1));
}
/// a0 b0 a1 b1
FLOAT4_INLINE float4 zip_low4(float4 a, float4 b) {
    return _mm_unpacklo_ps(a, b);
}
/// a2 b2 a3 b3
FLOAT4_INLINE float4 zip_high4(float4 a, float4 b) {
    return _mm_unpackhi_ps(a, b);
}
/// a1 a2 a3 b0
FLOAT4_INLINE float4 slide4(float4 a, float4 b) {
    const float4 t = _mm_move_ss(a, b);
    return _mm_shuffle_ps(t, t, _MM_SHUFFLE(0, 3, 2, 1));
}

FLOAT4_INLINE mask4 less4(float4 a, float4 b) {
    return _mm_cmplt_ps(a, b);
}
FLOAT4_INLINE mask4 at_most4(float4 a, float4 b) {
    return _mm_cmple_ps(a, b);
}
FLOAT4_INLINE mask4 equal4(float4 a, float4 b) {
    return _mm_cmpeq_ps(a, b);
}
/// Where either is a NaN.
FLOAT4_INLINE mask4 unordered4(float4 a, float4 b) {
    return _mm_cmpunord_ps(a, b);
}
FLOAT4_INLINE mask4 both4(mask4 a, mask4 b) {
    return _mm_and_ps(a, b);
}
FLOAT4_INLINE mask4 either4(mask4 a, mask4 b) {
    return _mm_or_ps(a, b);
}
/// Lane i is bit i.
FLOAT4_INLINE unsigned bits4(mask4 m) {
    return (unsigned)_mm_movemask_ps(m);
}
FLOAT4_INLINE int any4(mask4 m) {
    return _mm_movemask_ps(m) != 0;
}
FLOAT4_INLINE int every4(mask4 m) {
    return _mm_movemask_ps(m) == 15;
}
/// The lanes of group `group` (0 or 1) of two that are below `count` (0 to 8), counted through both.
FLOAT4_INLINE mask4 first_lanes4(int32_t count, int32_t group) {
    return _mm_castsi128_ps(_mm_loadu_si128((const __m128i *)(const void *)(&lane_rows4[count][4 * group])));
}
FLOAT4_INLINE float4 select4(mask4 m, float4 inside, float4 outside) {
    return _mm_or_ps(_mm_and_ps(m, inside), _mm_andnot_ps(m, outside));
}
/// Zero outside.
FLOAT4_INLINE float4 keep4(mask4 m, float4 v) {
    return _mm_and_ps(m, v);
}

/// The least of all lanes: of 0 and 2 and of 1 and 3, then of these. The same of min4 and max4 elsewhere.
FLOAT4_INLINE float least_of4(float4 v) {
    const float4 two = _mm_min_ps(v, _mm_movehl_ps(v, v));
    return _mm_cvtss_f32(_mm_min_ss(two, splat4(two, 1)));
}
FLOAT4_INLINE float most_of4(float4 v) {
    const float4 two = _mm_max_ps(v, _mm_movehl_ps(v, v));
    return _mm_cvtss_f32(_mm_max_ss(two, splat4(two, 1)));
}
/// Lane 0 and 1; and of all lanes: 0 and 2, 1 and 3, then both.
FLOAT4_INLINE float sum_of_first4(float4 v) {
    return _mm_cvtss_f32(_mm_add_ss(v, splat4(v, 1)));
}
FLOAT4_INLINE float sum_of4(float4 v) {
    return sum_of_first4(_mm_add_ps(v, _mm_movehl_ps(v, v)));
}

#elif defined(BMR_FLOAT4_NEON)

typedef float32x4_t float4;
typedef uint32x4_t mask4;

FLOAT4_INLINE float4 load4(const float *four) {
    return vld1q_f32(four);
}
FLOAT4_INLINE float4 load_pairs4(const float *low, const float *high) {
    return vcombine_f32(vld1_f32(low), vld1_f32(high));
}
FLOAT4_INLINE void store4(float *four, float4 v) {
    vst1q_f32(four, v);
}
FLOAT4_INLINE void store_low4(float *two, float4 v) {
    vst1_f32(two, vget_low_f32(v));
}
FLOAT4_INLINE void store_high4(float *two, float4 v) {
    vst1_f32(two, vget_high_f32(v));
}
FLOAT4_INLINE float4 all4(float x) {
    return vdupq_n_f32(x);
}
FLOAT4_INLINE float4 of4(float a, float b, float c, float d) {
    const float four[4] = {a, b, c, d};
    return vld1q_f32(four);
}
FLOAT4_INLINE float4 zero4(void) {
    return vdupq_n_f32(0.0f);
}
FLOAT4_INLINE float first_of4(float4 v) {
    return vgetq_lane_f32(v, 0);
}

FLOAT4_INLINE float4 add4(float4 a, float4 b) {
    return vaddq_f32(a, b);
}
FLOAT4_INLINE float4 sub4(float4 a, float4 b) {
    return vsubq_f32(a, b);
}
FLOAT4_INLINE float4 mul4(float4 a, float4 b) {
    return vmulq_f32(a, b);
}
FLOAT4_INLINE float4 div4(float4 a, float4 b) {
    return vdivq_f32(a, b);
}
FLOAT4_INLINE float4 sqrt4(float4 v) {
    return vsqrtq_f32(v);
}
FLOAT4_INLINE float root_of4(float x) {
    return vget_lane_f32(vsqrt_f32(vdup_n_f32(x)), 0);
}
// (vminq and vmaxq give a NaN where there is one, and order the zeros.)
FLOAT4_INLINE float4 min4(float4 a, float4 b) {
    return vbslq_f32(vcltq_f32(a, b), a, b);
}
FLOAT4_INLINE float4 max4(float4 a, float4 b) {
    return vbslq_f32(vcgtq_f32(a, b), a, b);
}
FLOAT4_INLINE float4 abs4(float4 v) {
    return vabsq_f32(v);
}
FLOAT4_INLINE float4 flip_by4_(float4 v, uint64_t low, uint64_t high) {
    const uint64x2_t signs = vcombine_u64(vcreate_u64(low), vcreate_u64(high));
    return vreinterpretq_f32_u64(veorq_u64(vreinterpretq_u64_f32(v), signs));
}
FLOAT4_INLINE float4 flip_even4(float4 v) {
    return flip_by4_(v, 0x80000000u, 0x80000000u);
}
FLOAT4_INLINE float4 flip_odd4(float4 v) {
    return flip_by4_(v, (uint64_t)0x80000000u << 32, (uint64_t)0x80000000u << 32);
}
FLOAT4_INLINE float4 flip_inner4(float4 v) {
    return flip_by4_(v, (uint64_t)0x80000000u << 32, 0x80000000u);
}
FLOAT4_INLINE float4 flip_low4(float4 v) {
    return flip_by4_(v, 0x8000000080000000u, 0);
}

#    define splat4(v, lane) vdupq_laneq_f32(v, lane)
#    define splat_two4(a, b, lane) vcombine_f32(vdup_laneq_f32(a, lane), vdup_laneq_f32(b, lane))
FLOAT4_INLINE float4 swap4(float4 v) {
    return vrev64q_f32(v);
}
FLOAT4_INLINE float4 exchange4(float4 v) {
    return vextq_f32(v, v, 2);
}
FLOAT4_INLINE float4 lows4(float4 a, float4 b) {
    return vcombine_f32(vget_low_f32(a), vget_low_f32(b));
}
FLOAT4_INLINE float4 highs4(float4 a, float4 b) {
    return vcombine_f32(vget_high_f32(a), vget_high_f32(b));
}
FLOAT4_INLINE float4 low_high4(float4 a, float4 b) {
    return vcombine_f32(vget_low_f32(a), vget_high_f32(b));
}
FLOAT4_INLINE float4 evens4(float4 a, float4 b) {
    return vuzp1q_f32(a, b);
}
FLOAT4_INLINE float4 odds4(float4 a, float4 b) {
    return vuzp2q_f32(a, b);
}
FLOAT4_INLINE float4 zip_low4(float4 a, float4 b) {
    return vzip1q_f32(a, b);
}
FLOAT4_INLINE float4 zip_high4(float4 a, float4 b) {
    return vzip2q_f32(a, b);
}
FLOAT4_INLINE float4 slide4(float4 a, float4 b) {
    return vextq_f32(a, b, 1);
}

FLOAT4_INLINE mask4 less4(float4 a, float4 b) {
    return vcltq_f32(a, b);
}
FLOAT4_INLINE mask4 at_most4(float4 a, float4 b) {
    return vcleq_f32(a, b);
}
FLOAT4_INLINE mask4 equal4(float4 a, float4 b) {
    return vceqq_f32(a, b);
}
FLOAT4_INLINE mask4 both4(mask4 a, mask4 b) {
    return vandq_u32(a, b);
}
FLOAT4_INLINE mask4 either4(mask4 a, mask4 b) {
    return vorrq_u32(a, b);
}
FLOAT4_INLINE mask4 unordered4(float4 a, float4 b) {
    return vmvnq_u32(vandq_u32(vceqq_f32(a, a), vceqq_f32(b, b)));
}
FLOAT4_INLINE unsigned bits4(mask4 m) {
    static const uint32_t weights[4] = {1, 2, 4, 8};
    return vaddvq_u32(vandq_u32(m, vld1q_u32(weights)));
}
FLOAT4_INLINE int any4(mask4 m) {
    return vmaxvq_u32(m) != 0;
}
FLOAT4_INLINE int every4(mask4 m) {
    return vminvq_u32(m) != 0;
}
FLOAT4_INLINE mask4 first_lanes4(int32_t count, int32_t group) {
    return vreinterpretq_u32_s32(vld1q_s32(&lane_rows4[count][4 * group]));
}
FLOAT4_INLINE float4 select4(mask4 m, float4 inside, float4 outside) {
    return vbslq_f32(m, inside, outside);
}
FLOAT4_INLINE float4 keep4(mask4 m, float4 v) {
    return vreinterpretq_f32_u32(vandq_u32(m, vreinterpretq_u32_f32(v)));
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
FLOAT4_INLINE float4 flip_even4(float4 v) {
    return of4(-v.lane[0], v.lane[1], -v.lane[2], v.lane[3]);
}
FLOAT4_INLINE float4 flip_odd4(float4 v) {
    return of4(v.lane[0], -v.lane[1], v.lane[2], -v.lane[3]);
}
FLOAT4_INLINE float4 flip_inner4(float4 v) {
    return of4(v.lane[0], -v.lane[1], -v.lane[2], v.lane[3]);
}
FLOAT4_INLINE float4 flip_low4(float4 v) {
    return of4(-v.lane[0], -v.lane[1], v.lane[2], v.lane[3]);
}

FLOAT4_INLINE float4 splat4(float4 v, int lane) {
    return all4(v.lane[lane]);
}
FLOAT4_INLINE float4 splat_two4(float4 a, float4 b, int lane) {
    return of4(a.lane[lane], a.lane[lane], b.lane[lane], b.lane[lane]);
}
FLOAT4_INLINE float4 swap4(float4 v) {
    return of4(v.lane[1], v.lane[0], v.lane[3], v.lane[2]);
}
FLOAT4_INLINE float4 exchange4(float4 v) {
    return of4(v.lane[2], v.lane[3], v.lane[0], v.lane[1]);
}
FLOAT4_INLINE float4 lows4(float4 a, float4 b) {
    return of4(a.lane[0], a.lane[1], b.lane[0], b.lane[1]);
}
FLOAT4_INLINE float4 highs4(float4 a, float4 b) {
    return of4(a.lane[2], a.lane[3], b.lane[2], b.lane[3]);
}
FLOAT4_INLINE float4 low_high4(float4 a, float4 b) {
    return of4(a.lane[0], a.lane[1], b.lane[2], b.lane[3]);
}
FLOAT4_INLINE float4 evens4(float4 a, float4 b) {
    return of4(a.lane[0], a.lane[2], b.lane[0], b.lane[2]);
}
FLOAT4_INLINE float4 odds4(float4 a, float4 b) {
    return of4(a.lane[1], a.lane[3], b.lane[1], b.lane[3]);
}
FLOAT4_INLINE float4 zip_low4(float4 a, float4 b) {
    return of4(a.lane[0], b.lane[0], a.lane[1], b.lane[1]);
}
FLOAT4_INLINE float4 zip_high4(float4 a, float4 b) {
    return of4(a.lane[2], b.lane[2], a.lane[3], b.lane[3]);
}
FLOAT4_INLINE float4 slide4(float4 a, float4 b) {
    return of4(a.lane[1], a.lane[2], a.lane[3], b.lane[0]);
}

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

#if !defined(BMR_FLOAT4_SSE2)

FLOAT4_INLINE float least_of4(float4 v) {
    const float4 two = min4(v, highs4(v, v));
    return first_of4(min4(two, splat4(two, 1)));
}
FLOAT4_INLINE float most_of4(float4 v) {
    const float4 two = max4(v, highs4(v, v));
    return first_of4(max4(two, splat4(two, 1)));
}
FLOAT4_INLINE float sum_of_first4(float4 v) {
    return first_of4(add4(v, splat4(v, 1)));
}
FLOAT4_INLINE float sum_of4(float4 v) {
    return sum_of_first4(add4(v, highs4(v, v)));
}

#endif

#endif
