// SPDX-License-Identifier: MIT
// All memory of a world goes through its own allocator, which counts.
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
