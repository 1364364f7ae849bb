// SPDX-License-Identifier: MIT
#include "outline/mesh.h"

#include <string.h>

#include "geometry/memory.h"
#include "outline/optimal.h"

#define NONE BMR_OUTLINE_NONE
/// The corners of a group that is a part of something larger. The programme's time grows with their third
/// power.
#define GROUP_CORNERS 64u

/// Some faces of a mesh whose union is a polygon without holes, to be cut anew.
typedef struct face_group {
    bmr_mesh *mesh;
    /// Of each face: the number of the last group that it was in. `number` is that of this group.
    uint32_t *member_of;
    uint32_t number;
    uint32_t faces[BMR_LOOP_MOST];
    uint32_t face_count;
    uint32_t corners[BMR_LOOP_MOST]; ///< the halves on its boundary, counter-clockwise
    uint32_t corner_count;
    bool is_whole; ///< nothing lies behind its boundary
    uint32_t spare[2 * BMR_LOOP_MOST];
} face_group;

static bool is_inside(const face_group *g, uint32_t half) {
    return half != NONE && g->member_of[g->mesh->halves[half].face] == g->number;
}

/// Would the group stay a polygon without holes, and of at most `most` corners, with this face? It does where
/// the two have one edge in common: a point between two such edges is on the outline, as all are, and so
/// there is a hole in between. *corners becomes how many the group would have. O(most), however large the
/// face is.
static bool fits(const face_group *g, uint32_t face, uint32_t most, uint32_t *corners) {
    const bmr_mesh *m = g->mesh;
    uint32_t count = 0, common = 0, h = m->faces[face];
    do {
        common += is_inside(g, m->halves[h].twin);
        if (++count + g->corner_count > most + 2)
            return false;
        h = m->halves[h].next;
    } while (h != m->faces[face]);
    *corners = g->corner_count + count - 2 * common;
    return common <= 1 && *corners <= most;
}

/// The boundary, once around.
static void collect_corners(face_group *g) {
    const bmr_mesh *m = g->mesh;
    uint32_t start = NONE;
    for (uint32_t f = 0; f < g->face_count && start == NONE; ++f) {
        uint32_t h = m->faces[g->faces[f]];
        do {
            if (!is_inside(g, m->halves[h].twin))
                start = h;
            h = m->halves[h].next;
        } while (h != m->faces[g->faces[f]]);
    }
    g->corner_count = 0;
    g->is_whole = true;
    uint32_t h = start;
    do {
        g->corners[g->corner_count++] = h;
        g->is_whole = g->is_whole && m->halves[h].twin == NONE;
        h = m->halves[h].next;
        while (is_inside(g, m->halves[h].twin))
            h = m->halves[m->halves[h].twin].next;
    } while (h != start);
}

/// A face and those around it, the nearest first, as long as they are a polygon without holes and of at most
/// `most` corners. False where the face alone has more.
static bool group_gather(face_group *group, uint32_t face, uint32_t most) {
    const bmr_mesh *m = group->mesh;
    uint32_t corners;
    ++group->number;
    group->face_count = group->corner_count = 0;
    if (!fits(group, face, most, &corners))
        return false;
    group->corner_count = corners;
    group->member_of[face] = group->number;
    group->faces[group->face_count++] = face;
    for (uint32_t f = 0; f < group->face_count; ++f) {
        const uint32_t start = m->faces[group->faces[f]];
        uint32_t h = start;
        do {
            const uint32_t twin = m->halves[h].twin;
            if (twin != NONE && !is_inside(group, twin) &&
                fits(group, m->halves[twin].face, most, &corners)) {
                group->corner_count = corners;
                group->member_of[m->halves[twin].face] = group->number;
                group->faces[group->face_count++] = m->halves[twin].face;
            }
            h = m->halves[h].next;
        } while (h != start);
    }
    collect_corners(group);
    return true;
}

/// What one notch sees.
typedef struct view {
    const face_group *group;
    bmr_loop *loop;
    uint32_t eye;
    bmr_vec2 at;
} view;

static void see(const view *v, uint32_t half) {
    const uint32_t corner = v->group->mesh->halves[half].corner;
    v->loop->sees[v->eye][corner] = v->loop->sees[corner][v->eye] = true;
}

static int side(const view *v, bmr_vec2 towards, bmr_vec2 of) {
    return bmr_orientation(v->at, towards, of);
}

