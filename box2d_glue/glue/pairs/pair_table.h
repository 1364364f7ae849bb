// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PAIR_TABLE_H
#define BOOMERANG_GLUE_PAIR_TABLE_H

#include <cstdint>
#include <optional>

#include <box2d/b2_contact.h>
#include <box2d/b2_contact_manager.h>

#include "base/columns.h"
#include "base/compiler.h"
#include "base/private_members.h"
#include "boomerang/budget.h"
#include "glue/pairs/bodies.h"
#include "glue/pairs/fixture_motion.h"
#include "glue/pairs/table_cost.h"
#include "glue/proofs/hull_pair.h"

namespace bmr {

/// A contact's number in the table, in the bits of its flags that Box2D does not use: bits 6 to 31 hold the
/// number plus 1. Box2D's constructor writes the flags whole, so that a new contact has no number; everything
/// else in Box2D sets and clears single flags.
struct ContactNumber : b2Contact {
    static constexpr uint32_t kShift = 6, kBox2DsFlags = (1u << kShift) - 1;
    /// So many contacts can have a number at a time.
    static constexpr uint32_t kMost = ~uint32_t{0} >> kShift;
    static_assert(ContactAccess::kAll == kBox2DsFlags);

    /// PairTable::kNone where it has none.
    static uint32_t Read(const b2Contact *contact) {
        return (contact->*(&ContactNumber::m_flags) >> kShift) - 1;
    }
    static void Write(b2Contact *contact, uint32_t number) {
        uint32 &flags = ContactAccess::Flags(contact);
        flags = (flags & kBox2DsFlags) | (number + 1) << kShift;
    }

    /// A contact takes four cache lines, and the next one in a list need not be the next in memory. At the
    /// list's end `contact` is nullptr.
    static void Prefetch(const b2Contact *contact) { PrefetchLines(contact, 4); }
};

/// The bits of a pair.
enum PairBit : uint8_t {
    kHasProof = 1, ///< it was proved apart, which both motions count; its line, if any, renews the deadline
    kNoImpactProof = 2, ///< its deadline says nothing of impacts
};

struct Pair {
    uint32_t deadline; ///< core/budget: due once the sums of the two fixtures reach it
    uint32_t a, b;     ///< motions of the contact's fixtures A and B
};

class PairTable;

/// Which pairs of fixtures, or of their children, have a contact: Box2D finds this out by a walk over a
/// body's contacts, for every pair of boxes that begin to overlap. A pair is known by a digest; two different
/// ones have the same with a probability of 2^-64.
class FixturePairs {
public:
    /// The contact of this number.
    void Add(uint32_t i, const b2Contact &contact) {
        m_digests.Reserve(i + 1);
        m_table.ReserveRow(KeyOf{*this});
        m_digests[i] = DigestOf(contact.GetFixtureA(), contact.GetChildIndexA()) +
                       DigestOf(contact.GetFixtureB(), contact.GetChildIndexB());
        m_table.Add(i, KeyOf{*this});
    }
    void Remove(uint32_t i) { m_table.Remove(i, KeyOf{*this}); }
    /// The contact of this number has another one from here on.
    void Renumber(uint32_t from, uint32_t to) {
        m_digests[to] = m_digests[from];
        m_table.Renumber(from, to, KeyOf{*this});
    }
    void Clear() { m_table.Clear(); }

    bool HaveContact(const b2FixtureProxy &a, const b2FixtureProxy &b) const {
        return m_table.Find(DigestOf(a.fixture, a.childIndex) + DigestOf(b.fixture, b.childIndex),
                            KeyOf{*this}) != KeyTable::kNone;
    }

private:
    struct KeyOf {
        const FixturePairs &pairs;
        uint64_t operator()(uint32_t i) const { return pairs.m_digests[i]; }
    };
    static uint64_t DigestOf(const b2Fixture *fixture, int32 child) {
        constexpr uint64_t kFirst = 0x9e3779b97f4a7c15u, kSecond = 0xc2b2ae3d27d4eb4fu;
        uint64_t digest = static_cast<uint64_t>(reinterpret_cast<uintptr_t>(fixture)) * kFirst +
                          static_cast<uint32_t>(child);
        digest = (digest ^ digest >> 32) * kSecond;
        return digest ^ digest >> 29;
    }

