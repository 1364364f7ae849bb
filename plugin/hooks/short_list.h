// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_HOOKS_SHORT_LIST_H
#define BOOMERANG_HOOKS_SHORT_LIST_H

#include <box2d/b2_world_callbacks.h>

#include "hooks/stepping.h"

class b2ContactManager;

namespace bmr {
class Ledger;
}

namespace bmr::hooks {

/// A world's list of contacts while b2World::SolveTOI is at work, without the contacts that are known to have
/// no impact left. Box2D goes through the whole list after each impact. It would skip the contacts that are
/// left out here, and change nothing in them. The contacts that are kept stay in Box2D's order. Nobody else
/// sees the short list: it is made whole before a listener is called and before new contacts are looked for.
///
/// `Kept` stores each remaining contact's original link. Opening the list writes these links back; the links
/// of contacts that are left out are never written. The pointers are good as long as no contact comes or
/// goes: after each call of game code, which may destroy contacts, the list is chosen anew if their number
/// has changed, or if FindNewContacts ran. The thread has room for one list's (on the heap: stacks may be
/// small); a list that begins in the midst of another one stays whole, as does one of which too many are
/// left.
class ShortList final : private b2ContactListener, public InChain<ShortList> {
public:
    /// Makes the list short, and writes the times of impact that are known into the contacts. Called in the
    /// middle of a step.
    explicit ShortList(b2ContactManager *manager);
    /// In a world with a ledger: keeps the contacts that the ledger's search for impacts asked for. The times
    /// of impact that are known are written into the contacts when the first impact is found.
    ShortList(b2ContactManager *manager, Ledger *ledger);
    bool IsShort() const { return m_count > 0; }
    /// Chooses the contacts of this thread's list for `manager` anew, if there is such a list: by now the
    /// contacts themselves say what is known, and those are kept that may still have an impact. May be called
    /// while Box2D is at a contact that is kept.
    static void ChooseAgain(const b2ContactManager *manager);
    /// A listener or a filter steps the world whose search for impacts called it.
    static void BeginNestedStep(const b2ContactManager *manager);
    /// Makes the list whole again, and gives the world back the listener that it has by now.
    ~ShortList() override;

    /// For as long as this lives, this thread's list for `manager`, if there is one, is whole. Contacts may
    /// be added to it and known times forgotten.
    class Whole {
    public:
        explicit Whole(const b2ContactManager *manager) : m_list(Of(manager)) {
            if (m_list != nullptr)
                m_list->Suspend();
        }
        ~Whole() {
            if (m_list != nullptr) {
                m_list->m_changed = true;
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

    /// The newest for this manager, or nullptr.
    static ShortList *Of(const b2ContactManager *manager) {
        ShortList *list = stepping.shortList == nullptr ? nullptr : stepping.shortList->Object();
        while (list != nullptr && list->m_manager != manager)
            list = list->Older();
        return list;
    }

    void BeginContact(b2Contact *contact) override;
    void EndContact(b2Contact *contact) override;
    void PreSolve(b2Contact *contact, const b2Manifold *old) override;
    void PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) override;

    struct Unchosen {};
    ShortList(b2ContactManager *manager, Ledger *ledger, Unchosen);
    void Choose();
    void ChooseAsked();
    void ChooseByLedger();
    bool Keep(b2Contact *contact);
    void LeaveNothingOut();
    void Suspend();
    void Resume();
    void Open();
    void Close();

    struct Kept {
        b2Contact *contact, *next;
    };
    // Planks that 300 hexagons lie on keep some 50.
    static constexpr int32 kMost = 512;
    /// 8 KB a thread that steps worlds.
    struct Room {
        bool taken;
        Kept kept[kMost];
    };

    b2ContactManager *m_manager;
    Ledger *m_ledger;              ///< nullptr: the world has none, or it is not asked
    b2ContactListener *m_listener; ///< the world's, at first
    bool m_listens;                ///< whether it is called through this
    bool m_staysWhole = false;     ///< a listener or a filter put another one in its place
    bool m_changed = false;        ///< contacts may have come and gone since they were chosen
    int32 m_suspensions = 0;       ///< that have not ended; the list is whole while there are any
    b2Contact *m_first = nullptr;  ///< of the whole list
    int32 m_contactCount = 0;      ///< of the whole list, when it was chosen from
    uint32_t m_choicesToRest = 0;  ///< the list stays whole so many times: too many were kept the last time
    int32 m_count = 0;             ///< of those that are kept; 0 where the list stays whole
    Room *m_room;                  ///< nullptr: none is left, and the list stays whole
};

} // namespace bmr::hooks

#endif
