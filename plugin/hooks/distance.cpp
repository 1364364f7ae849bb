// SPDX-License-Identifier: MIT
// b2Distance where a big polygon is asked about. (b2TestOverlap asks here too.)
#include <box2d/b2_distance.h>

#include "proofs/convex_distance.h"
#include "reach/real.h"

namespace bmr::hooks {

namespace {

Real<void(b2DistanceOutput *, b2SimplexCache *, const b2DistanceInput *)>
    realDistance("_Z10b2DistanceP16b2DistanceOutputP14b2SimplexCachePK15b2DistanceInput");

} // namespace

void Distance(b2DistanceOutput *output, b2SimplexCache *cache, const b2DistanceInput *input)
    BMR_STANDS_FOR("_Z10b2DistanceP16b2DistanceOutputP14b2SimplexCachePK15b2DistanceInput");

void Distance(b2DistanceOutput *output, b2SimplexCache *cache, const b2DistanceInput *input) {
    if (__builtin_expect(AnyBigPolygon(), 0) && BigDistance(output, cache, *input))
        return;
    realDistance(output, cache, input);
}

} // namespace bmr::hooks
