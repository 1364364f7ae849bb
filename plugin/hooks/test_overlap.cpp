// SPDX-License-Identifier: MIT
// b2TestOverlap: in a step (of sensors), answered where the answer is certain.
#include <box2d/b2_collision.h>

#include "hooks/stepping.h"
#include "proofs/overlap.h"
#include "reach/real.h"
#include "start/settings.h"
#include "tell/verify.h"

namespace bmr::hooks {

namespace {

Real<bool(const b2Shape *, int32, const b2Shape *, int32, const b2Transform &, const b2Transform &)>
    realTestOverlap("_Z13b2TestOverlapPK7b2ShapeiS1_iRK11b2TransformS4_");

} // namespace

bool TestOverlap(const b2Shape *shapeA, int32 indexA, const b2Shape *shapeB, int32 indexB,
                 const b2Transform &xfA, const b2Transform &xfB)
    BMR_STANDS_FOR("_Z13b2TestOverlapPK7b2ShapeiS1_iRK11b2TransformS4_");

bool TestOverlap(const b2Shape *shapeA, int32 indexA, const b2Shape *shapeB, int32 indexB,
                 const b2Transform &xfA, const b2Transform &xfB) {
    if (NothingIsInstalled())
        return realTestOverlap(shapeA, indexA, shapeB, indexB, xfA, xfB);
    if (!HookIsOn(Hook::TestOverlap) || !InStep())
        return realTestOverlap(shapeA, indexA, shapeB, indexB, xfA, xfB);
    Count(&Counts::overlapQueries);
    const Overlap answer = CertainOverlap(*shapeA, indexA, *shapeB, indexB, xfA, xfB);
    if (answer == Overlap::kUnknown)
        return realTestOverlap(shapeA, indexA, shapeB, indexB, xfA, xfB);
    Count(&Counts::overlapsAnswered);
    const bool overlap = answer == Overlap::kOverlapping;
    if (!Verifying())
        return overlap;
    const bool box2d = realTestOverlap(shapeA, indexA, shapeB, indexB, xfA, xfB);
    VerifyOverlap(nullptr, nullptr, overlap, box2d);
    return box2d;
}

} // namespace bmr::hooks
