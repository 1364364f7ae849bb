// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PAIR_RECORD_H
#define BOOMERANG_GLUE_PAIR_RECORD_H

#include <cstdint>

namespace bmr {

/// The bits of a pair.
enum RecordBit : uint8_t {
    kHasLine = 1,       ///< its line renews the deadline
    kToBeFiltered = 2,  ///< Box2D has flagged it for filtering
    kNoImpactProof = 4, ///< its budget says nothing of impacts
};

struct PairRecord {
    uint32_t deadline; ///< core/budget: due once the sums of the two movers reach it
    uint32_t a, b;     ///< movers of the contact's fixtures A and B
};

} // namespace bmr

#endif
