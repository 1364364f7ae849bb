// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_HOOKS_TOUCHING_LIST_H
#define BOOMERANG_HOOKS_TOUCHING_LIST_H

#include <box2d/b2_world_callbacks.h>

#include "hooks/stepping.h"
#include "ledger/column.h"

class b2Body;
class b2ContactManager;
struct b2ContactEdge;

namespace bmr {
class Ledger;
}

namespace bmr::hooks {

/// A world's list of contacts and the lists of its bodies while b2World::Solve is at work: only the contacts
/// that touch, in their order. It would look at all others, at each twice, and pass over them. All lists are
/// whole again from the first call of game code on, or when new contacts are looked for.
class TouchingList final : private b2ContactListener, public InChain<TouchingList> {
public:
    /// Makes the lists short where that pays: where few enough of the contacts touch.
    TouchingList(b2ContactManager *manager, b2Body **bodyList, int32 bodyCount, Ledger *ledger);
    ~TouchingList() override;

    /// All lists of this world are whole from here on.
    static void Open(const b2ContactManager *manager);
    /// A listener steps the world whose islands are being built. Contacts that come to touch in that step may
    /// be in islands yet to be built, whatever island of an earlier step they say they are in.
    static void BeginNestedStep(const b2ContactManager *manager);

private:
    struct Kept {
        b2Contact *contact, *next;
        b2ContactEdge *nextOfA, *nextOfB;
    };
    struct Head {
        b2Body *body;
        b2ContactEdge *first;
    };
    /// The thread's; the memory stays for the next step.
    struct Room {
        Column<Kept> kept;
        Column<Head> heads;
        Column<b2Body *> nextBodies; ///< of the awake ones
        bool taken = false;
    };

    void BeginContact(b2Contact *contact) override;
    void EndContact(b2Contact *contact) override;
    void PreSolve(b2Contact *contact, const b2Manifold *old) override;
    void PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) override;

    uint32_t NextAwake(uint32_t end) const;
    bool FindAwake(int32 bodyCount);
    bool FillContacts();
    bool FillBodies();
    void ShortenContacts();
    void ShortenBodies();
    void OpenLists();
    void OpenForGame();

    b2ContactManager *m_manager;
    b2Body **m_bodyList; ///< the world's
    Ledger *m_ledger;
    b2ContactListener *m_listener; ///< the world's
    b2Contact *m_first = nullptr;  ///< of the whole list
    Room *m_room = nullptr;        ///< nullptr: the lists are whole
    b2Body *m_firstBody = nullptr; ///< of the whole list; nullptr: it is whole
    uint32_t m_count = 0, m_headCount = 0;
    bool m_awakeAlone = false; ///< no island comes to a body that is asleep
    bool m_leftOut = false;    ///< those that do not touch, which may still be in islands of an earlier step
};

} // namespace bmr::hooks

#endif
