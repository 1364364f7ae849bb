// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_DEFERRED_ENABLE_H
#define BOOMERANG_GLUE_DEFERRED_ENABLE_H

#include <cstdint>

#include "base/columns.h"

class b2Body;

namespace bmr {

class PairTable;

/// Box2D's loop over contacts enables every active contact that it passes. The pass over pairs does not read
/// most of them. It defers the enabling, and does it before code of the game could see the difference. In
/// Mode::Verify these contacts are compared with Box2D's own answer as they are enabled.
class DeferredEnable {
public:
    explicit DeferredEnable(const PairTable *table) : m_table(*table) {}
    void Reserve(uint32_t count) { m_updated.Reserve(count); }

    /// A pass begins: all contacts below this are deferred.
    void Begin(uint32_t below) {
        m_below = below;
        m_updated.ClearAll();
        m_gameRanBefore = m_gameRan;
        m_gameRan = false;
    }
    /// Numbers change, or Box2D's list enables what is passed: no contact is deferred.
    void Forget() { m_below = 0; }
    /// Code of the game runs within the pass, which has come down to `down`, and may ask for other code of
    /// the game, or end the pass by an exception: none but the contacts from there on were passed.
    void Flush(uint32_t down) {
        EnableDownTo(down);
        m_below = 0;
    }
    /// The pass goes on.
    void Resume(uint32_t below) { m_below = below; }
    /// The contact is updated: from here on its flags are right.
    void NoteUpdated(uint32_t i) { m_updated.Set(i); }
    /// From the newest that is deferred down to `down`.
    void EnableDownTo(uint32_t down);
    void EnableIfDeferred(uint32_t i);
    /// The body fell asleep after the pass: its contacts stay as they are until it wakes, also in the middle
    /// of a step.
    void EnableOfSleeper(const b2Body *body);
    /// The pass over pairs is complete. Code of the game that ran in this step, or since the last pass, may
    /// have disabled contacts. In Mode::Verify all are enabled.
    void EndPass();

    /// Code of the game is to be called in a step that has a pass, behind it.
    void BeforeGame() {
        EnableDownTo(0);
        m_gameRan = true;
    }
    /// Code of the game runs, or did.
    void NoteGame() { m_gameRan = true; }
    /// Did it, since the last pass began? What was read of the world before may then be another by now.
    bool GameRan() const { return m_gameRan; }

private:
    bool IsActive(uint32_t i) const;

    const PairTable &m_table;
    BitColumn m_updated; ///< in the last pass
    uint32_t m_below = 0;
    bool m_gameRan = true, m_gameRanBefore = true; ///< since the last pass began; and before, since another
};

} // namespace bmr

#endif