    Column<uint64_t> m_digests;
    KeyTable m_table;
};

/// What b2World::SolveTOI notes of the pairs of a table while it works, beside the marks that Box2D makes at
/// the contacts themselves: e_toiFlag, m_toi, m_toiCount and e_islandFlag are in the contacts, here as there.
///
/// A pair whose deadline outlasts the step has a time of impact, which is 1. Its contact is not read, and has
/// no mark of it: the pair is in `noImpact`, until Box2D's list is to be walked (PairTable::GiveMarksBack).
struct ImpactTimes {
    struct Impact {
        float time;
        uint32_t number;
    };

    BitColumn noImpact;  ///< its time is known to be 1, though the contact has no e_toiFlag
    BitColumn marked;    ///< the contact has marks, which the next step takes away
    BitColumn pending;   ///< its time is not known: the next search finds it
    BitColumn disabled;  ///< it was disabled when the search came to it
    Column<Impact> heap; ///< known times below 1, and some that are old
    uint32_t heapCount = 0;
    bool areKnown = false; ///< no contact has marks but those of `marked`

    void Reserve(uint32_t count) {
        for (BitColumn *column : {&noImpact, &marked, &pending, &disabled})
            column->Reserve(count);
    }
    /// A contact that was just made has this number.
    void Begin(uint32_t i, b2Contact *contact) {
        for (BitColumn *column : {&noImpact, &marked, &disabled})
            column->Clear(i);
        pending.Set(i);
        ContactAccess::Flags(contact) &= ~ContactAccess::kInIsland;
        if (areKnown)
            ContactAccess::TimeOfImpact(contact) = 1.0f; // Box2D's constructor leaves it as it is
    }
    void Renumber(uint32_t from, uint32_t to) {
        for (BitColumn *column : {&noImpact, &marked, &pending, &disabled})
            column->Renumber(from, to);
    }
    bool IsKnown(uint32_t i, b2Contact *contact) const {
        return noImpact.Has(i) || (ContactAccess::Flags(contact) & ContactAccess::kTimeIsKnown) != 0;
    }
    void Forget(uint32_t i, b2Contact *contact) {
        noImpact.Clear(i);
        pending.Set(i);
        ContactAccess::Flags(contact) &= ~ContactAccess::kTimeIsKnown;
    }
    /// As b2World::SolveTOI begins with a new step, once the marks are away from the contacts.
    void ForgetAll() {
        for (BitColumn *column : {&noImpact, &marked, &pending, &disabled})
            column->ClearAll();
        heapCount = 0;
        areKnown = true;
    }

    /// The earliest first; of equal ones the newest contact, which is the first in Box2D's list.
    static bool IsBefore(const Impact &a, const Impact &b) {
        return a.time < b.time || (a.time == b.time && a.number > b.number);
    }
    void Push(uint32_t i, float time) {
        heap.Reserve(heapCount + 1);
        uint32_t at = heapCount++;
        const Impact impact = {time, i};
        for (; at > 0 && IsBefore(impact, heap[(at - 1) / 2]); at = (at - 1) / 2)
            heap[at] = heap[(at - 1) / 2];
        heap[at] = impact;
    }
    void Pop() {
        const Impact last = heap[--heapCount];
        uint32_t at = 0;
        for (uint32_t child = 1; child < heapCount; child = 2 * at + 1) {
            if (child + 1 < heapCount && IsBefore(heap[child + 1], heap[child]))
                ++child;
            if (!IsBefore(heap[child], last))
                break;
            heap[at] = heap[child];
            at = child;
        }
        if (heapCount > 0)
            heap[at] = last;
    }
};

/// As b2World::SolveTOI begins.
inline void ClearImpactMarks(b2Contact *contact) {
    ContactAccess::Flags(contact) &= ~(ContactAccess::kTimeIsKnown | ContactAccess::kInIsland);
    ContactAccess::CountOfImpacts(contact) = 0;
    ContactAccess::TimeOfImpact(contact) = 1.0f;
}

/// Box2D's loop over contacts enables every active contact that it passes. The pass over pairs does not read
/// most of them. It defers the enabling, and does it before code of the game could see the difference. In
/// Mode::Verify these contacts are compared with Box2D's own answer as they are enabled.
class DeferredEnable {
public:
    explicit DeferredEnable(const PairTable *table) : m_table(*table) {}
    void Reserve(uint32_t count) { m_settled.Reserve(count); }

