// SPDX-License-Identifier: MIT
// b2World::SolveTOI: the first search of a step for the next impact. Pairs that are proved apart over the
// whole step get the time of impact that Box2D would find, "none"; if there are other pairs Box2D goes on
// from there, as after one of its own events, and asks for those alone; it looks for the next event among
// the contacts that may have one (short_list.h). If there are none, the step has no impact.
//
// Where the world has a ledger, contacts whose budget of motion outlasts the sweeps of the step are not even
// looked at. What the search would have noted at them is told when the first impact of the step is found,
// ahead of all that may ask for it (untold_impacts.h); a step without an impact needs none of it. Contacts of
// which neither body stops the other are not touched at all: Box2D reads nothing of what it would have noted
// there before it looks for impacts again. That is not so of a world that a listener steps in the midst of
// its own step: the outer one goes on to build islands, or to look for impacts, by what the inner one left at
// all contacts. The inner search is Box2D's.
//
// What a step of Box2D's without an impact leaves behind: bodies at the beginning of their sweep and out of
// islands; contacts out of islands, with no impact counted, a time of impact of 1, and the flag that it is
// known where it was asked for. So does this, at all that somebody may read.
#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_time_of_impact.h>
#include <box2d/b2_time_step.h>
#include <box2d/b2_world.h>

#include "contacts/solid_contact.h"
#include "hooks/short_list.h"
#include "hooks/stepping.h"
#include "hooks/untold_impacts.h"
#include "ledger/ledger.h"
#include "ledger/ledgers.h"
#include "ledger/private_members.h"
#include "proofs/impact_scan.h"
#include "reach/stock.h"
#include "start/current_step.h"
#include "start/settings.h"
#include "tell/verify.h"

using namespace bmr;
using namespace bmr::hooks;

namespace {

constexpr uint32_t kSearchesToRest = 32;

/// Box2D's own search, whose questions are known as its own.
void Search(b2World *world, const b2TimeStep &step) {
    const ImpactSearch search;
    stock::SolveToi(world, step);
}

/// Impacts are looked for where one of the two moves and one of the two may not be tunnelled through.
bool MayImpact(bool awakeA, b2BodyType typeA, bool bulletA, bool awakeB, b2BodyType typeB, bool bulletB) {
    const bool moves = (awakeA && typeA != b2_staticBody) || (awakeB && typeB != b2_staticBody);
    return moves && (bulletA || bulletB || typeA != b2_dynamicBody || typeB != b2_dynamicBody);
}

/// Box2D's answer where ours is "apart" (Mode::Verify).
void CompareWithBox2D(const ImpactScan::Side &a, const ImpactScan::Side &b) {
    b2TOIInput input;
    input.proxyA.Set(a.fixture->GetShape(), a.child);
    input.proxyB.Set(b.fixture->GetShape(), b.child);
    input.sweepA = a.sweep;
    input.sweepB = b.sweep;
    input.tMax = 1.0f;
    b2TOIOutput ours, box2d;
    ours.state = b2TOIOutput::e_separated;
    ours.t = 1.0f;
    RealTimeOfImpact(&box2d, &input);
    VerifyImpact(a.fixture, b.fixture, ours, box2d);
}

/// The first search of a step by the world's ledger: contacts whose budget outlasts the sweeps are not looked
/// at. `isDone(contact)` asks one that may meet; false where it is not known whether the two do.
template <typename IsDone>
void SolveByLedger(b2World *world, const b2TimeStep &step, bool *stepComplete, Ledger *ledger,
                   b2ContactManager *manager, const IsDone &isDone) {
    ledger->BeginSearch(GameMayRun());
    // Where there was an impact in the last step, everything is told at once: one pass over the contacts, not
    // two.
    const bool eager = ledger->FoundImpact();
    ledger->SetFoundImpact(false);
    uint32_t unproved = 0;
    const bool awakeAlone = !eager && !GameMayRun() && ledger->IsAwakeAlone(CurrentStep());
    for (uint32_t i = ledger->Count(); i-- > 0;) {
        if (awakeAlone && (i = ledger->SkipResting(i)) == Ledger::kNone)
            break;
        b2Contact *const contact = ledger->Contact(i);
        if (contact == nullptr)
            continue;
        if (ledger->LeavesOut(i)) {
            if (eager)
                ledger->ForgetOldImpact(i);
            continue;
        }
        ledger->NoteMayImpact(i);
        const bool may = ledger->MayImpact(i);
        const bool outlasts = may && ledger->OutlastsSweeps(i);
        if (!eager && (!may || outlasts))
            continue;
        ContactNumber::ForgetImpact(contact);
        ledger->EnableIfOwed(i);
        if (!may || !contact->IsEnabled())
            continue;
        if (outlasts) {
            ContactNumber::HasNoImpact(contact);
        } else if (!isDone(contact)) {
            ledger->NoteAsked(i);
            ++unproved;
        }
    }
    if (eager)
        ledger->ForgetOwed();
    if (unproved == 0) {
        ledger->SetTouchesSure(true);
        ledger->SetAlphasClear(true);
        return;
    }
    UntoldImpacts untold(ledger);
    const ShortList list(manager, ledger);
    if (eager)
        untold.Finish();
    else if (!list.IsShort() || !TimeOfImpactIsReached())
        // Box2D is about to look at all: too many are kept or, in the midst of another world's search whose
        // listener steps this world, the thread has no room for a second short list.
        untold.Tell();
    const KnownImpacts known(unproved, stepComplete); // Box2D asks for the very same ones first
    Search(world, step);
    if (!*stepComplete) // a listener turned sub-stepping on: the next step goes on by what contacts say
        ledger->LeaveNothingOut();
    const bool none = !ledger->FoundImpact() && TimeOfImpactIsReached();
    ledger->SetTouchesSure(none);
    ledger->SetAlphasClear(none);
}

} // namespace

