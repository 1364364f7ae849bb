// SPDX-License-Identifier: MIT
// The rival that keeps a separating edge of one polygon at full resolution and the vertex of the other that
// is nearest to its line; on failure it walks to the next edge that separates. Theta(n) events under
// translation, Theta(n^2) under rotation, however far the polygons are apart.
#include <math.h>

#include "geometry/distance.h"
#include "kds/features.h"
#include "kds/registry.h"

/// Once no edge's slack exceeds the margin by this part of what the distance does, the line across the
/// closest points serves instead: two corners can be apart by more than the margin where no edge shows it.
#define EDGE_PART 1e-3
/// Contact begins within this much of the margin, relative to the extents: what rounding leaves of a
/// distance.
#define CONTACT_ROUNDING 1e-10
/// A vertex may be passed so many times in one event; more only after jumps, and then it is looked up.
#define ROLL_STEPS 8

enum { BEYOND, BEFORE_CONE, AFTER_CONE, OTHER_END };

typedef struct separating_edge {
    bmr_line line; ///< owner's frame
    int owner;
    bool is_edge;    ///< false: the line across the closest points
    uint32_t edge;   ///< the owner's
    uint32_t vertex; ///< the other's nearest; one end of what is a segment up to rounding
} separating_edge;

static separating_edge *state_of(bmr_kds *kds) {
    return (separating_edge *)(void *)kds->state;
}
static const separating_edge *view(const bmr_kds *kds) {
    return (const separating_edge *)(const void *)kds->state;
}

static bmr_vec2 in_a(int owner, const bmr_pose *b_in_a, bmr_vec2 normal) {
    return owner == 0 ? normal : bmr_neg(bmr_rotate(b_in_a, normal));
}

static uint32_t nearest_vertex(const bmr_kds *kds, const bmr_pose *b_in_a, int owner, bmr_vec2 normal,
                               uint32_t hint) {
    const bmr_vec2 n = owner == 0 ? bmr_unrotate(b_in_a, normal) : bmr_rotate(b_in_a, normal);
    unsigned steps = 0;
    const uint32_t nearest =
        bmr_support_from_counted(kds->shapes[1 - owner].polygon, bmr_neg(n), hint, &steps);
    bmr_kds_tally(kds, steps);
    return nearest;
}

/// Is the other body a segment up to the overlap, as its nearest vertex sees it? Cones of half a turn cannot
/// overlap: both ends are watched instead.
static bool watches_ends(const bmr_kds *kds) {
    const separating_edge *s = view(kds);
    return bmr_cone_is_half_turn(kds->shapes[1 - s->owner].polygon, s->vertex);
}

/// The end that is not the nearest vertex. O(log n), and O(1) for a segment.
static uint32_t other_end(const bmr_polygon *p, uint32_t vertex) {
    const uint32_t next = bmr_vertex_after(p, vertex);
    return p->count == 2 ? next : bmr_polygon_support_from(p, bmr_left(bmr_polygon_normal(p, vertex)), next);
}

/// Makes the line with this normal of the owner's frame; the nearest vertex is found from `hint`.
static separating_edge line_of(const bmr_kds *kds, const bmr_pose *b_in_a, int owner, bmr_vec2 normal,
                               uint32_t on_line, uint32_t hint) {
    separating_edge s = {.owner = owner};
    s.line.normal = normal;
    s.line.offset = bmr_dot(normal, kds->shapes[owner].polygon->vertices[on_line]);
    s.vertex = nearest_vertex(kds, b_in_a, owner, normal, hint);
    return s;
}

/// Where the polygons are: what a new edge is chosen by.
typedef struct situation {
    const bmr_pose *pose;
    uint32_t vertex[2]; ///< support vertices in the closest direction
    bmr_vec2 closest;
    double enough; ///< an edge must separate by more than this
} situation;

/// False: contact.
static bool find_situation(const bmr_kds *kds, const bmr_instant *now, situation *at) {
    const separating_edge *s = view(kds);
    at->pose = &now->pose;
    at->vertex[1 - s->owner] = s->vertex;
    at->vertex[s->owner] = s->edge;
    double distance;
    if (!bmr_kds_closest(kds, at->pose, &at->vertex[0], &at->vertex[1], &at->closest, &distance))
        return false;
    const double beyond = distance - kds->def.margin;
    at->enough = kds->def.margin + EDGE_PART * beyond;
    return beyond > CONTACT_ROUNDING * (kds->shapes[0].polygon->extent + kds->shapes[1].polygon->extent);
}

static void take_closest_line(bmr_kds *kds, const situation *at) {
    *state_of(kds) = line_of(kds, at->pose, 0, at->closest, at->vertex[0], at->vertex[1]);
}

