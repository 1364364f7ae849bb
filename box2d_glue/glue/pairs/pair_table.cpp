// SPDX-License-Identifier: MIT
#include "glue/pairs/pair_table.h"

#include <initializer_list>

#include "base/private_members.h"
#include "glue/pairs/pair_tables.h"
#include "start/current_step.h"
#include "start/settings.h"

namespace bmr {

namespace {

// Half of the records may be of contacts that are gone before they are swept together.
constexpr uint32_t kFewRecords = 64;

} // namespace

void Ledger::Reserve(uint32_t count) {
    m_records.Reserve(count);
    m_lines.Reserve(count);
    m_contacts.Reserve(count);
    m_bits.Reserve(count);
    m_awake.Reserve(count);
    m_touching.Reserve(count);
    m_stops.Reserve(count);
    m_owed.Reserve(count);
    m_marks.Reserve(count);
    if (PairsAreHulls())
        m_hullPairs.Reserve(count);
}

bool Ledger::Follow() {
    TrimEnd();
    const uint32_t live = static_cast<uint32_t>(m_live);
    if (m_count > 2 * live + kFewRecords)
        Compact();
    if (!CatchUp() && !Begin())
        return false;
    if (m_interrupted || m_movers.AreSumsLost()) {
        DropAllProofs();
        for (uint32_t i = 0; i < m_count; ++i) // Box2D may have updated contacts that are not watched
            if (m_contacts[i] != nullptr && !IsWatched(i))
                SetTouches(i, m_contacts[i]->IsTouching());
    }
    m_movers.ForgetSums();
    m_interrupted = false;
    return true;
}

bool Ledger::CatchUp() {
    if (IsWhole())
        return true;
    const int64_t more = int64_t{m_manager->m_contactCount} - m_live;
    if (more <= 0 || more > ContactNumber::kMost - int64_t{m_count})
        return false;
    Reserve(m_count + static_cast<uint32_t>(more));
    b2Contact *contact = m_manager->m_contactList;
    const b2Contact *const newest = Newest();
    for (int64_t k = more; k-- > 0; contact = contact->GetNext()) {
        if (contact == nullptr || contact == newest)
            return false;
        m_contacts[m_count + static_cast<uint32_t>(k)] = contact;
    }
    // (The newest one here may have ended without a word, and one that was made since be at its place in
    // memory.)
    if (contact != newest || (newest != nullptr && NumberOf(newest) == kNone))
        return false;
    for (int64_t k = 0; k < more; ++k)
        Put(m_count, m_contacts[m_count]);
    return true;
}

/// Of all contacts of the world.
bool Ledger::Begin() {
    Empty();
    return CatchUp();
}

void Ledger::Empty() {
    GiveMarksBack();
    m_movers.Clear();
    m_proxyPairs.Empty();
    m_hullPairs.Clear();
    m_count = 0;
    m_live = m_watched = 0;
    m_awake.ClearAll();
    m_touching.ClearAll();
}

/// The next record; counted where there is memory for its movers.
void Ledger::Put(uint32_t i, b2Contact *contact) {
    Record &record = m_records[i];
    record.a = m_movers.Acquire(contact->GetFixtureA(), m_manager->m_broadPhase, m_look);
    record.b = m_movers.Acquire(contact->GetFixtureB(), m_manager->m_broadPhase, m_look);
    m_proxyPairs.Reserve(i + 1);
    m_proxyPairs.Add(i, *contact);
    ContactNumber::Write(contact, i);
    m_contacts[i] = contact;
    m_bits[i] = 0;
    m_marks.Read(i, contact);
    ++m_count;
    ++m_live;
    Watch(i);
}

void Ledger::TakeMarks() {
    if (m_marks.areHere)
        return;
    for (uint32_t i = 0; i < m_count; ++i)
        if (m_contacts[i] != nullptr)
            m_marks.Read(i, m_contacts[i]);
    m_marks.areHere = true;
}

/// (Contacts may have ended without a word: those in the world's list alone are written.)
void Ledger::GiveMarksBack() {
    if (!m_marks.areHere)
        return;
    for (b2Contact *contact = m_manager->m_contactList; contact != nullptr; contact = contact->GetNext()) {
        const uint32_t i = NumberOf(contact);
        if (i != kNone)
            m_marks.WriteTo(contact, i);
    }
    m_marks.areHere = false;
}

void Ledger::Take(uint32_t i) {
    DropLine(i);
    if (IsWatched(i))
        Unwatch(i);
    m_touching.Clear(i);
    m_proxyPairs.Remove(i);
    m_hullPairs.End(i);
    m_movers.Release(m_records[i].a);
    m_movers.Release(m_records[i].b);
    m_contacts[i] = nullptr;
    --m_live;
    TrimEnd();
}

/// Numbers below a pass's own are not to be given to newer contacts while it goes on.
void Ledger::TrimEnd() {
    while (m_passes == 0 && m_count > 0 && m_contacts[m_count - 1] == nullptr)
        --m_count;
}

const b2Contact *Ledger::Newest() const {
    for (uint32_t i = m_count; i-- > 0;)
        if (m_contacts[i] != nullptr)
            return m_contacts[i];
    return nullptr;
}

uint32_t Ledger::FindNumber(const b2Contact *contact) {
    if (m_manager->m_contactList != Newest())
        CatchUp();
    return NumberOf(contact);
}

void Ledger::NoteLostProxies(uint32_t number, const b2Contact &ending) {
    if (number == kNone || !m_proxyPairs.IsKnown(number))
        return; // as is each of them after the first
    for (const b2Fixture *fixture : {ending.GetFixtureA(), ending.GetFixtureB()}) {
        if (FixtureAccess::ProxyCount(fixture) > 0)
            continue;
        for (const b2ContactEdge *edge = fixture->GetBody()->GetContactList(); edge != nullptr;
             edge = edge->next) {
            const uint32_t i = NumberOf(edge->contact);
            if (i == kNone)
                continue;
            if (m_proxyPairs.IsKnown(i))
                m_proxyPairs.Forget(i);
        }
    }
}

void Ledger::Compact() {
    uint32_t to = 0;
    for (uint32_t from = 0; from < m_count; ++from) {
        if (m_contacts[from] == nullptr)
            continue;
        m_contacts[to] = m_contacts[from];
        m_records[to] = m_records[from];
        m_lines[to] = m_lines[from];
        m_bits[to] = m_bits[from];
        m_proxyPairs.Renumber(from, to);
        m_hullPairs.Renumber(from, to);
        m_marks.Renumber(from, to);
        for (BitColumn *column : {&m_awake, &m_touching, &m_stops})
            column->Renumber(from, to);
        ContactNumber::Write(m_contacts[to], to);
        ++to;
    }
    m_count = to;
    m_owed.Begin(0);
}

// Which pairs are looked at: those of bodies that are awake are watched; of these, a pass looks at those that
// are due.

/// From here on its movers are looked at in every step. It is due: what they did meanwhile is unknown.
void Ledger::Watch(uint32_t i) {
    const Record &record = m_records[i];
    for (const uint32_t row : {record.a, record.b})
        ++m_movers[row].watched;
    m_awake.Set(i);
    ++m_watched;
    m_stops.Set(i);
    SetDue(i);
}

void Ledger::Unwatch(uint32_t i) {
    --m_movers[m_records[i].a].watched;
    --m_movers[m_records[i].b].watched;
    m_awake.Clear(i);
    --m_watched;
    m_stops.Set(i);
}

void Ledger::Rest(uint32_t i) {
    DropLine(i);
    Unwatch(i);
}

void Ledger::Flag(const b2Contact *contact, uint8_t bits) {
    const uint32_t i = NumberOf(contact);
    if (i == kNone)
        return;
    if (!IsWatched(i))
        Watch(i);
    SetDue(i);
    m_bits[i] |= bits;
}

void Ledger::Wake(const b2Body *body) {
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        const uint32_t i = NumberOf(edge->contact);
        if (i == kNone)
            continue;
        if (!IsWatched(i))
            Watch(i);
        const Record &record = m_records[i];
        const uint32_t row = m_movers[record.a].body == body ? record.a : record.b;
        m_movers.SetBits(row, m_movers.Bits(row) | kActive);
    }
}

