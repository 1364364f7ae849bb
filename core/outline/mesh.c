// SPDX-License-Identifier: MIT
#include <string.h>

#include "geometry/memory.h"
#include "outline/mesh.h"
#include "outline/sweep.h"

/// @file
/// Triangles in one sweep from left to right. Of each solid gap between two strands the sweep keeps the chain
/// of points that bounds what is cut already, from the left end of the lower strand to that of the upper one.
/// Along it the solid takes half a turn or more at every inner point, so that nothing more can be cut without
/// a further point. Where the sweep comes to one, it sees the newest point of the chain, and from there on a
/// run of the chain on either side. Each triangle takes a point off a chain: all of them cost O(n).

#define NONE BMR_OUTLINE_NONE

/// A point of a chain. `border` is what leads from it to the next one above.
typedef struct node {
    uint32_t point, lower, upper, border;
} node;

/// What two triangles, or a triangle and the outline, have in common: the half that came first (NONE: there
/// is none yet), and the outline's edge. Borders of strands come first, by their numbers; then diagonals.
typedef struct border {
    uint32_t half, source;
} border;

typedef struct cutter {
    bmr_mesh *mesh;
    bmr_strand *strands;
    node *nodes;
    uint32_t node_count;
    border *borders;
    uint32_t border_count;
} cutter;

static uint32_t new_node(cutter *c, uint32_t point) {
    c->nodes[c->node_count] = (node){point, NONE, NONE, NONE};
    return c->node_count++;
}

static uint32_t new_diagonal(cutter *c) {
    c->borders[c->border_count] = (border){NONE, NONE};
    return c->border_count++;
}

/// A triangle, counter-clockwise, and the border behind each of its points.
static void cut(cutter *c, const uint32_t points[3], const uint32_t borders[3]) {
    bmr_mesh *m = c->mesh;
    const uint32_t base = m->half_count;
    for (uint32_t i = 0; i < 3; ++i) {
        border *b = &c->borders[borders[i]];
        bmr_half *h = &m->halves[base + i];
        *h = (bmr_half){points[i], base + (i + 1) % 3, base + (i + 2) % 3, b->half, b->source, m->face_count,
                        0};
        if (b->half == NONE)
            b->half = base + i;
        else
            m->halves[b->half].twin = base + i;
    }
    m->faces[m->face_count++] = base;
    m->half_count += 3;
}

static bool turns_left(const cutter *c, uint32_t a, uint32_t b, uint32_t d) {
    const bmr_vec2 *p = c->mesh->points;
    return bmr_orientation(p[a], p[b], p[d]) > 0;
}

/// A point becomes the upper end of a gap's chain; `side` is what leads from the upper end so far to it.
static void join_at_top(cutter *c, bmr_gap *gap, uint32_t point, uint32_t side) {
    uint32_t end = gap->high;
    while (end != gap->low) {
        const uint32_t before = c->nodes[end].lower;
        if (!turns_left(c, c->nodes[before].point, point, c->nodes[end].point))
            break;
        const uint32_t diagonal = new_diagonal(c);
        cut(c, (uint32_t[]){c->nodes[before].point, point, c->nodes[end].point},
            (uint32_t[]){diagonal, side, c->nodes[before].border});
        side = diagonal;
        end = before;
    }
    const uint32_t top = new_node(c, point);
    c->nodes[end].upper = top;
    c->nodes[end].border = side;
    c->nodes[top].lower = end;
    gap->high = gap->newest = top;
}

/// The same at the lower end. `last` is the border to use instead of a new diagonal at the far end of the
/// chain; NONE where the gap goes on.
static void join_at_bottom(cutter *c, bmr_gap *gap, uint32_t point, uint32_t side, uint32_t last) {
    uint32_t end = gap->low;
    while (end != gap->high) {
        const uint32_t behind = c->nodes[end].upper;
        if (!turns_left(c, c->nodes[end].point, point, c->nodes[behind].point))
            break;
        const uint32_t diagonal = behind == gap->high && last != NONE ? last : new_diagonal(c);
        cut(c, (uint32_t[]){c->nodes[end].point, point, c->nodes[behind].point},
            (uint32_t[]){side, diagonal, c->nodes[end].border});
        side = diagonal;
        end = behind;
    }
    if (last != NONE)
        return;
    const uint32_t bottom = new_node(c, point);
    c->nodes[end].lower = bottom;
    c->nodes[bottom].upper = end;
    c->nodes[bottom].border = side;
    gap->low = gap->newest = bottom;
}

/// A point in the middle of a gap: it is joined to the newest point of the chain, which it sees, and the gap
/// becomes two.
static void split_gap(cutter *c, uint32_t point, bmr_gap *lower, bmr_gap *upper) {
    const uint32_t newest = lower->newest, diagonal = new_diagonal(c);
    const uint32_t copy = new_node(c, c->nodes[newest].point);
    c->nodes[copy].upper = c->nodes[newest].upper;
    c->nodes[copy].border = c->nodes[newest].border;
    if (newest == lower->high)
        upper->high = copy;
    else {
        upper->high = lower->high;
        c->nodes[c->nodes[copy].upper].lower = copy;
    }
    upper->low = copy;
    lower->high = newest;
    join_at_top(c, lower, point, diagonal);
    join_at_bottom(c, upper, point, diagonal, NONE);
}

