// SPDX-License-Identifier: MIT
#include "glue/passes.h"

#include <cstdint>
#include <optional>

#include <box2d/b2_contact_manager.h>

#include "base/compiler.h"
#include "base/private_members.h"
#include "debug/statistics.h"
#include "glue/contacts/game_calls.h"
#include "glue/pairs/pair_tables.h"
#include "glue/prove_apart.h"
#include "start/settings.h"

namespace bmr {

namespace {

/// Do the fat boxes of the two still overlap?
inline bool BoxesOverlap(const b2ContactManager &manager, const b2Contact &contact) {
    return manager.m_broadPhase.TestOverlap(
        FixtureAccess::ProxyOf(contact.GetFixtureA(), contact.GetChildIndexA()),
        FixtureAccess::ProxyOf(contact.GetFixtureB(), contact.GetChildIndexB()));
}

/// Brings one contact up to date; false where it is to be destroyed. Counts those of awake bodies.
inline bool Persists(b2ContactManager *manager, b2Contact *contact, uint32_t *awake) {
    b2Fixture *fixtureA = contact->GetFixtureA(), *fixtureB = contact->GetFixtureB();
    if (ContactAccess::WantsFiltering(*contact)) {
        if (!PassesFilters(manager, fixtureA, fixtureB))
            return false;
        ContactAccess::FilteringIsDone(contact);
    }
    if (!IsActive(fixtureA->GetBody()) && !IsActive(fixtureB->GetBody()))
        return true;
    if (!BoxesOverlap(*manager, *contact))
        return false;
    b2ContactListener *const listener = manager->m_contactListener;
    const ContactChange change = UpdateContact(contact);
    CallListener(listener, contact, change, [] {}); // which may end it
    ++*awake;
    return true;
}

/// b2ContactManager::Collide by Box2D's list, contact by contact, from this one on. As in Box2D, a filter
/// or a listener that breaks the rules may have destroyed the contact that it was asked about: its memory
/// says which one is next. Returns how many contacts are of bodies that are awake.
uint32_t CollideByList(b2ContactManager *manager, b2Contact *contact) {
    uint32_t awake = 0;
    while (contact != nullptr) {
        ContactNumber::Prefetch(contact->GetNext());
        b2Contact *const visited = contact;
        const bool persists = Persists(manager, visited, &awake);
        contact = visited->*Named(NextContact());
        if (!persists)
            EndContact(manager, visited);
    }
    return awake;
}

/// A pass over the table, newest pair first.
class CollidePass {
public:
    CollidePass(PairTable *table, b2ContactManager *manager) : m_table(table), m_manager(manager) {}

    void Run();

private:
    uint32_t Next();
    uint32_t TakeNewest(uint64_t *left) const;
    void Visit(uint32_t i);
    bool PassesFilter(b2Contact *contact);
    void Destroy(uint32_t i, b2Contact *contact);
    void Wake(const b2Body *body, uint32_t i);
    void Update(uint32_t i, b2Contact *contact);
    void GiveDeadline(uint32_t i, b2Contact *contact);

    void BeforeGame();
    void AfterGame();

