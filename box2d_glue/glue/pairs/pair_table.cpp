// SPDX-License-Identifier: MIT
#include "glue/pairs/pair_table.h"

#include <initializer_list>

#include "debug/verify.h"
#include "start/settings.h"

namespace bmr {

void PairTable::Reserve(uint32_t count) {
    m_pairs.Reserve(count);
    m_lines.Reserve(count);
    m_contacts.Reserve(count);
    m_bits.Reserve(count);
    m_awake.Reserve(count);
    m_touching.Reserve(count);
    m_toiCandidates.Reserve(count);
    deferred.Reserve(count);
    impacts.Reserve(count);
    if (PairsAreHulls())
        hullPairs.Reserve(count);
}

bool PairTable::Follow() {
    // Half of the pairs may be of contacts that have ended before the others get their numbers.
    constexpr uint32_t kFewPairs = 64;
    TrimEnd();
    const uint32_t live = static_cast<uint32_t>(m_live);
    if (m_count > 2 * live + kFewPairs)
        Compact();
    if (!CatchUp()) {
        Empty(); // and begins anew, with all contacts of the world
        if (!CatchUp())
            return false;
    }
    if (m_interrupted || motions.AreSumsLost()) {
        DropAllProofs();
        for (uint32_t i = 0; i < m_count; ++i) // Box2D's list may have updated contacts of pairs that sleep
            if (m_contacts[i] != nullptr && !IsAwake(i))
                SetTouching(i, m_contacts[i]->IsTouching());
    }
    motions.ForgetSums();
    bodies.SetOnlyAwakeInIslands(false);
    m_interrupted = false;
    return true;
}

void PairTable::Interrupt() {
    GiveMarksBack();
    bodies.NoteDisplaced();
    deferred.Forget();
    m_interrupted = true;
}

bool PairTable::CatchUp() {
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

void PairTable::Empty() {
    GiveMarksBack();
    motions.Clear();
    fixturePairs.Clear();
    hullPairs.Clear();
    m_count = 0;
    m_live = m_awakeCount = 0;
    m_awake.ClearAll();
    m_touching.ClearAll();
}

void PairTable::Put(uint32_t i, b2Contact *contact) {
    Pair &pair = m_pairs[i];
    pair.a = motions.Acquire(contact->GetFixtureA(), m_manager->m_broadPhase, m_stamp);
    pair.b = motions.Acquire(contact->GetFixtureB(), m_manager->m_broadPhase, m_stamp);
    fixturePairs.Add(i, *contact);
    ContactNumber::Write(contact, i);
    m_contacts[i] = contact;
    m_bits[i] = 0;
    impacts.Begin(i, contact);
    ++m_count;
    ++m_live;
    Awaken(i);
}

/// (Contacts may have ended without a word: those in the world's list alone are written.)
void PairTable::GiveMarksBack() {
    if (!impacts.areKnown)
        return;
    for (b2Contact *contact = m_manager->m_contactList; contact != nullptr; contact = contact->GetNext()) {
        const uint32_t i = NumberOf(contact);
        if (i != kNone && impacts.noImpact.Has(i))
            ContactAccess::Flags(contact) |= ContactAccess::kTimeIsKnown;
    }
    impacts.areKnown = false;
}

void PairTable::Remove(uint32_t i) {
    if (IsAwake(i))
        SetAsleep(i);
    m_touching.Clear(i);
    fixturePairs.Remove(i);
    hullPairs.End(i);
    motions.Release(m_pairs[i].a);
    motions.Release(m_pairs[i].b);
    m_contacts[i] = nullptr;
    --m_live;
    TrimEnd();
}

/// No number of a contact that has ended goes to a newer one while the table is held.
void PairTable::TrimEnd() {
    while (m_holds == 0 && m_count > 0 && m_contacts[m_count - 1] == nullptr)
        --m_count;
}

const b2Contact *PairTable::Newest() const {
    for (uint32_t i = m_count; i-- > 0;)
        if (m_contacts[i] != nullptr)
            return m_contacts[i];
    return nullptr;
}

uint32_t PairTable::FindNumber(const b2Contact *contact) {
    if (m_manager->m_contactList != Newest())
        CatchUp();
    return NumberOf(contact);
}

void PairTable::Compact() {
    uint32_t to = 0;
    for (uint32_t from = 0; from < m_count; ++from) {
        if (m_contacts[from] == nullptr)
            continue;
        m_contacts[to] = m_contacts[from];
        m_pairs[to] = m_pairs[from];
        m_lines[to] = m_lines[from];
        m_bits[to] = m_bits[from];
        fixturePairs.Renumber(from, to);
        hullPairs.Renumber(from, to);
        impacts.Renumber(from, to);
        for (BitColumn *column : {&m_awake, &m_touching, &m_toiCandidates})
            column->Renumber(from, to);
        ContactNumber::Write(m_contacts[to], to);
        ++to;
    }
    m_count = to;
}

// Which pairs are awake, and which of these are due.

/// The pair is due: what its fixtures did while it slept is unknown.
void PairTable::Awaken(uint32_t i) {
    const Pair &pair = m_pairs[i];
    for (const uint32_t row : {pair.a, pair.b})
        ++motions[row].awake;
    m_awake.Set(i);
    ++m_awakeCount;
    m_toiCandidates.Set(i);
    SetDue(i);
}

void PairTable::SetAsleep(uint32_t i) {
    DropProof(i);
    for (const uint32_t row : {m_pairs[i].a, m_pairs[i].b})
        --motions[row].awake;
    m_awake.Clear(i);
    --m_awakeCount;
}

void PairTable::Flag(const b2Contact *contact) {
    const uint32_t i = NumberOf(contact);
    if (i == kNone)
        return;
    if (!IsAwake(i))
        Awaken(i);
    SetDue(i);
}

void PairTable::Awaken(const b2Body *body) {
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        const uint32_t i = NumberOf(edge->contact);
        if (i == kNone)
            continue;
        if (!IsAwake(i))
            Awaken(i);
        const Pair &pair = m_pairs[i];
        const uint32_t row = motions[pair.a].body == body ? pair.a : pair.b;
        motions.SetBits(row, motions.Bits(row) | kActive);
    }
}

void PairTable::AwakenPassed(const b2Body *body) {
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        const uint32_t i = NumberOf(edge->contact);
        if (i == kNone || IsAwake(i))
            continue;
        Awaken(i);
        deferred.NoteSettled(i);
    }
}

