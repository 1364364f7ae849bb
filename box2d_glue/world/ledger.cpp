// SPDX-License-Identifier: MIT
#include "world/ledger.h"

#include <initializer_list>

#include "base/private_members.h"
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

} // namespace bmr
