// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_IMPACT_TIMES_H
#define BOOMERANG_GLUE_IMPACT_TIMES_H

#include <cstdint>

#include "base/columns.h"
#include "base/private_members.h"

namespace bmr {

/// What b2World::SolveTOI notes of the pairs of a table while it works, beside the marks that Box2D makes at
/// the contacts themselves: e_toiFlag, m_toi, m_toiCount and e_islandFlag are in the contacts, here as there.
///
/// A pair whose deadline outlasts the step has a time of impact, which is 1. Its contact is not read, and has
/// no mark of it: the pair is in `passed`, until Box2D's list is to be walked (PairTable::GiveMarksBack).
struct ImpactTimes {
    struct Impact {
        float time;
        uint32_t number;
    };

    BitColumn passed;    ///< its time is known to be 1, though the contact has no e_toiFlag
    BitColumn marked;    ///< the contact has marks, which the next step takes away
    BitColumn asked;     ///< its time is not known, and the next search asks for it
    BitColumn parked;    ///< it was disabled when the search asked
    Column<Impact> heap; ///< known times below 1, and some that are old
    uint32_t heapCount = 0;
    bool areKnown = false; ///< no contact has marks but those of `marked`

    void Reserve(uint32_t count) {
        for (BitColumn *column : {&passed, &marked, &asked, &parked})
            column->Reserve(count);
    }
    /// A contact that was just made has this number.
    void Begin(uint32_t i, b2Contact *contact) {
        for (BitColumn *column : {&passed, &marked, &parked})
            column->Clear(i);
        asked.Set(i);
        ContactAccess::Flags(contact) &= ~ContactAccess::kInIsland;
        if (areKnown)
            ContactAccess::TimeOfImpact(contact) = 1.0f; // Box2D's constructor leaves it as it is
    }
    void Renumber(uint32_t from, uint32_t to) {
        for (BitColumn *column : {&passed, &marked, &asked, &parked})
            column->Renumber(from, to);
    }
    bool IsKnown(uint32_t i, b2Contact *contact) const {
        return passed.Has(i) || (ContactAccess::Flags(contact) & ContactAccess::kTimeIsKnown) != 0;
    }
    void Forget(uint32_t i, b2Contact *contact) {
        passed.Clear(i);
        asked.Set(i);
        ContactAccess::Flags(contact) &= ~ContactAccess::kTimeIsKnown;
    }
    /// As b2World::SolveTOI begins with a new step, once the marks are away from the contacts.
    void ForgetAll() {
        for (BitColumn *column : {&passed, &marked, &asked, &parked})
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

} // namespace bmr

#endif
