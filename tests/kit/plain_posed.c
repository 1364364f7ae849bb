// SPDX-License-Identifier: MIT
#define BMR_FLOAT4_PLAIN
#include "plain_lanes.h"

#define bmr_posed32_depth test_plain_posed32_depth
#define bmr_points32_reach test_plain_points32_reach
#define bmr_posed32_gap test_plain_posed32_gap
#include "exact32/posed.c" // NOLINT(bugprone-suspicious-include): its plain form
