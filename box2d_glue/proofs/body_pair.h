// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_BODY_PAIR_H
#define BOOMERANG_GLUE_BODY_PAIR_H

#include <cstddef>
#include <cstdint>

#include <box2d/b2_math.h>

#include "boomerang/pair.h"
#include "proofs/hull.h"

namespace bmr {

/// The kinetic structure of two hulls, shared by all contacts between their bodies: it answers once for each
/// pair of poses, however many contacts ask. The first cache line is the kinetic pair (all that a check
/// needs), the second what the glue adds.
struct alignas(64) BodyPair {
    bmr_pair kinetic;

    b2Transform poseA, poseB; ///< where `verdict` was found
    Hull *a, *b;
    int32_t references; ///< contacts that use it
    /// Goes up whenever a hull was rebuilt. A contact whose own stamp differs must show again that the hulls
    /// hold its fixtures.
    uint32_t stamp;
    float radiusSum;  ///< radii that `margin` was made for
    uint8_t verdict;  ///< bmr_answer at poseA, poseB
    uint8_t patience; ///< log2 of how many new poses go by unasked after the next stab
    uint8_t unasked;  ///< how many still do
    uint8_t offset;   ///< bytes from the block's start to this object

    BodyPair *parent; ///< of a pair of fixtures: the pair of their bodies, asked first; else nullptr
};
static_assert(offsetof(BodyPair, parent) <= 128, "two cache lines, and one that only pairs of fixtures use");

/// Takes over one reference to each hull, and one to `parent` (may be nullptr). Has no contact of its own
/// yet.
BodyPair *CreateBodyPair(Hull *a, Hull *b, BodyPair *parent, b2BlockAllocator *allocator);
/// Gives one reference back; the last one frees the pair and its references to the hulls and the parent.
void ReleaseBodyPair(BodyPair *pair, b2BlockAllocator *allocator);
/// After a hull was rebuilt: forgets all that was known and makes contacts show their fixtures again.
void ResetBodyPair(BodyPair *pair);

/// Are the hulls farther apart than ContactMargin at these poses of a's and b's body? Answers from the last
/// verdict where the poses are the same to the bit. "Known apart" is certain; anything else says nothing.
bool KnownApart(BodyPair *pair, const b2Transform &poseA, const b2Transform &poseB);

/// A lower bound of the distance between the hulls; 0 where none is proved. Leaves the pair as it is.
double CertifiedGap(const BodyPair &pair, const b2Transform &poseA, const b2Transform &poseB);

/// The kinetic pair as a question at these poses would leave it, and what its certificate proves there (a
/// lower bound as above; 0: not known to be apart). Leaves the pair as it is.
bmr_pair KineticPairAt(const BodyPair &pair, const b2Transform &poseA, const b2Transform &poseB, double *gap);

} // namespace bmr

#endif
