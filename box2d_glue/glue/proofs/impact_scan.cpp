// SPDX-License-Identifier: MIT
#include "glue/proofs/impact_scan.h"

#include <cstddef>
#include <cstring>
#include <new>

#include <box2d/b2_distance.h>
#include <box2d/b2_fixture.h>

#include "base/per_thread.h"
#include "glue/proofs/convex_distance.h"
#include "shapes/convex_geometry.h"

namespace bmr {

ImpactScan *ImpactScan::Begin() {
    ImpactScan *scan = PerThread<ImpactScan>();
    if (scan != nullptr)
        ++scan->m_scan;
    return scan;
}

namespace {

bool Stays(const b2Sweep &sweep) {
    return sweep.c0 == sweep.c && sweep.a0 == sweep.a;
}

} // namespace

inline bool ImpactScan::Resting::IsOf(const b2DistanceProxy &proxy, const Side &side) const {
    static_assert(offsetof(b2Sweep, alpha0) == sizeof sweep);
    // All of them are floats without padding, and the same bits make the same shape.
    return count == proxy.m_count && radius == proxy.m_radius &&
           // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
           std::memcmp(sweep, &side.sweep, sizeof sweep) == 0 &&
           // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
           std::memcmp(&rotation, &side.rotation, sizeof rotation) == 0 &&
           std::memcmp(points, proxy.m_vertices, static_cast<size_t>(count) * sizeof *points) == 0;
}

inline void ImpactScan::Resting::Set(const b2DistanceProxy &proxy, const Side &side) {
    count = 0;
    if (proxy.m_count > BMR_SWEPT32_MOST || !Stays(side.sweep))
        return;
    count = proxy.m_count;
    radius = proxy.m_radius;
    std::memcpy(sweep, &side.sweep, sizeof sweep);
    rotation = side.rotation;
    std::memcpy(points, proxy.m_vertices, static_cast<size_t>(count) * sizeof *points);
}

inline const SweptShape &ImpactScan::Shape(Places &places, const Side &side) const {
    const uint64_t mixed = (static_cast<uint64_t>(reinterpret_cast<uintptr_t>(side.fixture)) +
                            static_cast<uint64_t>(side.child)) *
                           0x9e3779b97f4a7c15u;
    Place &place = places[mixed >> (64u - kPlaceBits)];
    if (place.fixture == side.fixture && place.child == side.child && place.scan == m_scan)
        return place.shape;
    b2DistanceProxy proxy;
    SetProxy(&proxy, *side.fixture->GetShape(), side.child);
    if (place.resting.count == 0 || !place.resting.IsOf(proxy, side)) {
        new (&place.shape) SweptShape(Sweep(proxy, side.sweep, side.rotation)); // made in place
        place.resting.Set(proxy, side);
    }
    place.fixture = side.fixture;
    place.child = side.child;
    place.scan = m_scan;
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
