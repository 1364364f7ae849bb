// SPDX-License-Identifier: MIT
// b2ShapeCast where a big polygon is cast or cast at.
#include <box2d/b2_distance.h>

#include "proofs/convex_distance.h"
#include "reach/real.h"

namespace bmr::hooks {

namespace {

Real<bool(b2ShapeCastOutput *, const b2ShapeCastInput *)>
    realShapeCast("_Z11b2ShapeCastP17b2ShapeCastOutputPK16b2ShapeCastInput");

} // namespace

bool ShapeCast(b2ShapeCastOutput *output, const b2ShapeCastInput *input)
    BMR_STANDS_FOR("_Z11b2ShapeCastP17b2ShapeCastOutputPK16b2ShapeCastInput");

bool ShapeCast(b2ShapeCastOutput *output, const b2ShapeCastInput *input) {
    bool hit;
    if (AnyBigPolygon() && BigCast(output, *input, &hit))
        return hit;
    return realShapeCast(output, input);
}

} // namespace bmr::hooks
