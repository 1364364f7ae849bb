// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SWEEP_APART_H
#define BOOMERANG_GLUE_SWEEP_APART_H

#include <box2d/b2_math.h>

#include "exact32/swept32.h"

struct b2DistanceProxy;
struct b2TOIInput;

namespace bmr {

/// @file
/// Which pairs b2TimeOfImpact cannot find touching. One fixed direction proves it for the whole motion; what
/// Box2D's arithmetic may be off by is left as a margin (thresholds.h). Nothing is remembered.

/// One shape of one body during what is left of a step.
struct SweptShape {
    bmr_swept32 points;
    float radius;   ///< its skin
    float rounding; ///< its part of the margin; infinite where Box2D must answer
    float tilt;     ///< its part of how much an axis may be tilted, times the length of a side
};

/// `rotation` is sweep.a's. A proxy of no points or of more than 8 gets an infinite margin.
SweptShape Sweep(const b2DistanceProxy &proxy, const b2Sweep &sweep, const b2Rot &rotation);

/// Is it certain that b2TimeOfImpact does not say e_touching of these two, for any tMax from 0 to 1?
/// `direction` is a guess, of unit length or zero; it becomes the direction that proves it, if one was found.
bool NeverTouch(const SweptShape &a, const SweptShape &b, bmr_vec32 *direction);

/// Does this very direction, of unit length, prove NeverTouch? No other one is looked for.
bool NeverTouchAlong(const SweptShape &a, const SweptShape &b, bmr_vec32 direction);

/// NeverTouch for an input of b2TimeOfImpact. False where its tMax is not from 0 to 1.
bool NeverTouch(const b2TOIInput &input);

} // namespace bmr

#endif