uint32_t PairTable::UpdateMotions() {
    constexpr uint32_t kAhead = 6;
    uint32_t active = 0;
    ++m_stamp;
    const uint32_t count = motions.Count();
    for (uint32_t row = 0; row < count; ++row) {
        motions.Prefetch(row + 2 * kAhead);
        motions.PrefetchShape(row + kAhead);
        const FixtureMotion &motion = motions[row];
        if (motion.pairs == 0)
            continue;
        if (motion.proved > 0) {
            motions.Update(row, m_manager->m_broadPhase, m_stamp, false);
            active += motions.IsActive(row) ? 1 : 0;
        } else // each of its pairs is due, and refreshes it then
            motions.PassOver(row);
        if (motion.awake < motion.pairs && motions.IsActiveNow(row))
            Awaken(motion.body);
    }
    return active;
}

uint64_t PairTable::DueOf(uint32_t word) const {
    if (AwakeOf(word) == 0)
        return 0;
    const uint32_t first = word * 64, end = m_count < first + 64 ? m_count : first + 64;
    uint64_t due = 0;
    for (uint32_t i = first; i < end; ++i)
        due |= static_cast<uint64_t>(IsDue(i)) << (i - first);
    return due & m_awake.Word(word);
}

/// Ahead of Refresh: asks memory for what it compares, for the second pair once that came for the first.
inline void PairTable::PrefetchRefresh(uint32_t fixtures, uint32_t shapes) const {
    for (const uint32_t row : {m_pairs[fixtures].a, m_pairs[fixtures].b})
        if (motions.StampOf(row) != m_stamp)
            motions.Prefetch(row);
    for (const uint32_t row : {m_pairs[shapes].a, m_pairs[shapes].b})
        if (motions.StampOf(row) != m_stamp)
            motions.PrefetchShape(row);
}

uint32_t PairTable::NextDue(uint32_t end) {
    constexpr uint32_t kAhead = 8;
    while (end-- > 0) {
        if (end >= 2 * kAhead) {
            PrefetchRefresh(end - 2 * kAhead, end - kAhead);
            if (IsAwake(end - kAhead) && IsDue(end - kAhead))
                ContactNumber::Prefetch(m_contacts[end - kAhead]);
        }
        if (m_contacts[end] == nullptr)
            continue;
        const Pair pair = m_pairs[end];
        if (!IsAwake(end) && (motions.IsActiveNow(pair.a) || motions.IsActiveNow(pair.b)))
            Awaken(end); // one of its bodies has woken since the pass began
        if (!IsAwake(end))
            continue;
        if ((m_bits[end] & kHasProof) == 0)
            return end; // due, for any motion of its fixtures
        Refresh(end);
        if (motions.AreSumsLost() || IsDue(end))
            return end;
    }
    return kNone;
}

