// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PROOF_REST_H
#define BOOMERANG_GLUE_PROOF_REST_H

#include <cstdint>

#include "start/settings.h"

namespace bmr {

/// Are proofs to be sought at all? Where too many of the last ones were sought in vain, what they cost is not
/// saved elsewhere: then none are for a while. No answer hangs on it.
class ProofRest {
public:
    bool IsOver() {
        if (m_left == 0 || WorksEverywhere())
            return true;
        --m_left;
        return false;
    }
    /// Of so many proofs so many were in vain. If that is too much, IsOver() says no the next `rest` times.
    void Note(uint32_t sought, uint32_t inVain, uint32_t rest) {
        constexpr uint32_t kEnoughToTell = 32, kMostInVainOf = 3;
        m_sought += sought;
        m_inVain += inVain;
        if (m_sought < kEnoughToTell)
            return;
        if (kMostInVainOf * m_inVain > m_sought)
            m_left = rest;
        m_sought = m_inVain = 0;
    }

private:
    uint32_t m_sought = 0, m_inVain = 0, m_left = 0;
};

} // namespace bmr

#endif
