// SPDX-License-Identifier: MIT
#include "kinetic/event_queue.h"

#include <math.h>
#include <stdbool.h>

void bmr_event_queue_init(bmr_event_queue *queue) {
    for (size_t i = 0; i < queue->count; i++) {
        queue->times[i] = INFINITY;
        queue->order[i] = queue->place[i] = i;
    }
}

static bool before(const bmr_event_queue *queue, size_t a, size_t b) {
    const double time = queue->times[a], other = queue->times[b];
    return time < other || (time == other && a < b);
}

static void put(bmr_event_queue *queue, size_t place, size_t item) {
    queue->order[place] = item;
    queue->place[item] = place;
}

void bmr_event_queue_set(bmr_event_queue *queue, size_t item, double time) {
    queue->times[item] = time;
    size_t at = queue->place[item];
    while (at > 0 && before(queue, item, queue->order[(at - 1) / 2])) {
        put(queue, at, queue->order[(at - 1) / 2]);
        at = (at - 1) / 2;
    }
    for (size_t child = 2 * at + 1; child < queue->count; child = 2 * at + 1) {
        if (child + 1 < queue->count && before(queue, queue->order[child + 1], queue->order[child]))
            child++;
        if (!before(queue, queue->order[child], item))
            break;
        put(queue, at, queue->order[child]);
        at = child;
    }
    put(queue, at, item);
}
