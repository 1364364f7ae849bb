// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_ROTATIONS_H
#define BOOMERANG_GLUE_ROTATIONS_H

#include <cstdint>
#include <cstring>

#include <box2d/b2_math.h>
#include <box2d/b2_time_step.h>

#include "base/column.h"

namespace bmr {

/// Sines and cosines of the angles of an island's bodies: computed once for as long as an angle has the same
/// bits. (A contact that is not corrected does not turn its bodies, and statics never turn.)
class Rotations {
public:
    void Reserve(uint32_t bodies) { m_known.Reserve(bodies); }
    void Begin(const b2Position *positions, uint32_t first, uint32_t end) {
        for (uint32_t i = first; i < end; ++i)
            Compute(positions[i].a, &m_known[i]);
    }
    const b2Rot &Of(int32 body, float angle) {
        Known &known = m_known[static_cast<uint32_t>(body)];
        uint32_t bits;
        std::memcpy(&bits, &angle, sizeof bits);
        if (bits != known.bits)
            Compute(angle, &known);
        return known.rotation;
    }

private:
    struct Known {
        uint32_t bits; ///< of the angle
        b2Rot rotation;
    };
    static void Compute(float angle, Known *known) {
        std::memcpy(&known->bits, &angle, sizeof known->bits);
        known->rotation.Set(angle);
    }
    Column<Known> m_known;
};

} // namespace bmr

#endif
