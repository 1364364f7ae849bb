// SPDX-License-Identifier: MIT
#include "proofs/impact_scan.h"

#include <new>

#include <box2d/b2_distance.h>
#include <box2d/b2_fixture.h>

#include "ledger/pair_memory.h"
#include "ledger/per_thread.h"
#include "proofs/convex_distance.h"
#include "shapes/convex_geometry.h"

namespace bmr {

ImpactScan *ImpactScan::Begin() {
    ImpactScan *scan = PerThread<ImpactScan>();
    if (scan != nullptr &&
        ++scan->m_scan == 0) { // four billion steps later no place may seem filled in this one
        for (Place &place : scan->m_places)
            place.scan = 0;
        scan->m_scan = 1;
    }
    return scan;
}

ImpactScan::Place &ImpactScan::PlaceOf(const Side &side) {
    const uint64_t mixed = (KeyOf(side.fixture) + static_cast<uint64_t>(side.child)) * 0x9e3779b97f4a7c15u;
    return m_places[mixed >> (64u - kPlaceBits)];
}

void ImpactScan::Fill(SweptShape *shape, const Side &side) {
    b2DistanceProxy proxy;
    SetProxy(&proxy, *side.fixture->GetShape(), side.child);
    new (shape) SweptShape(Sweep(proxy, side.sweep, side.rotation)); // made in place, not copied there
}

inline const SweptShape &ImpactScan::Shape(Place &place, const Side &side) {
    if (place.fixture != side.fixture || place.child != side.child || place.scan != m_scan) {
        place.fixture = side.fixture;
        place.child = side.child;
        place.scan = m_scan;
        Fill(&place.shape, side);
    }
    return place.shape;
}

bool ImpactScan::NeverTouchSpecial(const Side &a, const Side &b, bmr_vec32 *direction) {
    bool never;
    if (AnyBigPolygon() && BigNeverTouch({*a.fixture->GetShape(), a.child, a.sweep},
                                         {*b.fixture->GetShape(), b.child, b.sweep}, direction, &never))
        return never;
    const SweptShape &shapeA = Shape(PlaceOf(a), a);
    Place &placeB = PlaceOf(b);
    if (&placeB != &PlaceOf(a))
        return bmr::NeverTouch(shapeA, Shape(placeB, b), direction);
    SweptShape shapeB;
    Fill(&shapeB, b);
    return bmr::NeverTouch(shapeA, shapeB, direction);
}

bool ImpactScan::NeverTouch(const b2Contact *contact, const Side &a, const Side &b) {
    PairMemory *memory = Remember(KeyOf(contact), 0);
    if (memory == nullptr)
        return false;
    // A pair that is asked for has Box2D look at all others, too: so none rests after a miss or two.
    constexpr unsigned kMisses = 2;
    return SeekUnlessResting(memory, kMisses, [this, &a, &b, memory] {
        Place &placeA = PlaceOf(a), &placeB = PlaceOf(b);
        if (&placeA == &placeB || AnyBigPolygon())
            return NeverTouchSpecial(a, b, &memory->direction);
        const SweptShape &shapeA = Shape(placeA, a);
        return bmr::NeverTouch(shapeA, Shape(placeB, b), &memory->direction);
    });
}

} // namespace bmr
