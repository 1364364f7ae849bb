// SPDX-License-Identifier: MIT
#include "hooks/short_list.h"

#include <box2d/b2_contact.h>
#include <box2d/b2_contact_manager.h>

#include "hooks/contact_access.h"
#include "ledger/ledger.h"
#include "ledger/per_thread.h"
#include "start/current_step.h"

namespace bmr::hooks {

namespace {

/// Names protected members of b2Contact's. (Nobody asks for the contact before while the list is short.)
struct Links : b2Contact {
    static b2Contact *&Next(b2Contact *contact) { return contact->*(&Links::m_next); }
    static bool HasNoImpact(b2Contact *contact) {
        return (contact->*(&Links::m_flags) & e_toiFlag) != 0 && !(contact->*(&Links::m_toi) < 1.0f);
    }
};

} // namespace

/// While a listener is called the world is as Box2D would have it.
class ShortList::Pause {
public:
    explicit Pause(ShortList *list) : m_list(list) { m_list->Suspend(); }
    ~Pause() { m_list->Resume(); }
    Pause(const Pause &) = delete;
    Pause &operator=(const Pause &) = delete;

private:
    ShortList *m_list;
};

ShortList::ShortList(b2ContactManager *manager, Ledger *ledger, Unchosen)
    : InChain(&stepping.shortList), m_manager(manager), m_ledger(ledger),
      m_listener(manager->m_contactListener), m_listens(IsOfGame(m_listener)), m_room(PerThread<Room>()) {
    if (m_room != nullptr && m_room->taken)
        m_room = nullptr;
    if (m_room != nullptr)
        m_room->taken = true;
}

ShortList::ShortList(b2ContactManager *manager) : ShortList(manager, nullptr, Unchosen()) {
    Choose();
    Close();
}

ShortList::ShortList(b2ContactManager *manager, Ledger *ledger) : ShortList(manager, ledger, Unchosen()) {
    ChooseAsked();
    Close();
}

ShortList::~ShortList() {
    Open();
    if (m_room != nullptr)
        m_room->taken = false;
}

/// False, and none is kept, where there are too many.
inline bool ShortList::Keep(b2Contact *contact) {
    constexpr uint32_t kChoicesToRest = 16;
    if (m_count == kMost) {
        m_count = 0;
        m_choicesToRest = kChoicesToRest;
        return false;
    }
    m_room->kept[m_count++] = {contact, Links::Next(contact)};
    return true;
}

void ShortList::ChooseAsked() {
    m_first = m_manager->m_contactList;
    m_contactCount = m_manager->m_contactCount;
    if (m_room == nullptr)
        return;
    for (uint32_t i = m_ledger->Count(); i-- > 0;)
        if (m_ledger->WasAsked(i) && !Keep(m_ledger->Contact(i)))
            return;
}

/// As Choose. Pairs that may not impact in this step, nearly all in a pile, are not even read.
void ShortList::ChooseByLedger() {
    for (uint32_t i = m_ledger->Count(); i-- > 0;) {
        b2Contact *const contact = m_ledger->Contact(i);
        if (contact != nullptr && !m_ledger->MayNotImpact(i) && !Links::HasNoImpact(contact) &&
            !Keep(contact))
            return;
    }
}

/// Which are kept. The list is whole.
void ShortList::Choose() {
    m_first = m_manager->m_contactList;
    m_contactCount = m_manager->m_contactCount;
    m_count = 0;
    m_changed = false;
    if (m_room == nullptr)
        return;
    if (m_choicesToRest > 0) {
        --m_choicesToRest;
        return;
    }
    if (m_ledger != nullptr && (!GameMayRun() || m_ledger->LeavesOutCarefully()) && m_ledger->CatchUp()) {
        ChooseByLedger();
        return;
    }
    for (b2Contact *contact = m_first; contact != nullptr; contact = Links::Next(contact))
        if (!Links::HasNoImpact(contact) && !Keep(contact))
            return;
}

void ShortList::ChooseAgain(const b2ContactManager *manager) {
    ShortList *const list = Of(manager);
    if (list == nullptr)
        return;
    list->Open();
    list->Choose();
    list->Close();
}

/// As Box2D would have it: the list whole, and the world's own listener. Listeners and filters may call what
/// wants it whole, too (also by a step of this world): it is closed when the last of them is done.
void ShortList::Suspend() {
    if (m_suspensions++ == 0)
        Open();
}

void ShortList::Resume() {
    if (--m_suspensions > 0 || m_staysWhole)
        return;
    if (m_manager->m_contactListener != m_listener) {
        // Box2D hands another listener all but what it is in the middle of: nobody would open the list for
        // it.
        LeaveNothingOut();
        m_staysWhole = true;
        return;
    }
    if (m_ledger != nullptr && m_ledger->LeavesOutCarefully()) {
        m_ledger->LookAtLeftOut();
        m_changed = m_changed || !m_ledger->LeavesOutCarefully();
    }
    // Contacts are made in FindNewContacts alone, which says so. Where none was made, their number tells
    // whether any ended: a listener may put bodies out of the world (b2Body::SetEnabled), and the contacts of
    // these are destroyed, kept ones among them.
    if (m_changed || m_manager->m_contactCount != m_contactCount)
        Choose();
    Close();
}

void ShortList::LeaveNothingOut() {
    if (m_ledger != nullptr)
        m_ledger->LeaveNothingOut();
}

void ShortList::BeginNestedStep(const b2ContactManager *manager) {
    if (ShortList *const list = Of(manager))
        list->LeaveNothingOut();
}

void ShortList::Open() {
    if (m_staysWhole)
        return;
    if (m_manager->m_contactListener == this)
        m_manager->m_contactListener = m_listener;
    if (m_count == 0)
        return;
    m_manager->m_contactList = m_first;
    for (int32 i = 0; i < m_count; ++i)
        Links::Next(m_room->kept[i].contact) = m_room->kept[i].next;
}

void ShortList::Close() {
    if (m_listens)
        m_manager->m_contactListener = this;
    if (m_count == 0)
        return;
    const Kept *const kept = m_room->kept;
    m_manager->m_contactList = kept[0].contact;
    for (int32 i = 0; i + 1 < m_count; ++i)
        Links::Next(kept[i].contact) = kept[i + 1].contact;
    Links::Next(kept[m_count - 1].contact) = nullptr;
}

void ShortList::BeginContact(b2Contact *contact) {
    const Pause pause(this);
    m_listener->BeginContact(contact);
}

void ShortList::EndContact(b2Contact *contact) {
    const Pause pause(this);
    m_listener->EndContact(contact);
}

void ShortList::PreSolve(b2Contact *contact, const b2Manifold *old) {
    if (!HasOwnPreSolve(*m_listener))
        return;
    const Pause pause(this);
    m_listener->PreSolve(contact, old);
}

void ShortList::PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) {
    if (!HasOwnPostSolve(*m_listener))
        return;
    const Pause pause(this);
    m_listener->PostSolve(contact, impulse);
}

} // namespace bmr::hooks
