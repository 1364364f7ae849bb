// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_LEDGER_H
#define BOOMERANG_GLUE_LEDGER_H

#include <cstdint>
#include <initializer_list>
#include <optional>

#include <box2d/b2_contact.h>
#include <box2d/b2_contact_manager.h>

#include "base/columns.h"
#include "base/compiler.h"
#include "boomerang/budget.h"
#include "glue/pairs/bodies.h"
#include "glue/pairs/contact_number.h"
#include "glue/pairs/deferred_enable.h"
#include "glue/pairs/fixture_motion.h"
#include "glue/pairs/marks.h"
#include "glue/pairs/proxy_pairs.h"
#include "glue/proofs/hull_pair.h"

namespace bmr {

/// The bits of a pair.
enum RecordBit : uint8_t {
    kHasLine = 1,       ///< its line renews the deadline
    kToBeFiltered = 2,  ///< Box2D has flagged it for filtering
    kNoImpactProof = 4, ///< its budget says nothing of impacts
};

struct PairRecord {
    uint32_t deadline; ///< core/budget: due once the sums of the two movers reach it
    uint32_t a, b;     ///< movers of the contact's fixtures A and B
};

/// All that is remembered of a world's pairs: one record for each contact, the oldest first. Box2D puts new
/// contacts at the head of its lists, so that the world's list and every body's are in descending order here.
///
/// A pair that was proved apart has a deadline in the sums of its two movers (core/budget). Until then no
/// code looks at it. The same deadline answers the search for impacts, with the sums that a sweep may reach.
///
/// One thread at a time uses it, the one that its world is used by. It allocates where contacts begin, never
/// on the way of a pair that stays apart.
class Ledger {
public:
    explicit Ledger(b2ContactManager *manager) : m_manager(manager), m_owed(this) {}
    Ledger(const Ledger &) = delete;
    Ledger &operator=(const Ledger &) = delete;

    /// At the start of a step: does every contact of the world have its record here, in the world's order?
    /// Begins anew where one does not. False where it cannot be, for now: the world is to be stepped by its
    /// list.
    bool Follow();
    /// Is the next pass to be made, or left out because it costs more than Box2D's loop over its list? To be
    /// asked once a step, ahead of Follow. A world whose pairs move too fast for a budget, or touch, is
    /// stepped by its list for a while, and tried again.
    bool NextStepPays();
    /// A step of the world went by without a pass: every pair is due in the next one.
    void Interrupt() {
        m_owed.Begin(0);
        m_interrupted = true;
        m_step = 0;
        ++m_passNumber;
    }
    /// So many pairs were looked at in a pass.
    void NoteLooks(uint32_t looks);
    /// In a step by the world's list so many pairs were awake. Where nearly all sleep the ledger is tried in
    /// the next step: it passes over those without a look, and Box2D's list does not.
    void NoteList(uint32_t awake);
    /// The earliest impact was searched for.
    void NoteSearch() { ++m_searches; }
    /// Takes in contacts that were made since. False if they do not fit what is here.
    bool CatchUp();
    /// It has ended. (The pointer is compared, no more.)
    void Remove(uint32_t number, const b2Contact *ended) {
        if (number != kNone && number < m_count && m_contacts[number] == ended)
            Take(number);
    }
    /// Are all contacts here? A search for pairs makes contacts in the middle of a step, and they are taken
    /// in after it; and some of the calls that end or make a contact may be bound inside Box2D. (One may have
    /// ended unseen, and the next one be at its place in memory: that one has no number yet.)
    bool IsWhole() const {
        const b2Contact *const newest = m_manager->m_contactList;
        return m_live == m_manager->m_contactCount && Newest() == newest &&
               (newest == nullptr || NumberOf(newest) != kNone);
    }

    /// The contact was flagged for filtering, or looked at by other code: its record is due.
    void Flag(const b2Contact *contact, uint8_t bits);

    static constexpr uint32_t kNone = 0xffffffffu;
    uint32_t NumberOf(const b2Contact *contact) const {
        const uint32_t number = ContactNumber::Read(contact);
        return number < m_count && m_contacts[number] == contact ? number : kNone;
    }

