// SPDX-License-Identifier: MIT
#include "world/ledger.h"

#include <cstring>
#include <initializer_list>

#include "base/private_members.h"
#include "start/current_step.h"
#include "start/settings.h"

namespace bmr {

namespace {

// Half of the records may be of contacts that are gone before they are swept together.
constexpr uint32_t kFewRecords = 64;

} // namespace

bool Ledger::Reserve(uint32_t count) {
    const uint32_t words = count / 64 + 1;
    const uint32_t had = m_awakeWords;
    if (!m_records.Reserve(count) || !m_lines.Reserve(count) || !m_contacts.Reserve(count) ||
        !m_bits.Reserve(count) || !m_patience.Reserve(count) || !m_awake.Reserve(words) ||
        !m_looked.Reserve(words) || !m_listed.Reserve(words) || !m_marks.Reserve(count))
        return false;
    for (uint32_t word = had; word < words; ++word)
        m_awake[word] = m_looked[word] = 0;
    if (words > had)
        m_awakeWords = words;
    return true;
}

bool Ledger::Follow() {
    TrimEnd();
    if (m_passes > 0) { // a step in the midst of one: it may go on here as it is, or not at all
        if (!CatchUp())
            return false;
    } else {
        const uint32_t live = static_cast<uint32_t>(m_live);
        if (m_count > 2 * live + kFewRecords)
            Compact();
        if (!CatchUp() && !Begin())
            return false;
    }
    // (Also where the interrupted pass was another one in the midst of the present one: each adds to the
    // sums, and none of them asks all.)
    if (m_interrupted || m_movers.AreSumsLost()) {
        DropAllProofs();
        for (uint32_t i = 0; i < m_count; ++i) // Box2D may have updated contacts that nobody watches
            if (m_contacts[i] != nullptr && IsResting(i))
                SetTouches(i, m_contacts[i]->IsTouching());
    }
    m_movers.ForgetSums();
    m_interrupted = false;
    return true;
}

bool Ledger::Pays() {
    if (m_restingSteps == 0 || WorksEverywhere())
        return true;
    --m_restingSteps;
    return m_passes > 0;
}

namespace {
constexpr uint32_t kPassesToTry = 32, kStepsToRest = 8 * kPassesToTry;
} // namespace

void Ledger::NoteTouchingInList(uint32_t touching) {
    constexpr uint32_t kStepsUntilLookedFor = 16;
    if (MostOf(touching) && m_restingSteps < kStepsUntilLookedFor)
        m_restingSteps = kStepsUntilLookedFor;
}

void Ledger::NoteLooks(uint32_t looks, uint32_t touching) {
    if (MostOf(touching)) { // so it would be found in the end
        m_restingSteps = kStepsToRest;
        m_triedPasses = 0;
        m_triedLooks = m_triedPairs = 0;
        return;
    }
    m_triedLooks += looks;
    m_triedPairs += static_cast<uint64_t>(m_live); // Box2D passes over those that sleep, too
    if (++m_triedPasses < kPassesToTry)
        return;
    if (2 * m_triedLooks > m_triedPairs)
        m_restingSteps = kStepsToRest;
    m_triedPasses = 0;
    m_triedLooks = m_triedPairs = 0;
}

bool Ledger::CatchUp() {
    if (IsWhole())
        return true;
    const int64_t more = int64_t{m_manager->m_contactCount} - m_live;
    if (more <= 0 || more > ContactNumber::kMost - int64_t{m_count} ||
        !Reserve(m_count + static_cast<uint32_t>(more)))
        return false;
    b2Contact *contact = m_manager->m_contactList;
    const b2Contact *const newest = Newest();
    for (int64_t k = more; k-- > 0; contact = ContactNumber::Next(contact)) {
        if (contact == nullptr || contact == newest)
            return false;
        m_contacts[m_count + static_cast<uint32_t>(k)] = contact;
    }
    // (The newest one here may have ended without a word, and one that was made since be at its place in
    // memory.)
    if (contact != newest || (newest != nullptr && NumberOf(newest) == kNone))
        return false;
    for (int64_t k = 0; k < more; ++k)
        if (!Put(m_count, m_contacts[m_count]))
            return false;
    return true;
}

/// Of all contacts of the world.
bool Ledger::Begin() {
    Empty();
    return CatchUp();
}

void Ledger::BeginEmpty() {
    if (m_passes > 0)
        return;
    Empty();
    m_owed = 0;
    m_bodies.Forget();
}

void Ledger::Empty() {
    GiveMarksBack();
    m_movers.Clear();
    m_proxyPairs.Empty();
    m_withoutDynamic = false;
    m_unlisted = 0;
    m_count = 0;
    m_live = 0;
    for (uint32_t word = 0; word < m_awakeWords; ++word)
        m_awake[word] = 0;
}

/// The next record; counted where there is memory for its movers.
bool Ledger::Put(uint32_t i, b2Contact *contact) {
    Record &record = m_records[i];
    record.a = m_movers.Acquire(contact->GetFixtureA(), m_manager->m_broadPhase, m_look);
    if (record.a == Movers::kNone)
        return false;
    record.b = m_movers.Acquire(contact->GetFixtureB(), m_manager->m_broadPhase, m_look);
    if (record.b == Movers::kNone) {
        m_movers.Release(record.a);
        return false;
    }
    if (!m_proxyPairs.Reserve(i + 1)) {
        m_movers.Release(record.a);
        m_movers.Release(record.b);
        return false;
    }
    m_proxyPairs.Add(i, *contact);
    m_withoutDynamic = m_withoutDynamic || IsWithoutDynamic(*contact);
    ContactNumber::Write(contact, i);
    m_contacts[i] = contact;
    m_bits[i] =
        static_cast<uint8_t>((contact->IsTouching() ? kTouches : 0) | (m_endings > 0 ? kUnlisted : 0));
    m_unlisted += m_endings > 0 ? 1 : 0;
    m_patience[i] = {};
    ReadMarks(i);
    ++m_count;
    ++m_live;
    Watch(i);
    return true;
}

void Ledger::ReadMarks(uint32_t i) {
    b2Contact *const contact = m_contacts[i];
    const uint32 flags = ContactNumber::Flags(contact);
    const int32 count = ContactNumber::CountOfImpacts(contact);
    const bool known = (flags & ContactNumber::kTimeIsKnown) != 0;
    m_marks.Begin(i);
    if ((flags & ContactNumber::kInIsland) != 0)
        m_marks.inIsland.Set(i);
    if (known)
        m_marks.known.Set(i);
    if (count > 0 || (known && ContactNumber::TimeOfImpact(contact) < 1.0f))
        m_marks.Meet(i, known ? ContactNumber::TimeOfImpact(contact) : 1.0f, static_cast<uint8_t>(count));
}

void Ledger::TakeMarks() {
    if (m_marks.areHere)
        return;
    for (uint32_t i = 0; i < m_count; ++i)
        if (m_contacts[i] != nullptr)
            ReadMarks(i);
    m_marks.areHere = true;
}

/// (Contacts may have ended without a word: those in the world's list alone are written.)
void Ledger::GiveMarksBack() {
    if (!m_marks.areHere)
        return;
    for (b2Contact *contact = m_manager->m_contactList; contact != nullptr;
         contact = ContactNumber::Next(contact)) {
        const uint32_t i = NumberOf(contact);
        if (i == kNone)
            continue;
        uint32 &flags = ContactNumber::Flags(contact);
        flags &= ~(ContactNumber::kInIsland | ContactNumber::kTimeIsKnown);
        flags |= m_marks.inIsland.Has(i) ? ContactNumber::kInIsland : 0;
        flags |= m_marks.known.Has(i) ? ContactNumber::kTimeIsKnown : 0;
        ContactNumber::TimeOfImpact(contact) = m_marks.Time(i);
        ContactNumber::CountOfImpacts(contact) = m_marks.CountOf(i);
    }
    m_marks.areHere = false;
}

uint32_t Ledger::NextTouching(uint32_t end) const {
    constexpr uint32_t kWord = sizeof(uint64_t);
    constexpr uint64_t kAny = 0x0101010101010101u * kTouches;
    while (end > 0) {
        uint64_t word = kAny;
        if (end % kWord == 0)
            std::memcpy(&word, &m_bits[end - kWord], kWord);
        if ((word & kAny) == 0) {
            end -= kWord;
            continue;
        }
        --end;
        if ((m_bits[end] & kTouches) != 0 && m_contacts[end] != nullptr)
            return end;
    }
    return kNone;
}

void Ledger::Take(uint32_t i) {
    DropLine(i);
    if (!IsResting(i))
        Unwatch(i);
    m_proxyPairs.Remove(i);
    m_movers.Release(m_records[i].a);
    m_movers.Release(m_records[i].b);
    m_contacts[i] = nullptr;
    m_unlisted -= (m_bits[i] & kUnlisted) != 0 ? 1 : 0;
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
            // A listener may step the world before its turn comes: Box2D asserts then that there are proxies.
            for (const uint32_t row : {m_records[i].a, m_records[i].b})
                m_movers.LoseProxy(row);
            Flag(edge->contact, 0);
        }
    }
}

