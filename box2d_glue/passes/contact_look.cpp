// SPDX-License-Identifier: MIT
#include "passes/contact_look.h"

#include "base/private_members.h"
#include "base/rounding_mode.h"
#include "contacts/convex_contact.h"
#include "contacts/polygon_contact.h"
#include "start/settings.h"
#include "tree/box.h"

namespace {

/// Names the call below.
struct NoProxy {};

} // namespace

/// Asks Box2D for a proxy that is none. If Box2D was compiled with its assertions, they end the program;
/// else the call leaves nothing behind.
template <> void b2BroadPhase::UpdatePairs(NoProxy *) {
    const int32 count = m_pairCount;
    m_queryProxyId = 0;
    QueryCallback(e_nullProxy);
    m_pairCount = count;
}

namespace bmr {

bool BoxesOverlap(b2ContactManager *manager, const b2Contact &contact) {
    const int32 a = FixtureAccess::ProxyOf(contact.GetFixtureA(), contact.GetChildIndexA()),
                b = FixtureAccess::ProxyOf(contact.GetFixtureB(), contact.GetChildIndexB());
    // (A filter may put a body out of the world that then gets contacts all the same.)
    if (BMR_RARELY(a == b2BroadPhase::e_nullProxy || b == b2BroadPhase::e_nullProxy))
        manager->m_broadPhase.UpdatePairs(static_cast<NoProxy *>(nullptr));
    return tree::Overlap(tree::BoxOf(manager->m_broadPhase.GetFatAABB(a)),
                         tree::BoxOf(manager->m_broadPhase.GetFatAABB(b)));
}

void UpdateContact(b2Contact *contact, b2ContactListener *listener) {
    const bool sensor = contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor();
    const bool here = !Verifying() && RoundsToNearest(); // by now: a listener may change it
    PolygonContact *const ofSmall = here ? PolygonContact::AsOurs(contact) : nullptr;
    if (sensor) {
        if (ofSmall == nullptr || !ofSmall->UpdateSensor(listener))
            SolidContact::UpdateByBox2D(contact, listener);
    } else if (ofSmall != nullptr)
        ofSmall->UpdateSolid(listener);
    else if (ConvexContact *const ofBig = here ? ConvexContact::AsOurs(contact) : nullptr)
        ofBig->UpdateSolid(listener);
    else
        SolidContact::UpdateByBox2D(contact, listener);
}

} // namespace bmr
