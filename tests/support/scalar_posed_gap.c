// SPDX-License-Identifier: MIT
// The file chooses its form by this macro.
#undef __SSE2__
#include "scalar_swept.h"

#define bmr_posed32_gap test_scalar_posed32_gap
#include "exact32/posed_gap.c" // NOLINT(bugprone-suspicious-include): its other form
