// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_WHICH_SOLVER_H
#define BOOMERANG_GLUE_WHICH_SOLVER_H

#include <cstdint>

namespace bmr {

/// Who solves islands in our passes with this Box2D's bits.
enum class IslandsBy : uint8_t {
    Nobody, ///< b2World's own passes run: Box2D rounds otherwise than we do, and its b2Island is not reached
    Box2D,  ///< its b2Island, which was compiled with us
    Ours
};

/// Found out once for a process, about 0.2 ms: in a small world of pairs that overlap and of bullets, Box2D's
/// b2World::Solve and SolveTOI and our passes make the same steps. With our solver they end with the same
/// bits unless Box2D was compiled with fused products, or so that its operations may be reordered. Rounding
/// must be to nearest.
IslandsBy WhoSolvesIslands();

} // namespace bmr

#endif
