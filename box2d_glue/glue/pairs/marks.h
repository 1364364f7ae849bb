// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_MARKS_H
#define BOOMERANG_GLUE_MARKS_H

#include <cstdint>

#include "base/columns.h"

class b2Contact;

namespace bmr {

/// The marks that b2World::Solve and SolveTOI make at a world's contacts while they work, by the numbers of
/// pairs. There is one set for a world, not for a pass: a step inside another one leaves here what the outer
/// one would find at Box2D's contacts.
///
/// Either all marks are here, or all are in the contacts (`areHere`).
struct Marks {
    struct Impact {
        float time;
        uint32_t number;
    };

    BitColumn inIsland; ///< b2Contact's e_islandFlag
    BitColumn known;    ///< e_toiFlag
    BitColumn met;      ///< `times` and `counts` are its m_toi and m_toiCount; else these are 1 and 0
    BitColumn asked;    ///< unknown, and to be asked in the next search
    BitColumn parked;   ///< disabled when the search asked
    Column<float> times;
    Column<uint8_t> counts;
    Column<Impact> heap; ///< known times below 1, and some that are old
    uint32_t heapCount = 0;
    bool areHere = false;

    void Reserve(uint32_t count) {
        inIsland.Reserve(count);
        known.Reserve(count);
        met.Reserve(count);
        asked.Reserve(count);
        parked.Reserve(count);
        times.Reserve(count);
        counts.Reserve(count);
    }
    /// The contact's own marks become those of this number.
    void Read(uint32_t i, b2Contact *contact);
    /// Writes them into the contact.
    void WriteTo(b2Contact *contact, uint32_t i) const;
    /// A contact that was just made has this number.
    void Begin(uint32_t i) {
        inIsland.Clear(i);
        known.Clear(i);
        met.Clear(i);
        parked.Clear(i);
        asked.Set(i);
    }
    void Renumber(uint32_t from, uint32_t to) {
        for (BitColumn *column : {&inIsland, &known, &met, &asked, &parked})
            column->Renumber(from, to);
        times[to] = times[from];
        counts[to] = counts[from];
    }
    float Time(uint32_t i) const { return met.Has(i) ? times[i] : 1.0f; }
    uint8_t CountOf(uint32_t i) const { return met.Has(i) ? counts[i] : uint8_t{0}; }
    void Meet(uint32_t i, float time, uint8_t count) {
        met.Set(i);
        times[i] = time;
        counts[i] = count;
    }
    /// As b2World::SolveTOI begins with a new step.
    void ForgetImpacts() {
        for (BitColumn *column : {&inIsland, &known, &met, &asked, &parked})
            column->ClearAll();
        heapCount = 0;
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

} // namespace bmr

#endif