void Ledger::Resync() {
    for (uint32_t word = 0; word < m_awakeWords; ++word)
        m_listed[word] = 0;
    for (const b2Contact *contact = m_manager->m_contactList; contact != nullptr;
         contact = ContactNumber::Next(contact)) {
        const uint32_t i = NumberOf(contact);
        if (i != kNone)
            m_listed[i / 64] |= uint64_t{1} << (i % 64);
    }
    for (uint32_t i = 0; i < m_count; ++i)
        if (m_contacts[i] != nullptr && (m_listed[i / 64] >> (i % 64) & 1) == 0)
            Take(i);
}

void Ledger::OweEnabling(uint32_t below) {
    m_owed = below;
    for (uint32_t word = 0; word < m_awakeWords; ++word)
        m_looked[word] = 0;
}

void Ledger::Compact() {
    uint32_t to = 0;
    for (uint32_t from = 0; from < m_count; ++from) {
        if (m_contacts[from] == nullptr)
            continue;
        const uint64_t awake = IsResting(from) ? 0 : 1;
        m_contacts[to] = m_contacts[from];
        m_records[to] = m_records[from];
        m_lines[to] = m_lines[from];
        m_bits[to] = m_bits[from];
        m_proxyPairs.Renumber(from, to);
        m_patience[to] = m_patience[from];
        m_marks.Renumber(from, to);
        m_awake[from / 64] &= ~(uint64_t{1} << (from % 64));
        m_awake[to / 64] = (m_awake[to / 64] & ~(uint64_t{1} << (to % 64))) | awake << (to % 64);
        ContactNumber::Write(m_contacts[to], to);
        ++to;
    }
    m_count = to;
    m_owed = 0;
}

