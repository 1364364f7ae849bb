// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_BODIES_H
#define BOOMERANG_GLUE_BODIES_H

#include <cstdint>

#include <box2d/b2_body.h>

#include "base/columns.h"
#include "base/compiler.h"
#include "base/private_members.h"

namespace bmr {

inline bool IsActive(const b2Body *body) {
    return body->IsAwake() && body->GetType() != b2_staticBody;
}
/// Nothing is to tunnel through it.
inline bool IsBulletOrStatic(const b2Body *body) {
    return body->IsBullet() || body->GetType() != b2_dynamicBody;
}

/// All bodies of a world, the oldest first: Box2D's list backwards, in one piece of memory, so that one sweep
/// finds who is awake. Box2D walks over its list four times a step, asleep or not.
class Bodies {
public:
    /// Who may be in an island of the step that begins: awake, and not static. Puts all others out of
    /// islands. False, and not tried again for some steps, where the list of bodies is another one, or too
    /// many are awake for a list of their own to pay. `newest` of `count` bodies begins Box2D's list.
    bool FindAwake(b2Body *newest, int32 count);
    uint32_t AwakeCount() const { return m_awakeCount; }
    /// Newest first.
    b2Body *Awake(uint32_t i) const { return m_awake[i]; }

    /// In this step islands hold only bodies that are awake. Not known, and so not true, until the islands
    /// are solved.
    void SetOnlyAwakeInIslands(bool only) { m_onlyAwakeInIslands = only; }
    bool OnlyAwakeInIslands() const { return m_onlyAwakeInIslands; }

    /// An impact, or a search of Box2D's own, leaves bodies displaced in their sweeps. (Box2D puts all of
    /// them back as it begins to search: the bodies that are asleep would have to be asked one by one.)
    void NoteDisplaced() { m_displaced = true; }
    void NotePutBack() { m_displaced = false; }
    bool MayBeDisplaced() const { return m_displaced; }

private:
    void ReadList(b2Body *newest, uint32_t count);

    // In smaller worlds there is nothing to be gained; and where more than an eighth of the bodies is awake,
    // their own simulation is what a step costs.
    static constexpr uint32_t kFewBodies = 256, kMostAwakeOf = 8, kStepsToWait = 32;

    Column<b2Body *> m_bodies, m_awake;
    uint32_t m_count = 0, m_awakeCount = 0, m_waits = 0;
    bool m_onlyAwakeInIslands = false, m_displaced = true;
};

inline void Bodies::ReadList(b2Body *newest, uint32_t count) {
    m_bodies.Reserve(count);
    m_count = count;
    for (b2Body *body = newest; count > 0 && body != nullptr; body = body->*Named(NextBody()))
        m_bodies[--count] = body;
}

inline bool Bodies::FindAwake(b2Body *newest, int32 count) {
    constexpr uint32_t kAhead = 8;
    const auto wanted = static_cast<uint32_t>(count);
    m_awakeCount = 0;
    if (wanted < kFewBodies || (m_waits > 0 && m_waits-- > 0))
        return false;
    if (m_count != wanted)
        ReadList(newest, wanted);
    const uint32_t most = m_count / kMostAwakeOf;
    m_awake.Reserve(most + 1);
    const b2Body *next = newest;
    for (uint32_t i = m_count; i-- > 0;) {
        if (i >= kAhead) { // its flags, and its link: they lie in two lines of the cache
            BMR_PREFETCH(m_bodies[i - kAhead]);
            BMR_PREFETCH(&(m_bodies[i - kAhead]->*Named(NextBody())));
        }
        b2Body *const body = m_bodies[i];
        if (body != next) { // some have gone, and others were made
            m_count = 0;
            return false;
        }
        next = body->GetNext();
        if (BodyInIsland::Is(body))
            BodyInIsland::Clear(body);
        if (!IsActive(body))
            continue;
        if (m_awakeCount == most) {
            m_waits = kStepsToWait;
            return false;
        }
        m_awake[m_awakeCount++] = body;
    }
    return true;
}

} // namespace bmr

#endif
