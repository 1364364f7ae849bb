// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_IMPACT_SCAN_H
#define BOOMERANG_GLUE_IMPACT_SCAN_H

#include <cstdint>

#include "proofs/sweep_apart.h"

class b2Contact;
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

    /// Is it certain that b2TimeOfImpact would not say e_touching of them?
    bool NeverTouch(const b2Contact *contact, const Side &a, const Side &b);

private:
    struct Place {
        const b2Fixture *fixture;
        int32 child;
        uint32_t scan; ///< in which scan it was filled
        SweptShape shape;
    };

    Place &PlaceOf(const Side &side);
    static void Fill(SweptShape *shape, const Side &side);
    const SweptShape &Shape(Place &place, const Side &side);
    /// Of two shapes in one place, and wherever one may be too big for a place.
    bool NeverTouchSpecial(const Side &a, const Side &b, bmr_vec32 *direction);

    // 144 KB a thread that steps worlds. Two shapes that fall on one place take turns.
    static constexpr unsigned kPlaceBits = 10;
    uint32_t m_scan;
    Place m_places[1u << kPlaceBits];
};

} // namespace bmr

#endif