void Ledger::DropAllProofs() {
    for (uint32_t i = 0; i < m_count; ++i)
        if (m_contacts[i] != nullptr && !IsResting(i))
            SetDue(i);
}

/// From here on its movers are looked at in every step. It is due: nobody knows what they did meanwhile.
void Ledger::Watch(uint32_t i) {
    const Record &record = m_records[i];
    for (const uint32_t row : {record.a, record.b})
        ++m_movers[row].watched;
    m_awake[i / 64] |= uint64_t{1} << (i % 64);
    SetTouches(i, m_contacts[i]->IsTouching()); // an impact may have changed it while nobody watched
    SetDue(i);
}

void Ledger::Unwatch(uint32_t i) {
    --m_movers[m_records[i].a].watched;
    --m_movers[m_records[i].b].watched;
    m_awake[i / 64] &= ~(uint64_t{1} << (i % 64));
}

void Ledger::Rest(uint32_t i) {
    DropLine(i);
    Unwatch(i);
}

void Ledger::Flag(const b2Contact *contact, uint8_t bits) {
    const uint32_t i = NumberOf(contact);
    if (i == kNone)
        return;
    if (IsResting(i))
        Watch(i);
    SetDue(i);
    m_bits[i] |= bits;
}

void Ledger::Wake(const b2Body *body) {
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        const uint32_t i = NumberOf(edge->contact);
        if (i == kNone)
            continue;
        if (IsResting(i))
            Watch(i);
        const Record &record = m_records[i];
        const uint32_t row = m_movers[record.a].body == body ? record.a : record.b;
        m_movers.SetBits(row, m_movers.Bits(row) | kActive);
    }
}

void Ledger::WatchPairsOf(const b2Body *body) {
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        const uint32_t i = NumberOf(edge->contact);
        if (i == kNone || !IsResting(i))
            continue;
        Watch(i);
        NoteLookedAt(i);
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
    m_locked = true;
    const uint32_t count = m_movers.Count();
    for (uint32_t row = 0; row < count; ++row) {
        m_movers.Prefetch(row + 2 * kAhead);
        m_movers.PrefetchShape(row + kAhead);
        const Mover &mover = m_movers[row];
        if (mover.records == 0)
            continue;
        const uint8_t before = m_movers.Bits(row);
        if (mover.proved > 0)
            m_movers.Look(row, m_manager->m_broadPhase, m_look, false);
        else // each of its pairs is due, and looks at it then
            m_movers.PassOver(row);
        if (m_passes > 1) // the pass that this one is in the midst of had not come by all of its pairs
            m_movers.SetBits(row, m_movers.Bits(row) | (before & kChanged));
        if (mover.watched < mover.records && m_movers.IsActiveNow(row))
            WakeRow(row);
    }
}