    /// A pass begins: all contacts below this are deferred.
    void Begin(uint32_t below) {
        m_below = below;
        m_settled.ClearAll();
        m_gameRanBefore = m_gameRan;
        m_gameRan = false;
    }
    /// Box2D's list enables what is passed: no contact is deferred.
    void Forget() { m_below = 0; }
    /// Code of the game runs within the pass, which has come down to `down`, and may ask for other code of
    /// the game, or end the pass by an exception: none but the contacts from there on were passed.
    void Flush(uint32_t down) {
        EnableDownTo(down);
        m_below = 0;
    }
    /// The pass goes on.
    void Resume(uint32_t below) { m_below = below; }
    /// The contact is enabled or disabled as in Box2D: from here on nothing of it is deferred.
    void NoteSettled(uint32_t i) { m_settled.Set(i); }
    /// From the newest that is deferred down to `down`.
    void EnableDownTo(uint32_t down);
    /// Settles the contact: enables it if that is deferred.
    void Settle(uint32_t i);
    /// The body fell asleep after the pass: its contacts stay as they are until it wakes, also in the middle
    /// of a step.
    void EnableOfSleeper(const b2Body *body);
    /// The pass ends. Code of the game that ran in this step, or since the pass before, may have disabled
    /// contacts. In Mode::Verify all are enabled.
    void End();

    /// Code of the game is to be called, behind the pass.
    void BeforeGame() {
        EnableDownTo(0);
        m_gameRan = true;
    }
    /// Code of the game runs, or did.
    void NoteGame() { m_gameRan = true; }
    /// Did it, since the last pass began? What was read of the world before may then be another by now.
    bool GameRan() const { return m_gameRan; }

private:
    bool IsActive(uint32_t i) const;

    const PairTable &m_table;
    BitColumn m_settled; ///< since the pass began
    uint32_t m_below = 0;
    bool m_gameRan = true, m_gameRanBefore = true; ///< since the last pass began; and before, since another
};

/// The table of a world's pairs: one for each contact, the oldest first. Box2D puts new contacts at the head
/// of its lists, so that the world's list and every body's are in descending order here.
///
/// A pair is in one of three states:
/// - asleep: none of its bodies was awake when the pass over pairs last saw it. No pass reads it, unless code
///   of the game ran, which may have woken one.
/// - apart: two fixtures were proved apart, until the sums of their motions reach the pair's deadline. Until
///   then no pass reads the contact. The same deadline answers the search for impacts, with the sums that a
///   sweep may reach.
/// - due: the next pass over pairs updates it.
/// Beside the state the table knows of a pair whether it touches, as its last update left it (then it is due
/// or asleep), whether it may have an impact, and its time of impact (ImpactTimes).
///
/// The passes (passes.h) are functions over the table. One thread at a time uses it, the one that its world
/// is used by. It allocates where contacts begin, never on the way of a pair that stays apart.
class PairTable {
public:
    explicit PairTable(b2ContactManager *manager) : deferred(this), m_manager(manager) {}
    PairTable(const PairTable &) = delete;
    PairTable &operator=(const PairTable &) = delete;

    // What it is made of.

    Bodies bodies;
    FixtureMotions motions;
    FixturePairs fixturePairs; ///< good where IsWhole
    HullPairs hullPairs;       ///< the structures of Options::pairsBy; empty without it
    ImpactTimes impacts;
    DeferredEnable deferred;
    TableCost cost;

    b2ContactManager *Manager() const { return m_manager; }

    // Which contacts it has.

    static constexpr uint32_t kNone = 0xffffffffu;
    uint32_t NumberOf(const b2Contact *contact) const {
        const uint32_t number = ContactNumber::Read(contact);
        return number < m_count && m_contacts[number] == contact ? number : kNone;
    }
    /// Pairs are numbered below this.
    uint32_t Count() const { return m_count; }
    b2Contact *Contact(uint32_t i) const { return m_contacts[i]; } ///< nullptr where it has ended
    const Pair &At(uint32_t i) const { return m_pairs[i]; }
    uint8_t Bits(uint32_t i) const { return m_bits[i]; }

    /// At the start of a step: does every contact of the world have its pair here, in the world's order?
    /// Begins anew where one does not. False where it cannot be, for now: the world is to be stepped by its
    /// list.
    bool Follow();
    /// A step goes by Box2D's list. Box2D's marks are in the contacts alone, and every pair is due in the
    /// next pass.
    void Interrupt();
    /// Takes in contacts that were made since. False if they do not fit what is here.
    bool CatchUp();
    /// Are all contacts here? A search for pairs makes contacts in the middle of a step, and they are taken
    /// in after it; and some of the calls that end or make a contact may be bound inside Box2D. (One may have
    /// ended unseen, and the next one be at its place in memory: that one has no number yet.)
    bool IsWhole() const {
        const b2Contact *const newest = m_manager->m_contactList;
        return m_live == m_manager->m_contactCount && Newest() == newest &&
               (newest == nullptr || NumberOf(newest) != kNone);
    }
    /// The contact was flagged for filtering, or updated by other code: its pair is due.
    void Flag(const b2Contact *contact);

