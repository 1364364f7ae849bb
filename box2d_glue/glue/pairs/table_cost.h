// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_TABLE_COST_H
#define BOOMERANG_GLUE_TABLE_COST_H

#include <cstdint>

#include "start/settings.h"

namespace bmr {

/// A pass over a table costs as much as Box2D's loop over so many contacts, whatever the table holds: a
/// game's own work has put its code and memory out of the caches between two steps. Where the plugin is to
/// work everywhere it is not asked what anything costs.
inline int CostOfAPass() {
    return PairsAreHulls() ? 1 : WorksEverywhere() ? 8 : 48;
}

/// Does a pass over the table pay in this world, or is Box2D's way through its list the cheaper one? A world
/// whose pairs move too fast for a deadline, or touch, is stepped by its list for a while, and tried again.
/// Both ways are counted, so that a game is stepped in the same way wherever it runs.
class TableCost {
public:
    /// A step begins. Is it to go by the table? It is not while the table rests, for so many steps.
    bool CountStep() {
        if (m_restingSteps == 0 || WorksEverywhere())
            return true;
        --m_restingSteps;
        return false;
    }
    /// A pass over the table updated so many pairs, and so many fixtures' motions. Of `pairs` so many were
    /// awake.
    void NotePass(uint32_t updates, uint32_t fixtures, uint32_t pairs, uint32_t awake) {
        if (m_triedPasses > 0) { // in the first one every pair is due
            m_costOfTable += static_cast<uint64_t>(CostOfAPass()) + kUpdate * updates + kFixture * fixtures;
            m_costOfList += CostOfList(pairs, awake) + m_searches * uint64_t{pairs} / kSearchesPerUnit;
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
    /// In a step by the world's list so many pairs were awake. If the table would cost less, it is tried in
    /// the next step.
    void NoteList(uint32_t pairs, uint32_t awake) {
        if (static_cast<uint64_t>(CostOfAPass()) + (kUpdate + kFixture) * awake < CostOfList(pairs, awake))
            m_restingSteps = 0;
    }
    /// The earliest impact was searched for.
    void NoteSearch() { ++m_searches; }

private:
    // The unit is what Box2D's loop does for a contact of a body that is awake. The rest was fitted to the
    // times of the testbed's scenes, with every step by the table and with every step by the list.
    static constexpr uint64_t kUpdate = 3;          ///< the table updates a contact, and proves it apart anew
    static constexpr uint64_t kFixture = 1;         ///< the table updates a fixture's motion
    static constexpr uint64_t kSleepersPerUnit = 4; ///< Box2D's loop passes over contacts
    static constexpr uint64_t kSearchesPerUnit = 16; ///< each impact is a pass over Box2D's list
    /// Islands and the first search for impacts walk Box2D's list, too. That costs half a unit for each
    /// contact. A world of more contacts than this does not stay in the processor's caches, and the walks
    /// cost two units.
    static constexpr uint64_t kPairsInCache = 4096;
    static constexpr uint32_t kPassesToTry = 8, kStepsToRest = 256;

    /// What a step by the world's list costs that searches for no impact.
    static uint64_t CostOfList(uint64_t pairs, uint64_t awake) {
        return awake + (pairs - awake) / kSleepersPerUnit + (pairs <= kPairsInCache ? pairs / 2 : 2 * pairs);
    }

    uint32_t m_triedPasses = 0, m_restingSteps = 0;
    uint64_t m_searches = 0, m_costOfTable = 0, m_costOfList = 0;
};

} // namespace bmr

#endif