    /// The structures of Options::pairsBy; empty without it.
    HullPairs &GetHullPairs() { return m_hullPairs; }
    /// Good where IsWhole.
    const ProxyPairs &GetProxyPairs() const { return m_proxyPairs; }

    // A pass over all pairs, newest first.

    /// Looks at all movers; wakes the pairs of those that woke.
    void LookAtMovers();
    /// Of the 64 pairs of this word, a bit each for those that are to be looked at. Good until code of the
    /// game runs, or a body wakes.
    uint64_t DueOf(uint32_t word) const;
    /// The newest pair below `end` that is to be looked at, kNone where there is none, after code of the game
    /// ran: each pair's own two movers are compared once more.
    uint32_t NextDue(uint32_t end);
    /// Code of the game ran: what was read before may have changed. (The world was locked all the while.)
    void Distrust() { ++m_look; }
    uint32_t WatchedCount() const { return static_cast<uint32_t>(m_watched); }
    /// Of these, the ones that touched when they were looked at.
    uint32_t CountTouching() const {
        uint32_t count = 0;
        for (uint32_t word = 0; word <= m_count / 64; ++word)
            count += CountBits(WatchedOf(word) & TouchingOf(word));
        return count;
    }
    bool IsDue(uint32_t i) const {
        const Record &record = m_records[i];
        return bmr_budget_is_due(record.deadline, m_movers.Moved(record.a), m_movers.Moved(record.b));
    }
    /// Did it touch when it was looked at?
    void SetTouches(uint32_t i, bool touches) { m_touching.Put(i, touches); }
    bool Touches(uint32_t i) const { return m_touching.Has(i); }
    /// Those of the 64 pairs of this word.
    uint64_t TouchingOf(uint32_t word) const { return word < m_touching.Words() ? m_touching.Word(word) : 0; }
    /// Watches the pair if one of its bodies has woken since the pass began. Is it watched?
    bool WatchIfAwake(uint32_t i) {
        const Record record = m_records[i];
        if (!IsWatched(i) && (m_movers.IsActiveNow(record.a) || m_movers.IsActiveNow(record.b)))
            Watch(i);
        return IsWatched(i);
    }
    uint64_t CurrentLook() const { return m_look; }
    /// Compares the two movers of a pair with what they are by now, where that is not known.
    void LookAgain(uint32_t i) {
        const Record record = m_records[i];
        LookAgainAt(record.a);
        LookAgainAt(record.b);
    }

    /// A pair that is due: looked at, and to be again next time.
    void SetDue(uint32_t i) {
        Record &record = m_records[i];
        record.deadline = m_movers.Moved(record.a) + m_movers.Moved(record.b);
        DropLine(i);
    }
    /// Neither of its bodies is awake: out of sight until one is.
    void Rest(uint32_t i);
    /// Renews a pair by its own line; false where that proves nothing.
    bool Renew(uint32_t i, double threshold);
    /// Reads all that a proof of the two needs; false if they are to have none. Call Prove or SetDue next.
    bool BeginProof(uint32_t i);
    /// The two are apart: <d, b - a> >= gap for all their points. A budget without a line is that of d = 0:
    /// it lasts until the two have moved by `gap` - `threshold`.
    void Prove(uint32_t i, bmr_vec2 d, double gap, double threshold, bool forImpactsToo);
    /// A body woke behind the pass: its pairs are watched. (Box2D passed them when it slept.)
    void WatchPairsOf(const b2Body *body);
    /// A body woke in the middle of a pass: its pairs are due.
    void Wake(const b2Body *body);

    /// Nothing where the two's boxes were not looked at in this pass: one of them has no pair with a proof.
    std::optional<bool> BoxesOverlap(uint32_t i) const {
        const Mover &a = m_movers[m_records[i].a], &b = m_movers[m_records[i].b];
        if (a.proved == 0 || b.proved == 0 || a.proxy == b2BroadPhase::e_nullProxy ||
            b.proxy == b2BroadPhase::e_nullProxy)
            return std::nullopt;
        return b2TestOverlap(a.box, b.box);
    }

