// SPDX-License-Identifier: MIT
#include "passes/contact_look.h"

#include <box2d/b2_collision.h>
#include <box2d/b2_world_callbacks.h>

#include "base/private_members.h"
#include "base/rounding_mode.h"
#include "contacts/convex_contact.h"
#include "contacts/polygon_contact.h"
#include "proofs/overlap.h"
#include "start/settings.h"
#include "tell/verify.h"
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

namespace {

/// What b2TestOverlap would say of the two, where that is certain.
Overlap OverlapOf(b2Contact *contact) {
    const b2Fixture &a = *contact->GetFixtureA(), &b = *contact->GetFixtureB();
    PolygonContact *const ours = PolygonContact::AsOurs(contact);
    const int32 childA = contact->GetChildIndexA(), childB = contact->GetChildIndexB();
    const b2Transform &poseA = a.GetBody()->GetTransform(), &poseB = b.GetBody()->GetTransform();
    const Overlap answer = CertainOverlap(*a.GetShape(), childA, *b.GetShape(), childB, poseA, poseB,
                                          ours != nullptr ? ours->Memory() : nullptr);
    if (answer != Overlap::kUnknown && Verifying())
        VerifyOverlap(&a, &b, answer == Overlap::kOverlapping,
                      b2TestOverlap(a.GetShape(), childA, b.GetShape(), childB, poseA, poseB));
    return answer;
}

/// b2Contact::Update of a contact of which a fixture is a sensor. False, and nothing done, where it is Box2D
/// who answers.
bool UpdateSensor(b2Contact *contact, b2ContactListener *listener) {
    const Overlap answer = OverlapOf(contact);
    if (answer == Overlap::kUnknown || Verifying())
        return false;
    Count(&Counts::overlapsAnswered);
    const bool touches = answer == Overlap::kOverlapping, touched = contact->IsTouching();
    ContactAccess::Flags(contact) |= ContactAccess::kEnabled;
    contact->GetManifold()->pointCount = 0;
    if (touches == touched)
        return true;
    ContactAccess::Flags(contact) ^= ContactAccess::kTouching;
    if (listener != nullptr && touches)
        listener->BeginContact(contact);
    else if (listener != nullptr)
        listener->EndContact(contact);
    return true;
}

} // namespace

void UpdateContact(b2Contact *contact, b2ContactListener *listener) {
    const bool isNear = RoundsToNearest(), here = isNear && !Verifying(); // by now: a listener may change it
    if (contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor()) {
        if (!isNear || !UpdateSensor(contact, listener))
            SolidContact::UpdateByBox2D(contact, listener);
    } else if (PolygonContact *const ofSmall = here ? PolygonContact::AsOurs(contact) : nullptr)
        ofSmall->UpdateSolid(listener);
    else if (ConvexContact *const ofBig = here ? ConvexContact::AsOurs(contact) : nullptr)
        ofBig->UpdateSolid(listener);
    else
        SolidContact::UpdateByBox2D(contact, listener);
}

} // namespace bmr
