// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_BODIES_H
#define BOOMERANG_GLUE_BODIES_H

#include <cstdint>

#include <box2d/b2_body.h>

#include "base/columns.h"

namespace bmr {

/// All bodies of a world, the oldest first: Box2D's list backwards, in one piece of memory, so that one sweep
/// finds who is awake. Box2D walks over its list four times a step, asleep or not.
class Bodies {
public:
    /// Takes in bodies that were made since; begins anew where one has gone. False if it is to be asked
    /// again.
    bool Follow(b2Body *newest, int32 count);
    /// One has gone: the list of bodies is another one.
    void Forget() { m_count = 0; }

    /// Who may be in an island of the step that begins: awake, and not static. Puts all others out of
    /// islands. False, and not tried again for some steps, where too many are awake for a list of their
    /// own to pay.
    bool FindAwake();
    uint32_t AwakeCount() const { return m_awakeCount; }
    /// Newest first.
    b2Body *Awake(uint32_t i) const { return m_awake[i]; }

    /// In this step islands hold only bodies that are awake. Not known, and so not true, until the islands
    /// are solved.
    void SetAlone(bool alone) { m_alone = alone; }
    bool AreAlone() const { return m_alone; }

    /// An impact, or a search of Box2D's own, leaves bodies displaced in their sweeps. (Box2D puts all of
    /// them back as it begins to search: the bodies that are asleep would have to be asked one by one.)
    void NoteDisplaced() { m_displaced = true; }
    void NotePutBack() { m_displaced = false; }
    bool MayBeDisplaced() const { return m_displaced; }

private:
    Column<b2Body *> m_bodies, m_awake;
    uint32_t m_count = 0, m_awakeCount = 0, m_waits = 0;
    bool m_alone = false, m_displaced = true;
};

} // namespace bmr

#endif
