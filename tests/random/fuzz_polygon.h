// SPDX-License-Identifier: MIT
#ifndef BMR_FUZZ_POLYGON_H
#define BMR_FUZZ_POLYGON_H

#include "bytes.h"

/// The half of fuzz_polygon that makes and asks the plugin's polygons in float (convex32.h).
void FuzzPolygon32(fuzz_bytes *bytes);

#endif
