// SPDX-License-Identifier: MIT
#include "glue/passes.h"

#include <cstdint>
#include <initializer_list>
#include <optional>

#include <box2d/b2_contact_manager.h>

#include "base/compiler.h"
#include "base/rounding_mode.h"
#include "debug/exit_line.h"
#include "glue/contact_update.h"
#include "glue/contacts/solid_contact.h"
#include "glue/pairs/pair_table.h"
#include "glue/pairs/pair_tables.h"
#include "glue/proofs/apart_line.h"
#include "start/current_step.h"
#include "start/settings.h"

namespace bmr {

namespace {

/// The contact of a sensor and another polygon, if statistics are on; otherwise nullptr.
SolidContact *SensorThatLives(b2Contact *contact) {
    if (!GetSettings().options.statistics ||
        !(contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor()))
        return nullptr;
    SolidContact *ours = SolidContact::AsOurs(contact);
    return ours != nullptr && ours->IsOfPolygons() ? ours : nullptr;
}

/// Contacts of a step by Box2D's list.
struct ListCounts {
    uint32_t awake = 0;    ///< one of the two bodies is
    uint32_t touching = 0; ///< of these
};

/// Brings one contact up to date; false where it is to be destroyed.
inline bool Persists(b2ContactManager *manager, b2Contact *contact, ListCounts *counts) {
    b2Fixture *fixtureA = contact->GetFixtureA(), *fixtureB = contact->GetFixtureB();
    if (SolidContact::WantsFiltering(*contact)) {
        if (!PassesFilters(manager, fixtureA, fixtureB))
            return false;
        SolidContact::FilteringIsDone(contact);
    }
    if (!IsActive(fixtureA->GetBody()) && !IsActive(fixtureB->GetBody()))
        return true;
    if (!BoxesOverlap(manager, *contact))
        return false;
    b2ContactListener *const listener = manager->m_contactListener;
    TellListener(listener, contact, UpdateContact(contact), [] {});
    ++counts->awake;
    counts->touching += contact->IsTouching() ? 1 : 0;
    return true;
}

/// b2ContactManager::Collide by Box2D's list, contact by contact, from this one on.
ListCounts CollideByList(b2ContactManager *manager, b2Contact *contact) {
    ListCounts counts;
    while (contact != nullptr) {
        ContactNumber::Prefetch(contact->GetNext());
        if (Persists(manager, contact, &counts)) {
            contact = contact->GetNext();
        } else {
            b2Contact *parted = contact;
            contact = contact->GetNext();
            manager->Destroy(parted);
            AskRoundingAgain();
        }
    }
    return counts;
}

/// A pass over the ledger, newest pair first.
class CollidePass {
public:
    CollidePass(Ledger *ledger, b2ContactManager *manager)
        : m_ledger(ledger), m_manager(manager), m_pass(ledger) {}

    void Run();

private:
    uint32_t Next();
    uint32_t TakeNewest(uint64_t *left) const;
    void Visit(uint32_t i);
    bool PassesFilter(uint32_t i, b2Contact *contact);
    void Destroy(uint32_t i, b2Contact *contact);
    void Wake(const b2Body *body, uint32_t i);
    void Look(uint32_t i, b2Contact *contact);
    void Update(b2Contact *contact);
    void Prove(uint32_t i, b2Contact *contact);
    void End();
    void FinishByList();

    void BeforeGame();
    void AfterGame();

