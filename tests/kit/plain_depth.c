// SPDX-License-Identifier: MIT
#define BMR_FLOAT4_PLAIN
#include "plain_lanes.h"

#define bmr_posed32_depth test_plain_posed32_depth
#define bmr_points32_reach test_plain_points32_reach
#include "exact32/depth.c" // NOLINT(bugprone-suspicious-include): its plain form
