// SPDX-License-Identifier: MIT
#include "contacts/pair_registry.h"

#include <algorithm>

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "base/rounding_mode.h"
#include "contacts/solid_contact.h"
#include "proofs/body_pair.h"
#include "proofs/hull.h"
#include "start/current_step.h"
#include "start/settings.h"

namespace bmr {

namespace {

/// The fixtures of which one side of a pair is the hull.
struct Unit {
    b2Body *body;
    const b2Fixture *fixture; ///< nullptr: the whole body
};

// Hulls and pairs are looked for among this many of a body's newest contacts. Not finding one costs memory,
// not correctness.
constexpr int kMostContactsSearched = 32;

// Two bodies get a structure of their own from so many contacts between them on: fewer are served as well by
// an edge each. And not before there is a contact for every three fixtures: that is what a hull costs to
// build, and bodies of many small pieces (concave ones, most of all) would build it for a short encounter.
constexpr int kWorthAPair = 8;
constexpr int kFixturesForAContact = 3;
constexpr int kMostSiblings = 31; // bodies of more than 96 fixtures together need no more contacts than this

bool OneFixture(const b2Body &body) {
    const b2Fixture *first = body.GetFixtureList();
    return first != nullptr && first->GetNext() == nullptr;
}

/// Number of fixtures, counted up to `most`.
int CountFixtures(const b2Body &body, int most) {
    int count = 0;
    for (const b2Fixture *f = body.GetFixtureList(); f != nullptr && count < most; f = f->GetNext())
        ++count;
    return count;
}

/// Have the two bodies fixtures enough for so many contacts with each other?
bool MayMakeContacts(const b2Body &a, const b2Body &b, int contacts) {
    return CountFixtures(a, contacts) * CountFixtures(b, contacts) >= contacts;
}

/// The hull of a static body of many fixtures (the level) would swallow everything: there each fixture is its
/// own.
Unit BodyUnit(b2Fixture *fixture) {
    b2Body *body = fixture->GetBody();
    const bool alone = body->GetType() == b2_staticBody || OneFixture(*body);
    return {body, alone ? fixture : nullptr};
}

Unit FixtureUnit(b2Fixture *fixture) {
    return {fixture->GetBody(), fixture};
}

bool IsHullOf(const Hull &hull, const Unit &unit) {
    return hull.body == unit.body && hull.fixture == unit.fixture;
}

bool IsPairOf(const BodyPair &pair, const Unit &a, const Unit &b) {
    return (IsHullOf(*pair.a, a) && IsHullOf(*pair.b, b)) || (IsHullOf(*pair.a, b) && IsHullOf(*pair.b, a));
}

bool Serves(const b2Contact &contact, const Unit &unit) {
    const b2Fixture *a = contact.GetFixtureA(), *b = contact.GetFixtureB();
    const b2Fixture *mine = a->GetBody() == unit.body ? a : b;
    return unit.fixture == nullptr || mine == unit.fixture;
}

/// Calls `visit` with each contact of ours between polygons of two bodies that is no sensor's, the newest
/// first, until it returns true; among the newest kMostContactsSearched of `walked` alone. That is to be the
/// body of the new contact's fixture B: Box2D has just walked its list to look for the same contact, so that
/// it is in the cache.
template <typename Visit> void VisitContactsBetween(b2Body *walked, const b2Body *other, Visit visit) {
    int left = kMostContactsSearched;
    for (b2ContactEdge *edge = walked->GetContactList(); edge != nullptr && left > 0;
         edge = edge->next, --left) {
        if (edge->other != other)
            continue;
        SolidContact *ours = SolidContact::AsOurs(edge->contact);
        if (ours != nullptr && ours->IsOfPolygons() && !ours->GetFixtureA()->IsSensor() &&
            !ours->GetFixtureB()->IsSensor() && visit(ours))
            return;
    }
}

/// Calls `visit` with each hull that a pair of this body's contacts uses, and the pair, until it returns
/// true.
template <typename Visit> void VisitHulls(const b2Body *body, int mostContacts, Visit visit) {
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr && mostContacts > 0;
         edge = edge->next, --mostContacts) {
        SolidContact *ours = SolidContact::AsOurs(edge->contact);
        for (BodyPair *pair = ours != nullptr ? ours->state.pair.Get() : nullptr; pair != nullptr;
             pair = pair->parent) {
            if (visit(pair->a, pair) || visit(pair->b, pair))
                return;
        }
    }
}

constexpr int kAllContacts = 0x7fffffff;

void RebuildAndReset(Hull *hull) {
    RebuildHull(hull);
    VisitHulls(hull->body, kAllContacts, [hull](Hull *used, BodyPair *pair) {
        if (used == hull)
            ResetBodyPair(pair);
        return false;
    });
}

/// A reference to a hull of this unit, one that is there already if possible.
Hull *AcquireHull(const Unit &unit, b2BlockAllocator *allocator) {
    Hull *found = nullptr;
    VisitHulls(unit.body, kMostContactsSearched, [&found, &unit](Hull *hull, BodyPair *) {
        if (IsHullOf(*hull, unit))
            found = hull;
        return found != nullptr;
    });
    if (found == nullptr)
        return CreateHull(unit.body, unit.fixture, allocator);
    ++found->references;
    return found;
}

BodyPair *MakePair(const Unit &a, const Unit &b, BodyPair *parent, b2BlockAllocator *allocator) {
    Hull *hullA = AcquireHull(a, allocator);
    Hull *hullB = AcquireHull(b, allocator);
    return CreateBodyPair(hullA, hullB, parent, allocator);
}

/// Makes the hull of a pair hold a fixture, by building it again if need be. Box2D reuses addresses and
/// announces no new fixture: the content of the fixture decides, not its address.
bool MakeHold(BodyPair *pair, const b2Fixture &fixture) {
    Hull *hull = pair->a->body == fixture.GetBody() ? pair->a : pair->b;
    if (HullHolds(*hull, fixture))
        return true;
    if (hull->shape.polygon == nullptr)
        return false; // it could not be built; trying again at every contact would cost more than it could
                      // save
    RebuildAndReset(hull);
    ResetBodyPair(pair); // it may be too new to be in any list
    return HullHolds(*hull, fixture);
}

/// Gives a contact a reference to a pair whose hulls it has not been shown to lie in.
void Share(SolidContact *contact, BodyPair *pair) {
    ++pair->references;
    contact->MakeRoomForPair();
    contact->state.pair = pair;
    contact->state.link.stamp =
        (StampOf(*pair) - 1) & kStampMask; // differs: the next evaluation looks at the fixtures
}

/// The same for a new contact, whose fixtures may be new too: the hulls are made to hold them.
void Join(SolidContact *contact, BodyPair *pair) {
    Share(contact, pair);
    bool holds = true;
    for (BodyPair *level = pair; level != nullptr; level = level->parent)
        holds = MakeHold(level, *contact->GetFixtureA()) && MakeHold(level, *contact->GetFixtureB()) && holds;
    contact->state.link.stamp = StampOf(*pair) & kStampMask;
    contact->state.link.excluded = !holds;
}

/// Are so many contacts between two bodies worth a structure?
bool WorthAPair(const b2Body &a, const b2Body &b, int contacts) {
    constexpr int kMostCounted = kFixturesForAContact * (kMostSiblings + 1);
    return contacts >= kWorthAPair &&
           contacts * kFixturesForAContact >=
               std::min(CountFixtures(a, kMostCounted) + CountFixtures(b, kMostCounted), kMostCounted);
}

/// With remembered edges on: body pairs alone, once two bodies have contacts enough.
void AttachToBodies(SolidContact *contact, const Unit &a, const Unit &b, b2BlockAllocator *allocator) {
    if (!MayMakeContacts(*a.body, *b.body, kWorthAPair))
        return;
    SolidContact *siblings[kMostSiblings];
    BodyPair *pair = nullptr;
    int count = 0;
    VisitContactsBetween(b.body, a.body, [&](SolidContact *other) {
        BodyPair *theirs = other->state.pair;
        if (theirs != nullptr && IsPairOf(*theirs, a, b))
            pair = theirs;
        else if (theirs == nullptr && Serves(*other, a) && Serves(*other, b))
            siblings[count++] = other;
        return pair != nullptr || count == kMostSiblings;
    });
    if (pair == nullptr && WorthAPair(*a.body, *b.body, count + 1)) {
        pair = MakePair(a, b, nullptr, allocator);
        for (int i = 0; i < count; ++i)
            Share(siblings[i], pair);
    }
    if (pair != nullptr)
        Join(contact, pair);
}

/// Without remembered edges: every contact has a pair of its own fixtures, below that of the bodies where
/// that says more.
void AttachToFixtures(SolidContact *contact, const Unit &a, const Unit &b, b2BlockAllocator *allocator) {
    const Unit fixtureA = FixtureUnit(contact->GetFixtureA()), fixtureB = FixtureUnit(contact->GetFixtureB());
    BodyPair *parent = nullptr;
    if (a.fixture == nullptr || b.fixture == nullptr) {
        VisitContactsBetween(b.body, a.body, [&parent, &a, &b](SolidContact *other) {
            BodyPair *above = other->state.pair != nullptr ? other->state.pair->parent : nullptr;
            if (above != nullptr && IsPairOf(*above, a, b))
                parent = above;
            return parent != nullptr;
        });
        if (parent == nullptr)
            parent = MakePair(a, b, nullptr, allocator);
        ++parent->references;
    }
    Join(contact, MakePair(fixtureA, fixtureB, parent, allocator));
}

} // namespace

