// SPDX-License-Identifier: MIT
// b2ContactManager::Collide: the loop over a world's contacts at the start of a step. The same contacts in
// the same order, each filtered, destroyed or updated when Box2D would.
//
// A world with a ledger (world/ledger.h) does not look at contacts whose budget of motion is not used up.
// What Box2D's loop would leave behind at these is what is there already: no points, not touching, enabled.
// The last is not quite so: a game may have disabled a contact that nobody looked at, and Box2D would enable
// it in passing. That is made good before anybody can see it: ahead of every call of the game's code, for the
// contacts that the loop has passed, and at the end of the loop where code of the game may still run in this
// step. (Where none may, it is b2World::SolveTOI alone that asks; see solve_toi.cpp.)
//
// Worlds of few contacts, and those whose ledger has no memory, are stepped by Box2D's list.
#include <cstdint>
#include <initializer_list>
#include <optional>

#include <box2d/b2_world.h>

#include "base/compiler.h"
#include "base/rounding_mode.h"
#include "contacts/apart_line.h"
#include "contacts/convex_contact.h"
#include "contacts/polygon_contact.h"
#include "hooks/stepping.h"
#include "passes/contact_access.h"
#include "reach/stock.h"
#include "start/current_step.h"
#include "start/settings.h"
#include "tell/verify.h"
#include "tree/box.h"
#include "world/ledger.h"
#include "world/ledgers.h"

namespace bmr::hooks {

namespace {

/// Names the call below.
struct NoProxy {};

} // namespace

} // namespace bmr::hooks

/// Box2D's function on a proxy that is none: where Box2D was compiled with its assertions, they end the
/// program. Else nothing is left of the call.
template <> void b2BroadPhase::UpdatePairs(bmr::hooks::NoProxy *) {
    const int32 count = m_pairCount;
    m_queryProxyId = 0;
    QueryCallback(e_nullProxy);
    m_pairCount = count;
}

namespace bmr::hooks {

namespace {

bool IsActive(const b2Body *body) {
    return body->IsAwake() && body->GetType() != b2_staticBody;
}

inline bool BoxesOverlap(b2ContactManager *manager, const b2Contact *contact) {
    const int32 a = FixtureAccess::ProxyOf(contact->GetFixtureA(), contact->GetChildIndexA()),
                b = FixtureAccess::ProxyOf(contact->GetFixtureB(), contact->GetChildIndexB());
    // (A filter may put a body out of the world that then gets contacts all the same.)
    if (BMR_RARELY(a == b2BroadPhase::e_nullProxy || b == b2BroadPhase::e_nullProxy))
        manager->m_broadPhase.UpdatePairs(static_cast<NoProxy *>(nullptr));
    return tree::Overlap(tree::BoxOf(manager->m_broadPhase.GetFatAABB(a)),
                         tree::BoxOf(manager->m_broadPhase.GetFatAABB(b)));
}

void Update(b2Contact *contact, b2ContactListener *listener) {
    const bool sensor = contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor();
    const bool here = !Verifying() && RoundsToNearest(); // by now: a listener may change it
    PolygonContact *ofSmall = here ? PolygonContact::AsOurs(contact) : nullptr;
    if (sensor) {
        if (ofSmall == nullptr || !HookIsOn(Hook::TestOverlap) || !ofSmall->UpdateSensor(listener))
            SolidContact::UpdateByBox2D(contact, listener);
    } else if (ofSmall != nullptr)
        ofSmall->UpdateSolid(listener);
    else if (ConvexContact *ofBig = here ? ConvexContact::AsOurs(contact) : nullptr)
        ofBig->UpdateSolid(listener);
    else
        SolidContact::UpdateByBox2D(contact, listener);
}

/// The contact of a sensor whose life is told: of two polygons. Else nullptr.
SolidContact *SensorThatLives(b2Contact *contact) {
    if (!GetSettings().options.statistics ||
        !(contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor()))
        return nullptr;
    SolidContact *ours = SolidContact::AsOurs(contact);
    return ours != nullptr && ours->IsOfPolygons() ? ours : nullptr;
}

/// Brings one contact up to date; false where it is to be destroyed. Counts those that are awake and touch.
inline bool Persists(b2ContactManager *manager, b2Contact *contact, uint32_t *touching) {
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
    *touching += contact->IsTouching() ? 1 : 0;
    return true;
}

/// The world's list, contact by contact. How many of those that are awake touch.
uint32_t CollideByList(b2ContactManager *manager) {
    uint32_t touching = 0;
    b2Contact *contact = manager->m_contactList;
    while (contact != nullptr) {
        ContactNumber::Prefetch(contact->GetNext());
        if (Persists(manager, contact, &touching)) {
            contact = contact->GetNext();
        } else {
            b2Contact *parted = contact;
            contact = contact->GetNext();
            manager->Destroy(parted);
        }
    }
    return touching;
}

/// nullptr where it has no contacts.
const b2World *WorldOf(const b2ContactManager &manager) {
    const b2Contact *const contact = manager.m_contactList;
    return contact == nullptr ? nullptr : contact->GetFixtureA()->GetBody()->GetWorld();
}

/// A pass over the ledger. The listener that contacts are handed is this one, where the world has one of the
/// game's: whatever the game's code does, the pass knows that it ran.
class LedgerPass final : private b2ContactListener {
public:
    LedgerPass(Ledger *ledger, b2ContactManager *manager)
        : m_ledger(ledger), m_manager(manager), m_world(WorldOf(*manager)), m_pass(ledger) {}

