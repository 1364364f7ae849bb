// SPDX-License-Identifier: MIT
#define BMR_FLOAT4_PLAIN
#include "plain_lanes.h"

#define bmr_exact32_relative test_plain_exact32_relative
#define bmr_exact32_edge_separation test_plain_exact32_edge_separation
#define bmr_exact32_posed_separation test_plain_exact32_posed_separation
#define bmr_exact32_max_separation test_plain_exact32_max_separation
#define bmr_exact32_collide test_plain_exact32_collide
#include "exact32/exact32.c" // NOLINT(bugprone-suspicious-include): its plain form