void AttachPair(SolidContact *contact, b2BlockAllocator *allocator) {
    if (contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor())
        return;
    const NearestRounding nearest; // hulls outlast the mode that they are built in
    const Unit a = BodyUnit(contact->GetFixtureA()), b = BodyUnit(contact->GetFixtureB());
    if (EdgesAreOn())
        AttachToBodies(contact, a, b, allocator);
    else
        AttachToFixtures(contact, a, b, allocator);
}

void DetachPair(SolidContact *contact, b2BlockAllocator *allocator) {
    if (contact->state.pair != nullptr)
        ReleaseBodyPair(contact->state.pair, allocator);
    contact->state.pair = nullptr;
}

unsigned StampOf(const BodyPair &pair) {
    return (pair.stamp + (pair.parent != nullptr ? pair.parent->stamp : 0)) & kStampMask;
}

namespace {

/// Do the hulls of the contact's pair hold its fixtures as they are now? Some 20 ns.
bool HullsHold(const SolidContact &contact) {
    const b2Fixture &first = *contact.GetFixtureA(), &second = *contact.GetFixtureB();
    for (const BodyPair *pair = contact.state.pair; pair != nullptr; pair = pair->parent) {
        const bool swapped = pair->a->body != first.GetBody();
        if (!HullHolds(swapped ? *pair->b : *pair->a, first) ||
            !HullHolds(swapped ? *pair->a : *pair->b, second))
            return false;
    }
    return true;
}

/// The same, to be asked when the stamps differ; makes them agree.
bool VerifyStamp(SolidContact *contact) {
    PairLink &link = contact->state.link;
    link.stamp = StampOf(*contact->state.pair) & kStampMask;
    const bool holds = HullsHold(*contact);
    link.excluded = !holds;
    return holds;
}

/// To be called once in each step, ahead of the first question to a pair: builds those of its hulls anew that
/// do not hold all fixtures as they are now. (Vertices may be changed in place. What a listener or a filter
/// changes after that, in the middle of the step, is found by HullsHold.)
void LookAtShapes(const SolidContact &contact) {
    const uint64_t step = CurrentStep();
    for (BodyPair *pair = contact.state.pair; pair != nullptr; pair = pair->parent) {
        for (Hull *hull : {pair->a, pair->b}) {
            if (hull->lookedAt == step)
                continue;
            if (!HullIsUpToDate(*hull))
                RebuildAndReset(hull);
            hull->lookedAt = step;
        }
    }
}

} // namespace

bool PairSaysApart(SolidContact *contact, const b2Transform &xfA, const b2Transform &xfB) {
    BodyPair *pair = contact->state.pair, *parent = pair->parent;
    const uint64_t step = CurrentStep();
    if (step != 0 && (pair->a->lookedAt != step || pair->b->lookedAt != step || parent != nullptr))
        LookAtShapes(*contact);
    const PairLink &link = contact->state.link;
    if (link.stamp != StampOf(*pair) ? !VerifyStamp(contact) : link.excluded)
        return false;
    const b2Body *bodyA = contact->GetFixtureA()->GetBody();
    const float radiusSum = contact->RadiusSum();
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
    return !GameRan() || HullsHold(*contact);
}

void InvalidateBody(b2Body *body) {
    const NearestRounding nearest;
    // One hull after another: rebuilding it for each pair that uses it changes nothing but the time this
    // takes.
    VisitHulls(body, kAllContacts, [body](Hull *hull, BodyPair *pair) {
        if (hull->body == body) {
            RebuildHull(hull);
            ResetBodyPair(pair);
        }
        return false;
    });
}

} // namespace bmr