    void Run();

private:
    // Ahead of game code and behind it.
    class Game;

    void BeginContact(b2Contact *contact) override;
    void EndContact(b2Contact *contact) override;
    void PreSolve(b2Contact *contact, const b2Manifold *old) override;
    void PostSolve(b2Contact *, const b2ContactImpulse *) override {}

    /// For one update of one contact: whoever listens as it begins is told all of it, though the game may put
    /// another one into the world meanwhile.
    b2ContactListener *Listener() {
        m_listener = m_manager->m_contactListener;
        if (!IsOfGame(m_listener))
            return m_listener;
        m_preSolves = HasOwnPreSolve(*m_listener);
        return this;
    }
    uint32_t Next();
    uint32_t TakeNewest(uint64_t *left) const;
    void Visit(uint32_t i);
    bool PassesFilter(uint32_t i, b2Contact *contact);
    void Destroy(uint32_t i, b2Contact *contact);
    void Wake(const b2Body *body, uint32_t i);
    void Look(uint32_t i, b2Contact *contact);
    void Verify(uint32_t i);

    Ledger *m_ledger;
    b2ContactManager *m_manager;
    const b2World *m_world;
    Ledger::Pass m_pass;
    b2ContactListener *m_listener = nullptr; ///< of the update that is under way
    bool m_preSolves = true; ///< the listener's PreSolve is not the empty one of b2ContactListener
    uint32_t m_looks = 0, m_touching = 0; ///< in this pass; of them, those that touch and are due again
    uint32_t m_at = 0;   ///< records from here on are passed; the one that is visited is the last of them
    uint64_t m_seen = 0; ///< the look that the pass goes by, as long as no code of the game ran
    uint64_t m_due =
        0; ///< of the word of 64 records that the pass is in, those that are due and still to come
    uint32_t m_word = 0; ///< its number; words from it on were looked at
};

class LedgerPass::Game {
public:
    explicit Game(LedgerPass *pass) : m_pass(pass), m_passNumber(pass->m_ledger->PassNumber()) {
        pass->m_ledger->EnableDownTo(pass->m_at + 1);
    }
    ~Game() {
        // A step that a listener makes unlocks the world when it is done.
        const bool otherPass = m_pass->m_ledger->PassNumber() != m_passNumber;
        m_pass->m_ledger->Distrust(!otherPass && m_pass->m_world->IsLocked());
        if (otherPass)
            m_pass->m_ledger->OweEnabling(m_pass->m_at); // and this one goes on
    }
    Game(const Game &) = delete;
    Game &operator=(const Game &) = delete;

private:
    LedgerPass *m_pass;
    uint32_t m_passNumber;
};

void LedgerPass::BeginContact(b2Contact *contact) {
    const Game game(this);
    m_listener->BeginContact(contact);
}

void LedgerPass::EndContact(b2Contact *contact) {
    const Game game(this);
    m_listener->EndContact(contact);
}

void LedgerPass::PreSolve(b2Contact *contact, const b2Manifold *old) {
    if (!m_preSolves)
        return;
    const Game game(this);
    m_listener->PreSolve(contact, old);
}

/// The next record that is due. Found for 64 records at a time; contacts are asked for from memory some
/// visits ahead.
uint32_t LedgerPass::Next() {
    constexpr int kAhead = 3;
    if (m_ledger->CurrentLook() != m_seen)
        return m_ledger->NextDue(m_at);
    while (m_due == 0) {
        if (m_word == 0)
            return Ledger::kNone;
        m_due = m_ledger->DueOf(--m_word);
        for (uint64_t left = m_due, ahead = kAhead; left != 0 && ahead > 0; --ahead)
            ContactNumber::Prefetch(m_ledger->Contact(TakeNewest(&left)));
    }
    const uint32_t next = TakeNewest(&m_due);
    uint64_t left = m_due;
    for (int ahead = 1; left != 0 && ahead < kAhead; ++ahead)
        TakeNewest(&left);
    if (left != 0)
        ContactNumber::Prefetch(m_ledger->Contact(TakeNewest(&left)));
    return next;
}

/// The number of the last of the word's records that are left.
uint32_t LedgerPass::TakeNewest(uint64_t *left) const {
    const uint32_t bit = HighestBit(*left);
    *left &= ~(uint64_t{1} << bit);
    return m_word * 64 + bit;
}

bool LedgerPass::PassesFilter(uint32_t i, b2Contact *contact) {
    std::optional<Game> game;
    if (IsOfGame(m_manager->m_contactFilter))
        game.emplace(this);
    const bool passes = PassesFilters(m_manager, contact->GetFixtureA(), contact->GetFixtureB());
    game.reset();
    if (passes) {
        SolidContact::FilteringIsDone(contact);
        m_ledger->ClearBit(i, kToBeFiltered);
    }
    return passes;
}

void LedgerPass::Destroy(uint32_t i, b2Contact *contact) {
    if (contact->IsTouching() && IsOfGame(m_manager->m_contactListener)) {
        const Game game(this);
        m_manager->Destroy(contact);
        m_ledger->Remove(i, contact); // where Destroy did not come by our hook
        return;
    }
    b2Body *const bodies[2] = {contact->GetFixtureA()->GetBody(), contact->GetFixtureB()->GetBody()};
    const bool slept[2] = {!IsActive(bodies[0]), !IsActive(bodies[1])};
    m_manager->Destroy(contact);
    m_ledger->Remove(i, contact);
    for (int side = 0; side < 2; ++side) // the end of a contact that touched wakes its bodies
        if (slept[side] && IsActive(bodies[side]))
            Wake(bodies[side], i);
}

/// A body woke in the midst of the pass: its pairs that are still to come are due by now. Those that the pass
/// has come by slept then: they are not to be enabled as if they had not.
void LedgerPass::Wake(const b2Body *body, uint32_t i) {
    m_ledger->EnableDownTo(i + 1);
    m_ledger->Wake(body);
    if (m_word == i / 64)
        m_due = m_ledger->DueOf(m_word) & ~(~uint64_t{0} << (i % 64));
}

/// As Box2D looks at a contact. What is apart afterwards gets a budget.
void LedgerPass::Look(uint32_t i, b2Contact *contact) {
    Movers &movers = m_ledger->GetMovers();
    const Ledger::Record record = m_ledger->At(i);
    Count(&Counts::looks);
    ++m_looks;
    m_ledger->NoteLookedAt(i);
    SolidContact *const sensor = SensorThatLives(contact);
    const bmr_vec2 before = sensor != nullptr ? sensor->GuessDirection() : bmr_vec2{0.0, 0.0};
    Update(contact, Listener());
    if (m_ledger->Contact(i) != contact)
        return; // the game ended it
    if (sensor != nullptr)
        sensor->LiveAsSensor(before);
    for (const uint32_t row : {record.a, record.b}) {
        if (movers.IsActive(row) || !movers.IsActiveNow(row))
            continue;
        Wake(movers[row].body, i);
    }
    // A listener may have changed the two, and change them back before the next pass: a proof is of what they
    // are at this moment.
    m_ledger->LookAgain(i);
    m_ledger->SetTouches(i, contact->IsTouching());
    SolidContact *ours = SolidContact::AsOurs(contact);
    // (A listener may have flagged this very contact: Box2D filters it in the next step.)
    const bool canProve = ours != nullptr && ours->IsOfPolygons() &&
                          contact->GetManifold()->pointCount == 0 && !SolidContact::WantsFiltering(*contact);
    if (canProve && !contact->IsTouching())
        ProveApart(m_ledger, i, ours);
    else if (canProve && (contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor()))
        ProveOverlap(m_ledger, i);
    else {
        m_ledger->SetDue(i);
        m_touching += contact->IsTouching() ? 1 : 0;
    }
}

void LedgerPass::Visit(uint32_t i) {
    Movers &movers = m_ledger->GetMovers();
    const Ledger::Record record = m_ledger->At(i);
    b2Contact *const contact = m_ledger->Contact(i);
    const bool hasLine = (m_ledger->Bits(i) & kHasLine) != 0;
    if (!hasLine)
        m_ledger->LookAgain(i);
    // Without a line the contact is read anyway.
    // (A step by the list may have filtered it since it was flagged.)
    if (((m_ledger->Bits(i) & kToBeFiltered) != 0 || !hasLine) && SolidContact::WantsFiltering(*contact)) {
        const bool passes = PassesFilter(i, contact);
        // The filter may have ended it. Box2D then goes by its memory, and survives that if nobody is active.
        if (m_ledger->Contact(i) != contact)
            return;
        if (!passes) {
            Destroy(i, contact);
            return;
        }
        m_ledger->LookAgain(i);
    }
    if (!movers.IsActive(record.a) && !movers.IsActive(record.b)) { // whoever woke since is known to have
        m_ledger->SetTouches(i, contact->IsTouching());             // an impact may have changed it
        m_ledger->Rest(i);
        return;
    }
    if (!(m_ledger->KnowsBoxes(i) ? m_ledger->BoxesOverlap(i) : BoxesOverlap(m_manager, contact))) {
        Destroy(i, contact);
        return;
    }
    if (!Verifying() && m_ledger->Renew(i, ApartThreshold(*m_ledger, i))) {
        Count(&Counts::renewals);
        return;
    }
    Look(i, contact);
}

/// Mode::Verify: every pair is looked at. One that has a budget must be found as it was; and one whose budget
/// its line would renew, if it is still there.
void LedgerPass::Verify(uint32_t i) {
    if (m_ledger->CurrentLook() != m_seen)
        m_ledger->LookAgain(i); // as NextDue would
    const bool due = m_ledger->IsDue(i) || m_ledger->GetMovers().AreSumsLost();
    const bool renewed = due && m_ledger->Renew(i, ApartThreshold(*m_ledger, i));
    const bool touches = (m_ledger->Bits(i) & kTouches) != 0;
    b2Contact *const contact = m_ledger->Contact(i);
    const b2Fixture *const a = contact->GetFixtureA(), *const b = contact->GetFixtureB();
    Visit(i);
    const bool gone = m_ledger->Contact(i) != contact;
    if (due && (!renewed || gone))
        return;
    CountVerified();
    if (gone || contact->IsTouching() != touches)
        ReportDifference("budget", a, b, "the contact begins or ends to touch, or is gone");
}

void LedgerPass::Run() {
    m_ledger->LookAtMovers();
    if (GetSettings().options.statistics)
        GetCounts().pairsWatched.fetch_add(m_ledger->CountWatched(), std::memory_order_relaxed);
    m_ledger->OweEnabling(m_ledger->Count());
    m_seen = m_ledger->CurrentLook();
    m_at = m_ledger->Count();
    m_word = m_at / 64 + 1;
    if (Verifying()) {
        while (m_at-- > 0)
            if (m_ledger->Contact(m_at) != nullptr && m_ledger->IsWatchedByNow(m_at))
                Verify(m_at);
        m_at = 0;
    } else {
        for (uint32_t i = Next(); i != Ledger::kNone; i = Next()) {
            m_at = i;
            Visit(i);
        }
    }
    m_pass.Complete();
    m_ledger->NoteLooks(m_looks, m_touching);
    // Code of the game runs later in this step, or ran since the last pass: it could read or have written
    // IsEnabled(). (Whoever listened as the step began may have left by now, and a step in the midst of
    // another one is the game's call.)
    const bool gameMayRun = GameMayRun() || IsInOwnStep(m_world) || IsOfGame(m_manager->m_contactListener) ||
                            IsOfGame(m_manager->m_contactFilter);
    if (gameMayRun || m_ledger->DidGameRun() || !m_ledger->AreSearchesForImpactsSeen())
        m_ledger->EnableDownTo(0);
    m_ledger->SetGameRan(gameMayRun);
}

BMR_NOINLINE void CollideHere(b2ContactManager *manager) {
    if (!HookIsOn(Hook::ContactLoop)) {
        stock::Collide(manager);
        return;
    }
    Ledger *ledger = nullptr;
    if (HookIsOn(Hook::Ledger) && RoundsToNearest()) {
        ledger = FindLedger(manager);
        if (ledger == nullptr && manager->m_contactCount >= WorthALedgerAnyway())
            ledger = MakeLedger(manager);
    }
    if (ledger != nullptr && !ledger->MayHaveUnlisted() && ledger->Pays() && ledger->Follow()) {
        LedgerPass(ledger, manager).Run();
        return;
    }
    // What contacts do meanwhile the ledger does not see: nothing that it knows holds when it is asked again.
    if (Ledger *passedOver = FindLedger(manager))
        passedOver->Interrupt();
    const uint32_t touching = CollideByList(manager);
    if (Ledger *passedOver = FindLedger(manager))
        passedOver->NoteTouchingInList(touching);
}

} // namespace

} // namespace bmr::hooks

using namespace bmr;
using namespace bmr::hooks;

BMR_FOR_LOADERS("_ZN16b2ContactManager7CollideEv");

void b2ContactManager::Collide() {
    if (NothingIsInstalled())
        stock::Collide(this);
    else
        CollideHere(this);
}
