// SPDX-License-Identifier: MIT
// The functions of core that are written in lanes, in their plain form, under the names of plain_lanes.h.
// (Those of swept shapes are in plain_swept.c.)
// NOLINTBEGIN(bugprone-suspicious-include)
#define BMR_FLOAT4_PLAIN
#include "plain_lanes.h"

#define bmr_convex32_apart test_plain_convex32_apart
#define bmr_convex32_edge_against test_plain_convex32_edge_against
#define bmr_convex32_collide test_plain_convex32_collide
#define bmr_convex32_collide_circle test_plain_convex32_collide_circle
#define bmr_convex32_keep_features test_plain_convex32_keep_features
#define bmr_posed32_depth test_plain_posed32_depth
#define bmr_points32_reach test_plain_points32_reach
#define bmr_posed32_gap test_plain_posed32_gap
#define bmr_exact32_edge_separation test_plain_exact32_edge_separation
#define bmr_exact32_posed_separation test_plain_exact32_posed_separation
#define bmr_exact32_max_separation test_plain_exact32_max_separation
#define bmr_exact32_collide test_plain_exact32_collide

// Some files have names of their own that others have, too.
#define gap gap_along_axis
#include "convex32/apart.c"
#undef gap
#include "convex32/collide.c"
#include "exact32/posed.c"
#define make_points make_points_of_small_polygons
#define bmr_exact32_relative test_plain_exact32_relative
#include "exact32/exact32.c"
// NOLINTEND(bugprone-suspicious-include)

#define FLOAT4_TABLE test_plain_float4
#include "float4_operations.h"
