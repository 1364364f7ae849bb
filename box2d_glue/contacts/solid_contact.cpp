// SPDX-License-Identifier: MIT
#include "contacts/solid_contact.h"

#include <box2d/b2_world.h>

#include "proofs/body_pair.h"
#include "start/current_step.h"
#include "world/ledger.h"
#include "world/ledgers.h"

namespace bmr {

static_assert(alignof(BodyPair) > PairAndLife::kLife, "the two lowest bits of its address are zero");

std::atomic<const void *> SolidContact::polygonVtable{nullptr}, SolidContact::convexVtable{nullptr};

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
    const bmr_vec2 d = KnownDirection();
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

} // namespace bmr
