// SPDX-License-Identifier: MIT
#ifndef BMR_FUZZ_HIERARCHY_H
#define BMR_FUZZ_HIERARCHY_H

#include "boomerang/hierarchy.h"
#include "bytes.h"

/// A table for all polygons here.
const bmr_compass *fuzz_compass();
/// The half of fuzz_hierarchy on the mixed hierarchy of a polygon and another one that is read.
void FuzzMixed(fuzz_bytes *bytes, const bmr_polygon *a, bmr_hierarchy_kind kind);

#endif