/// Sees through an edge into the face of `half`, which is the edge's side there, between the rays to `right`
/// and `left`. Each face is entered once: as deep as the group has faces.
static void see_through(const view *v, uint32_t half, bmr_vec2 right, bmr_vec2 left) {
    const bmr_mesh *m = v->group->mesh;
    for (uint32_t h = m->halves[half].next; h != half; h = m->halves[h].next) {
        const uint32_t next = m->halves[h].next, twin = m->halves[h].twin;
        const bmr_vec2 from = bmr_mesh_point(m, h), to = bmr_mesh_point(m, next);
        if (next != half) {
            const int from_right = side(v, right, to), from_left = -side(v, left, to);
            if (from_right > 0 && from_left > 0)
                see(v, next);
            if (from_right == 0 || from_left == 0)
                v->loop->has_line[v->eye] = true;
        }
        if (!is_inside(v->group, twin))
            continue;
        const bmr_vec2 new_right = side(v, right, from) > 0 ? from : right;
        const bmr_vec2 new_left = side(v, left, to) < 0 ? to : left;
        if (side(v, new_right, new_left) > 0)
            see_through(v, twin, new_right, new_left);
    }
}

/// Do two points lie on one ray from the eye?
static bool on_one_ray(const view *v, bmr_vec2 p, bmr_vec2 q) {
    return side(v, p, q) == 0 && bmr_sweep_compare(v->at, p) == bmr_sweep_compare(v->at, q);
}

/// The faces around the notch, and through their edges.
static void see_around(const view *v) {
    const bmr_mesh *m = v->group->mesh;
    uint32_t h = v->group->corners[v->eye];
    do {
        // Along the two sides of the face that meet at the notch, its nearest corners hide those behind.
        const uint32_t first = m->halves[h].next, last = m->halves[h].previous;
        for (uint32_t e = first; e != h; e = m->halves[e].next) {
            const bmr_vec2 here = bmr_mesh_point(m, e), next = bmr_mesh_point(m, m->halves[e].next);
            const bool hidden = (e != first && on_one_ray(v, bmr_mesh_point(m, first), here)) ||
                                (e != last && on_one_ray(v, bmr_mesh_point(m, last), here));
            if (hidden)
                v->loop->has_line[v->eye] = true;
            else
                see(v, e);
            if (e != last && is_inside(v->group, m->halves[e].twin) && side(v, here, next) != 0)
                see_through(v, m->halves[e].twin, here, next);
        }
        h = bmr_mesh_turn_left(m, h);
    } while (is_inside(v->group, h));
}

/// Turns the list of corners so that it begins with a notch; which corners are notches goes to the loop.
static bool begin_with_notch(face_group *g, bmr_loop *loop) {
    const bmr_mesh *m = g->mesh;
    const uint32_t n = g->corner_count;
    uint32_t first = n;
    bool notch[BMR_LOOP_MOST];
    uint32_t turned[BMR_LOOP_MOST];
    for (uint32_t i = 0; i < n; ++i) {
        notch[i] =
            bmr_orientation(bmr_mesh_point(m, g->corners[(i + n - 1) % n]), bmr_mesh_point(m, g->corners[i]),
                            bmr_mesh_point(m, g->corners[(i + 1) % n])) < 0;
        if (notch[i] && first == n)
            first = i;
    }
    if (first == n)
        return false;
    for (uint32_t i = 0; i < n; ++i) {
        turned[i] = g->corners[(first + i) % n];
        loop->is_notch[i] = notch[(first + i) % n];
        loop->corners[i] = bmr_mesh_point(m, turned[i]);
    }
    memcpy(g->corners, turned, n * sizeof *turned);
    return true;
}

/// The group as a loop whose corner 0 is a notch, with what its notches see. False where there is no notch:
/// all of it is convex. O(n r) at worst for n corners and r notches, and as many faces.
static bool group_loop(face_group *group, bmr_loop *loop) {
    const bmr_mesh *m = group->mesh;
    const uint32_t n = group->corner_count;
    loop->count = n;
    if (!begin_with_notch(group, loop))
        return false;
    for (uint32_t i = 0; i < n; ++i) {
        memset(loop->sees[i], 0, n * sizeof(bool));
        loop->has_line[i] = false;
        uint32_t h = group->corners[i];
        do {
            m->halves[h].corner = i;
            h = bmr_mesh_turn_left(m, h);
        } while (is_inside(group, h));
    }
    for (uint32_t i = 0; i < n; ++i)
        if (loop->is_notch[i]) {
            const view v = {group, loop, i, loop->corners[i]};
            see_around(&v);
        }
    return true;
}

/// The halves inside of the group, which its new cuts will use; each is marked as used by no face.
static void collect_spare(face_group *g) {
    bmr_mesh *m = g->mesh;
    uint32_t count = 0;
    for (uint32_t f = 0; f < g->face_count; ++f) {
        const uint32_t start = m->faces[g->faces[f]];
        uint32_t h = start;
        do {
            if (is_inside(g, m->halves[h].twin))
                g->spare[count++] = h;
            h = m->halves[h].next;
        } while (h != start);
    }
    for (uint32_t i = 0; i < count; ++i)
        m->halves[g->spare[i]].face = NONE;
}

