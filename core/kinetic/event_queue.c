// SPDX-License-Identifier: MIT
#include "kinetic/event_queue.h"

#include <string.h>

#include "geometry/memory.h"

#define LEAST_CAPACITY 16

static bmr_error resize(bmr_event_queue *queue, size_t capacity, const bmr_allocator *allocator) {
    size_t bytes;
    if (!bmr_size_product(capacity, sizeof *queue->heap, &bytes))
        return BMR_ERROR_TOO_LARGE;
    bmr_event_entry *heap = bmr_allocate(allocator, bytes);
    if (!heap)
        return BMR_ERROR_NO_MEMORY;
    if (queue->heap) {
        memcpy(heap, queue->heap, queue->count * sizeof *heap);
        bmr_release(allocator, queue->heap, queue->capacity * sizeof *heap);
    }
    queue->heap = heap;
    queue->capacity = capacity;
    return BMR_OK;
}

bmr_error bmr_event_queue_promise(bmr_event_queue *queue, const bmr_allocator *allocator) {
    if (queue->promised == queue->capacity) {
        const size_t capacity = queue->capacity ? queue->capacity : LEAST_CAPACITY / 2;
        const bmr_error error =
            capacity > SIZE_MAX / 2 ? BMR_ERROR_TOO_LARGE : resize(queue, 2 * capacity, allocator);
        if (error != BMR_OK)
            return error;
    }
    queue->promised++;
    return BMR_OK;
}

void bmr_event_queue_release(bmr_event_queue *queue, const bmr_allocator *allocator) {
    queue->promised--;
    // Where there is no memory for a smaller heap, the larger one stays.
    if (queue->capacity > LEAST_CAPACITY && queue->promised <= queue->capacity / 4)
        resize(queue, queue->capacity / 2, allocator);
}

static bool before(const bmr_event_queue *queue, const bmr_event_entry *a, const bmr_event_entry *b) {
    return a->time < b->time || (a->time == b->time && queue->before(a->item, b->item));
}

static void put(bmr_event_queue *queue, size_t place, bmr_event_entry entry) {
    queue->heap[place] = entry;
    entry.item->place = place;
}

/// Puts the entry where it belongs, beginning at a place that is free.
static void settle(bmr_event_queue *queue, size_t at, bmr_event_entry entry) {
    while (at > 0 && before(queue, &entry, &queue->heap[(at - 1) / 2])) {
        put(queue, at, queue->heap[(at - 1) / 2]);
        at = (at - 1) / 2;
    }
    for (size_t child = 2 * at + 1; child < queue->count; child = 2 * at + 1) {
        if (child + 1 < queue->count && before(queue, &queue->heap[child + 1], &queue->heap[child]))
            child++;
        if (!before(queue, &queue->heap[child], &entry))
            break;
        put(queue, at, queue->heap[child]);
        at = child;
    }
    put(queue, at, entry);
}

void bmr_event_queue_set(bmr_event_queue *queue, bmr_event_item *item, double time) {
    const bmr_event_entry entry = {time, item};
    if (time < INFINITY) {
        settle(queue, item->place == BMR_NOT_QUEUED ? queue->count++ : item->place, entry);
        return;
    }
    if (item->place == BMR_NOT_QUEUED)
        return;
    const size_t hole = item->place;
    const bmr_event_entry last = queue->heap[--queue->count];
    item->place = BMR_NOT_QUEUED;
    if (last.item != item)
        settle(queue, hole, last);
}
