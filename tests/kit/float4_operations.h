// SPDX-License-Identifier: MIT
// The operations of core/exact32/float4.h as functions of arrays, in the form that float4.h has where this is
// included: test_float4.c has this processor's, plain_lanes.c plain C. FLOAT4_TABLE is the table's name.
#include "exact32/float4.h"

typedef struct float4_operation {
    const char *name;
    /// `count` is from 0 to 8. Of what gives one number, or bits, all of `out` is that.
    void (*run)(const float a[4], const float b[4], int32_t count, float out[4]);
} float4_operation;

extern const float4_operation test_native_float4[], test_plain_float4[];

#define OPERATION(name, result)                                                                              \
    static void run_##name(const float first[4], const float second[4], int32_t count, float out[4]) {       \
        const float4 a = load4(first), b = load4(second);                                                    \
        (void)a, (void)b, (void)count;                                                                       \
        store4(out, result);                                                                                 \
    }
#define SHOWN(mask) select4(mask, all4(1.0f), zero4())

#define OPERATIONS(X)                                                                                        \
    X(add, add4(a, b))                                                                                       \
    X(sub, sub4(a, b))                                                                                       \
    X(mul, mul4(a, b))                                                                                       \
    X(div, div4(a, b))                                                                                       \
    X(sqrt, sqrt4(a))                                                                                        \
    X(root, all4(root_of4(first[1])))                                                                        \
    X(min, min4(a, b))                                                                                       \
    X(max, max4(a, b))                                                                                       \
    X(abs, abs4(a))                                                                                          \
    X(flip_even, flip_even4(a))                                                                              \
    X(flip_odd, flip_odd4(a))                                                                                \
    X(flip_inner, flip_inner4(a))                                                                            \
    X(flip_low, flip_low4(a))                                                                                \
    X(all, all4(first[2]))                                                                                   \
    X(of, of4(first[3], second[0], first[1], second[2]))                                                     \
    X(zero, zero4())                                                                                         \
    X(first, all4(first_of4(b)))                                                                             \
    X(load_pairs, load_pairs4(first + 1, second + 2))                                                        \
    X(splat_0, splat4(a, 0))                                                                                 \
    X(splat_1, splat4(a, 1))                                                                                 \
    X(splat_2, splat4(b, 2))                                                                                 \
    X(splat_3, splat4(a, 3))                                                                                 \
    X(splat_two_2, splat_two4(a, b, 2))                                                                      \
    X(splat_two_3, splat_two4(a, b, 3))                                                                      \
    X(swap, swap4(a))                                                                                        \
    X(exchange, exchange4(a))                                                                                \
    X(lows, lows4(a, b))                                                                                     \
    X(highs, highs4(a, b))                                                                                   \
    X(low_high, low_high4(a, b))                                                                             \
    X(evens, evens4(a, b))                                                                                   \
    X(odds, odds4(a, b))                                                                                     \
    X(zip_low, zip_low4(a, b))                                                                               \
    X(zip_high, zip_high4(a, b))                                                                             \
    X(slide, slide4(a, b))                                                                                   \
    X(less, SHOWN(less4(a, b)))                                                                              \
    X(at_most, SHOWN(at_most4(a, b)))                                                                        \
    X(equal, SHOWN(equal4(a, b)))                                                                            \
    X(unordered, SHOWN(unordered4(a, b)))                                                                    \
    X(both, SHOWN(both4(at_most4(a, b), less4(zero4(), a))))                                                 \
    X(either, SHOWN(either4(less4(a, b), less4(zero4(), a))))                                                \
    X(bits, all4((float)bits4(less4(a, b))))                                                                 \
    X(any, all4(any4(less4(a, b)) ? 2.0f : 3.0f))                                                            \
    X(every, all4(every4(less4(a, b)) ? 2.0f : 3.0f))                                                        \
    X(first_lanes, SHOWN(first_lanes4(count, 0)))                                                            \
    X(later_lanes, SHOWN(first_lanes4(count, 1)))                                                            \
    X(select, select4(less4(a, b), b, a))                                                                    \
    X(keep, keep4(less4(a, b), a))                                                                           \
    X(least, all4(least_of4(a)))                                                                             \
    X(most, all4(most_of4(a)))                                                                               \
    X(sum_of_first, all4(sum_of_first4(a)))                                                                  \
    X(sum, all4(sum_of4(a)))

OPERATIONS(OPERATION)

// Halves are stored into what was there.
static void run_store_low(const float first[4], const float second[4], int32_t count, float out[4]) {
    (void)count;
    store4(out, load4(second));
    store_low4(out + 1, load4(first));
}
static void run_store_high(const float first[4], const float second[4], int32_t count, float out[4]) {
    (void)count;
    store4(out, load4(second));
    store_high4(out + 1, load4(first));
}
static void run_lowest_bit(const float first[4], const float second[4], int32_t count, float out[4]) {
    (void)first, (void)second;
    store4(out, all4((float)lowest_bit(0x20u << count | 0x8000u)));
}

#define ROW(name, result) {#name, run_##name},
const float4_operation FLOAT4_TABLE[] = {OPERATIONS(ROW){"store_low", run_store_low},
                                         {"store_high", run_store_high},
                                         {"lowest_bit", run_lowest_bit}};
