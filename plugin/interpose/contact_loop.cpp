// SPDX-License-Identifier: MIT
// b2ContactManager::Collide: the loop over a world's contacts at the start of a step. The same contacts in
// the same order, each filtered, destroyed or updated when Box2D would; contacts of ours are updated without
// a virtual call and, where they stay apart, without a copy of their manifold.
//
// An odometer (no look at a contact whose slack outlasts the summed motion of its bodies) was tried: motions
// summed for each polygon in b2Fixture::Synchronize, the sum at which to look again kept in the word that a
// contact without a pair has to spare. A step of needles took 36 % fewer instructions, plates 30 %, tumbler
// 0.4 %; coins, whose contacts have pairs and which paid for the sums, 5 % more. It is not in: the
// experiment did not see SetTransform, ShiftOrigin, radii and the sub-steps of SolveTOI, each of which must
// end or widen what was proved, and its sums had no room of their own in a world.
#include <cstdint>

#include "contact_access.h"
#include "convex_contact.h"
#include "polygon_contact.h"
#include "real.h"
#include "rounding_mode.h"
#include "settings.h"
#include "short_list.h"

namespace bmr::interpose {

namespace {

Real<void(b2ContactManager *)> realCollide("_ZN16b2ContactManager7CollideEv");

bool IsActive(const b2Body *body) {
    return body->IsAwake() && body->GetType() != b2_staticBody;
}

bool BoxesOverlap(const b2ContactManager *manager, const b2Contact *contact) {
    return manager->m_broadPhase.TestOverlap(
        FixtureAccess::ProxyOf(contact->GetFixtureA(), contact->GetChildIndexA()),
        FixtureAccess::ProxyOf(contact->GetFixtureB(), contact->GetChildIndexB()));
}

/// A contact takes four cache lines; what follows in the list need not follow in memory. At the list's end
/// there is none, which does no harm: addresses are numbers here, for no pointer may be moved from nullptr.
void Prefetch(const b2Contact *contact) {
    constexpr uintptr_t kLine = 64;
    const uintptr_t first = reinterpret_cast<uintptr_t>(contact);
    for (uintptr_t line = 0; line < 4; ++line)
        __builtin_prefetch(
            reinterpret_cast<const void *>(first + line * kLine)); // NOLINT(performance-no-int-to-ptr)
}

void Update(b2Contact *contact, b2ContactListener *listener) {
    const bool sensor = contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor();
    const bool here = !sensor && !Verifying() && RoundsToNearest(); // by now: a listener may change it
    PolygonContact *ofSmall = here ? PolygonContact::AsOurs(contact) : nullptr;
    if (ofSmall != nullptr)
        ofSmall->UpdateSolid(listener);
    else if (ConvexContact *ofBig = here ? ConvexContact::AsOurs(contact) : nullptr)
        ofBig->UpdateSolid(listener);
    else
        SolidContact::UpdateByBox2D(contact, listener);
}

/// Brings one contact up to date; false where it is to be destroyed.
inline bool Persists(b2ContactManager *manager, b2Contact *contact) {
    b2Fixture *fixtureA = contact->GetFixtureA(), *fixtureB = contact->GetFixtureB();
    if (SolidContact::WantsFiltering(*contact)) {
        if (!PassesFilters(manager, fixtureA, fixtureB))
            return false;
        SolidContact::FilteringIsDone(contact);
    }
    if (!IsActive(fixtureA->GetBody()) && !IsActive(fixtureB->GetBody()))
        return true;
    if (!BoxesOverlap(manager, contact))
        return false;
    Update(contact, manager->m_contactListener);
    return true;
}

} // namespace

void Collide(b2ContactManager *manager) BMR_STANDS_FOR("_ZN16b2ContactManager7CollideEv");

void Collide(b2ContactManager *manager) {
    const ShortList::Whole whole(manager);
    if (!HookIsOn(Hook::ContactLoop)) {
        realCollide.Get()(manager);
        return;
    }
    b2Contact *contact = manager->m_contactList;
    while (contact != nullptr) {
        Prefetch(contact->GetNext());
        if (Persists(manager, contact)) {
            contact = contact->GetNext();
        } else {
            b2Contact *parted = contact;
            contact = contact->GetNext();
            manager->Destroy(parted);
        }
    }
}

} // namespace bmr::interpose
