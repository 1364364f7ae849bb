// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_ROUNDING_MODE_H
#define BOOMERANG_GLUE_ROUNDING_MODE_H

#if defined(__SSE2__) && !defined(__EMSCRIPTEN__) // which has lanes, and one mode
#    define BMR_MODE_OF_SSE
#    include <xmmintrin.h>
#else
#    include <cfenv>
#endif

/// @file
/// The mode of this thread's arithmetic. Programs change how it rounds (libraries for intervals do), or let
/// an underflow end them. Every claim of equal bits is made for rounding to nearest, and proofs have
/// underflows of their own. In any other mode Box2D answers.

namespace bmr {

#if defined(BMR_MODE_OF_SSE)

// (std::fegetround asks the other unit, which nothing here computes with.)
using RoundingMode = unsigned;
constexpr RoundingMode kNoSmallTraps = _MM_MASK_UNDERFLOW | _MM_MASK_DENORM | _MM_MASK_INEXACT;
constexpr RoundingMode kToNearest = _MM_ROUND_NEAREST | kNoSmallTraps,
                       kModeBits = _MM_ROUND_MASK | kNoSmallTraps;
inline RoundingMode CurrentRounding() {
    return _mm_getcsr() & kModeBits;
}
inline void RoundBy(RoundingMode mode) {
    _mm_setcsr((_mm_getcsr() & ~kModeBits) | mode);
}
/// Does an operation without a number as its result, a division by zero or an overflow end the program?
inline bool TrapsAreSet() {
    constexpr unsigned kMasks = _MM_MASK_INVALID | _MM_MASK_DIV_ZERO | _MM_MASK_OVERFLOW;
    return (_mm_getcsr() & kMasks) != kMasks;
}

#else

using RoundingMode = int;
constexpr RoundingMode kToNearest = FE_TONEAREST;
inline RoundingMode CurrentRounding() {
    return std::fegetround();
}
inline void RoundBy(RoundingMode mode) {
    std::fesetround(mode);
}
inline bool TrapsAreSet() {
    return false; // those who set them here are not known
}

#endif

/// Does this thread's step round to nearest? It is asked as the step begins, and behind each call of the
/// game's code. False outside of steps that are ours.
inline bool &StepIsToNearest() {
    static thread_local bool nearest = false;
    return nearest;
}

/// Behind a call of the game's code in such a step.
inline void AskRoundingAgain() {
    StepIsToNearest() = StepIsToNearest() && CurrentRounding() == kToNearest;
}

/// (Reading the mode takes as long as a third of what is done for a fixture.)
inline bool RoundsToNearest() {
    return StepIsToNearest() || CurrentRounding() == kToNearest;
}

/// Rounds to nearest as long as it lives: for what is made in one mode and used in another.
class NearestRounding {
public:
    NearestRounding() : m_before(CurrentRounding()) {
        if (m_before != kToNearest)
            RoundBy(kToNearest);
    }
    ~NearestRounding() {
        if (m_before != kToNearest)
            RoundBy(m_before);
    }
    NearestRounding(const NearestRounding &) = delete;
    NearestRounding &operator=(const NearestRounding &) = delete;

private:
    RoundingMode m_before;
};

} // namespace bmr

#endif
