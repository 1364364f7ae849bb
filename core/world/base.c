// SPDX-License-Identifier: MIT
// What every part of a world needs: memory that is counted, why the world stopped, who observes events.
#include <string.h>

#include "geometry/memory.h"
#include "world/parts.h"

void *bmr_world_take(void *world, size_t bytes) {
    bmr_world *const w = world;
    void *block = bmr_allocate(w->allocator, bytes);
    if (block)
        w->counts.bytes += bytes;
    if (w->counts.most_bytes < w->counts.bytes)
        w->counts.most_bytes = w->counts.bytes;
    return block;
}

void bmr_world_give(void *world, void *block, size_t bytes) {
    bmr_world *const w = world;
    if (!block)
        return;
    w->counts.bytes -= bytes;
    bmr_release(w->allocator, block, bytes);
}

bmr_error bmr_scheduled_make(bmr_world *w, size_t bytes, bool is_pair, bmr_scheduled **made) {
    bmr_scheduled *const head = bmr_world_take(w, bytes);
    const bmr_error error = head ? bmr_event_queue_promise(&w->queue, &w->counted) : BMR_ERROR_NO_MEMORY;
    if (error != BMR_OK) {
        bmr_world_give(w, head, bytes);
        return error;
    }
    memset(head, 0, bytes);
    head->item.place = BMR_NOT_QUEUED;
    head->is_pair = is_pair;
    *made = head;
    return BMR_OK;
}

void bmr_scheduled_destroy(bmr_world *w, bmr_scheduled *head, size_t bytes) {
    bmr_event_queue_set(&w->queue, &head->item, INFINITY);
    bmr_event_queue_release(&w->queue, &w->counted);
    bmr_world_give(w, head, bytes);
}

// ---- trouble ----

const char *bmr_trouble_describe(bmr_trouble trouble) {
    static const char *const sentences[BMR_TROUBLE_COUNT] = {
        [BMR_TROUBLE_NONE] = "nothing is wrong",
        [BMR_TROUBLE_CONTACTS] =
            "contact after contact, each nearer than the last, and no answer takes them apart: "
            "they rest on each other, or others push them together, or the answer ends nothing; "
            "BMR_ZENO_ELASTIC, more restitution or a larger margin helps",
        [BMR_TROUBLE_REPAIRS] =
            "their structure fails again as soon as it is repaired: take a larger margin, or "
            "another structure",
        [BMR_TROUBLE_PROOF] =
            "they are apart by less than their structure can prove: take a larger margin, or "
            "another structure",
        [BMR_TROUBLE_SPEED] =
            "so much way in one rounding of the time that contacts could be missed: take slower "
            "bodies, a larger margin, or times nearer to 0",
        [BMR_TROUBLE_PLACE] =
            "so far away that there are no larger cells, or no digits left in its place: remove "
            "it, or put it back",
        [BMR_TROUBLE_ANSWER] =
            "the answer to their contact makes no sense: a restitution is from 0 to 1, and a "
            "response one of bmr_response_kind",
        [BMR_TROUBLE_EVENTS] =
            "so many events as most_events allows have been in this call: call again to go on",
        [BMR_TROUBLE_OTHER] = "the error says what",
    };
    return (unsigned)trouble < BMR_TROUBLE_COUNT ? sentences[trouble] : "not a trouble of this library";
}

bmr_error bmr_world_stop(bmr_world *w, bmr_error error, bmr_trouble kind, bmr_body a, bmr_body b) {
    w->trouble = (bmr_world_trouble){error, kind, w->time, a, b};
    return error;
}

bmr_world_trouble bmr_world_get_trouble(const bmr_world *w) {
    return w->trouble;
}

// ---- events ----

void bmr_world_observe(bmr_world *w, bmr_world_event_kind kind, bmr_body a, bmr_body b,
                       const bmr_kds_report *report) {
    w->counts.events[kind]++;
    if (!w->def.observer)
        return;
    bmr_world_event event = {.kind = kind, .time = w->time, .a = a, .b = b};
    if (report)
        event.report = *report;
    w->def.observer(w->def.context, w, &event);
}
