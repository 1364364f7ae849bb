// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_INTERPOSE_SHORT_LIST_H
#define BOOMERANG_INTERPOSE_SHORT_LIST_H

#include <box2d/b2_world_callbacks.h>

#include "real.h"

class b2ContactManager;

namespace bmr::interpose {

/// A world's list of contacts while b2World::SolveTOI is at work, without those that are known to have no
/// impact left. After each event Box2D goes through the list anew; it would pass over those that are missing,
/// and leave them as they are. What is left is in its order, and nobody else sees it: the list is whole while
/// a listener is called or new contacts are looked for.
///
/// No memory beyond itself: the links of those that are left are kept here and put back, the links of the
/// others stay as they are. Where too many are left the list is whole.
class ShortList final : private b2ContactListener {
public:
    /// From here on; the times of impact that are known are marked. To be called in the middle of a step.
    explicit ShortList(b2ContactManager *manager);
    /// Whole again, with the listener that the world has by now.
    ~ShortList() override;
    ShortList(const ShortList &) = delete;
    ShortList &operator=(const ShortList &) = delete;

    /// For as long as this lives, this thread's list for `manager`, if there is one, is whole. Contacts may
    /// be added to it and known times forgotten.
    class Whole {
    public:
        explicit Whole(const b2ContactManager *manager) : m_list(stepping.shortList) {
            if (m_list != nullptr && m_list->m_manager != manager)
                m_list = nullptr;
            if (m_list != nullptr)
                m_list->Suspend();
        }
        ~Whole() {
            if (m_list != nullptr) {
                m_list->Choose();
                m_list->Resume();
            }
        }
        Whole(const Whole &) = delete;
        Whole &operator=(const Whole &) = delete;

    private:
        ShortList *m_list;
    };

private:
    class Pause;

    void BeginContact(b2Contact *contact) override;
    void EndContact(b2Contact *contact) override;
    void PreSolve(b2Contact *contact, const b2Manifold *old) override;
    void PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) override;

    void Choose();
    void Suspend();
    void Resume();
    void Open();
    void Close();

    struct Kept {
        b2Contact *contact, *next;
    };
    // 8 KB of stack. Planks that 300 hexagons lie on keep some 50.
    static constexpr int32 kMost = 512;

    b2ContactManager *m_manager;
    b2ContactListener *m_listener; ///< the world's, at first
    bool m_listens;                ///< whether it is called through this
    bool m_staysWhole = false;     ///< a listener or a filter put another one in its place
    ShortList *m_outer;
    b2Contact *m_first = nullptr; ///< of the whole list
    int32 m_count = 0;            ///< of m_kept; 0 where the list stays whole
    Kept m_kept[kMost];
};

} // namespace bmr::interpose

#endif
