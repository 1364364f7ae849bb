// SPDX-License-Identifier: MIT
#define BMR_FLOAT4_PLAIN
#include "plain_lanes.h"

#define bmr_convex32_edge_against test_plain_convex32_edge_against
#define bmr_convex32_collide test_plain_convex32_collide
#include "convex32/collide.c" // NOLINT(bugprone-suspicious-include): its plain form
