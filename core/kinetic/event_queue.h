// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_EVENT_QUEUE_H
#define BMR_KINETIC_EVENT_QUEUE_H

#include <stddef.h>

/// @file
/// A binary heap of items 0 .. count-1, each with one time, the earliest on top; ties by item. The caller
/// owns the three arrays of `count`.
typedef struct bmr_event_queue {
    double *times; ///< of each item
    size_t *order; ///< the heap: items
    size_t *place; ///< of each item in `order`
    size_t count;
} bmr_event_queue;

/// Every item at INFINITY.
void bmr_event_queue_init(bmr_event_queue *queue);
/// O(log count).
void bmr_event_queue_set(bmr_event_queue *queue, size_t item, double time);
static inline size_t bmr_event_queue_first(const bmr_event_queue *queue) {
    return queue->order[0];
}
static inline double bmr_event_queue_time(const bmr_event_queue *queue) {
    return queue->times[queue->order[0]];
}

#endif