void Ledger::WatchPairsOf(const b2Body *body) {
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        const uint32_t i = NumberOf(edge->contact);
        if (i == kNone || IsWatched(i))
            continue;
        Watch(i);
        m_owed.NoteLookedAt(i);
    }
}

void Ledger::WakeRow(uint32_t row) {
    Wake(m_movers[row].body);
}

void Ledger::LookAtMovers() {
    constexpr uint32_t kAhead = 6;
    ++m_look;
    ++m_passNumber;
    m_step = CurrentStep();
    m_followed = 0;
    const uint32_t count = m_movers.Count();
    for (uint32_t row = 0; row < count; ++row) {
        m_movers.Prefetch(row + 2 * kAhead);
        m_movers.PrefetchShape(row + kAhead);
        const Mover &mover = m_movers[row];
        if (mover.records == 0)
            continue;
        if (mover.proved > 0) {
            m_movers.Look(row, m_manager->m_broadPhase, m_look, false);
            m_followed += m_movers.IsActive(row) ? 1 : 0;
        } else // each of its pairs is due, and looks at it then
            m_movers.PassOver(row);
        if (mover.watched < mover.records && m_movers.IsActiveNow(row))
            WakeRow(row);
    }
}

uint64_t Ledger::DueOf(uint32_t word) const {
    if (WatchedOf(word) == 0)
        return 0;
    const uint32_t first = word * 64, end = m_count < first + 64 ? m_count : first + 64;
    uint64_t due = 0;
    for (uint32_t i = first; i < end; ++i)
        due |= static_cast<uint64_t>(IsDue(i)) << (i - first);
    return due & m_awake.Word(word);
}

