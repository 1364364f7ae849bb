// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_EVENT_QUEUE_H
#define BMR_KINETIC_EVENT_QUEUE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "boomerang/allocator.h"
#include "boomerang/error.h"

/// @file
/// A queue of events: a binary heap of items, each with one time, the earliest on top. An item stands in it
/// only while it has a time.

/// The first member of a structure that the queue holds: a pair, or a body.
typedef struct bmr_event_item {
    size_t place; ///< in the heap; BMR_NOT_QUEUED
} bmr_event_item;
#define BMR_NOT_QUEUED SIZE_MAX

typedef struct bmr_event_entry {
    double time;
    bmr_event_item *item;
} bmr_event_entry;

typedef struct bmr_event_queue {
    bmr_event_entry *heap;
    size_t count, capacity;
    size_t promised; ///< items that may want a place
    /// Of two items of one time: which comes first. A total order of all items.
    bool (*before)(const bmr_event_item *, const bmr_event_item *);
} bmr_event_queue;

/// Memory for one item more, so that bmr_event_queue_set never needs memory. Amortized O(1). NO_MEMORY: as it
/// was.
bmr_error bmr_event_queue_promise(bmr_event_queue *queue, const bmr_allocator *allocator);
/// Gives the memory of one item back; memory, where a quarter is enough.
void bmr_event_queue_release(bmr_event_queue *queue, const bmr_allocator *allocator);
/// INFINITY: the item leaves the queue. O(log count).
void bmr_event_queue_set(bmr_event_queue *queue, bmr_event_item *item, double time);

static inline double bmr_event_queue_time(const bmr_event_queue *queue) {
    return queue->count > 0 ? queue->heap[0].time : INFINITY;
}

#endif