static void visit(void *context, bmr_strand *strands, const bmr_sweep_event *e) {
    cutter *c = context;
    for (uint32_t i = 0; i < e->start_count; ++i)
        c->borders[e->starts[i]] = (border){NONE, strands[e->starts[i]].edge};
    const uint32_t top_start = e->start_count > 0 ? e->starts[e->start_count - 1] : NONE;
    const bool solid_below = e->below != NONE && strands[e->below].solid_above;
    bmr_gap above = {NONE, NONE, NONE}; // the gap under the strand above, on the right of the place
    bool solid_beyond = solid_below;
    if (e->end_count == 0) {
        if (solid_below)
            split_gap(c, e->point, &strands[e->below].gap, &above);
    } else {
        if (solid_below)
            join_at_top(c, &strands[e->below].gap, e->point, e->ends[0]);
        for (uint32_t i = 0; i + 1 < e->end_count; ++i)
            if (strands[e->ends[i]].solid_above)
                join_at_bottom(c, &strands[e->ends[i]].gap, e->point, e->ends[i], e->ends[i + 1]);
        const uint32_t top_end = e->ends[e->end_count - 1];
        solid_beyond = strands[top_end].solid_above;
        if (solid_beyond) {
            above = strands[top_end].gap;
            join_at_bottom(c, &above, e->point, top_end, NONE);
        }
    }
    for (uint32_t i = 0; i + 1 < e->start_count; ++i)
        if (strands[e->starts[i]].solid_above) {
            const uint32_t only = new_node(c, e->point);
            strands[e->starts[i]].gap = (bmr_gap){only, only, only};
        }
    if (!solid_beyond)
        return;
    if (top_start != NONE) {
        strands[top_start].gap = above;
        return;
    }
    // Nothing starts here: the gaps below and above become one, whose chain turns at the place.
    bmr_gap *below = &strands[e->below].gap;
    const uint32_t behind = c->nodes[above.low].upper;
    c->nodes[below->high].upper = behind;
    c->nodes[below->high].border = c->nodes[above.low].border;
    c->nodes[behind].lower = below->high;
    below->high = above.high;
}

bmr_error bmr_mesh_triangulate(const bmr_ring_links *links, const bmr_allocator *allocator, bmr_mesh *mesh,
                               bmr_outline_fault *fault) {
    // The outline has at most as many edges as there are strands, and as many corners. Each hole adds two
    // triangles, and each triangle has half a diagonal a side at most. At one place a chain gets three nodes
    // at most, and every second strand that starts there another one.
    const uint32_t strands = bmr_sweep_most_strands(links->count);
    const uint32_t triangles = strands + 2 * links->ring_count;
    const uint32_t borders = strands + (3 * triangles) / 2, nodes = 3 * links->count + strands;
    const size_t bytes = triangles * (3 * sizeof(bmr_half) + sizeof(uint32_t));
    const size_t scratch_bytes = nodes * sizeof(node) + borders * sizeof(border);
    bmr_half *halves = bmr_allocate(allocator, bytes);
    node *scratch = halves ? bmr_allocate(allocator, scratch_bytes) : NULL;
    bmr_error error = BMR_ERROR_NO_MEMORY;
    if (scratch) {
        bmr_mesh made = {.points = links->points,
                         .halves = halves,
                         .faces = (uint32_t *)(void *)(halves + 3 * (size_t)triangles),
                         .bytes = bytes};
        cutter c = {&made, NULL, scratch, 0, (border *)(void *)(scratch + nodes), strands};
        error = bmr_sweep(links, allocator, visit, &c, fault);
        if (error == BMR_OK)
            *mesh = made;
        bmr_release(allocator, scratch, scratch_bytes);
    }
    if (halves && error != BMR_OK)
        bmr_release(allocator, halves, bytes);
    return error;
}

void bmr_mesh_free(bmr_mesh *mesh, const bmr_allocator *allocator) {
    bmr_release(allocator, mesh->halves, mesh->bytes);
}

/// Steps through both faces at once and stops at the end of the shorter one.
static bool is_shorter(const bmr_mesh *m, uint32_t half, uint32_t other) {
    uint32_t h = half, o = other;
    do {
        h = m->halves[h].next;
        o = m->halves[o].next;
    } while (h != half && o != other);
    return h == half;
}

void bmr_mesh_unite(bmr_mesh *mesh, uint32_t half) {
    bmr_half *halves = mesh->halves;
    const uint32_t twin = halves[half].twin;
    const uint32_t kept = is_shorter(mesh, half, twin) ? twin : half;
    const uint32_t gone = halves[kept].twin, face = halves[kept].face;
    mesh->faces[halves[gone].face] = NONE;
    for (uint32_t h = halves[gone].next; h != gone; h = halves[h].next)
        halves[h].face = face;
    mesh->faces[face] = halves[kept].next;
    const bmr_half a = halves[kept], b = halves[gone];
    halves[a.previous].next = b.next;
    halves[b.next].previous = a.previous;
    halves[b.previous].next = a.next;
    halves[a.next].previous = b.previous;
    halves[kept].face = halves[gone].face = NONE;
}

void bmr_mesh_unite_idle(bmr_mesh *mesh) {
    for (uint32_t h = 0; h < mesh->half_count; ++h) {
        const bmr_half *half = &mesh->halves[h];
        if (half->face != NONE && half->twin != NONE && h < half->twin && bmr_mesh_is_idle_at(mesh, h) &&
            bmr_mesh_is_idle_at(mesh, half->twin))
            bmr_mesh_unite(mesh, h);
    }
}