    OwedEnabling &Owed() { return m_owed; }

    // Impacts.

    /// `careful`: code of the game may have run since the look at the movers.
    void BeginSearch(bool careful);
    /// Those of the 64 pairs of this word that a search comes by: of `all`, or of those that are watched, the
    /// ones that LookForImpact says more of.
    uint64_t ToSearch(uint32_t word, bool all) const {
        return (all ? ~uint64_t{0} : WatchedOf(word)) & (word < m_stops.Words() ? m_stops.Word(word) : 0);
    }
    /// Looks at the two's sweeps. May Box2D look for an impact at all: one moves, and one of them is not to
    /// be tunnelled through?
    bool LookForImpact(uint32_t i) {
        if (RuleOutImpact(i))
            return false;
        const Record record = m_records[i];
        m_movers.LookAtSweep(record.a, m_look);
        m_movers.LookAtSweep(record.b, m_look);
        const uint8_t both = m_movers.SweepBits(record.a) | m_movers.SweepBits(record.b);
        return (both & (kActive | kStops | kIsSensor)) == (kActive | kStops);
    }
    bool IsLookedAtIn(uint64_t step) const { return step != 0 && m_step == step; }
    /// Does the budget outlast the step's sweeps?
    bool OutlastsSweeps(uint32_t i) {
        if ((m_bits[i] & (kHasLine | kNoImpactProof)) != kHasLine)
            return false;
        const Record record = m_records[i];
        m_movers.LookAtEnd(record.a, m_sweepsCarefully, m_look);
        m_movers.LookAtEnd(record.b, m_sweepsCarefully, m_look);
        return !bmr_budget_is_due(record.deadline, m_movers.End(record.a), m_movers.End(record.b));
    }

    // Rows of the table.

    using Record = PairRecord;
    uint32_t Count() const { return m_count; }
    b2Contact *Contact(uint32_t i) const { return m_contacts[i]; } ///< nullptr where it is gone
    const Record &At(uint32_t i) const { return m_records[i]; }
    uint8_t Bits(uint32_t i) const { return m_bits[i]; }
    void ClearBit(uint32_t i, uint8_t bit) { m_bits[i] &= static_cast<uint8_t>(~bit); }
    Marks &GetMarks() { return m_marks; }
    /// From here on Box2D's marks are here, and no more in the contacts; or the other way round.
    void TakeMarks();
    void GiveMarksBack();
    /// Is one of its bodies awake, or was it at the last look? Else it is out of sight.
    bool IsWatched(uint32_t i) const { return m_awake.Has(i); }
    /// The pairs that are watched, of the 64 of this word.
    uint64_t WatchedOf(uint32_t word) const { return word < m_awake.Words() ? m_awake.Word(word) : 0; }
    Bodies &GetBodies() { return m_bodies; }
    Movers &GetMovers() { return m_movers; }
    const Movers &GetMovers() const { return m_movers; }
    b2ContactManager *Manager() const { return m_manager; }

    /// Has somebody, a pass or a contact that ends, a pointer to it?
    bool IsInPass() const { return m_passes > 0; }
    /// Has the world left it (LeaveTable)? A pass that is under way looks at nothing here from then on, and
    /// goes on by Box2D's list.
    bool WasLeft() const { return m_left; }
    /// A pass is under way: numbers stay as they are. If an exception of the game's ends it, the world leaves
    /// the table.
    class Pass {
    public:
        explicit Pass(Ledger *ledger) : m_ledger(ledger) { ++ledger->m_passes; }
        ~Pass();
        Pass(const Pass &) = delete;
        Pass &operator=(const Pass &) = delete;
        void Complete() { m_complete = true; }

    protected:
        Ledger *m_ledger;

    private:
        bool m_complete = false;
    };

    /// The same while a contact ends. Its record goes as this is complete.
    class Ending : private Pass {
    public:
        Ending(Ledger *ledger, const b2Contact *contact)
            : Pass(ledger), m_contact(contact), m_number(ledger->FindNumber(contact)) {
            ledger->NoteLostProxies(m_number, *contact);
        }
        void Complete();

