// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_OWED_ENABLING_H
#define BOOMERANG_GLUE_OWED_ENABLING_H

#include <cstdint>

#include "base/columns.h"
#include "start/settings.h"

class b2Body;

namespace bmr {

class Ledger;

/// Box2D's loop over contacts enables every active contact that it passes. A contact that our pass did not
/// look at is owed the enabling, and gets it before the first call that could see the difference. In
/// Mode::Verify these contacts are held against Box2D's own answer as they get it.
class OwedEnabling {
public:
    explicit OwedEnabling(const Ledger *ledger) : m_ledger(*ledger) {}
    void Reserve(uint32_t count) { m_looked.Reserve(count); }

    /// From here on all contacts below this are owed it.
    void Begin(uint32_t below) {
        m_below = below;
        m_looked.ClearAll();
    }
    /// Code of the game runs within the loop, which has come down to `down`, and may ask for other code of
    /// the game, or end the loop by an exception: none but the contacts from there on were passed.
    void Pause(uint32_t down) {
        EnableDownTo(down);
        m_below = 0;
    }
    /// The loop goes on.
    void GoOn(uint32_t below) { m_below = below; }
    /// The contact is looked at: from here on its flags are right.
    void NoteLookedAt(uint32_t i) { m_looked.Set(i); }
    /// From the newest that is still owed it down to `down`.
    void EnableDownTo(uint32_t down);
    void EnableIfOwed(uint32_t i);
    /// The body fell asleep after the pass: its contacts stay as they are until it wakes, also in the middle
    /// of a step.
    void EnableOfSleeper(const b2Body *body);
    /// Code of the game is to be called in a step that has a pass, behind it.
    void BeforeGame() {
        EnableDownTo(0);
        m_gameRan = true;
    }
    /// The pass over pairs is complete. Code of the game that ran in this step, or since the last pass, may
    /// have disabled contacts. In Mode::Verify all are enabled.
    void EndPass(bool gameRan);

private:
    bool IsActive(uint32_t i) const;

    const Ledger &m_ledger;
    BitColumn m_looked; ///< looked at in the last pass
    uint32_t m_below = 0;
    bool m_gameRan = false; ///< in the step of the last pass
};

} // namespace bmr

#endif
