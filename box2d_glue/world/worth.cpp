// SPDX-License-Identifier: MIT
// Does a pass over pairs pay in this world, or is Box2D's way through its list the cheaper one?
#include "start/settings.h"
#include "world/ledger.h"

namespace bmr {

namespace {
constexpr uint32_t kPassesToTry = 32, kStepsToRest = 8 * kPassesToTry;
} // namespace

bool Ledger::NextStepPays() {
    if (m_restingSteps == 0 || WorksEverywhere())
        return true;
    --m_restingSteps;
    return m_passes > 0;
}

void Ledger::NoteList(uint32_t awake, uint32_t touching) {
    constexpr uint32_t kStepsUntilLookedFor = 16, kNearlyAll = 8;
    if (!MostOf(uint64_t{kNearlyAll} / 2 * awake))
        m_restingSteps = 0;
    else if (MostOf(touching) && m_restingSteps < kStepsUntilLookedFor)
        m_restingSteps = kStepsUntilLookedFor;
}

void Ledger::NoteLooks(uint32_t looks, uint32_t touching) {
    const bool mostTouch = MostOf(touching); // then 32 passes would find the same
    m_triedLooks += looks;
    m_triedPairs += static_cast<uint64_t>(m_live); // Box2D passes over those that sleep, too
    if (++m_triedPasses < kPassesToTry && !mostTouch)
        return;
    if (mostTouch || 2 * m_triedLooks > m_triedPairs)
        m_restingSteps = kStepsToRest;
    m_triedPasses = 0;
    m_triedLooks = m_triedPairs = 0;
}

} // namespace bmr
