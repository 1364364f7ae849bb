// SPDX-License-Identifier: MIT
#define BMR_FLOAT4_PLAIN
#define FLOAT4_TABLE test_plain_float4
#include "float4_operations.h"
