// SPDX-License-Identifier: MIT
#include "passes/collide_by_list.h"

#include "contacts/solid_contact.h"
#include "passes/contact_access.h"
#include "passes/contact_look.h"
#include "world/ledger.h"

namespace bmr {

namespace {

/// Brings one contact up to date; false where it is to be destroyed.
inline bool Persists(b2ContactManager *manager, b2Contact *contact, ListCounts *counts) {
    b2Fixture *fixtureA = contact->GetFixtureA(), *fixtureB = contact->GetFixtureB();
    if (SolidContact::WantsFiltering(*contact)) {
        if (!PassesFilters(manager, fixtureA, fixtureB))
            return false;
        SolidContact::FilteringIsDone(contact);
    }
    if (!IsActive(fixtureA->GetBody()) && !IsActive(fixtureB->GetBody()))
        return true;
    if (!BoxesOverlap(manager, *contact))
        return false;
    b2ContactListener *const listener = manager->m_contactListener;
    TellListener(listener, contact, UpdateContact(contact), [] {});
    ++counts->awake;
    counts->touching += contact->IsTouching() ? 1 : 0;
    return true;
}

} // namespace

ListCounts CollideByList(b2ContactManager *manager) {
    ListCounts counts;
    b2Contact *contact = manager->m_contactList;
    while (contact != nullptr) {
        ContactNumber::Prefetch(contact->GetNext());
        if (Persists(manager, contact, &counts)) {
            contact = contact->GetNext();
        } else {
            b2Contact *parted = contact;
            contact = contact->GetNext();
            manager->Destroy(parted);
        }
    }
    return counts;
}

} // namespace bmr
