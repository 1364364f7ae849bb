// SPDX-License-Identifier: MIT
#ifndef BMR_HIERARCHY_MIXED_TILING_H
#define BMR_HIERARCHY_MIXED_TILING_H

#include "hierarchy/mixed_cells.h"

/// @file
/// A tiling in a block of the caller's.

/// Bytes that are enough for the two hierarchies' tiling at any rotation. O(n + m).
size_t bmr_mixed_tiling_most_bytes(const bmr_hierarchy *a, const bmr_hierarchy *b);
/// Builds the tiling of `mixed` in a block of that many bytes, aligned for any type.
void bmr_mixed_tiling_build(bmr_mixed_tiling *tiling, const bmr_mixed *mixed, size_t bytes);

#endif
