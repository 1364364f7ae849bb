// SPDX-License-Identifier: MIT
#define BMR_FLOAT4_PLAIN
#include "plain_lanes.h"

#define bmr_swept32_make test_plain_swept32_make
#define bmr_swept32_apart_along test_plain_swept32_apart_along
#define bmr_swept32_find_apart test_plain_swept32_find_apart
#include "exact32/swept.c" // NOLINT(bugprone-suspicious-include): its plain form
