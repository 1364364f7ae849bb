// SPDX-License-Identifier: MIT
#define BMR_FLOAT4_PLAIN
#include "plain_lanes.h"

#define bmr_exact32_collide test_plain_exact32_collide
#include "exact32/manifold.c" // NOLINT(bugprone-suspicious-include): its plain form
