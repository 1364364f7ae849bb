// SPDX-License-Identifier: MIT
#define BMR_FLOAT4_PLAIN
#include "plain_lanes.h"

#define bmr_convex32_edge_against test_plain_convex32_edge_against
#define bmr_convex32_collide test_plain_convex32_collide
#define bmr_convex32_collide_circle test_plain_convex32_collide_circle
#define bmr_convex32_keep_features test_plain_convex32_keep_features
#include "convex32/collide.c" // NOLINT(bugprone-suspicious-include): its plain form