    // A pass over all pairs, newest first.

    /// Compares each fixture that has a proof with what it was, and returns how many of these have a body
    /// that is awake. Awakens the pairs of all bodies that woke.
    uint32_t UpdateMotions();
    /// Of the 64 pairs of this word, a bit each for those that are due. Good until code of the game runs, or
    /// a body wakes.
    uint64_t DueOf(uint32_t word) const;
    /// The newest pair below `end` that is due, kNone where there is none, after code of the game ran: each
    /// pair's own two fixtures are compared once more.
    uint32_t NextDue(uint32_t end);
    /// Goes up whenever what was read of the world may have changed.
    uint64_t Stamp() const { return m_stamp; }
    /// Code of the game ran. (The world was locked all the while.)
    void Distrust() { ++m_stamp; }
    /// Compares the two fixtures of a pair with what they are by now, where that is not known.
    void Refresh(uint32_t i) {
        const Pair pair = m_pairs[i];
        RefreshRow(pair.a);
        RefreshRow(pair.b);
    }
    /// Nothing where the two's boxes were not compared in this pass: one of them has no pair with a proof.
    std::optional<bool> KnownBoxesOverlap(uint32_t i) const {
        const FixtureMotion &a = motions[m_pairs[i].a], &b = motions[m_pairs[i].b];
        if (a.proved == 0 || b.proved == 0 || a.proxy == b2BroadPhase::e_nullProxy ||
            b.proxy == b2BroadPhase::e_nullProxy)
            return std::nullopt;
        return b2TestOverlap(a.box, b.box);
    }
    /// Length in time of the step, for guesses of how far bodies will move.
    float seconds = 0.0f;

    // The state of a pair.

    bool IsAwake(uint32_t i) const { return m_awake.Has(i); }
    uint32_t AwakeCount() const { return m_awakeCount; }
    /// The pairs that are awake, of the 64 of this word; and those that touched at their last update.
    uint64_t AwakeOf(uint32_t word) const { return word < m_awake.Words() ? m_awake.Word(word) : 0; }
    uint64_t TouchingOf(uint32_t word) const { return word < m_touching.Words() ? m_touching.Word(word) : 0; }
    void SetTouching(uint32_t i, bool touches) { m_touching.Put(i, touches); }
    /// Due now, and to be again next time.
    void SetDue(uint32_t i) {
        Pair &pair = m_pairs[i];
        pair.deadline = motions.Moved(pair.a) + motions.Moved(pair.b);
        DropProof(i);
    }
    /// Neither of its bodies is awake.
    void SetAsleep(uint32_t i);
    /// A body woke ahead of the pass or within it: its pairs are awake, and due.
    void Awaken(const b2Body *body);
    /// A body woke behind the pass. (Box2D passed its contacts while it slept: they are not enabled.)
    void AwakenPassed(const b2Body *body);
    /// Reads all that a proof of the two needs; false if they are to have none. Call Prove or SetDue next.
    bool BeginProof(uint32_t i);
    /// The two are apart: <d, b - a> >= gap for all their points.
    void Prove(uint32_t i, bmr_vec2 d, double gap, double threshold, bool forImpactsToo);
    /// Renews the deadline by the pair's own line; false where that proves nothing.
    bool Renew(uint32_t i, double threshold);

    // The first search for impacts in a step.

    /// If code of the game ran since the pass over pairs, flags of all bodies are read anew.
    void BeginSearch();
    /// Those of the 64 pairs of this word that may have an impact: of the pairs that are awake, and of all if
    /// code of the game, which may have woken bodies, ran since the pass.
    uint64_t ToSearch(uint32_t word) const {
        return (deferred.GameRan() ? ~uint64_t{0} : AwakeOf(word)) &
               (word < m_toiCandidates.Words() ? m_toiCandidates.Word(word) : 0);
    }
    /// Compares the two's sweeps. May Box2D look for an impact at all: one moves, and one is a bullet or not
    /// dynamic?
    bool MayImpact(uint32_t i) {
        if (RuleOutImpact(i))
            return false;
        const Pair pair = m_pairs[i];
        motions.UpdateSweep(pair.a, m_stamp);
        motions.UpdateSweep(pair.b, m_stamp);
        const uint8_t both = motions.SweepBits(pair.a) | motions.SweepBits(pair.b);
        return (both & (kActive | kBulletOrStatic | kIsSensor)) == (kActive | kBulletOrStatic);
    }
    /// Does the deadline outlast the step's sweeps?
    bool OutlastsSweeps(uint32_t i) {
        if ((m_bits[i] & (kHasProof | kNoImpactProof)) != kHasProof)
            return false;
        const Pair pair = m_pairs[i];
        motions.UpdateEnd(pair.a, deferred.GameRan(), m_stamp);
        motions.UpdateEnd(pair.b, deferred.GameRan(), m_stamp);
        return !bmr_budget_is_due(pair.deadline, motions.End(pair.a), motions.End(pair.b));
    }

