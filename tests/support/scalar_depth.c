// SPDX-License-Identifier: MIT
#define BMR_FLOAT4_PLAIN
#include "scalar_swept.h"

#define bmr_posed32_depth test_scalar_posed32_depth
#define bmr_points32_reach test_scalar_points32_reach
#include "exact32/depth.c" // NOLINT(bugprone-suspicious-include): its plain form
