// SPDX-License-Identifier: MIT
#define BMR_FLOAT4_PLAIN
#include "plain_lanes.h"

#define bmr_convex32_apart test_plain_convex32_apart
#include "convex32/apart.c" // NOLINT(bugprone-suspicious-include): its plain form
