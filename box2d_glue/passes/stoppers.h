// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_STOPPERS_H
#define BOOMERANG_GLUE_STOPPERS_H

#include <cstdint>

#include "base/column.h"

class b2Body;
class b2Contact;
class b2World;

namespace bmr {

/// Is nothing to tunnel through it?
bool Stops(const b2Body *body);

/// The contacts of the world's list that may have an impact, if one of their bodies is awake. The first
/// search of the list in a step writes them down, and later ones look at these: in a pile they are one in
/// a hundred.
class Stoppers {
public:
    /// `room` is where they are written down.
    Stoppers(const b2World *world, Column<b2Contact *> *room) : m_world(world), m_room(room) {}

    /// False where the list is to be searched.
    bool AreKnown() const;
    uint32_t Count() const { return m_count; }
    b2Contact *operator[](uint32_t i) const { return (*m_room)[i]; }

    /// A search of the list begins.
    void Begin();
    void Add(b2Contact *contact) {
        if (m_known)
            (*m_room)[m_count++] = contact;
    }

    // The world is locked while listeners are called in an impact: they can make bullets and sensors. A step
    // inside this one unlocks it, unless an exception ends that step.
    void BeforeGame();
    /// Ahead of the search for new contacts.
    void AfterGame();
    void Forget() { m_known = false; }

private:
    uint64_t Digest() const;

    const b2World *m_world;
    Column<b2Contact *> *m_room;
    bool m_known = false, m_hasDigest = false;
    uint32_t m_count = 0;
    int32_t m_contactCount = 0;
    uint64_t m_step = 0; ///< LatestStep, as the search began
    const b2Contact *m_newest = nullptr;
    uint64_t m_digest = 0;
};

} // namespace bmr

#endif
