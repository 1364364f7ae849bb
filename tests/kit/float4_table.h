// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_FLOAT4_TABLE_H
#define BMR_TEST_FLOAT4_TABLE_H

#include <stdint.h>

/// @file
/// The operations of core/exact32/float4.h as functions of arrays, in the form of this processor and in plain
/// C, so that one program has both.

typedef struct float4_operation {
    const char *name;
    /// `count` is from 0 to 8. Of what gives one number, or bits, all of `out` is that.
    void (*run)(const float a[4], const float b[4], int32_t count, float out[4]);
} float4_operation;

extern const float4_operation test_native_float4[], test_plain_float4[];
extern const int test_float4_operations; ///< in each
extern const int test_float4_is_native;  ///< is there another form than plain C here?

#endif
