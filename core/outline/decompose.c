// SPDX-License-Identifier: MIT
#include <math.h>
#include <string.h>

#include "geometry/memory.h"
#include "outline/mesh.h"
#include "outline/sweep.h"

#define NONE BMR_OUTLINE_NONE

static const bmr_outline_fault NO_FAULT = {BMR_OK, {NONE, NONE}, {NONE, NONE}, {0.0, 0.0}};

/// What the outline that is cut has to do with the one that was given: its points there, by their indices
/// here.
typedef struct origin {
    const bmr_rings *given;
    uint32_t given_count;
    const uint32_t *kept;
} origin;

static void tell_given(const origin *from, bmr_outline_fault *fault) {
    for (int i = 0; i < 2; ++i)
        if (fault->edge[i] != NONE)
            fault->edge[i] = from->kept[fault->edge[i]];
}

/// The rings that were given, without repeated points, and linked.
typedef struct outline {
    bmr_distinct_rings distinct;
    bmr_ring_links links;
    origin from;
} outline;

/// Errors: those of bmr_rings_check, TOO_FEW_POINTS (with the fault, of the rings in `o`), NO_MEMORY.
static bmr_error open_outline(const bmr_rings *rings, const bmr_allocator *allocator,
                              bmr_outline_fault *fault, outline *o) {
    uint32_t count;
    bmr_error error = bmr_rings_check(rings, &count);
    if (error == BMR_OK)
        error = bmr_distinct_rings_make(rings, count, allocator, &o->distinct);
    if (error != BMR_OK)
        return error;
    o->from = (origin){rings, count, o->distinct.kept};
    error = bmr_rings_find_short(&o->distinct.rings, fault);
    if (error == BMR_OK)
        error = bmr_ring_links_make(&o->distinct.rings, o->distinct.count, allocator, &o->links);
    if (error != BMR_OK) {
        tell_given(&o->from, fault);
        bmr_distinct_rings_free(&o->distinct, allocator);
    }
    return error;
}

/// The fault becomes one of the rings that were given.
static void close_outline(outline *o, const bmr_allocator *allocator, bmr_outline_fault *fault) {
    tell_given(&o->from, fault);
    bmr_ring_links_free(&o->links, allocator);
    bmr_distinct_rings_free(&o->distinct, allocator);
}

bmr_error bmr_outline_check(const bmr_rings *rings, const bmr_allocator *allocator,
                            bmr_outline_fault *fault) {
    bmr_outline_fault found = NO_FAULT;
    outline o;
    bmr_error error = open_outline(rings, allocator, &found, &o);
    if (error == BMR_OK) {
        error = bmr_sweep(&o.links, allocator, NULL, NULL, &found);
        close_outline(&o, allocator, &found);
    }
    if (fault && found.error == error)
        *fault = found;
    return error;
}

typedef struct tally {
    uint32_t pieces, edges;
} tally;

static tally count_pieces(const bmr_mesh *m) {
    tally n = {0, 0};
    for (uint32_t f = 0; f < m->face_count; ++f)
        n.pieces += m->faces[f] != NONE;
    for (uint32_t h = 0; h < m->half_count; ++h)
        n.edges += m->halves[h].face != NONE;
    return n;
}

_Static_assert(sizeof(bmr_outline_pieces) % sizeof(double) == 0, "the points begin behind it");

/// Of a block of pieces: points, edges and where each piece begins.
static size_t bytes_for(uint32_t points, uint32_t pieces, uint32_t edges) {
    return sizeof(bmr_outline_pieces) + points * sizeof(bmr_vec2) + edges * sizeof(bmr_outline_edge) +
           ((size_t)pieces + 1) * sizeof(uint32_t);
}

