// SPDX-License-Identifier: MIT
#ifndef BMR_FUZZ_BYTES_H
#define BMR_FUZZ_BYTES_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Reads a fuzzer's bytes as numbers. Past the end all is zero, so that every byte string is an input and a
/// short one has a meaning of its own. A mutator changes few bytes at a time: what is read is laid out so
/// that a byte changed changes one thing.

typedef struct fuzz_bytes {
    const uint8_t *data;
    size_t size; ///< left
} fuzz_bytes;

static inline fuzz_bytes fuzz_bytes_make(const uint8_t *data, size_t size) {
    const fuzz_bytes bytes = {data, size};
    return bytes;
}
static inline bool fuzz_done(const fuzz_bytes *bytes) {
    return bytes->size == 0;
}
/// Copies `size` bytes, zeros past the end.
static inline void fuzz_take(fuzz_bytes *bytes, void *into, size_t size) {
    const size_t have = size < bytes->size ? size : bytes->size;
    memset(into, 0, size);
    if (have > 0)
        memcpy(into, bytes->data, have);
    bytes->data += have;
    bytes->size -= have;
}
static inline uint8_t fuzz_u8(fuzz_bytes *bytes) {
    uint8_t value;
    fuzz_take(bytes, &value, sizeof value);
    return value;
}
static inline uint16_t fuzz_u16(fuzz_bytes *bytes) {
    uint16_t value;
    fuzz_take(bytes, &value, sizeof value);
    return value;
}
static inline uint32_t fuzz_u32(fuzz_bytes *bytes) {
    uint32_t value;
    fuzz_take(bytes, &value, sizeof value);
    return value;
}
static inline uint64_t fuzz_u64(fuzz_bytes *bytes) {
    uint64_t value;
    fuzz_take(bytes, &value, sizeof value);
    return value;
}
/// In 0 .. bound - 1; one byte, bound from 1 to 256.
static inline uint32_t fuzz_below(fuzz_bytes *bytes, uint32_t bound) {
    return fuzz_u8(bytes) % bound;
}
/// In [low, high]: 65536 values, two bytes; the first is `low`.
static inline double fuzz_in(fuzz_bytes *bytes, double low, double high) {
    return low + (high - low) * ((double)fuzz_u16(bytes) / 65535.0);
}
/// Any bit pattern, a NaN too.
static inline double fuzz_raw_double(fuzz_bytes *bytes) {
    double value;
    fuzz_take(bytes, &value, sizeof value);
    return value;
}
/// Numbers on the edges of what is allowed, and beyond.
static inline double fuzz_special(fuzz_bytes *bytes) {
    static const double numbers[] = {0.0,     -0.0,    1.0,      -1.0,     0.5,       1e9,
                                     -1e9,    1e-9,    -1e-9,    INFINITY, NAN,       DBL_MAX,
                                     DBL_MIN, FLT_MAX, -FLT_MAX, FLT_MIN,  4.94e-324, 1.4013e-45,
                                     1e-300,  1e15,    1e30,     1e-15,    3.0,       1e8};
    return numbers[fuzz_below(bytes, sizeof numbers / sizeof *numbers)];
}
/// By the first byte: a small integer, a fraction, a fraction times a power of two, one of the edges and up
/// to 127 neighbours, or any bits.
static inline double fuzz_number(fuzz_bytes *bytes) {
    const uint8_t how = fuzz_u8(bytes);
    switch (how % 8) {
    case 0:
    case 1:
        return (double)(int8_t)fuzz_u8(bytes);
    case 2:
    case 3:
    case 4:
        return fuzz_in(bytes, -2.0, 2.0);
    case 5: {
        const double fraction = fuzz_in(bytes, -1.0, 1.0); // first: arguments are computed in any order
        return ldexp(fraction, (int8_t)fuzz_u8(bytes) / (how >= 128 ? 1 : 4));
    }
    case 6: {
        double value = fuzz_special(bytes);
        for (int steps = (int8_t)fuzz_u8(bytes); steps != 0; steps += steps < 0 ? 1 : -1)
            value = nextafter(value, steps < 0 ? -INFINITY : INFINITY);
        return value;
    }
    default:
        return fuzz_raw_double(bytes);
    }
}

#ifdef __cplusplus
}
#endif
#endif