    Ledger *m_ledger;
    b2ContactManager *m_manager;
    Ledger::Pass m_pass;
    uint32_t m_looks = 0; ///< in this pass
    uint32_t m_at = 0;    ///< records from here on are passed; the one that is visited is the last of them
    uint64_t m_seen = 0;  ///< the look whose results the pass uses, as long as no code of the game ran
    uint64_t m_due =
        0; ///< of the word of 64 records that the pass is in, those that are due and still to come
    uint32_t m_word = 0;         ///< its number; words from it on were looked at
    b2Contact *m_next = nullptr; ///< if the world has left its table: the contact that comes next in the list
};

// The game's code: a listener or a filter.

/// The game may be called: contacts that the pass has passed are enabled, as Box2D's loop would have left
/// them.
void CollidePass::BeforeGame() {
    m_ledger->Owed().Pause(m_at + 1);
}

/// The game was called: what was read before may have changed.
void CollidePass::AfterGame() {
    GameRan() = true;
    if (!m_ledger->WasLeft() && !m_ledger->IsWhole())
        LeaveTable(m_manager);
    if (m_ledger->WasLeft())
        return;
    m_ledger->Distrust();
    m_ledger->Owed().GoOn(m_at + 1);
}

/// b2Contact::Update, by the listener of this moment.
void CollidePass::Update(b2Contact *contact) {
    b2ContactListener *const listener = m_manager->m_contactListener;
    const ContactChange change = UpdateContact(contact);
    if (TellListener(listener, contact, change, [this] { BeforeGame(); }))
        AfterGame();
}

/// The next record that is due. Found for 64 records at a time; contacts are asked for from memory some
/// visits ahead.
uint32_t CollidePass::Next() {
    constexpr int kAhead = 3;
    if (m_ledger->CurrentLook() != m_seen)
        return m_ledger->NextDue(m_at);
    while (m_due == 0) {
        if (m_word == 0)
            return Ledger::kNone;
        --m_word;
        m_due = m_ledger->DueOf(m_word);
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
uint32_t CollidePass::TakeNewest(uint64_t *left) const {
    const uint32_t bit = HighestBit(*left);
    *left &= ~(uint64_t{1} << bit);
    return m_word * 64 + bit;
}

bool CollidePass::PassesFilter(uint32_t i, b2Contact *contact) {
    const bool ofGame = IsOfGame(m_manager->m_contactFilter); // ahead of the call: it may replace itself
    if (ofGame)
        BeforeGame();
    const bool passes = PassesFilters(m_manager, contact->GetFixtureA(), contact->GetFixtureB());
    if (passes)
        SolidContact::FilteringIsDone(contact);
    if (ofGame)
        AfterGame();
    if (passes && !m_ledger->WasLeft())
        m_ledger->ClearBit(i, kToBeFiltered);
    return passes;
}

void CollidePass::Destroy(uint32_t i, b2Contact *contact) {
    if (m_ledger->WasLeft() || (contact->IsTouching() && IsOfGame(m_manager->m_contactListener))) {
        if (!m_ledger->WasLeft())
            BeforeGame();
        m_next = contact->GetNext();
        m_manager->Destroy(contact);
        AskRoundingAgain();
        AfterGame();
        return;
    }
    b2Body *const bodies[2] = {contact->GetFixtureA()->GetBody(), contact->GetFixtureB()->GetBody()};
    const bool slept[2] = {!IsActive(bodies[0]), !IsActive(bodies[1])};
    m_manager->Destroy(contact);
    for (int side = 0; side < 2; ++side) // the end of a contact that touched wakes its bodies
        if (slept[side] && IsActive(bodies[side]))
            Wake(bodies[side], i);
}

/// A body woke in the middle of the pass: its pairs that are still to come are due. The others slept when the
/// pass reached them, so they are not enabled.
void CollidePass::Wake(const b2Body *body, uint32_t i) {
    m_ledger->Owed().EnableDownTo(i + 1);
    m_ledger->Wake(body);
    if (m_word == i / 64)
        m_due = m_ledger->DueOf(m_word) & ~(~uint64_t{0} << (i % 64));
}

/// As Box2D looks at a contact. If it is apart afterwards, it gets a budget.
void CollidePass::Look(uint32_t i, b2Contact *contact) {
    Movers &movers = m_ledger->GetMovers();
    const Ledger::Record record = m_ledger->At(i);
    Count(&Counts::looks);
    ++m_looks;
    m_ledger->Owed().NoteLookedAt(i);
    SolidContact *const sensor = SensorThatLives(contact);
    const bmr_vec2 before = sensor != nullptr ? sensor->GuessDirection() : bmr_vec2{0.0, 0.0};
    Update(contact);
    if (m_ledger->WasLeft()) {
        m_next = contact->GetNext();
        return;
    }
    if (sensor != nullptr)
        sensor->LiveAsSensor(before);
    for (const uint32_t row : {record.a, record.b})
        if (!movers.IsActive(row) && movers.IsActiveNow(row))
            Wake(movers[row].body, i);
    Prove(i, contact);
}

/// Gives the pair the proof that fits what it is at this moment, when the game's code ran. A listener may
/// have made a sensor solid in BeginContact, flagged the contact for filtering, or changed the two in a way
/// that it takes back before the next pass. If it stepped the world, which unlocks it, the two's boxes may
/// have parted since they were compared: the pair is due then.
void CollidePass::Prove(uint32_t i, b2Contact *contact) {
    m_ledger->LookAgain(i);
    m_ledger->SetTouches(i, contact->IsTouching());
    SolidContact *ours = SolidContact::AsOurs(contact);
    const bool canProve = ours != nullptr && ours->IsOfPolygons() &&
                          contact->GetManifold()->pointCount == 0 &&
                          !SolidContact::WantsFiltering(*contact) && contact->IsEnabled();
    if (canProve && !contact->IsTouching())
        ProveApart(m_ledger, i, ours);
    else if (canProve && (contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor()))
        ProveOverlap(m_ledger, i);
    else
        m_ledger->SetDue(i);
}

void CollidePass::Visit(uint32_t i) {
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
        if (!passes) {
            Destroy(i, contact);
            return;
        }
        if (m_ledger->WasLeft()) {
            m_next = contact;
            return;
        }
        m_ledger->LookAgain(i);
    }
    if (!movers.IsActive(record.a) && !movers.IsActive(record.b)) { // Wake has marked bodies that woke since
        m_ledger->SetTouches(i, contact->IsTouching());             // an impact may have changed it
        m_ledger->Rest(i);
        return;
    }
    const std::optional<bool> known = m_ledger->BoxesOverlap(i);
    if (!(known.has_value() ? *known : BoxesOverlap(m_manager, *contact))) {
        Destroy(i, contact);
        return;
    }
    if (m_ledger->Renew(i, ApartThreshold(*m_ledger, i))) {
        Count(&Counts::renewals);
        return;
    }
    Look(i, contact);
}

void CollidePass::Run() {
    m_ledger->LookAtMovers();
    for (uint32_t word = 0; GetSettings().options.statistics && word <= m_ledger->Count() / 64; ++word)
        GetCounts().pairs.fetch_add(CountBits(m_ledger->WatchedOf(word)), std::memory_order_relaxed);
    m_ledger->Owed().Begin(m_ledger->Count());
    m_seen = m_ledger->CurrentLook();
    m_at = m_ledger->Count();
    m_word = m_at / 64 + 1;
    for (uint32_t i = Next(); i != Ledger::kNone; i = Next()) {
        m_at = i;
        Visit(i);
        if (m_ledger->WasLeft())
            return FinishByList();
    }
    End();
}

/// The world has left its table in the middle of the pass.
void CollidePass::FinishByList() {
    CollideByList(m_manager, m_next);
    if (Ledger *const newer = FindLedger(m_manager)) // that a step inside this one has made
        newer->Interrupt();
    m_pass.Complete();
}

void CollidePass::End() {
    m_pass.Complete();
    if (StepsAreTimed())
        NotePairs(m_ledger->WatchedCount(), m_ledger->CountTouching());
    m_ledger->NoteLooks(m_looks);
    m_ledger->Owed().EndPass(GameRan());
}

} // namespace

void Collide(b2ContactManager *manager) {
    Ledger *const ledger = LedgerForStep(manager);
    if (ledger != nullptr && ledger->NextStepPays() && ledger->Follow()) {
        CollidePass(ledger, manager).Run();
        return;
    }
    // The ledger does not see what contacts do meanwhile: when it is asked again, nothing that it knows
    // holds.
    if (Ledger *passedOver = FindLedger(manager))
        passedOver->Interrupt();
    if (HasCodeOfGame(*manager))
        GameRan() = true;
    const ListCounts counts = CollideByList(manager, manager->m_contactList);
    if (StepsAreTimed())
        NotePairs(counts.awake, counts.touching);
    if (Ledger *passedOver = FindLedger(manager))
        passedOver->NoteList(counts.awake);
}

} // namespace bmr