BMR_FOR_LOADERS("_ZN7b2World8SolveTOIERK10b2TimeStep");

void b2World::SolveTOI(const b2TimeStep &step) {
    if (NothingIsInstalled())
        return stock::SolveToi(this, step);
    Ledger *ledger = FindLedger(&m_contactManager);
    bool alphasClear = false;
    if (ledger != nullptr) {
        alphasClear = ledger->AreAlphasClear();
        ledger->SetAlphasClear(false);
        ledger->SetTouchesSure(false);
        ledger->NoteSearchForImpacts();
    }
    // b2World::Solve, which ran just before, has looked for new contacts. Where that did not come by our
    // FindNewContacts (a Box2D whose inner calls are bound in part), neither would it after an impact, and
    // nobody would tell the short list of contacts that were made.
    ImpactScan *scan = HookIsOn(Hook::SolveToi) && m_stepComplete && !m_subStepping && RoundsToNearest() &&
                               stepping.searched == &m_contactManager && !IsInOwnStep(this) &&
                               !(ledger != nullptr && ledger->MayLackDynamic())
                           ? ImpactScan::Begin()
                           : nullptr;
    const bool isLookedAt = ledger != nullptr && ledger->IsLookedAtIn(CurrentStep());
    const bool byLedger =
        scan != nullptr && HookIsOn(Hook::Ledger) && !Verifying() && isLookedAt && ledger->IsWhole();
    if (ledger != nullptr && !byLedger) { // all contacts are about to be asked
        ledger->NoteAllMayImpact();
        if (isLookedAt)
            ledger->EnableDownTo(0);
    }
    if (scan == nullptr) {
        Search(this, step);
        return;
    }
    ProofRest &rest = ledger != nullptr ? ledger->RestOfSearches() : stepping.restOfSearches;
    if (!byLedger && !rest.IsOver()) {
        const ImpactsAreBox2Ds left;
        Search(this, step);
        return;
    }
    const auto begin = [ledger, byLedger](b2Body *body) {
        if (byLedger && (body->m_flags & b2Body::e_islandFlag) != 0 && !body->IsAwake())
            ledger->EnableOfSleeper(body);
        body->m_flags &= static_cast<uint16>(~b2Body::e_islandFlag);
        body->m_sweep.alpha0 = 0.0f;
    };
    if (ledger != nullptr && ledger->IsAwakeAlone(CurrentStep()) && alphasClear) {
        for (uint32_t i = 0; i < ledger->GetBodies().AwakeCount(); ++i)
            begin(ledger->GetBodies().Awake(i));
    } else {
        for (b2Body *body = m_bodyList; body != nullptr; body = body->m_next)
            begin(body);
    }
    // The contact's own part of the search; false where it is not known whether the two meet.
    const auto isDone = [scan](b2Contact *contact) {
        const b2Fixture *fixtureA = contact->m_fixtureA, *fixtureB = contact->m_fixtureB;
        const b2Body *bodyA = fixtureA->m_body, *bodyB = fixtureB->m_body;
        const ImpactScan::Side a = {fixtureA, contact->m_indexA, bodyA->m_sweep, bodyA->m_xf.q};
        const ImpactScan::Side b = {fixtureB, contact->m_indexB, bodyB->m_sweep, bodyB->m_xf.q};
        Count(&Counts::toiQueries);
        if (!scan->NeverTouch(a, b, GuessDirection(*contact), contact->m_manifold.pointCount > 0))
            return false;
        Count(&Counts::toiAnswered);
        if (Verifying())
            CompareWithBox2D(a, b);
        else
            ContactNumber::HasNoImpact(contact);
        return true;
    };
    if (byLedger) {
        SolveByLedger(this, step, &m_stepComplete, ledger, &m_contactManager, isDone);
        return;
    }
    uint32_t asked = 0, unproved = 0;
    bool asserts = false; // Box2D's own search does, if it was compiled so
    for (b2Contact *contact = m_contactManager.m_contactList; contact != nullptr; contact = contact->m_next) {
        ContactNumber::ForgetImpact(contact);
        const b2Fixture *fixtureA = contact->m_fixtureA, *fixtureB = contact->m_fixtureB;
        const b2Body *bodyA = fixtureA->m_body, *bodyB = fixtureB->m_body;
        const bool withoutDynamic = IsWithoutDynamic(*contact);
        asserts = asserts || withoutDynamic;
        if (!contact->IsEnabled() || fixtureA->m_isSensor || fixtureB->m_isSensor ||
            !MayImpact(bodyA->IsAwake(), bodyA->m_type, bodyA->IsBullet(), bodyB->IsAwake(), bodyB->m_type,
                       bodyB->IsBullet()))
            continue;
        ++asked;
        unproved += !withoutDynamic && isDone(contact) ? 0 : 1;
    }
    rest.Note(asked, unproved, kSearchesToRest);
    if (Verifying()) {
        Search(this, step);
        return;
    }
    if (unproved == 0 && !asserts)
        return;
    // In the middle of a step Box2D keeps what is known; when it is done it says that the step is complete.
    const ShortList list(&m_contactManager);
    const KnownImpacts known(unproved, &m_stepComplete); // Box2D asks for the very same ones first
    Search(this, step);
}
