// SPDX-License-Identifier: MIT
#include "short_list.h"

#include <box2d/b2_contact.h>
#include <box2d/b2_contact_manager.h>

#include "recognise.h"

namespace bmr::interpose {

namespace {

/// Names protected members of b2Contact's. (Nobody asks for the contact before while the list is short.)
struct Links : b2Contact {
    static b2Contact *&Next(b2Contact *contact) { return contact->*(&Links::m_next); }
    static bool HasNoImpact(b2Contact *contact) {
        return (contact->*(&Links::m_flags) & e_toiFlag) != 0 && !(contact->*(&Links::m_toi) < 1.0f);
    }
};

/// Box2D's own listener, which it begins with, does nothing: it need not be kept from the list.
bool Listens(const b2ContactListener *listener) {
    return listener != nullptr && listener != ListenerOfNewWorlds();
}

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

ShortList::ShortList(b2ContactManager *manager)
    : m_manager(manager), m_listener(manager->m_contactListener), m_listens(Listens(m_listener)),
      m_outer(stepping.shortList) {
    stepping.shortList = this;
    Choose();
    Resume();
}

ShortList::~ShortList() {
    Open();
    if (m_manager->m_contactListener == this)
        m_manager->m_contactListener = m_listener;
    stepping.shortList = m_outer;
}

/// Which are kept. The list is whole.
void ShortList::Choose() {
    m_first = m_manager->m_contactList;
    m_count = 0;
    if (m_staysWhole)
        return;
    for (b2Contact *contact = m_first; contact != nullptr; contact = Links::Next(contact)) {
        if (Links::HasNoImpact(contact))
            continue;
        if (m_count == kMost) {
            m_count = 0;
            return;
        }
        m_kept[m_count++] = {contact, Links::Next(contact)};
    }
}

/// As Box2D would have it: the list whole, and the world's own listener.
void ShortList::Suspend() {
    Open();
    if (m_listens && !m_staysWhole)
        m_manager->m_contactListener = m_listener;
}

/// Another listener from now on: Box2D hands it all but what it is in the middle of, so nobody would open the
/// list for it.
void ShortList::Resume() {
    m_staysWhole = m_staysWhole || m_manager->m_contactListener != m_listener;
    if (m_staysWhole)
        m_count = 0;
    else if (m_listens)
        m_manager->m_contactListener = this;
    Close();
}

void ShortList::Open() {
    if (m_count == 0)
        return;
    m_manager->m_contactList = m_first;
    for (int32 i = 0; i < m_count; ++i)
        Links::Next(m_kept[i].contact) = m_kept[i].next;
}

void ShortList::Close() {
    if (m_count == 0)
        return;
    m_manager->m_contactList = m_kept[0].contact;
    for (int32 i = 0; i + 1 < m_count; ++i)
        Links::Next(m_kept[i].contact) = m_kept[i + 1].contact;
    Links::Next(m_kept[m_count - 1].contact) = nullptr;
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
    const Pause pause(this);
    m_listener->PreSolve(contact, old);
}

void ShortList::PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) {
    const Pause pause(this);
    m_listener->PostSolve(contact, impulse);
}

} // namespace bmr::interpose
