// SPDX-License-Identifier: MIT
// b2TimeOfImpact of big polygons, which Box2D's search does not know: it takes no more than 256 vertices.
#include <box2d/b2_time_of_impact.h>

#include "proofs/convex_distance.h"
#include "reach/stock.h"
#include "shapes/convex_geometry.h"

BMR_FOR_LOADERS("_Z14b2TimeOfImpactP11b2TOIOutputPK10b2TOIInput");

void b2TimeOfImpact(b2TOIOutput *output, const b2TOIInput *input) {
    if (!bmr::AnyBigPolygon() || !bmr::BigImpact(output, *input))
        bmr::stock::TimeOfImpact(output, input);
}
