// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_BOX2D_H
#define BOOMERANG_BOX2D_H

/// @file
/// A game includes this, in C++11 or later. One call before the first step, and nothing else changes:
///
///     #include <box2d/box2d.h>
///     #include <boomerang/box2d.h>
///     bmr::Install();
///
/// Every simulation computes the bits that it computes without it. bmr::ConvexShape is a convex polygon of
/// any number of vertices, bmr::OutlineShape any outline, as a few of these. bmr_error_describe says what is
/// wrong with points that a shape refuses.

#include <box2d/b2_collision.h>

#include "boomerang/box2d_glue.h"
#include "boomerang/convex_shape.h"
#include "boomerang/outline_shape.h"

namespace bmr {
namespace internal {

/// Tells the library which Box2D this program calls, by the address of one of its functions. If the library
/// finds another function by that name, or none, the program has Box2D inside: Install and ConvexShape
/// refuse.
BMR_BOX2D_API bool MeetBox2D(const void *function);

/// Before main, for each source that includes this.
const bool metBox2D = MeetBox2D(reinterpret_cast<const void *>(&b2CollidePolygons));

} // namespace internal
} // namespace bmr

#endif