uint64_t Ledger::DueOf(uint32_t word) const {
    if (word >= m_awakeWords || m_awake[word] == 0)
        return 0;
    const uint32_t first = word * 64, end = m_count < first + 64 ? m_count : first + 64;
    uint64_t due = 0;
    for (uint32_t i = first; i < end; ++i)
        due |= static_cast<uint64_t>(IsDue(i)) << (i - first);
    return due & m_awake[word];
}

uint32_t Ledger::NextDue(uint32_t end) {
    constexpr uint32_t kAhead = 8;
    while (end-- > 0) {
        if (end >= 2 * kAhead) {
            PrefetchLookAgain(end - 2 * kAhead, end - kAhead);
            if (!IsResting(end - kAhead) && IsDue(end - kAhead))
                ContactNumber::Prefetch(m_contacts[end - kAhead]);
        }
        if (m_contacts[end] == nullptr || !IsWatchedByNow(end))
            continue;
        if ((m_bits[end] & kHasLine) == 0)
            return end; // due, whatever its movers did
        LookAgain(end);
        if (m_movers.AreSumsLost() || IsDue(end))
            return end;
    }
    return kNone;
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

bool Ledger::WaitsForProof(uint32_t i) {
    Patience &patience = m_patience[i];
    if ((m_bits[i] & kHasLine) != 0) {
        // It was made, and is used up. Did it spare a look?
        if (static_cast<uint8_t>(m_passNumber - patience.provedAt) > 1)
            patience = {patience.provedAt, 0, 0};
        else
            ProvedInVain(i);
    }
    if (patience.waits == 0)
        return false;
    --patience.waits;
    return true;
}

void Ledger::ProvedInVain(uint32_t i) {
    constexpr uint8_t kMostDoublings = 3;
    Patience &patience = m_patience[i];
    if (patience.doublings < kMostDoublings)
        ++patience.doublings;
    patience.waits = static_cast<uint8_t>((1u << patience.doublings) - 1u);
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
    m_patience[i].provedAt = static_cast<uint8_t>(m_passNumber);
}

void Ledger::ProveUntil(uint32_t i, double measure, double threshold) {
    const Record &record = m_records[i];
    const bmr_mover &a = m_movers[record.a].motion, &b = m_movers[record.b].motion;
    m_records[i].deadline = bmr_budget_deadline(measure - threshold, a.moved, b.moved, kUnits);
    m_lines[i] = {};
    m_bits[i] |= kNoImpactProof;
    m_patience[i].provedAt = static_cast<uint8_t>(m_passNumber);
}

void Ledger::EnableDownTo(uint32_t down) {
    if (m_owed > m_count)
        m_owed = m_count;
    while (m_owed > down) {
        // Those of one word that are owed it, in any order: nobody looks in between.
        const uint32_t word = (m_owed - 1) / 64, first = word * 64 > down ? word * 64 : down;
        uint64_t owed = m_awake[word] & ~m_looked[word] & ~uint64_t{0} << (first % 64);
        if (m_owed % 64 != 0)
            owed &= ~(~uint64_t{0} << (m_owed % 64));
        for (uint64_t left = owed; left != 0; left &= left - 1)
            BMR_PREFETCH(m_contacts[word * 64 + LowestBit(left)]);
        for (; owed != 0; owed &= owed - 1) {
            const uint32_t i = word * 64 + LowestBit(owed);
            if (IsActive(i))
                ContactNumber::Enable(m_contacts[i]);
        }
        m_owed = first;
    }
}

void Ledger::EnableOfSleeper(const b2Body *body) {
    for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        const uint32_t i = NumberOf(edge->contact);
        if (i != kNone)
            EnableIfOwed(i);
    }
}

void Ledger::BeginSearch(bool careful) {
    if (m_movers.AreSumsLost())
        DropAllProofs();
    ++m_look; // and the sweeps of no mover are looked at
    m_sweepsCarefully = careful;
    if (careful)
        m_movers.LookAtAllSweeps(m_look);
}

} // namespace bmr