/// Ahead of LookAgain: asks memory for what it compares, for the second pair once that came for the first.
inline void Ledger::PrefetchLookAgain(uint32_t rows, uint32_t shapes) const {
    for (const uint32_t row : {m_records[rows].a, m_records[rows].b})
        if (m_movers.LookedAt(row) != m_look)
            m_movers.Prefetch(row);
    for (const uint32_t row : {m_records[shapes].a, m_records[shapes].b})
        if (m_movers.LookedAt(row) != m_look)
            m_movers.PrefetchShape(row);
}

uint32_t Ledger::NextDue(uint32_t end) {
    constexpr uint32_t kAhead = 8;
    while (end-- > 0) {
        if (end >= 2 * kAhead) {
            PrefetchLookAgain(end - 2 * kAhead, end - kAhead);
            if (IsWatched(end - kAhead) && IsDue(end - kAhead))
                ContactNumber::Prefetch(m_contacts[end - kAhead]);
        }
        if (m_contacts[end] == nullptr || !WatchIfAwake(end))
            continue;
        if ((m_bits[end] & kHasLine) == 0)
            return end; // due, for any motion of its movers
        LookAgain(end);
        if (m_movers.AreSumsLost() || IsDue(end))
            return end;
    }
    return kNone;
}

void Ledger::BeginSearch(bool careful) {
    if (m_movers.AreSumsLost())
        DropAllProofs();
    ++m_look; // and the sweeps of no mover are looked at
    m_sweepsCarefully = careful;
    if (careful)
        m_movers.LookAtAllSweeps(m_look);
    if (m_movers.TakeNewStops())
        m_stops.SetAll();
}

// What a pair's budget is: made by a proof, renewed by the pair's line, dropped.

void Ledger::DropAllProofs() {
    for (uint32_t i = 0; i < m_count; ++i)
        if (m_contacts[i] != nullptr && IsWatched(i))
            SetDue(i);
}

