// SPDX-License-Identifier: MIT
#include "glue/contact_update.h"

#include <box2d/b2_collision.h>

#include "base/private_members.h"
#include "base/rounding_mode.h"
#include "debug/verify.h"
#include "glue/contacts/polygon_contact.h"
#include "glue/proofs/overlap.h"
#include "start/settings.h"
#include "tree/box.h"

namespace bmr {

bool BoxesOverlap(b2ContactManager *manager, const b2Contact &contact) {
    const int32 a = FixtureAccess::ProxyOf(contact.GetFixtureA(), contact.GetChildIndexA()),
                b = FixtureAccess::ProxyOf(contact.GetFixtureB(), contact.GetChildIndexB());
    return tree::Overlap(tree::BoxOf(manager->m_broadPhase.GetFatAABB(a)),
                         tree::BoxOf(manager->m_broadPhase.GetFatAABB(b)));
}

namespace {

/// b2TestOverlap of a contact of which a fixture is a sensor.
bool Overlaps(b2Contact *contact) {
    const b2Fixture &a = *contact->GetFixtureA(), &b = *contact->GetFixtureB();
    const int32 childA = contact->GetChildIndexA(), childB = contact->GetChildIndexB();
    const b2Transform &poseA = a.GetBody()->GetTransform(), &poseB = b.GetBody()->GetTransform();
    const auto ofBox2D = [&] {
        return b2TestOverlap(a.GetShape(), childA, b.GetShape(), childB, poseA, poseB);
    };
    if (!RoundsToNearest())
        return ofBox2D();
    PolygonContact *const ours = PolygonContact::AsOurs(contact);
    const Overlap answer = CertainOverlap(*a.GetShape(), childA, *b.GetShape(), childB, poseA, poseB,
                                          ours != nullptr ? ours->Memory() : nullptr, contact->IsTouching());
    if (answer == Overlap::kUnknown)
        return ofBox2D();
    Count(&Counts::overlapsAnswered);
    return answer == Overlap::kOverlapping;
}

/// Points that were there before, by their features, keep the impulses that the solver starts from.
void KeepImpulses(b2Manifold *manifold, const b2Manifold &old) {
    for (int32 i = 0; i < manifold->pointCount; ++i) {
        b2ManifoldPoint &point = manifold->points[i];
        const b2ManifoldPoint *before = nullptr;
        for (int32 j = old.pointCount; j-- > 0;) // the first of equals, should there be any, is taken last
            if (old.points[j].id.key == point.id.key)
                before = &old.points[j];
        point.normalImpulse = before != nullptr ? before->normalImpulse : 0.0f;
        point.tangentImpulse = before != nullptr ? before->tangentImpulse : 0.0f;
    }
}

/// The manifold of two solid fixtures. `old` is what it was, if it had points or has some now.
void MakeManifold(b2Contact *contact, bool touched, b2Manifold *old) {
    b2Manifold &manifold = *contact->GetManifold();
    if (SolidContact *const ours = SolidContact::AsOurs(contact)) {
        ours->MakeManifold(touched, old);
    } else {
        *old = manifold;
        contact->Evaluate(&manifold, contact->GetFixtureA()->GetBody()->GetTransform(),
                          contact->GetFixtureB()->GetBody()->GetTransform());
    }
    KeepImpulses(&manifold, *old);
}

} // namespace

ContactChange UpdateContact(b2Contact *contact) {
    ContactChange change;
    change.old.pointCount = 0;
    b2Fixture *const a = contact->GetFixtureA(), *const b = contact->GetFixtureB();
    b2Manifold &manifold = *contact->GetManifold();
    change.touched = contact->IsTouching();
    change.isSensor = a->IsSensor() || b->IsSensor();
    ContactAccess::Flags(contact) |= ContactAccess::kEnabled;
    if (change.isSensor) {
        change.touches = Overlaps(contact);
        manifold.pointCount = 0;
    } else {
        MakeManifold(contact, change.touched, &change.old);
        change.touches = manifold.pointCount > 0;
    }
    if (change.touches != change.touched) {
        if (!change.isSensor) {
            a->GetBody()->SetAwake(true);
            b->GetBody()->SetAwake(true);
        }
        ContactAccess::Flags(contact) ^= ContactAccess::kTouching;
    }
    if (Verifying())
        VerifyContact(*contact);
    return change;
}

} // namespace bmr
