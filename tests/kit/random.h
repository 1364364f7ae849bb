// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_RANDOM_H
#define BMR_TEST_RANDOM_H

#include <stdint.h>

/// @file
/// Random numbers for tests, in C and C++: the same from the same seed on every machine. (What a fuzzer's
/// bytes decide is read from the bytes.)

/// splitmix64 (Steele, Lea, Flood). The state is the seed; any value will do.
typedef struct test_random {
    uint64_t state;
} test_random;

/// What a test that fails says of its random numbers: the seed that was begun with last, and how many were
/// drawn since. One for all sources of a program, and for each of its threads.
typedef struct test_random_record {
    uint64_t seed, drawn;
} test_random_record;
__attribute__((weak)) __thread test_random_record test_random_last;

/// Every test begins so, that its failure names the seed.
static inline test_random test_random_from(uint64_t seed) {
    const test_random random = {seed};
    const test_random_record record = {seed, 0};
    test_random_last = record;
    return random;
}

static inline uint64_t test_random_next(test_random *random) {
    ++test_random_last.drawn;
    uint64_t z = random->state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/// In [low, high).
static inline double test_random_uniform(test_random *random, double low, double high) {
    return low + (high - low) * ((double)(test_random_next(random) >> 11) * 0x1p-53);
}

/// In 0 .. bound-1, bound >= 1.
static inline uint32_t test_random_below(test_random *random, uint32_t bound) {
    return (uint32_t)((test_random_next(random) >> 32) * bound >> 32);
}

#endif