/// One block of what the mesh has become. `corner` of each half becomes the number of its edge.
static bmr_error write_pieces(bmr_mesh *m, const origin *from, const bmr_allocator *allocator,
                              bmr_outline_pieces **pieces) {
    const tally n = count_pieces(m);
    bmr_outline_pieces *made = bmr_allocate(allocator, bytes_for(from->given_count, n.pieces, n.edges));
    if (!made)
        return BMR_ERROR_NO_MEMORY;
    bmr_vec2 *points = (bmr_vec2 *)(void *)(made + 1);
    bmr_outline_edge *edges = (bmr_outline_edge *)(void *)(points + from->given_count);
    uint32_t *first = (uint32_t *)(void *)(edges + n.edges);
    memcpy(points, from->given->points, from->given_count * sizeof *points);
    uint32_t edge = 0, piece = 0;
    for (uint32_t f = 0; f < m->face_count; ++f) {
        if (m->faces[f] == NONE)
            continue;
        first[piece] = edge;
        uint32_t h = m->faces[f];
        do {
            m->halves[h].corner = edge;
            edges[edge++] =
                (bmr_outline_edge){m->halves[h].origin, m->halves[h].source, m->halves[h].twin, piece};
            h = m->halves[h].next;
        } while (h != m->faces[f]);
        ++piece;
    }
    first[piece] = edge;
    for (uint32_t e = 0; e < edge; ++e) {
        bmr_outline_edge *it = &edges[e];
        it->point = from->kept[it->point];
        it->outline = it->outline != NONE ? from->kept[it->outline] : NONE;
        it->twin = it->twin != NONE ? m->halves[it->twin].corner : NONE;
    }
    *made = (bmr_outline_pieces){points, from->given_count, piece, first, edges, edge};
    *pieces = made;
    return BMR_OK;
}

/// The pieces of exactly this outline.
static bmr_error cut(const bmr_ring_links *links, const origin *from, const bmr_allocator *allocator,
                     bmr_outline_pieces **pieces, bmr_outline_fault *fault) {
    bmr_mesh mesh;
    bmr_error error = bmr_mesh_triangulate(links, allocator, &mesh, fault);
    if (error != BMR_OK)
        return error;
    bmr_mesh_unite_idle(&mesh);
    error = bmr_mesh_improve(&mesh, allocator);
    if (error == BMR_OK)
        error = write_pieces(&mesh, from, allocator, pieces);
    bmr_mesh_free(&mesh, allocator);
    return error;
}

/// The pieces of what a simplification leaves.
static bmr_error cut_simpler(const outline *o, double tolerance, const bmr_allocator *allocator,
                             bmr_outline_pieces **pieces, bmr_outline_fault *fault) {
    const bmr_ring_links *links = &o->links;
    const size_t bytes = bmr_rings_bytes(links->count, links->ring_count);
    bmr_vec2 *points = bmr_allocate(allocator, bytes);
    if (!points)
        return BMR_ERROR_NO_MEMORY;
    uint32_t *kept = (uint32_t *)(void *)(points + links->count), *counts = kept + links->count;
    bmr_error error = bmr_simplify(links, tolerance, allocator, kept, counts, fault);
    if (error == BMR_OK) {
        uint32_t ring_count = 0, count = 0;
        for (uint32_t r = 0; r < links->ring_count; ++r) {
            count += counts[r];
            if (counts[r] > 0)
                counts[ring_count++] = counts[r];
        }
        for (uint32_t i = 0; i < count; ++i) {
            points[i] = links->points[kept[i]];
            kept[i] = o->from.kept[kept[i]];
        }
        const bmr_rings left = {points, counts, ring_count};
        const origin from = {o->from.given, o->from.given_count, kept};
        bmr_ring_links left_links;
        error = bmr_ring_links_make(&left, count, allocator, &left_links);
        if (error == BMR_OK) {
            error = cut(&left_links, &from, allocator, pieces, fault);
            bmr_ring_links_free(&left_links, allocator);
        }
    }
    bmr_release(allocator, points, bytes);
    return error;
}

static bmr_error check_tolerance(double tolerance) {
    if (!isfinite(tolerance))
        return BMR_ERROR_NOT_FINITE;
    return tolerance < 0.0 ? BMR_ERROR_NEGATIVE : BMR_OK;
}

bmr_error bmr_outline_decompose(const bmr_rings *rings, const bmr_outline_def *def,
                                const bmr_allocator *allocator, bmr_outline_pieces **pieces,
                                bmr_outline_fault *fault) {
    const bmr_outline_def defaults = bmr_default_outline_def();
    if (!def)
        def = &defaults;
    if (!pieces)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_error error = check_tolerance(def->tolerance);
    if (error != BMR_OK)
        return error;
    bmr_outline_fault found = NO_FAULT;
    outline o;
    error = open_outline(rings, allocator, &found, &o);
    if (error == BMR_OK) {
        error = def->tolerance > 0.0 ? cut_simpler(&o, def->tolerance, allocator, pieces, &found)
                                     : cut(&o.links, &o.from, allocator, pieces, &found);
        close_outline(&o, allocator, &found);
    }
    if (fault && found.error == error)
        *fault = found;
    return error;
}