    private:
        const b2Contact *m_contact; ///< once it has ended, its address and no more
        uint32_t m_number;
    };

protected:
    bool m_left = false; ///< see WasLeft

private:
    const b2Contact *Newest() const;
    /// The number of a contact that is about to end (it may have been made since), kNone where it has none.
    uint32_t FindNumber(const b2Contact *contact);
    /// The contact of this number is about to end. Has its body been put out of the world, so that it has no
    /// proxies? Then none of its contacts has.
    void NoteLostProxies(uint32_t number, const b2Contact &ending);
    /// The two could not impact when they were last looked at: by the pass or, where code of the game may
    /// have run since, by the search. Without such code they cannot now. (What else decides of it is looked
    /// at where this says nothing.)
    bool RuleOutImpact(uint32_t i) {
        if (m_sweepsCarefully && StopsInSweeps(i))
            return false;
        const uint8_t a = m_movers.Bits(m_records[i].a), b = m_movers.Bits(m_records[i].b);
        const bool passSaysSo = (a & b & kLookedAt) != 0 && ((a | b) & kStops) == 0;
        if (passSaysSo && IsWatched(i))
            m_stops.Clear(i);
        return m_sweepsCarefully || passSaysSo;
    }
    void TrimEnd();
    void PrefetchLookAgain(uint32_t rows, uint32_t shapes) const;
    void LookAgainAt(uint32_t row) {
        if (m_movers.LookedAt(row) != m_look && !m_movers.ConfirmAsBefore(row, m_look))
            m_movers.Look(row, m_manager->m_broadPhase, m_look, true);
    }
    bool StopsInSweeps(uint32_t i) const {
        return ((m_movers.SweepBits(m_records[i].a) | m_movers.SweepBits(m_records[i].b)) & kStops) != 0;
    }
    bool Begin();
    void Reserve(uint32_t count);
    void Put(uint32_t i, b2Contact *contact);
    void Take(uint32_t i);
    void Compact();
    void Empty();
    void Watch(uint32_t i);
    void Unwatch(uint32_t i);
    void WakeRow(uint32_t row);
    void DropLine(uint32_t i) {
        if ((m_bits[i] & kHasLine) == 0)
            return;
        m_bits[i] &= static_cast<uint8_t>(~kHasLine);
        m_movers.DropProof(m_records[i].a);
        m_movers.DropProof(m_records[i].b);
    }
    void DropAllProofs();

    b2ContactManager *m_manager;
    OwedEnabling m_owed;
    Bodies m_bodies;
    Movers m_movers;
    Column<Record> m_records;
    Column<bmr_budget_line> m_lines;
    ProxyPairs m_proxyPairs;
    Column<b2Contact *> m_contacts;
    Column<uint8_t> m_bits;
    Marks m_marks;
    HullPairs m_hullPairs;
    BitColumn m_awake;    ///< alive, and one of its bodies was awake
    BitColumn m_touching; ///< alive, and touching at the last look
    /// One of the two is not to be tunnelled through, as far as anybody knows. Without it both are watched,
    /// and neither row had kStops at any look since.
    BitColumn m_stops;
    uint32_t m_count = 0; ///< records, the dead ones among them
    int32 m_live = 0, m_watched = 0;
    uint64_t m_step = 0; ///< CurrentStep() of the last look at all movers
    uint64_t m_look = 1; ///< goes up whenever what was read may be old
    uint32_t m_passNumber = 0;
    uint32_t m_passes = 0; ///< under way
    bool m_interrupted = false;
    bool m_sweepsCarefully = false; ///< see BeginSearch, RuleOutImpact
    uint32_t m_followed = 0; ///< rows that were looked at in the last look at all movers, and are active
    /// What a step by the world's list costs that searches for no impact; so many pairs are awake.
    uint64_t CostOfList(int32 awake) const;

    // See NextStepPays.
    uint32_t m_triedPasses = 0, m_restingSteps = 0;
    uint64_t m_searches = 0, m_costOfTable = 0, m_costOfList = 0;
};

} // namespace bmr

#endif
