// SPDX-License-Identifier: MIT
#include "world/agenda.h"

#include <string.h>

#include "geometry/memory.h"
#include "geometry/size.h"

#define LEAST_CAPACITY 16

static bmr_error resize(bmr_agenda *agenda, size_t capacity, const bmr_allocator *allocator) {
    size_t bytes;
    if (!bmr_size_product(capacity, sizeof *agenda->heap, SIZE_MAX, &bytes))
        return BMR_ERROR_TOO_LARGE;
    bmr_agenda_entry *heap = bmr_allocate(allocator, bytes);
    if (!heap)
        return BMR_ERROR_NO_MEMORY;
    if (agenda->heap) {
        memcpy(heap, agenda->heap, agenda->count * sizeof *heap);
        bmr_release(allocator, agenda->heap, agenda->capacity * sizeof *heap);
    }
    agenda->heap = heap;
    agenda->capacity = capacity;
    return BMR_OK;
}

bmr_error bmr_agenda_promise(bmr_agenda *agenda, const bmr_allocator *allocator) {
    if (agenda->promised == agenda->capacity) {
        const size_t capacity = agenda->capacity ? agenda->capacity : LEAST_CAPACITY / 2;
        const bmr_error error =
            capacity > SIZE_MAX / 2 ? BMR_ERROR_TOO_LARGE : resize(agenda, 2 * capacity, allocator);
        if (error != BMR_OK)
            return error;
    }
    agenda->promised++;
    return BMR_OK;
}

void bmr_agenda_release(bmr_agenda *agenda, const bmr_allocator *allocator) {
    agenda->promised--;
    // Where there is no memory for a smaller heap, the larger one stays.
    if (agenda->capacity > LEAST_CAPACITY && agenda->promised <= agenda->capacity / 4)
        resize(agenda, agenda->capacity / 2, allocator);
}

static bool before(const bmr_agenda *agenda, const bmr_agenda_entry *a, const bmr_agenda_entry *b) {
    return a->time < b->time || (a->time == b->time && agenda->before(a->item, b->item));
}

static void put(bmr_agenda *agenda, size_t place, bmr_agenda_entry entry) {
    agenda->heap[place] = entry;
    entry.item->place = place;
}

/// Puts the entry where it belongs, beginning at a place that is free.
static void settle(bmr_agenda *agenda, size_t at, bmr_agenda_entry entry) {
    while (at > 0 && before(agenda, &entry, &agenda->heap[(at - 1) / 2])) {
        put(agenda, at, agenda->heap[(at - 1) / 2]);
        at = (at - 1) / 2;
    }
    for (size_t child = 2 * at + 1; child < agenda->count; child = 2 * at + 1) {
        if (child + 1 < agenda->count && before(agenda, &agenda->heap[child + 1], &agenda->heap[child]))
            child++;
        if (!before(agenda, &agenda->heap[child], &entry))
            break;
        put(agenda, at, agenda->heap[child]);
        at = child;
    }
    put(agenda, at, entry);
}

void bmr_agenda_set(bmr_agenda *agenda, bmr_agenda_item *item, double time) {
    const bmr_agenda_entry entry = {time, item};
    if (time < INFINITY) {
        settle(agenda, item->place == BMR_NOT_QUEUED ? agenda->count++ : item->place, entry);
        return;
    }
    if (item->place == BMR_NOT_QUEUED)
        return;
    const size_t hole = item->place;
    const bmr_agenda_entry last = agenda->heap[--agenda->count];
    item->place = BMR_NOT_QUEUED;
    if (last.item != item)
        settle(agenda, hole, last);
}
