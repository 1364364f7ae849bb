// SPDX-License-Identifier: MIT
#include "proofs/impact_scan.h"

#include <new>

#include <box2d/b2_distance.h>
#include <box2d/b2_fixture.h>

#include "base/per_thread.h"
#include "proofs/convex_distance.h"
#include "shapes/convex_geometry.h"

namespace bmr {

ImpactScan *ImpactScan::Begin() {
    ImpactScan *scan = PerThread<ImpactScan>();
    if (scan != nullptr)
        ++scan->m_scan;
    return scan;
}

inline const SweptShape &ImpactScan::Shape(Places &places, const Side &side) const {
    const uint64_t mixed = (static_cast<uint64_t>(reinterpret_cast<uintptr_t>(side.fixture)) +
                            static_cast<uint64_t>(side.child)) *
                           0x9e3779b97f4a7c15u;
    Place &place = places[mixed >> (64u - kPlaceBits)];
    if (place.fixture != side.fixture || place.child != side.child || place.scan != m_scan) {
        place.fixture = side.fixture;
        place.child = side.child;
        place.scan = m_scan;
        b2DistanceProxy proxy;
        SetProxy(&proxy, *side.fixture->GetShape(), side.child);
        new (&place.shape) SweptShape(Sweep(proxy, side.sweep, side.rotation)); // made in place
    }
    return place.shape;
}

bool ImpactScan::NeverTouch(const Side &a, const Side &b, bmr_vec32 guess, bool touching) {
    bool never;
    if (AnyBigPolygon() && BigNeverTouch({*a.fixture->GetShape(), a.child, a.sweep},
                                         {*b.fixture->GetShape(), b.child, b.sweep}, guess, &never))
        return never;
    const SweptShape &shapeA = Shape(m_ofA, a), &shapeB = Shape(m_ofB, b);
    return touching ? NeverTouchAlong(shapeA, shapeB, guess) : bmr::NeverTouch(shapeA, shapeB, &guess);
}

} // namespace bmr