static void take_edge(bmr_kds *kds, const situation *at, int owner, uint32_t edge) {
    separating_edge *s = state_of(kds);
    const bmr_vec2 n = bmr_polygon_normal(kds->shapes[owner].polygon, edge);
    *s = line_of(kds, at->pose, owner, n, edge, at->vertex[1 - owner]);
    s->is_edge = true;
    s->edge = edge;
}

/// The edge of largest slack is next to the closest direction in the order of all edges' directions, so that
/// it is one of the four at the two support vertices.
static void pick_best(bmr_kds *kds, const situation *at, unsigned *touched) {
    double most = at->enough;
    take_closest_line(kds, at);
    for (int owner = 0; owner < 2; owner++) {
        const bmr_polygon *p = kds->shapes[owner].polygon;
        for (int k = 0; k < 2 && p->count > 1; k++, ++*touched) {
            const uint32_t edge = k == 0 ? at->vertex[owner] : bmr_vertex_before(p, at->vertex[owner]);
            const double slack =
                bmr_kds_separation(kds, at->pose, in_a(owner, at->pose, bmr_polygon_normal(p, edge)));
            if (slack > most) {
                most = slack;
                take_edge(kds, at, owner, edge);
            }
        }
    }
}

/// From the edge that failed towards the closest direction, over both polygons' edges in the order of their
/// directions, to the first that separates.
static void walk_on(bmr_kds *kds, const situation *at, unsigned *touched) {
    const separating_edge from = *view(kds);
    const bmr_vec2 failed = in_a(from.owner, at->pose, from.line.normal);
    const int turn = bmr_cross(failed, at->closest) >= 0.0 ? 1 : -1;
    uint32_t vertex[2];
    vertex[from.owner] = turn > 0 ? bmr_vertex_after(kds->shapes[from.owner].polygon, from.edge) : from.edge;
    vertex[1 - from.owner] = from.vertex;
    const uint32_t most_steps = kds->shapes[0].polygon->count + kds->shapes[1].polygon->count;
    for (uint32_t k = 0; k < most_steps; k++, ++*touched) {
        int first = -1;
        uint32_t edge = 0;
        bmr_vec2 normal = failed;
        for (int body = 0; body < 2; body++) {
            const bmr_polygon *p = kds->shapes[body].polygon;
            const uint32_t i = turn > 0 ? vertex[body] : bmr_vertex_before(p, vertex[body]);
            const bmr_vec2 n = in_a(body, at->pose, bmr_polygon_normal(p, i));
            if (p->count > 1 && (first < 0 || turn * bmr_cross(n, normal) > 0.0)) {
                first = body;
                edge = i;
                normal = n;
            }
        }
        if (first < 0)
            break;
        const bmr_polygon *p = kds->shapes[first].polygon;
        vertex[first] = turn > 0 ? bmr_vertex_after(p, vertex[first]) : bmr_vertex_before(p, vertex[first]);
        if (bmr_kds_separation(kds, at->pose, normal) > at->enough) {
            take_edge(kds, at, first, edge);
            return;
        }
        if (turn * bmr_cross(at->closest, normal) > 0.0)
            break; // past the closest direction separation only falls
    }
    take_closest_line(kds, at);
}

static size_t conditions(const bmr_kds *kds, bmr_condition *c) {
    const separating_edge *s = view(kds);
    const bmr_polygon *other = kds->shapes[1 - s->owner].polygon;
    const bmr_vec2 n = s->line.normal;
    c[0] = bmr_condition_beyond(s->owner, n, s->line.offset + kds->def.margin, other->vertices[s->vertex],
                                BEYOND);
    if (other->count == 1)
        return 1;
    if (watches_ends(kds)) {
        c[1] = bmr_condition_beyond(s->owner, n, s->line.offset + kds->def.margin,
                                    other->vertices[other_end(other, s->vertex)], OTHER_END);
        return 2;
    }
    const bmr_vec2 before = bmr_polygon_normal(other, bmr_vertex_before(other, s->vertex)),
                   after = bmr_polygon_normal(other, s->vertex);
    c[1] = bmr_condition_turn(1 - s->owner, bmr_turned_slightly(before, -BMR_CONE_OVERLAP), bmr_neg(n),
                              BEFORE_CONE);
    c[2] = bmr_condition_turn(1 - s->owner, bmr_turned_slightly(after, BMR_CONE_OVERLAP), n, AFTER_CONE);
    return 3;
}

/// On which side the direction against the line is out of the vertex's cone; 0: on none.
static int side_outside(const bmr_kds *kds, const bmr_pose *b_in_a) {
    bmr_condition c[BMR_KDS_MAX_CONDITIONS];
    const size_t count = conditions(kds, c);
    for (size_t k = 1; k < count; k++)
        if (c[k].kind == BMR_CONDITION_TURN && bmr_features_outside(&c[k], b_in_a))
            return c[k].label;
    return 0;
}

