// SPDX-License-Identifier: MIT
#include "solid_contact.h"

#include "body_pair.h"
#include "current_step.h"
#include "pair_registry.h"

namespace bmr {

std::atomic<const void *> SolidContact::polygonVtable{nullptr}, SolidContact::convexVtable{nullptr};

void SolidContact::UpdateByBox2D(b2Contact *contact, b2ContactListener *listener) {
    (contact->*(&SolidContact::Update))(listener);
}

/// Points that were there before, by their features, keep the impulses that the solver starts from.
inline void SolidContact::KeepImpulses(const b2Manifold &old) {
    for (int32 i = 0; i < m_manifold.pointCount; ++i) {
        b2ManifoldPoint &point = m_manifold.points[i];
        const b2ManifoldPoint *before = nullptr;
        for (int32 j = old.pointCount; j-- > 0;) // the first of equals, should there be any, is taken last
            if (old.points[j].id.key == point.id.key)
                before = &old.points[j];
        point.normalImpulse = before != nullptr ? before->normalImpulse : 0.0f;
        point.tangentImpulse = before != nullptr ? before->tangentImpulse : 0.0f;
    }
}

void SolidContact::Finish(bool wasTouching, const b2Manifold &old, b2ContactListener *listener) {
    KeepImpulses(old);
    const bool touching = m_manifold.pointCount > 0;
    if (touching != wasTouching) {
        m_fixtureA->GetBody()->SetAwake(true);
        m_fixtureB->GetBody()->SetAwake(true);
        m_flags ^= e_touchingFlag;
    }
    if (listener == nullptr)
        return;
    if (touching && !wasTouching)
        listener->BeginContact(this);
    if (!touching && wasTouching)
        listener->EndContact(this);
    if (touching)
        listener->PreSolve(this, &old);
}

bool SolidContact::PairSaysApart(const b2Transform &xfA, const b2Transform &xfB) {
    BodyPair *pair = state.pair, *parent = pair->parent;
    const uint64_t step = CurrentStep();
    if (step != 0 && (pair->a->lookedAt != step || pair->b->lookedAt != step || parent != nullptr))
        LookAtShapes(*this);
    if (state.link.stamp != StampOf(*pair) ? !VerifyStamp(this) : state.link.excluded)
        return false;
    const b2Body *bodyA = m_fixtureA->GetBody();
    const float radiusSum = RadiusSum();
    const auto apart = [&](BodyPair *asked) {
        const bool swapped = asked->a->body != bodyA;
        // Radii may be changed by anybody at any time.
        return radiusSum <= asked->radiusSum && KnownApart(asked, swapped ? xfB : xfA, swapped ? xfA : xfB);
    };
    if (!(parent != nullptr && apart(parent)) && !apart(pair))
        return false;
    // In a step, LookAtShapes has compared the hulls with their fixtures. Since then a listener or a filter
    // may have changed vertices, or have made a sensor solid, which is in no hull. Outside of steps nobody
    // has compared anything. So this contact's own two fixtures are compared now.
    return !GameMayRun() || HullsHold(*this);
}

} // namespace bmr
