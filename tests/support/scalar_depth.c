// SPDX-License-Identifier: MIT
// The file chooses its form by this macro.
#undef __SSE2__
#include "scalar_swept.h"

#define bmr_posed32_depth test_scalar_posed32_depth
#define bmr_points32_reach test_scalar_points32_reach
#include "exact32/depth.c" // NOLINT(bugprone-suspicious-include): its other form
