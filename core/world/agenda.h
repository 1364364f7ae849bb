// SPDX-License-Identifier: MIT
#ifndef BMR_WORLD_AGENDA_H
#define BMR_WORLD_AGENDA_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "boomerang/allocator.h"
#include "boomerang/error.h"

/// @file
/// The world's queue: a binary heap of items that come and go, each with one time, the earliest on top. (The
/// simulation's event queue has a fixed number of items and breaks ties by their numbers.) An item stands in
/// it only while it has a time.

/// The head of whatever has a time.
typedef struct bmr_agenda_item {
    size_t place;   ///< in the heap; BMR_NOT_QUEUED
    bool is_couple; ///< else a resident
} bmr_agenda_item;
#define BMR_NOT_QUEUED SIZE_MAX

typedef struct bmr_agenda_entry {
    double time;
    bmr_agenda_item *item;
} bmr_agenda_entry;

typedef struct bmr_agenda {
    bmr_agenda_entry *heap;
    size_t count, capacity;
    size_t promised; ///< items that may want a place
    /// Of two items of one time: which comes first. A total order of all items.
    bool (*before)(const bmr_agenda_item *, const bmr_agenda_item *);
} bmr_agenda;

/// Room for one item more, so that bmr_agenda_set never needs memory. Amortized O(1). NO_MEMORY: as it was.
bmr_error bmr_agenda_promise(bmr_agenda *agenda, const bmr_allocator *allocator);
/// Gives the room for one item back; memory, where a quarter is enough.
void bmr_agenda_release(bmr_agenda *agenda, const bmr_allocator *allocator);
/// INFINITY: the item leaves the queue. O(log count).
void bmr_agenda_set(bmr_agenda *agenda, bmr_agenda_item *item, double time);

static inline double bmr_agenda_time(const bmr_agenda *agenda) {
    return agenda->count > 0 ? agenda->heap[0].time : INFINITY;
}

#endif
