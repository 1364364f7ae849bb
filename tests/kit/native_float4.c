// SPDX-License-Identifier: MIT
#define FLOAT4_TABLE test_native_float4
#include "float4_operations.h"

const int test_float4_operations = sizeof test_native_float4 / sizeof test_native_float4[0];
const int test_float4_is_native = BMR_FLOAT4_NATIVE;