bmr_error bmr_outline_simplify(const bmr_rings *rings, double tolerance, const bmr_allocator *allocator,
                               uint32_t *kept, uint32_t *counts, bmr_outline_fault *fault) {
    if (!kept || !counts)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_error error = check_tolerance(tolerance);
    if (error != BMR_OK)
        return error;
    bmr_outline_fault found = NO_FAULT;
    outline o;
    error = open_outline(rings, allocator, &found, &o);
    if (error == BMR_OK) {
        error = bmr_simplify(&o.links, tolerance, allocator, kept, counts, &found);
        for (uint32_t r = 0; error == BMR_OK && r < o.links.ring_count; ++r)
            for (uint32_t i = 0; i < counts[r]; ++i, ++kept)
                *kept = o.from.kept[*kept];
        close_outline(&o, allocator, &found);
    }
    if (fault && found.error == error)
        *fault = found;
    return error;
}

void bmr_outline_pieces_destroy(bmr_outline_pieces *pieces, const bmr_allocator *allocator) {
    if (pieces)
        bmr_release(allocator, pieces,
                    bytes_for(pieces->point_count, pieces->piece_count, pieces->edge_count));
}

/// Once around, turning left or not at all, and somewhere left?
static bool is_convex(const bmr_outline_pieces *o, uint32_t piece) {
    const uint32_t begin = o->first[piece], count = o->first[piece + 1] - begin;
    uint32_t rises = 0; // edges that begin to go right after one that went left: one, once around
    bool turned = false;
    for (uint32_t i = 0; i < count; ++i) {
        bmr_vec2 p[3];
        for (uint32_t k = 0; k < 3; ++k)
            p[k] = o->points[o->edges[begin + (i + k) % count].point];
        const int turn = bmr_orientation(p[0], p[1], p[2]);
        const int ahead = bmr_sweep_compare(p[0], p[1]), on = bmr_sweep_compare(p[1], p[2]);
        // A corner that is no turn goes straight on, and not back.
        if (turn < 0 || ahead == 0 || (turn == 0 && ahead != on))
            return false;
        turned = turned || turn > 0;
        rises += ahead > 0 && on < 0;
    }
    return count >= 3 && turned && rises == 1;
}

static bool is_whole(const bmr_outline_pieces *o) {
    if (o->piece_count == 0 || o->first[0] != 0 || o->first[o->piece_count] != o->edge_count)
        return false;
    for (uint32_t p = 0; p < o->piece_count; ++p) {
        if (o->first[p] >= o->first[p + 1] || o->first[p + 1] > o->edge_count)
            return false;
        for (uint32_t e = o->first[p]; e < o->first[p + 1]; ++e) {
            const bmr_outline_edge *it = &o->edges[e];
            if (it->point >= o->point_count || it->piece != p ||
                (it->outline == NONE) == (it->twin == NONE) ||
                (it->outline != NONE && it->outline >= o->point_count) ||
                (it->twin != NONE && it->twin >= o->edge_count))
                return false;
        }
    }
    return true;
}

static uint32_t end_of(const bmr_outline_pieces *o, uint32_t edge) {
    const uint32_t piece = o->edges[edge].piece;
    return o->edges[edge + 1 < o->first[piece + 1] ? edge + 1 : o->first[piece]].point;
}

bmr_error bmr_outline_pieces_audit(const bmr_outline_pieces *pieces) {
    if (!pieces)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!is_whole(pieces))
        return BMR_ERROR_INVALID_STRUCTURE;
    for (uint32_t e = 0; e < pieces->edge_count; ++e) {
        const uint32_t twin = pieces->edges[e].twin;
        if (twin != NONE &&
            (pieces->edges[twin].twin != e || pieces->edges[twin].piece == pieces->edges[e].piece ||
             pieces->edges[twin].point != end_of(pieces, e) ||
             pieces->edges[e].point != end_of(pieces, twin)))
            return BMR_ERROR_INVALID_STRUCTURE;
    }
    for (uint32_t p = 0; p < pieces->piece_count; ++p)
        if (!is_convex(pieces, p))
            return BMR_ERROR_NOT_CONVEX;
    return BMR_OK;
}