    /// Box2D's marks, of which ImpactTimes has a part, are all in the contacts from here on.
    void GiveMarksBack();

    /// Does a step that goes by it hold it, or a contact that ends?
    bool IsHeld() const { return m_holds > 0; }
    /// Has the world left it (LeaveTable)? A step that is under way reads nothing here from then on, and goes
    /// on by Box2D's list.
    bool WasLeft() const { return m_left; }

    /// A step holds the table, if it has one, from its first pass to its last: numbers stay as they are. If
    /// an exception of the game's ends the step, the world leaves the table.
    class Hold {
    public:
        explicit Hold(PairTable *table) : m_table(table) {
            if (table != nullptr)
                ++table->m_holds;
        }
        ~Hold(); // (pair_tables.cpp: a table whose world has ended goes with its last hold)
        Hold(const Hold &) = delete;
        Hold &operator=(const Hold &) = delete;
        void Complete() { m_complete = true; }

    protected:
        PairTable *m_table;

    private:
        bool m_complete = false;
    };

    /// The same while a contact ends. Its pair goes as this is complete.
    class Ending : private Hold {
    public:
        Ending(PairTable *table, const b2Contact *contact)
            : Hold(table), m_contact(contact),
              m_number(table != nullptr ? table->FindNumber(contact) : kNone) {}
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
    void TrimEnd();
    void Reserve(uint32_t count);
    void Put(uint32_t i, b2Contact *contact);
    void Remove(uint32_t i);
    void Compact();
    void Empty();

    bool IsDue(uint32_t i) const {
        const Pair &pair = m_pairs[i];
        return bmr_budget_is_due(pair.deadline, motions.Moved(pair.a), motions.Moved(pair.b));
    }
    void PrefetchRefresh(uint32_t fixtures, uint32_t shapes) const;
    void RefreshRow(uint32_t row) {
        if (motions.StampOf(row) != m_stamp && !motions.ConfirmAsBefore(row, m_stamp))
            motions.Update(row, m_manager->m_broadPhase, m_stamp, true);
    }
    void Awaken(uint32_t i);
    void DropProof(uint32_t i) {
        if ((m_bits[i] & kHasProof) == 0)
            return;
        m_bits[i] &= static_cast<uint8_t>(~kHasProof);
        motions.DropProof(m_pairs[i].a);
        motions.DropProof(m_pairs[i].b);
    }
    void DropAllProofs();
    /// The two could not impact when they were last compared: by the pass over pairs or, where code of the
    /// game may have run since, by the search. Without such code they cannot now. (What else decides of it is
    /// compared where this says nothing.)
    bool RuleOutImpact(uint32_t i) {
        const Pair pair = m_pairs[i];
        if (deferred.GameRan() &&
            ((motions.SweepBits(pair.a) | motions.SweepBits(pair.b)) & kBulletOrStatic) != 0)
            return false;
        const uint8_t a = motions.Bits(pair.a), b = motions.Bits(pair.b);
        const bool passSaysSo = (a & b & kUpdated) != 0 && ((a | b) & kBulletOrStatic) == 0;
        if (passSaysSo && IsAwake(i))
            m_toiCandidates.Clear(i);
        return deferred.GameRan() || passSaysSo;
    }

    b2ContactManager *m_manager;
    Column<Pair> m_pairs;
    Column<bmr_budget_line> m_lines;
    Column<b2Contact *> m_contacts;
    Column<uint8_t> m_bits;
    BitColumn m_awake;    ///< all that are not asleep
    BitColumn m_touching; ///< as the contact was left by its last update
    /// One of the two is a bullet or not dynamic, as far as is known. Without this bit neither fixture had
    /// kBulletOrStatic at any update since the pair woke, unless TakeNewBullets is still to say so.
    BitColumn m_toiCandidates;
    uint32_t m_count = 0; ///< pairs, those of contacts that have ended among them
    int32 m_live = 0;
    uint32_t m_awakeCount = 0;
    uint64_t m_stamp = 1;
    uint32_t m_holds = 0;
    bool m_interrupted = true; ///< by steps that went by Box2D's list
};

} // namespace bmr

#endif