bool Ledger::Renew(uint32_t i, double threshold) {
    const Record &record = m_records[i];
    if ((m_bits[i] & kHasLine) == 0 ||
        ((m_movers.Bits(record.a) | m_movers.Bits(record.b)) & kChanged) != 0 || m_movers.AreSumsLost())
        return false;
    const bmr_mover &a = m_movers[record.a].motion, &b = m_movers[record.b].motion;
    const double slack = bmr_budget_line_gap(&m_lines[i], &a, &b, kUnits) - threshold;
    const uint32_t deadline = bmr_budget_deadline(slack, a.moved, b.moved, kUnits);
    if (bmr_budget_is_due(deadline, a.moved, b.moved))
        return false;
    m_records[i].deadline = deadline;
    return true;
}

bool Ledger::BeginProof(uint32_t i) {
    DropLine(i);
    const Record &record = m_records[i];
    m_movers.AddProof(record.a, m_manager->m_broadPhase, m_look);
    m_movers.AddProof(record.b, m_manager->m_broadPhase, m_look);
    m_bits[i] |= kHasLine;
    return ((m_movers.Bits(record.a) | m_movers.Bits(record.b)) & kPlain) == 0;
}

void Ledger::Prove(uint32_t i, bmr_vec2 d, double gap, double threshold, bool forImpactsToo) {
    const Record &record = m_records[i];
    const bmr_mover &a = m_movers[record.a].motion, &b = m_movers[record.b].motion;
    m_records[i].deadline = bmr_budget_deadline(gap - threshold, a.moved, b.moved, kUnits);
    m_lines[i] = bmr_budget_line_make(d, gap, &a, &b, kUnits);
    m_bits[i] = static_cast<uint8_t>((m_bits[i] & ~kNoImpactProof) | (forImpactsToo ? 0 : kNoImpactProof));
}

// Does a pass over the table pay in this world, or is Box2D's way through its list the cheaper one? Both are
// counted, so that a game is stepped in the same way wherever it runs.

namespace {

// The unit is what Box2D's loop does for a contact of a body that is awake. The rest was fitted to the times
// of the testbed's scenes, with every step by the table and with every step by the list.
constexpr uint64_t kLook = 3;             ///< the table brings a contact up to date, and proves it apart anew
constexpr uint64_t kMover = 1;            ///< the table follows a fixture
constexpr uint64_t kSleepersPerUnit = 4;  ///< Box2D's loop passes over contacts
constexpr uint64_t kSearchesPerUnit = 16; ///< for each impact Box2D passes over contacts once more
/// Islands and the first search for impacts walk Box2D's list, too. That costs half a unit for each contact.
/// A world of more contacts than this does not stay in the processor's caches, and the walks cost two units.
constexpr uint64_t kPairsInCache = 4096;
constexpr uint32_t kPassesToTry = 8, kStepsToRest = 256;

} // namespace

bool Ledger::NextStepPays() {
    if (m_restingSteps == 0 || WorksEverywhere())
        return true;
    --m_restingSteps;
    return false;
}

uint64_t Ledger::CostOfList(int32 awake) const {
    const auto pairs = static_cast<uint64_t>(m_live), watched = static_cast<uint64_t>(awake);
    return watched + (pairs - watched) / kSleepersPerUnit + (pairs <= kPairsInCache ? pairs / 2 : 2 * pairs);
}

void Ledger::NoteList(uint32_t awake) {
    if (static_cast<uint64_t>(CostOfAPass()) + (kLook + kMover) * awake <
        CostOfList(static_cast<int32>(awake)))
        m_restingSteps = 0;
}

void Ledger::NoteLooks(uint32_t looks) {
    if (m_triedPasses > 0) { // in the first one every pair is due
        m_costOfTable += static_cast<uint64_t>(CostOfAPass()) + kLook * looks + kMover * m_followed;
        m_costOfList += CostOfList(m_watched) + m_searches * static_cast<uint64_t>(m_live) / kSearchesPerUnit;
    }
    m_searches = 0;
    if (m_triedPasses++ < kPassesToTry)
        return;
    if (m_costOfTable > m_costOfList) {
        m_restingSteps = kStepsToRest;
        m_triedPasses = 0;
    } else
        m_triedPasses = 1;
    m_costOfTable = m_costOfList = 0;
}

} // namespace bmr
