// SPDX-License-Identifier: MIT
#include "hooks/touching_list.h"

#include <initializer_list>

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_contact_manager.h>
#include <box2d/b2_joint.h>

#include "hooks/contact_access.h"
#include "ledger/ledger.h"
#include "ledger/per_thread.h"
#include "ledger/private_members.h"
#include "start/current_step.h"

namespace bmr::hooks {

namespace {

// With more of them the relinking costs what it saves.
constexpr uint32_t kMostTouchingOf = 3;

/// Names protected members of b2Contact's. (Nobody asks for what comes before a contact while lists are
/// short.)
struct Nodes : b2Contact {
    static b2Contact *&Next(b2Contact *contact) { return contact->*(&Nodes::m_next); }
    static b2ContactEdge &OfA(b2Contact *contact) { return contact->*(&Nodes::m_nodeA); }
    static b2ContactEdge &OfB(b2Contact *contact) { return contact->*(&Nodes::m_nodeB); }
};

b2ContactEdge *&ListOf(b2Body *body) {
    return body->*Named(ContactList());
}

} // namespace

TouchingList::TouchingList(b2ContactManager *manager, b2Body **bodyList, int32 bodyCount, Ledger *ledger)
    : InChain(&stepping.touchingList), m_manager(manager), m_bodyList(bodyList), m_ledger(ledger),
      m_listener(manager->m_contactListener) {
    m_room = PerThread<Room>();
    if (m_room == nullptr || m_room->taken) {
        m_room = nullptr;
        return;
    }
    m_awakeAlone = FindAwake(bodyCount);
    if (!FillContacts() || (m_awakeAlone && !FillBodies())) {
        m_room = nullptr;
        return;
    }
    m_room->taken = true;
    m_leftOut = true;
    ShortenContacts();
    if (m_awakeAlone)
        ShortenBodies();
    if (IsOfGame(m_listener))
        m_manager->m_contactListener = this;
}

TouchingList::~TouchingList() {
    OpenLists();
}

/// The newest contact below `end` that touches and has a body that is awake.
uint32_t TouchingList::NextAwake(uint32_t end) const {
    while (end > 0) {
        const uint32_t i = m_ledger->SkipResting(end - 1);
        if (i == Ledger::kNone || (m_ledger->Bits(i) & kTouches) != 0)
            return i;
        end = i;
    }
    return Ledger::kNone;
}

/// Are nearly all bodies asleep, and will they be after Box2D has built its islands?
bool TouchingList::FindAwake(int32 bodyCount) {
    Bodies &bodies = m_ledger->GetBodies();
    if (!bodies.Follow(*m_bodyList, bodyCount) || !bodies.FindAwake())
        return false;
    const auto sleeps = [](const b2Body *body) {
        return body->GetType() != b2_staticBody && !body->IsAwake();
    };
    // Woken by code of the game, or in the midst of the pass over pairs, when that had come by some of its
    // own.
    for (uint32_t i = 0; i < bodies.AwakeCount(); ++i)
        for (const b2ContactEdge *edge = bodies.Awake(i)->GetContactList(); edge != nullptr;
             edge = edge->next)
            if (!m_ledger->IsWatched(edge->contact))
                return false;
    for (uint32_t i = 0; i < bodies.AwakeCount(); ++i)
        for (const b2JointEdge *edge = bodies.Awake(i)->GetJointList(); edge != nullptr; edge = edge->next)
            if (sleeps(edge->other))
                return false;
    for (uint32_t i = NextAwake(m_ledger->Count()); i != Ledger::kNone; i = NextAwake(i)) {
        const Ledger::Record &record = m_ledger->At(i);
        if (sleeps(m_ledger->GetMovers()[record.a].body) || sleeps(m_ledger->GetMovers()[record.b].body))
            return false;
    }
    return true;
}

/// Which contacts are kept, and the heads of all lists; false where it does not pay, or without memory.
bool TouchingList::FillContacts() {
    const Ledger &ledger = *m_ledger;
    const uint32_t most = ledger.Count() / kMostTouchingOf;
    const auto next = [this, &ledger](uint32_t end) {
        return m_awakeAlone ? NextAwake(end) : ledger.NextTouching(end);
    };
    for (uint32_t i = next(ledger.Count()); i != Ledger::kNone; i = next(i)) {
        if (m_count == most || !m_room->kept.Reserve(m_count + 1))
            return false;
        b2Contact *const contact = ledger.Contact(i);
        m_room->kept[m_count++] = {contact, Nodes::Next(contact), Nodes::OfA(contact).next,
                                   Nodes::OfB(contact).next};
    }
    const Movers &movers = ledger.GetMovers();
    if (!m_room->heads.Reserve(m_awakeAlone ? m_ledger->GetBodies().AwakeCount() + 1 : movers.Count()))
        return false;
    m_first = m_manager->m_contactList;
    return true;
}

bool TouchingList::FillBodies() {
    const Bodies &bodies = m_ledger->GetBodies();
    if (!m_room->nextBodies.Reserve(bodies.AwakeCount() + 1))
        return false;
    for (uint32_t i = 0; i < bodies.AwakeCount(); ++i)
        m_room->nextBodies[i] = bodies.Awake(i)->*Named(NextBody());
    return true;
}

void TouchingList::ShortenBodies() {
    const Bodies &bodies = m_ledger->GetBodies();
    m_firstBody = *m_bodyList;
    *m_bodyList = nullptr;
    for (uint32_t i = bodies.AwakeCount(); i-- > 0;) {
        bodies.Awake(i)->*Named(NextBody()) = *m_bodyList;
        *m_bodyList = bodies.Awake(i);
    }
    m_ledger->SetAwakeAlone(CurrentStep());
}

void TouchingList::ShortenContacts() {
    const auto takeHead = [this](b2Body *body) {
        b2ContactEdge *&list = ListOf(body);
        if (list == nullptr)
            return; // it has none, or another fixture's row was first
        m_room->heads[m_headCount++] = {body, list};
        list = nullptr;
    };
    // Islands do not go on from bodies that are asleep unless one comes to them: then by their whole lists.
    if (m_awakeAlone) {
        for (uint32_t i = 0; i < m_ledger->GetBodies().AwakeCount(); ++i)
            takeHead(m_ledger->GetBodies().Awake(i));
    } else {
        const Movers &movers = m_ledger->GetMovers();
        for (uint32_t row = 0; row < movers.Count(); ++row)
            if (movers[row].records > 0 && movers.IsActiveNow(row))
                takeHead(const_cast<b2Body *>(movers[row].body));
    }
    // From the oldest on, each at the head of its lists, as when they were made.
    m_manager->m_contactList = nullptr;
    for (uint32_t k = m_count; k-- > 0;) {
        b2Contact *const contact = m_room->kept[k].contact;
        Nodes::Next(contact) = m_manager->m_contactList;
        m_manager->m_contactList = contact;
        for (b2ContactEdge *edge : {&Nodes::OfA(contact), &Nodes::OfB(contact)}) {
            b2Body *const body =
                (edge == &Nodes::OfA(contact) ? contact->GetFixtureA() : contact->GetFixtureB())->GetBody();
            if (!body->IsAwake() || body->GetType() == b2_staticBody)
                continue;
            edge->next = ListOf(body);
            ListOf(body) = edge;
        }
    }
}

/// Whatever the game does from here on, nobody knows any more who is awake.
void TouchingList::OpenForGame() {
    if (m_room != nullptr && m_awakeAlone)
        m_ledger->TakeRestingOutOfIslands(); // Box2D did so as it began with all contacts of its list
    OpenLists();
    m_ledger->SetAwakeAlone(0);
}

void TouchingList::OpenLists() {
    if (m_room == nullptr)
        return;
    if (m_manager->m_contactListener == this)
        m_manager->m_contactListener = m_listener;
    m_manager->m_contactList = m_first;
    for (uint32_t k = 0; k < m_count; ++k) {
        const Kept &kept = m_room->kept[k];
        Nodes::Next(kept.contact) = kept.next;
        Nodes::OfA(kept.contact).next = kept.nextOfA;
        Nodes::OfB(kept.contact).next = kept.nextOfB;
    }
    for (uint32_t k = 0; k < m_headCount; ++k)
        ListOf(m_room->heads[k].body) = m_room->heads[k].first;
    if (m_firstBody != nullptr) {
        const Bodies &bodies = m_ledger->GetBodies();
        *m_bodyList = m_firstBody;
        for (uint32_t i = 0; i < bodies.AwakeCount(); ++i)
            bodies.Awake(i)->*Named(NextBody()) = m_room->nextBodies[i];
    }
    m_room->taken = false;
    m_room = nullptr;
}

void TouchingList::Open(const b2ContactManager *manager) {
    TouchingList *list = stepping.touchingList == nullptr ? nullptr : stepping.touchingList->Object();
    for (; list != nullptr; list = list->Older())
        if (list->m_manager == manager)
            list->OpenLists();
}

void TouchingList::BeginNestedStep(const b2ContactManager *manager) {
    TouchingList *list = stepping.touchingList == nullptr ? nullptr : stepping.touchingList->Object();
    for (; list != nullptr; list = list->Older()) {
        if (list->m_manager != manager || !list->m_leftOut)
            continue;
        list->m_leftOut = false;
        list->m_ledger->TakeApartOutOfIslands();
    }
}

void TouchingList::BeginContact(b2Contact *contact) {
    OpenForGame();
    m_listener->BeginContact(contact);
}

void TouchingList::EndContact(b2Contact *contact) {
    OpenForGame();
    m_listener->EndContact(contact);
}

void TouchingList::PreSolve(b2Contact *contact, const b2Manifold *old) {
    if (!HasOwnPreSolve(*m_listener))
        return;
    OpenForGame();
    m_listener->PreSolve(contact, old);
}

void TouchingList::PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) {
    if (!HasOwnPostSolve(*m_listener))
        return;
    OpenForGame();
    m_listener->PostSolve(contact, impulse);
}

} // namespace bmr::hooks