/// The vertex follows the direction against the line, out of its cone on the side `label`.
static void roll(bmr_kds *kds, const bmr_pose *b_in_a, int label, unsigned *touched) {
    separating_edge *s = state_of(kds);
    const bmr_polygon *other = kds->shapes[1 - s->owner].polygon;
    const int way = label;
    for (int k = 0; k < ROLL_STEPS && label == way; k++, ++*touched) {
        s->vertex =
            way == AFTER_CONE ? bmr_vertex_after(other, s->vertex) : bmr_vertex_before(other, s->vertex);
        // Going on in the same direction only: back is where it came from.
        label = side_outside(kds, b_in_a);
    }
    if (label == way)
        s->vertex = nearest_vertex(kds, b_in_a, s->owner, s->line.normal, s->vertex);
}

/// A new line, or contact.
static bool choose(bmr_kds *kds, const bmr_instant *now, bool afresh, unsigned *touched) {
    situation at;
    if (!find_situation(kds, now, &at))
        return false;
    if (afresh || !view(kds)->is_edge)
        pick_best(kds, &at, touched);
    else
        walk_on(kds, &at, touched);
    // By the rounding of a distance the nearest vertex may be the one beside the right one.
    const int side = side_outside(kds, at.pose);
    if (side != 0)
        roll(kds, at.pose, side, touched);
    return true;
}

static bool start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    return choose(kds, now, true, &report->touched);
}

/// Is what is watched of the other body beyond the line by more than the margin?
static bool is_beyond(const bmr_kds *kds, const bmr_pose *b_in_a) {
    bmr_condition c[BMR_KDS_MAX_CONDITIONS];
    const size_t count = conditions(kds, c);
    for (size_t k = 0; k < count; k++)
        if (c[k].kind == BMR_CONDITION_BEYOND && !(bmr_condition_value(&c[k], b_in_a) > 0.0))
            return false;
    return true;
}

static bool repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    separating_edge *s = state_of(kds);
    bmr_condition c[BMR_KDS_MAX_CONDITIONS];
    const size_t count = conditions(kds, c);
    if (failed >= count || !bmr_features_failed(kds, &c[failed], now))
        return true;
    report->kind = BMR_KDS_FEATURE;
    const bool rolls = c[failed].kind == BMR_CONDITION_TURN;
    if (rolls)
        roll(kds, &now->pose, c[failed].label, &report->touched);
    else if (c[failed].label == OTHER_END)
        s->vertex = other_end(kds->shapes[1 - s->owner].polygon, s->vertex);
    if (rolls && is_beyond(kds, &now->pose))
        return true;
    const bmr_line before = s->line;
    const int owner = s->owner;
    const bool apart = choose(kds, now, false, &report->touched);
    report->line_changed = owner != s->owner || before.normal.x != s->line.normal.x ||
                           before.normal.y != s->line.normal.y || before.offset != s->line.offset;
    return apart;
}

static void proof(const bmr_kds *kds, bmr_kds_proof *proof) {
    const separating_edge *s = view(kds);
    proof->owner = s->owner;
    proof->line = s->line;
    proof->nearest = kds->shapes[1 - s->owner].polygon->vertices[s->vertex];
    proof->level = 0;
}

/// The line is the edge's, and the vertex is the nearest, or the other end is: brute force.
static bmr_error audit(const bmr_kds *kds, const bmr_pose *b_in_a) {
    const separating_edge *s = view(kds);
    const bmr_polygon *own = kds->shapes[s->owner].polygon, *other = kds->shapes[1 - s->owner].polygon;
    const double slop = 10.0 * bmr_features_overlap(kds);
    if (s->is_edge)
        for (uint32_t end = 0; end < 2; end++)
            if (fabs(bmr_dot(s->line.normal, own->vertices[(s->edge + end) % own->count]) - s->line.offset) >
                slop)
                return BMR_ERROR_INVALID_STRUCTURE;
    const bmr_pose other_in_own = s->owner == 0 ? *b_in_a : bmr_pose_inverse(b_in_a);
    const bmr_vec2 n = bmr_unrotate(&other_in_own, s->line.normal);
    double value = bmr_dot(n, other->vertices[s->vertex]);
    if (watches_ends(kds))
        value = fmin(value, bmr_dot(n, other->vertices[other_end(other, s->vertex)]));
    for (uint32_t i = 0; i < other->count; i++)
        if (bmr_dot(n, other->vertices[i]) < value - slop)
            return BMR_ERROR_INVALID_STRUCTURE;
    return BMR_OK;
}

static const bmr_kds_class implementation = {.state_bytes = sizeof(separating_edge),
                                             .start = start,
                                             .conditions = conditions,
                                             .repair = repair,
                                             .proof = proof,
                                             .audit = audit};

BMR_KDS_INFO(separating_edge_walk, .name = "separating-edge-walk",
             .title = "rival: separating edge, full resolution", .section = "5, introduction",
             .domain = BMR_KDS_RIGID, .role = BMR_KDS_RIVAL, .hierarchy = -1,
             .implementation = &implementation);
