// SPDX-License-Identifier: MIT
#define BMR_FLOAT4_PLAIN
#include "scalar_swept.h"

#define bmr_posed32_gap test_scalar_posed32_gap
#include "exact32/posed_gap.c" // NOLINT(bugprone-suspicious-include): its plain form
