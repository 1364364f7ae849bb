// SPDX-License-Identifier: MIT
// What every part of a world needs: memory that is counted, why the world stopped, who is told of events.
#include <string.h>

#include "geometry/memory.h"
#include "world/parts.h"

void *bmr_world_take(bmr_world *w, size_t bytes) {
    void *block = bmr_allocate(w->allocator, bytes);
    if (block)
        w->counts.bytes += bytes;
    if (w->counts.most_bytes < w->counts.bytes)
        w->counts.most_bytes = w->counts.bytes;
    return block;
}

void bmr_world_give(bmr_world *w, void *block, size_t bytes) {
    w->counts.bytes -= bytes;
    bmr_release(w->allocator, block, bytes);
}

static void *take(void *context, size_t bytes) {
    return bmr_world_take(context, bytes);
}

static void give(void *context, void *block, size_t bytes) {
    bmr_world_give(context, block, bytes);
}

bmr_allocator bmr_world_allocator(bmr_world *w) {
    const bmr_allocator counted = {take, give, w};
    return counted;
}

// ---- trouble ----

const char *bmr_trouble_describe(bmr_trouble trouble) {
    switch (trouble) {
    case BMR_TROUBLE_NONE:
        return "nothing is wrong";
    case BMR_TROUBLE_CONTACTS:
        return "contact after contact, each nearer than the last, and no answer takes them apart: they rest "
               "on each other, or others push them together, or the answer ends nothing; BMR_ZENO_ELASTIC, "
               "more restitution or a larger margin helps";
    case BMR_TROUBLE_REPAIRS:
        return "their structure fails again as soon as it is repaired: take a larger margin, or another "
               "structure";
    case BMR_TROUBLE_PROOF:
        return "they are apart by less than their structure can prove: take a larger margin, or another "
               "structure";
    case BMR_TROUBLE_SPEED:
        return "so much way in one rounding of the time that contacts could be missed: take slower bodies, a "
               "larger margin, or times nearer to 0";
    case BMR_TROUBLE_PLACE:
        return "so far away that there are no larger cells, or no digits left in its place: remove it, or "
               "put "
               "it back";
    case BMR_TROUBLE_ANSWER:
        return "the answer to their contact makes no sense: a restitution is from 0 to 1, and a response one "
               "of bmr_response_kind";
    case BMR_TROUBLE_EVENTS:
        return "so many events as most_events allows have been in this call: call again to go on";
    case BMR_TROUBLE_OTHER:
        return "the error says what";
    case BMR_TROUBLE_COUNT:
        break;
    }
    return "not a trouble of this library";
}

bmr_error bmr_world_stop(bmr_world *w, bmr_error error, bmr_trouble kind, bmr_body a, bmr_body b) {
    w->trouble.error = error;
    w->trouble.kind = kind;
    w->trouble.a = a;
    w->trouble.b = b;
    w->trouble.time = w->time;
    return error;
}

bmr_world_trouble bmr_world_get_trouble(const bmr_world *w) {
    return w->trouble;
}

// ---- events ----

void bmr_world_observe(bmr_world *w, bmr_world_event_kind kind, double time, bmr_body a, bmr_body b,
                       const bmr_kds_report *report) {
    w->counts.events[kind]++;
    if (!w->def.observer)
        return;
    bmr_world_event event;
    memset(&event, 0, sizeof event);
    event.kind = kind;
    event.time = time;
    event.a = a;
    event.b = b;
    if (report)
        event.report = *report;
    w->def.observer(w->def.context, w, &event);
}
