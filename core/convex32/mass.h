// SPDX-License-Identifier: MIT
#ifndef BMR_CONVEX32_MASS_H
#define BMR_CONVEX32_MASS_H

#include "convex32/convex32.h"

/// Mass of a convex polygon, however thin, and how far its vertices reach, in double, rounded once. Outputs
/// are written only without error: BMR_ERROR_OUT_OF_RANGE where the area or the inertia is no normal float.
bmr_error convex32_measure(const bmr_convex32 *polygon, bmr_mass32 *mass, float *reach);

#endif
