// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_SWEEP_APART_H
#define BOOMERANG_GLUE_SWEEP_APART_H

#include <cstdint>

#include <box2d/b2_math.h>

#include "exact32/swept32.h"

class b2Fixture;
struct b2DistanceProxy;

namespace bmr {

/// @file
/// Which pairs b2TimeOfImpact cannot find touching. One fixed direction proves it for the whole motion; what
/// Box2D's arithmetic may be off by is left as a margin (thresholds.h). Nothing is remembered.

/// One shape of one body during what is left of a step.
struct SweptShape {
    bmr_swept32 points;
    float radius;   ///< its skin
    float rounding; ///< its part of the margin; infinite where Box2D must answer
    float tilt;     ///< its part of how much an axis may be tilted, times the length of a side
};

/// `rotation` is sweep.a's. A proxy of no points or of more than 8 gets an infinite margin.
SweptShape Sweep(const b2DistanceProxy &proxy, const b2Sweep &sweep, const b2Rot &rotation);

/// Is it certain that b2TimeOfImpact does not say e_touching of these two, for any tMax from 0 to 1?
/// `direction` is a guess, of unit length or zero; it becomes the direction that proves it, if one was found.
bool NeverTouch(const SweptShape &a, const SweptShape &b, bmr_vec32 *direction);

/// Does this very direction, of unit length, prove NeverTouch? No other one is looked for.
bool NeverTouchAlong(const SweptShape &a, const SweptShape &b, bmr_vec32 direction);

/// One search of b2World::SolveTOI: which pairs can touch in what is left of the step? No body moves while it
/// runs. So each shape is placed once for a time that its sweep begins at, however many pairs it is in; and
/// one that lies where it lay in an earlier scan is not placed again.
class ImpactScan {
public:
    /// Begins a scan in this thread's memory, and forgets the one before. nullptr while
    /// the thread ends. Good until the thread begins the next one.
    static ImpactScan *Begin();

    /// One side of a contact. (Box2D keeps the sweep to itself and its friends.)
    struct Side {
        const b2Fixture *fixture;
        int32 child;
        const b2Sweep &sweep;
        const b2Rot &rotation; ///< of sweep.a
    };

    /// Is it certain that b2TimeOfImpact would not say e_touching of them? `guess`: a direction from a to b
    /// that may keep them apart, or zero. If `touching`, the guess is the normal along which they touch, and
    /// no other direction is tried: most pairs that this one does not keep apart do meet.
    bool NeverTouch(const Side &a, const Side &b, bmr_vec32 guess, bool touching);

private:
    /// All that a SweptShape is made of, of a body that stays where it is.
    struct Resting {
        float sweep[8]; ///< b2Sweep's members but alpha0
        b2Rot rotation;
        float radius;
        int32 count; ///< of points; 0: the body moved
        b2Vec2 points[BMR_SWEPT32_MOST];

        bool IsOf(const b2DistanceProxy &proxy, const Side &side) const;
        void Set(const b2DistanceProxy &proxy, const Side &side);
    };
    struct Place {
        const b2Fixture *fixture;
        int32 child;
        uint64_t scan; ///< in which scan it was last asked for
        float from;    ///< b2Sweep::alpha0 then
        SweptShape shape;
        Resting resting;
    };

    // 264 KB a thread that steps worlds. Two shapes that fall on one place take turns.
    static constexpr unsigned kPlaceBits = 9;
    using Places = Place[1u << kPlaceBits];
    const SweptShape &Shape(Places &places, const Side &side) const;

    uint64_t m_scan;
    Places m_ofA, m_ofB;
};

} // namespace bmr

#endif
