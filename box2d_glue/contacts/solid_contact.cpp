// SPDX-License-Identifier: MIT
#include "contacts/solid_contact.h"

#include <box2d/b2_world.h>

#include "contacts/convex_contact.h"
#include "contacts/pair_registry.h"
#include "contacts/polygon_contact.h"
#include "proofs/body_pair.h"
#include "start/current_step.h"
#include "world/ledger.h"
#include "world/ledgers.h"

namespace bmr {

static_assert(alignof(BodyPair) > PairAndLife::kLife, "the two lowest bits of its address are zero");

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

namespace {

/// From a to b, of the line that keeps their two hulls apart; zero where that is two disks.
bmr_vec2 DirectionOf(const BodyPair &pair) {
    const bmr_pair &kinetic = pair.kinetic;
    if (pair.verdict != BMR_APART || kinetic.state != BMR_PAIR_APART || kinetic.level == BMR_LEVEL_DISKS)
        return {0.0, 0.0};
    const bool ofA = kinetic.owner == 0;
    const b2Rot &q = (ofA ? pair.a : pair.b)->body->GetTransform().q;
    const bmr_pose turn = {{0.0, 0.0}, static_cast<double>(q.c), static_cast<double>(q.s)};
    const float *const n = kinetic.certificate.normal;
    const bmr_vec2 d = bmr_rotate(&turn, {static_cast<double>(n[0]), static_cast<double>(n[1])});
    return ofA ? d : bmr_neg(d);
}

bool IsZero(bmr_vec2 d) {
    return d.x == 0.0 && d.y == 0.0;
}

} // namespace

bmr_vec2 SolidContact::GuessDirection() const {
    const PolygonContact *ofSmall = PolygonContact::AsOurs(this);
    const bmr_vec2 d = ofSmall != nullptr ? ofSmall->EdgeDirection()
                                          : static_cast<const ConvexContact *>(this)->LookDirection();
    if (!IsZero(d) || state.pair == nullptr)
        return d;
    const bmr_vec2 ofHulls = DirectionOf(*state.pair);
    return state.pair->a->body == m_fixtureA->GetBody() ? ofHulls : bmr_neg(ofHulls);
}

bmr_vec32 GuessDirection(const b2Contact &contact) {
    const b2Manifold &manifold = *contact.GetManifold();
    b2Vec2 d(0.0f, 0.0f);
    if (manifold.pointCount > 0) {
        const b2Transform &xfA = contact.GetFixtureA()->GetBody()->GetTransform(),
                          &xfB = contact.GetFixtureB()->GetBody()->GetTransform();
        if (manifold.type == b2Manifold::e_faceA)
            d = b2Mul(xfA.q, manifold.localNormal);
        else if (manifold.type == b2Manifold::e_faceB)
            d = -b2Mul(xfB.q, manifold.localNormal);
        else
            d = b2Mul(xfB, manifold.points[0].localPoint) - b2Mul(xfA, manifold.localPoint);
    } else if (const SolidContact *ours = SolidContact::AsOurs(&contact)) {
        const bmr_vec2 known = ours->IsOfPolygons() ? ours->GuessDirection() : bmr_vec2{0.0, 0.0};
        d.Set(static_cast<float>(known.x), static_cast<float>(known.y));
    }
    // (Normals may be written to in place.)
    return d.Normalize() > 0.0f ? bmr_vec32{d.x, d.y} : bmr_vec32{0.0f, 0.0f};
}

void SolidContact::IsLookedAtByOthers() const {
    GameRan() = true; // it may be the game that asks, in the midst of a call
    const b2World *world = m_fixtureA->GetBody()->GetWorld();
    if (Ledger *ledger = FindLedger(&world->GetContactManager()))
        ledger->Flag(this, 0);
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
        // A game may change radii at any time.
        return radiusSum <= asked->radiusSum && KnownApart(asked, swapped ? xfB : xfA, swapped ? xfA : xfB);
    };
    if (!(parent != nullptr && apart(parent)) && !apart(pair))
        return false;
    // In a step, LookAtShapes has compared the hulls with their fixtures. Since then a listener or a filter
    // may have changed vertices, or have made a sensor solid, which is in no hull. Outside of steps nothing
    // was compared. So this contact's own two fixtures are compared now.
    return !GameRan() || (step != 0 && ListenersAreModest()) || HullsHold(*this);
}

} // namespace bmr
