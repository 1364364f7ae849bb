// SPDX-License-Identifier: MIT
// b2DistanceProxy::Set of a shape: a big polygon's proxy is that of all its vertices. What is asked of it
// goes through the functions that distance.cpp, shape_cast.cpp and time_of_impact.cpp stand in front of.
#include <box2d/b2_distance.h>

#include "proofs/convex_distance.h"
#include "reach/real.h"
#include "start/settings.h"

namespace bmr::hooks {

namespace {

Real<void(b2DistanceProxy *, const b2Shape *, int32)> realSet("_ZN15b2DistanceProxy3SetEPK7b2Shapei");

} // namespace

void SetProxy(b2DistanceProxy *proxy, const b2Shape *shape, int32 child)
    BMR_STANDS_FOR("_ZN15b2DistanceProxy3SetEPK7b2Shapei");

void SetProxy(b2DistanceProxy *proxy, const b2Shape *shape, int32 child) {
    // (Shapes of a Box2D that is none we know are not ours to read.)
    if (!(AnyHookIsOn() || AnyBigPolygon()) || !SetCommonProxy(proxy, *shape))
        realSet(proxy, shape, child);
}

} // namespace bmr::hooks
