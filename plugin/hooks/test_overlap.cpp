// SPDX-License-Identifier: MIT
// b2TestOverlap: in a step (of sensors), answered where the answer is certain.
#include <box2d/b2_collision.h>

#include "base/rounding_mode.h"
#include "proofs/overlap.h"
#include "reach/stock.h"
#include "start/current_step.h"
#include "start/settings.h"
#include "tell/verify.h"

using namespace bmr;

BMR_FOR_LOADERS("_Z13b2TestOverlapPK7b2ShapeiS1_iRK11b2TransformS4_");

bool b2TestOverlap(const b2Shape *shapeA, int32 indexA, const b2Shape *shapeB, int32 indexB,
                   const b2Transform &xfA, const b2Transform &xfB) {
    if (NothingIsInstalled())
        return stock::TestOverlap(shapeA, indexA, shapeB, indexB, xfA, xfB);
    if (!PassesRun() || CurrentStep() == 0 || !RoundsToNearest())
        return stock::TestOverlap(shapeA, indexA, shapeB, indexB, xfA, xfB);
    const Overlap answer =
        OverlapWasAsked() ? Overlap::kUnknown : CertainOverlap(*shapeA, indexA, *shapeB, indexB, xfA, xfB);
    OverlapWasAsked() = false;
    if (answer == Overlap::kUnknown)
        return stock::TestOverlap(shapeA, indexA, shapeB, indexB, xfA, xfB);
    Count(&Counts::overlapsAnswered);
    const bool overlap = answer == Overlap::kOverlapping;
    if (!Verifying())
        return overlap;
    const bool box2d = stock::TestOverlap(shapeA, indexA, shapeB, indexB, xfA, xfB);
    VerifyOverlap(nullptr, nullptr, overlap, box2d);
    return box2d;
}
