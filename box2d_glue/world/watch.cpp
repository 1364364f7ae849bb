// SPDX-License-Identifier: MIT
// Which pairs are looked at: those of bodies that are awake are watched; of these, a pass looks at those that
// are due.
#include <initializer_list>

#include "start/current_step.h"
#include "world/ledger.h"

namespace bmr {

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

} // namespace bmr
