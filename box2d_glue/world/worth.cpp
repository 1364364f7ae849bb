// SPDX-License-Identifier: MIT
// Does a pass over the table pay in this world, or is Box2D's way through its list the cheaper one? Both are
// counted, so that a game is stepped in the same way wherever it runs.
#include "start/settings.h"
#include "world/ledger.h"

namespace bmr {

namespace {

// The unit is what Box2D's loop does for a contact of a body that is awake. The rest was fitted to the times
// of the testbed's scenes, with every step by the table and with every step by the list.
constexpr uint64_t kLook = 3;            ///< the table brings a contact up to date, and proves it apart anew
constexpr uint64_t kMover = 1;           ///< the table follows a fixture
constexpr uint64_t kSleepersPerUnit = 4; ///< Box2D's loop passes over contacts
constexpr uint64_t kSearchesPerUnit = 8; ///< for each impact Box2D passes over all contacts once more
constexpr uint32_t kPassesToTry = 8, kStepsToRest = 256;

} // namespace

bool Ledger::NextStepPays() {
    if (m_restingSteps == 0 || WorksEverywhere())
        return true;
    --m_restingSteps;
    return false;
}

void Ledger::NoteList(uint32_t awake) {
    if (8 * static_cast<uint64_t>(awake) < static_cast<uint64_t>(m_live))
        m_restingSteps = 0;
}

void Ledger::NoteLooks(uint32_t looks) {
    const auto pairs = static_cast<uint64_t>(m_live), awake = static_cast<uint64_t>(m_watched);
    if (m_triedPasses > 0) { // in the first one every pair is due
        m_costOfTable += kLook * looks + kMover * m_followed;
        m_costOfList += awake + (pairs - awake) / kSleepersPerUnit + m_searches * pairs / kSearchesPerUnit;
    }
    m_searches = 0;
    if (m_triedPasses++ < kPassesToTry)
        return;
    if (m_costOfTable > m_costOfList) {
        m_restingSteps = kStepsToRest;
        m_triedPasses = 0;
    } else
        m_triedPasses = 1;
    m_costOfTable = m_costOfList = 0;
}

} // namespace bmr
