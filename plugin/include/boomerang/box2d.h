// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_BOX2D_H
#define BOOMERANG_BOX2D_H

/// @file
/// What a game includes. One call before the first world, and nothing else changes:
///
///     #include <box2d/box2d.h>
///     #include <boomerang/box2d.h>
///     bmr::Install();
///
/// Every simulation computes the bits that it computed before. bmr::ConvexShape is there besides: a convex
/// polygon of any number of vertices; bmr_error_describe tells what is wrong with points that make none.

#include "boomerang/box2d_glue.h"
#include "boomerang/convex_shape.h"
#include "boomerang/inspect.h"

#endif