/// Links the halves that leave and reach one corner. Cut k has the spare halves 2k (from its `from`) and
/// 2k + 1. Counter-clockwise around the corner come the edge that leaves it and the cuts, by their other
/// ends.
static void link_corner(face_group *g, uint32_t corner, const bmr_cut *cuts, uint32_t count) {
    bmr_half *halves = g->mesh->halves;
    const uint32_t n = g->corner_count;
    struct {
        uint32_t half, twin, ahead;
    } out[BMR_LOOP_MOST];
    uint32_t outs = 0;
    for (uint32_t k = 0; k < count; ++k) {
        const bool from = cuts[k].from == corner;
        if (!from && cuts[k].to != corner)
            continue;
        const uint32_t other = from ? cuts[k].to : cuts[k].from, ahead = (other + n - corner) % n;
        uint32_t at = outs++;
        for (; at > 0 && out[at - 1].ahead > ahead; --at)
            out[at] = out[at - 1];
        out[at].half = g->spare[2 * k + (from ? 0 : 1)];
        out[at].twin = g->spare[2 * k + (from ? 1 : 0)];
        out[at].ahead = ahead;
    }
    uint32_t leaves = g->corners[corner];
    const uint32_t origin = halves[leaves].origin;
    for (uint32_t i = 0; i < outs; ++i) {
        bmr_half *h = &halves[out[i].half];
        h->origin = origin;
        h->twin = out[i].twin;
        h->source = NONE;
        halves[out[i].twin].next = leaves;
        halves[leaves].previous = out[i].twin;
        leaves = out[i].half;
    }
    const uint32_t reaches = g->corners[(corner + n - 1) % n];
    halves[reaches].next = leaves;
    halves[leaves].previous = reaches;
}

/// Cuts the group anew, into fewer faces than it has. Their numbers, of those that it had, are `faces` then.
static void group_cut(face_group *group, const bmr_cut *cuts, uint32_t count) {
    bmr_mesh *m = group->mesh;
    collect_spare(group);
    for (uint32_t i = 0; i < group->corner_count; ++i) {
        link_corner(group, i, cuts, count);
        m->halves[group->corners[i]].face = NONE;
    }
    for (uint32_t f = 0; f < group->face_count; ++f)
        m->faces[group->faces[f]] = NONE;
    // Each new face has an edge of the boundary, or a half of a cut: both are tried.
    uint32_t made = 0;
    for (uint32_t i = 0; i < group->corner_count + 2 * count; ++i) {
        const uint32_t start =
            i < group->corner_count ? group->corners[i] : group->spare[i - group->corner_count];
        if (m->halves[start].face != NONE)
            continue;
        const uint32_t face = group->faces[made++];
        m->faces[face] = start;
        uint32_t h = start;
        do {
            m->halves[h].face = face;
            h = m->halves[h].next;
        } while (h != start);
    }
    group->face_count = made;
}

typedef struct work {
    face_group group;
    bmr_loop loop;
    bmr_cut cuts[BMR_LOOP_MOST];
    bmr_optimal *optimal;
} work;

/// Faces whose groups are still to be visited: a ring that holds every face once.
typedef struct queue {
    uint32_t *faces;
    bool *waits;
    uint32_t capacity, first, count;
} queue;

static void put(queue *q, uint32_t face) {
    if (q->waits[face])
        return;
    q->waits[face] = true;
    q->faces[(q->first + q->count++) % q->capacity] = face;
}

static uint32_t take(queue *q) {
    const uint32_t face = q->faces[q->first];
    q->first = (q->first + 1) % q->capacity;
    --q->count;
    q->waits[face] = false;
    return face;
}

/// Cuts the group of a face anew, if that saves a face.
static bmr_error improve_around(work *w, uint32_t face, queue *q) {
    face_group *g = &w->group;
    // The whole, where that is small enough; there, the best is the best.
    bool gathered = group_gather(g, face, BMR_LOOP_MOST);
    if (!gathered || !g->is_whole)
        gathered = group_gather(g, face, GROUP_CORNERS);
    if (!gathered || g->face_count < 2)
        return BMR_OK;
    uint32_t count = 0;
    if (group_loop(g, &w->loop)) {
        const bmr_error error = bmr_optimal_cuts(w->optimal, &w->loop, w->cuts, &count);
        if (error != BMR_OK)
            return error;
    }
    if (count + 1 >= g->face_count)
        return BMR_OK;
    group_cut(g, w->cuts, count);
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
