// SPDX-License-Identifier: MIT
#include "outline/improve.h"

#include <string.h>

#include "geometry/memory.h"
#include "outline/group.h"

#define NONE BMR_OUTLINE_NONE
/// The corners of a group that is a part of something larger. The programme's time grows with their third
/// power.
#define GROUP_CORNERS 64u

typedef struct work {
    bmr_group group;
    bmr_loop loop;
    bmr_cut cuts[BMR_LOOP_MOST];
    bmr_optimal *optimal;
} work;

/// Faces whose groups are still to be looked at: a ring that has room for every face once.
typedef struct queue {
    uint32_t *faces;
    bool *waits;
    uint32_t room, first, count;
} queue;

static void put(queue *q, uint32_t face) {
    if (q->waits[face])
        return;
    q->waits[face] = true;
    q->faces[(q->first + q->count++) % q->room] = face;
}

static uint32_t take(queue *q) {
    const uint32_t face = q->faces[q->first];
    q->first = (q->first + 1) % q->room;
    --q->count;
    q->waits[face] = false;
    return face;
}

/// Cuts the group of a face anew, if that saves a face.
static bmr_error improve_around(work *w, uint32_t face, queue *q) {
    bmr_group *g = &w->group;
    // The whole, where that is small enough; there, the best is the best.
    bool gathered = bmr_group_gather(g, face, BMR_LOOP_MOST);
    if (!gathered || !g->is_whole)
        gathered = bmr_group_gather(g, face, GROUP_CORNERS);
    if (!gathered || g->face_count < 2)
        return BMR_OK;
    uint32_t count = 0;
    if (bmr_group_loop(g, &w->loop)) {
        const bmr_error error = bmr_optimal_cuts(w->optimal, &w->loop, w->cuts, &count);
        if (error != BMR_OK)
            return error;
    }
    if (count + 1 >= g->face_count)
        return BMR_OK;
    bmr_group_cut(g, w->cuts, count);
    for (uint32_t f = 0; f < g->face_count && !g->is_whole; ++f)
        put(q, g->faces[f]);
    return BMR_OK;
}

static bmr_error improve(bmr_mesh *m, work *w, queue *q) {
    for (uint32_t f = 0; f < m->face_count; ++f)
        if (m->faces[f] != NONE)
            put(q, f);
    while (q->count > 0) {
        const uint32_t face = take(q);
        if (m->faces[face] == NONE)
            continue;
        const bmr_error error = improve_around(w, face, q);
        if (error != BMR_OK)
            return error;
    }
    return BMR_OK;
}

bmr_error bmr_mesh_improve(bmr_mesh *mesh, const bmr_allocator *allocator) {
    const uint32_t faces = mesh->face_count;
    const size_t bytes = sizeof(work) + faces * (2 * sizeof(uint32_t) + sizeof(bool));
    char *block = bmr_allocate(allocator, bytes);
    if (!block)
        return BMR_ERROR_NO_MEMORY;
    work *w = (work *)(void *)block;
    uint32_t *lists = (uint32_t *)(void *)(block + sizeof *w);
    memset(lists, 0, bytes - sizeof *w);
    w->group.mesh = mesh;
    w->group.member_of = lists;
    w->group.number = 0;
    queue q = {lists + faces, (bool *)(lists + 2 * (size_t)faces), faces, 0, 0};
    bmr_error error = bmr_optimal_create(allocator, &w->optimal);
    if (error == BMR_OK) {
        error = improve(mesh, w, &q);
        bmr_optimal_destroy(w->optimal);
    }
    bmr_release(allocator, block, bytes);
    if (error == BMR_OK)
        bmr_mesh_unite_idle(mesh);
    return error;
}