void PairTable::BeginSearch() {
    if (motions.AreSumsLost())
        DropAllProofs();
    if (deferred.GameRan())
        motions.UpdateAllSweeps(m_stamp);
    if (motions.TakeNewBullets())
        m_toiCandidates.SetAll();
}

// A pair's deadline: made by a proof, renewed by the pair's line, dropped.

void PairTable::DropAllProofs() {
    for (uint32_t i = 0; i < m_count; ++i)
        if (m_contacts[i] != nullptr && IsAwake(i))
            SetDue(i);
}

bool PairTable::Renew(uint32_t i, double threshold) {
    const Pair &pair = m_pairs[i];
    if ((m_bits[i] & kHasProof) == 0 || ((motions.Bits(pair.a) | motions.Bits(pair.b)) & kChanged) != 0 ||
        motions.AreSumsLost())
        return false;
    const bmr_mover &a = motions[pair.a].mover, &b = motions[pair.b].mover;
    const double slack = bmr_budget_line_gap(&m_lines[i], &a, &b, kUnits) - threshold;
    const uint32_t deadline = bmr_budget_deadline(slack, a.moved, b.moved, kUnits);
    if (bmr_budget_is_due(deadline, a.moved, b.moved))
        return false;
    m_pairs[i].deadline = deadline;
    return true;
}

bool PairTable::BeginProof(uint32_t i) {
    DropProof(i);
    const Pair &pair = m_pairs[i];
    motions.AddProof(pair.a, m_manager->m_broadPhase, m_stamp);
    motions.AddProof(pair.b, m_manager->m_broadPhase, m_stamp);
    m_bits[i] |= kHasProof;
    return ((motions.Bits(pair.a) | motions.Bits(pair.b)) & kNoBudget) == 0;
}

void PairTable::Prove(uint32_t i, bmr_vec2 d, double gap, double threshold, bool forImpactsToo) {
    const Pair &pair = m_pairs[i];
    const bmr_mover &a = motions[pair.a].mover, &b = motions[pair.b].mover;
    m_pairs[i].deadline = bmr_budget_deadline(gap - threshold, a.moved, b.moved, kUnits);
    m_lines[i] = bmr_budget_line_make(d, gap, &a, &b, kUnits);
    m_bits[i] = static_cast<uint8_t>((m_bits[i] & ~kNoImpactProof) | (forImpactsToo ? 0 : kNoImpactProof));
}

// Deferred enabling.

bool DeferredEnable::IsActive(uint32_t i) const {
    const Pair &pair = m_table.At(i);
    return m_table.motions.IsActive(pair.a) || m_table.motions.IsActive(pair.b);
}

void DeferredEnable::EnableDownTo(uint32_t down) {
    if (m_below > m_table.Count())
        m_below = m_table.Count();
    while (m_below > down) {
        // The contacts of one word that are deferred, in any order: no code of the game runs in between.
        const uint32_t word = (m_below - 1) / 64, first = word * 64 > down ? word * 64 : down;
        uint64_t deferred = m_table.AwakeOf(word) & ~m_settled.Word(word) & ~uint64_t{0} << (first % 64);
        if (m_below % 64 != 0)
            deferred &= ~(~uint64_t{0} << (m_below % 64));
        for (uint64_t left = deferred; left != 0; left &= left - 1)
            BMR_PREFETCH(m_table.Contact(word * 64 + LowestBit(left)));
        for (; deferred != 0; deferred &= deferred - 1) {
            const uint32_t i = word * 64 + LowestBit(deferred);
            b2Contact *const contact = m_table.Contact(i);
            if ((!contact->IsEnabled() || Verifying()) && IsActive(i)) {
                ContactAccess::Enable(contact);
                if (Verifying())
                    VerifyContact(*contact);
            }
        }
        m_below = first;
    }
}

void DeferredEnable::Settle(uint32_t i) {
    if (i < m_below && m_table.IsAwake(i) && !m_settled.Has(i) && IsActive(i))
        ContactAccess::Enable(m_table.Contact(i));
    NoteSettled(i);
}

void DeferredEnable::EnableOfSleeper(const b2Body *body) {
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        const uint32_t i = m_table.NumberOf(edge->contact);
        if (i != PairTable::kNone)
            Settle(i);
    }
}

void DeferredEnable::End() {
    if (m_gameRan || m_gameRanBefore || Verifying())
        EnableDownTo(0);
}

} // namespace bmr