    PairTable *m_table;
    b2ContactManager *m_manager;
    uint32_t m_updates = 0; ///< in this pass
    uint32_t m_at = 0;      ///< pairs from here on are passed; the one that is visited is the last of them
    uint64_t m_seen = 0;    ///< the stamp of what the pass uses, as long as no code of the game ran
    uint64_t m_due = 0; ///< of the word of 64 pairs that the pass is in, those that are due and still to come
    uint32_t m_word = 0;         ///< its number; words from it on were passed
    b2Contact *m_next = nullptr; ///< if the world has left its table: the contact that comes next in the list
};

void CollidePass::Run() {
    const uint32_t fixtures = m_table->UpdateMotions();
    for (uint32_t word = 0; GetSettings().options.statistics && word <= m_table->Count() / 64; ++word)
        GetCounts().pairs.fetch_add(CountBits(m_table->AwakeOf(word)), std::memory_order_relaxed);
    m_table->deferred.Begin(m_table->Count());
    m_seen = m_table->Stamp();
    m_at = m_table->Count();
    m_word = m_at / 64 + 1;
    for (uint32_t i = Next(); i != PairTable::kNone; i = Next()) {
        m_at = i;
        Visit(i);
        if (m_table->WasLeft()) {
            CollideByList(m_manager, m_next);
            return;
        }
    }
    m_table->deferred.End();
    m_table->cost.NotePass(m_updates, fixtures, static_cast<uint32_t>(m_manager->m_contactCount),
                           m_table->AwakeCount());
}

/// The next pair that is due. Found for 64 pairs at a time; contacts are asked for from memory some
/// visits ahead.
uint32_t CollidePass::Next() {
    constexpr int kAhead = 3;
    if (m_table->Stamp() != m_seen)
        return m_table->NextDue(m_at);
    while (m_due == 0) {
        if (m_word == 0)
            return PairTable::kNone;
        --m_word;
        m_due = m_table->DueOf(m_word);
        for (uint64_t left = m_due, ahead = kAhead; left != 0 && ahead > 0; --ahead)
            ContactNumber::Prefetch(m_table->Contact(TakeNewest(&left)));
    }
    const uint32_t next = TakeNewest(&m_due);
    uint64_t left = m_due;
    for (int ahead = 1; left != 0 && ahead < kAhead; ++ahead)
        TakeNewest(&left);
    if (left != 0)
        ContactNumber::Prefetch(m_table->Contact(TakeNewest(&left)));
    return next;
}

/// The number of the last of the word's pairs that are left.
uint32_t CollidePass::TakeNewest(uint64_t *left) const {
    const uint32_t bit = HighestBit(*left);
    *left &= ~(uint64_t{1} << bit);
    return m_word * 64 + bit;
}

void CollidePass::Visit(uint32_t i) {
    const FixtureMotions &motions = m_table->motions;
    const Pair pair = m_table->At(i);
    b2Contact *const contact = m_table->Contact(i);
    const bool hasProof = (m_table->Bits(i) & kHasProof) != 0;
    if (!hasProof)
        m_table->Refresh(i);
    // A contact that is flagged for filtering has no proof: PairTable::Flag ends it, GiveDeadline makes none.
    if (!hasProof && ContactAccess::WantsFiltering(*contact)) {
        const bool passes = PassesFilter(contact);
        if (!passes) {
            Destroy(i, contact);
            return;
        }
        if (m_table->WasLeft()) {
            m_next = contact;
            return;
        }
        m_table->Refresh(i);
    }
    if (!motions.IsActive(pair.a) && !motions.IsActive(pair.b)) { // Wake has marked bodies that woke since
        m_table->SetTouching(i, contact->IsTouching());           // an impact may have changed it
        m_table->SetAsleep(i);
        return;
    }
    const std::optional<bool> known = m_table->KnownBoxesOverlap(i);
    if (!(known.has_value() ? *known : BoxesOverlap(*m_manager, *contact))) {
        Destroy(i, contact);
        return;
    }
    if (m_table->Renew(i, ApartThreshold(*m_table, i))) {
        Count(&Counts::renewals);
        return;
    }
    Update(i, contact);
}

bool CollidePass::PassesFilter(b2Contact *contact) {
    const bool ofGame = IsOfGame(m_manager->m_contactFilter); // ahead of the call: it may replace itself
    if (ofGame)
        BeforeGame();
    const bool passes = PassesFilters(m_manager, contact->GetFixtureA(), contact->GetFixtureB());
    if (passes)
        ContactAccess::FilteringIsDone(contact);
    if (ofGame)
        AfterGame();
    return passes;
}

void CollidePass::Destroy(uint32_t i, b2Contact *contact) {
    if (m_table->WasLeft() || (contact->IsTouching() && IsOfGame(m_manager->m_contactListener))) {
        if (!m_table->WasLeft())
            BeforeGame();
        m_next = contact->GetNext();
        EndContact(m_manager, contact);
        AfterGame();
        return;
    }
    b2Body *const bodies[2] = {contact->GetFixtureA()->GetBody(), contact->GetFixtureB()->GetBody()};
    const bool slept[2] = {!IsActive(bodies[0]), !IsActive(bodies[1])};
    EndContact(m_manager, contact);
    for (int side = 0; side < 2; ++side) // the end of a contact that touched wakes its bodies
        if (slept[side] && IsActive(bodies[side]))
            Wake(bodies[side], i);
}

/// A body woke in the middle of the pass: its pairs that are still to come are due. The others slept when the
/// pass reached them, so they are not enabled.
void CollidePass::Wake(const b2Body *body, uint32_t i) {
    m_table->deferred.EnableDownTo(i + 1);
    m_table->Awaken(body);
    if (m_word == i / 64)
        m_due = m_table->DueOf(m_word) & ~(~uint64_t{0} << (i % 64));
}

/// Takes the result of an update into the state of a sensor's contact. `before`: GuessDirection() from ahead
/// of the update.
void TakeSensorResult(SolidContact *sensor, bmr_vec2 before) {
    if (sensor->IsTouching()) {
        sensor->TakeResult(ProofResult::Nothing);
        return;
    }
    // If Box2D found the two apart, the direction is from another update, or there is none.
    const bmr_vec2 now = sensor->GuessDirection();
    if (SeparatesAlong(*sensor->GetFixtureA(), *sensor->GetFixtureB(), now))
        sensor->TakeResult(now.x == before.x && now.y == before.y ? ProofResult::Remembered
                                                                  : ProofResult::Another);
}

/// The contact of a sensor and another polygon, if statistics are on; otherwise nullptr.
SolidContact *SensorWithEvents(b2Contact *contact) {
    if (!GetSettings().options.statistics ||
        !(contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor()))
        return nullptr;
    SolidContact *ours = SolidContact::AsOurs(contact);
    return ours != nullptr && ours->IsOfPolygons() ? ours : nullptr;
}

/// As Box2D updates a contact. If it is apart afterwards, it gets a deadline.
void CollidePass::Update(uint32_t i, b2Contact *contact) {
    FixtureMotions &motions = m_table->motions;
    const Pair pair = m_table->At(i);
    Count(&Counts::updates);
    ++m_updates;
    m_table->deferred.NoteSettled(i);
    SolidContact *const sensor = SensorWithEvents(contact);
    const bmr_vec2 before = sensor != nullptr ? sensor->GuessDirection() : bmr_vec2{0.0, 0.0};
    b2ContactListener *const listener = m_manager->m_contactListener; // of this moment
    const ContactChange change = UpdateContact(contact);
    if (CallListener(listener, contact, change, [this] { BeforeGame(); }))
        AfterGame();
    if (m_table->WasLeft()) {
        m_next = contact->*Named(NextContact()); // it may have ended
        return;
    }
    if (sensor != nullptr)
        TakeSensorResult(sensor, before);
    for (const uint32_t row : {pair.a, pair.b})
        if (!motions.IsActive(row) && motions.IsActiveNow(row))
            Wake(motions[row].body, i);
    GiveDeadline(i, contact);
}

/// Gives the pair the proof that fits what it is at this moment, when the game's code ran. A listener may
/// have made a sensor solid in BeginContact, flagged the contact for filtering, or changed the two in a way
/// that it takes back before the next pass. If it stepped the world, which unlocks it, the two's boxes may
/// have parted since they were compared: the pair is due then.
void CollidePass::GiveDeadline(uint32_t i, b2Contact *contact) {
    m_table->Refresh(i);
    m_table->SetTouching(i, contact->IsTouching());
    SolidContact *ours = SolidContact::AsOurs(contact);
    const bool isApart = ours != nullptr && ours->IsOfPolygons() && !contact->IsTouching() &&
                         contact->GetManifold()->pointCount == 0 && !ContactAccess::WantsFiltering(*contact);
    if (!isApart || !ProveApart(m_table, i, ours))
        m_table->SetDue(i);
}

// The game's code: a listener or a filter.

/// The game may be called: contacts that the pass has passed are enabled, as Box2D's loop would have left
/// them.
void CollidePass::BeforeGame() {
    m_table->deferred.Flush(m_at + 1);
}

/// The game was called: what was read before may have changed.
void CollidePass::AfterGame() {
    if (LeaveIfNotWhole(m_table))
        return;
    m_table->deferred.NoteGame();
    m_table->Distrust();
    m_table->deferred.Resume(m_at + 1);
}

} // namespace

void Collide(b2ContactManager *manager, PairTable *table) {
    if (table != nullptr) {
        CollidePass(table, manager).Run();
        return;
    }
    const uint32_t awake = CollideByList(manager, manager->m_contactList);
    if (PairTable *const resting = FindPairTable(manager))
        resting->cost.NoteList(static_cast<uint32_t>(manager->m_contactCount), awake);
}

namespace {

/// A contact that ends.
struct EndingContact : b2Contact {
    /// Takes it out of all lists, and frees it.
    static void Destroy(b2ContactManager *manager, b2Contact *contact) {
        b2Contact *const before = contact->*(&EndingContact::m_prev);
        b2Contact *const after = contact->*(&EndingContact::m_next);
        (before != nullptr ? before->*(&EndingContact::m_next) : manager->m_contactList) = after;
        if (after != nullptr)
            after->*(&EndingContact::m_prev) = before;
        Detach(contact->*(&EndingContact::m_nodeA), contact->GetFixtureA()->GetBody());
        Detach(contact->*(&EndingContact::m_nodeB), contact->GetFixtureB()->GetBody());
        b2Contact::Destroy(contact, manager->m_allocator);
        --manager->m_contactCount;
    }

private:
    static void Detach(const b2ContactEdge &edge, b2Body *body) {
        (edge.prev != nullptr ? edge.prev->next : body->*Named(ContactList())) = edge.next;
        if (edge.next != nullptr)
            edge.next->prev = edge.prev;
    }
};

} // namespace

void EndContact(b2ContactManager *manager, b2Contact *contact) {
    PairTable::Ending ending(FindAndSignPairTable(manager), contact);
    if (manager->m_contactListener != nullptr && contact->IsTouching()) {
        manager->m_contactListener->EndContact(contact);
        AskRoundingAgain();
    }
    EndingContact::Destroy(manager, contact);
    ending.Complete();
}

} // namespace bmr
