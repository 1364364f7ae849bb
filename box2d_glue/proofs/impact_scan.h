// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_IMPACT_SCAN_H
#define BOOMERANG_GLUE_IMPACT_SCAN_H

#include <cstdint>

#include "proofs/sweep_apart.h"

class b2Fixture;

namespace bmr {

/// What b2World::SolveTOI asks first in a step, of all its pairs at once: which can touch? Nobody but the
/// scan runs meanwhile, so a shape is placed once however many pairs it is in.
class ImpactScan {
public:
    /// This thread's, with nothing known; nullptr without memory, and when the thread ends. Good until the
    /// thread begins another.
    static ImpactScan *Begin();

    /// One side of a contact. (Box2D keeps the sweep to itself and its friends.)
    struct Side {
        const b2Fixture *fixture;
        int32 child;
        const b2Sweep &sweep;
        const b2Rot &rotation; ///< of sweep.a
    };

    /// Is it certain that b2TimeOfImpact would not say e_touching of them? `guess`: a direction from a to b
    /// that may keep them apart, or zero. Where `touching`, it is the normal that they touch along, and no
    /// other one is looked for: most of those that are not kept apart by it meet.
    bool NeverTouch(const Side &a, const Side &b, bmr_vec32 guess, bool touching);

private:
    struct Place {
        const b2Fixture *fixture;
        int32 child;
        uint64_t scan; ///< in which scan it was filled
        SweptShape shape;
    };

    // 136 KB a thread that steps worlds. Two shapes that fall on one place take turns.
    static constexpr unsigned kPlaceBits = 9;
    using Places = Place[1u << kPlaceBits];
    const SweptShape &Shape(Places &places, const Side &side) const;

    uint64_t m_scan;
    Places m_ofA, m_ofB;
};

} // namespace bmr

#endif
