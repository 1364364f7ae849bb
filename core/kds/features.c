// SPDX-License-Identifier: MIT
#include "kds/features.h"

#include <math.h>

#include "geometry/length.h"
#include "kds/registry.h"

/// Each Voronoi region is taken to be this much wider than it is, in parts of the extents: a few thousand
/// roundings, and far below any margin.
#define OVERLAP 1e-12
/// The sine of an angle between unit vectors that is larger than this is positive however it is computed; and
/// it is well within the overlap of two cones.
#define SINE_ROUNDING (0.25 * BMR_CONE_OVERLAP)
/// A vertex whose cone of normals is within this sine of half a turn is treated as a segment's end: a cone
/// that is widened on both sides must stay below half a turn, and its ends are rounded.
#define HALF_TURN_SINE (2.5 * BMR_CONE_OVERLAP)
/// Steps of a walk before it begins anew from the exact distance. A walk takes one step, two past a short
/// edge; only jumps take more.
#define WALK_STEPS 64
/// What the audit grants a distance, relatively: the line across two near points may be turned by the width
/// of the overlap.
#define AUDIT_TOLERANCE 1e-9

double bmr_features_overlap(const bmr_kds *kds) {
    return OVERLAP * (kds->shapes[0].polygon->extent + kds->shapes[1].polygon->extent);
}

/// How near to zero a condition's value counts as zero: a part of 1 where it is the sine of an angle, else
/// the same part of the lengths that it is computed from.
static double tolerance(const bmr_kds *kds, const bmr_condition *condition, const bmr_pose *pose) {
    const double extent = kds->shapes[0].polygon->extent + kds->shapes[1].polygon->extent;
    const bool angle = condition->kind == BMR_CONDITION_TURN;
    return BMR_FAILING_PART * (angle ? 1.0 : extent + bmr_length(pose->position));
}

bool bmr_features_failed(const bmr_kds *kds, const bmr_condition *condition, const bmr_instant *now) {
    return bmr_condition_fails(condition, now, tolerance(kds, condition, &now->pose));
}

bool bmr_features_violated(const bmr_kds *kds, const bmr_condition *condition, const bmr_instant *now) {
    const double value = bmr_condition_value(condition, &now->pose);
    return !(value > 0.0) && (!(value >= -tolerance(kds, condition, &now->pose)) ||
                              !(bmr_condition_rate(condition, now) > 0.0));
}

bool bmr_features_outside(const bmr_condition *condition, const bmr_pose *b_in_a) {
    const double least = condition->kind == BMR_CONDITION_TURN ? SINE_ROUNDING : 0.0;
    return !(bmr_condition_value(condition, b_in_a) > least);
}

bool bmr_cone_is_half_turn(const bmr_polygon *p, uint32_t i) {
    const bmr_vec2 before = bmr_polygon_normal(p, bmr_vertex_before(p, i)), after = bmr_polygon_normal(p, i);
    return p->count > 1 && bmr_dot(before, after) < 0.0 && bmr_cross(before, after) < HALF_TURN_SINE;
}

double bmr_cone_overlap(const bmr_polygon *p, uint32_t i) {
    return bmr_cone_is_half_turn(p, i) ? 0.0 : BMR_CONE_OVERLAP;
}

static bmr_vec2 unit(bmr_vec2 v) {
    const bmr_vec2 d = bmr_scale_up_if_tiny(v);
    return bmr_scale(1.0 / bmr_length(d), d);
}

/// The unit vector from vertex i to the one after (before) it.
static bmr_vec2 along(const bmr_polygon *p, uint32_t i, bool forward) {
    const uint32_t j = forward ? bmr_vertex_after(p, i) : bmr_vertex_before(p, i);
    return unit(bmr_sub(p->vertices[j], p->vertices[i]));
}

enum { DISTANCE, PAST_START, PAST_END, BEFORE_CONE, AFTER_CONE };

/// Labels of the four region conditions of two vertices: 1 + 2 * body + (forward ? 0 : 1).
static size_t vertex_conditions(const bmr_kds *kds, const bmr_feature_pair *pair, bmr_condition *c) {
    const double overlap = bmr_features_overlap(kds);
    const bmr_vec2 point[2] = {kds->shapes[0].polygon->vertices[pair->vertex[0]],
                               kds->shapes[1].polygon->vertices[pair->vertex[1]]};
    size_t count = 0;
    c[count++] = bmr_condition_disks(point[0], point[1], kds->def.margin, DISTANCE);
    for (int body = 0; body < 2; body++) {
        const bmr_polygon *p = kds->shapes[body].polygon;
        for (int backward = 0; backward < 2 && p->count > 1; backward++) {
            const bmr_vec2 n = bmr_neg(along(p, pair->vertex[body], !backward));
            c[count++] = bmr_condition_beyond(body, n, bmr_dot(n, point[body]) - overlap, point[1 - body],
                                              1 + 2 * body + backward);
        }
    }
    return count;
}

static size_t edge_conditions(const bmr_kds *kds, const bmr_feature_pair *pair, bmr_condition *c) {
    const double overlap = bmr_features_overlap(kds);
    const int owner = pair->edge_owner;
    const bmr_polygon *own = kds->shapes[owner].polygon, *other = kds->shapes[1 - owner].polygon;
    const uint32_t i = pair->vertex[owner], j = pair->vertex[1 - owner];
    const bmr_vec2 start = own->vertices[i], end = own->vertices[bmr_vertex_after(own, i)];
    const bmr_vec2 t = along(own, i, true), n = bmr_polygon_normal(own, i), point = other->vertices[j];
    size_t count = 0;
    c[count++] = bmr_condition_beyond(owner, n, bmr_dot(n, start) + kds->def.margin, point, DISTANCE);
    c[count++] = bmr_condition_beyond(owner, t, bmr_dot(t, start) - overlap, point, PAST_START);
    c[count++] = bmr_condition_beyond(owner, bmr_neg(t), -bmr_dot(t, end) - overlap, point, PAST_END);
    if (other->count > 1) { // the direction against the edge stays in the vertex's cone
        const bmr_vec2 before = bmr_polygon_normal(other, bmr_vertex_before(other, j)),
                       after = bmr_polygon_normal(other, j);
        const double widening = bmr_cone_overlap(other, j);
        c[count++] =
            bmr_condition_turn(1 - owner, bmr_turned_slightly(before, -widening), bmr_neg(n), BEFORE_CONE);
        c[count++] = bmr_condition_turn(1 - owner, bmr_turned_slightly(after, widening), n, AFTER_CONE);
    }
    return count;
}

size_t bmr_features_conditions(const bmr_kds *kds, const bmr_feature_pair *pair, bmr_condition *conditions) {
    if (pair->by_line)
        return bmr_windowed_conditions(&pair->line, kds->def.margin, conditions);
    return pair->edge_owner < 0 ? vertex_conditions(kds, pair, conditions)
                                : edge_conditions(kds, pair, conditions);
}

/// The other body's vertex, in the frame of `owner`.
static bmr_vec2 other_vertex(const bmr_kds *kds, const bmr_feature_pair *pair, int owner,
                             const bmr_pose *b_in_a) {
    const bmr_pose q = owner == 0 ? *b_in_a : bmr_pose_inverse(b_in_a);
    return bmr_transform(&q, kds->shapes[1 - owner].polygon->vertices[pair->vertex[1 - owner]]);
}

/// The closest features were two vertices, and one left the region of the other (`label` says whose, and on
/// which side): the edge on that side takes the place of the vertex.
static void step_to_edge(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_feature_pair *pair, int label) {
    const int body = (label - 1) / 2;
    const bmr_polygon *p = kds->shapes[body].polygon;
    const bool backward = (label - 1) % 2 != 0;
    uint32_t edge = backward ? bmr_vertex_before(p, pair->vertex[body]) : pair->vertex[body];
    if (p->count == 2) { // both ways lead to the other end: it is the side that counts
        const bmr_vec2 x = other_vertex(kds, pair, body, b_in_a);
        edge = bmr_dot(bmr_polygon_normal(p, 0), bmr_sub(x, p->vertices[0])) > 0.0 ? 0 : 1;
    }
    pair->vertex[body] = edge;
    pair->edge_owner = body;
}

/// The edge and an edge at the vertex have become parallel. The closest points now lie anywhere along the
/// two; from here on they are where the first of the two edges ends.
static void step_over_parallel(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_feature_pair *pair,
                               bool after) {
    const int owner = pair->edge_owner;
    const bmr_polygon *own = kds->shapes[owner].polygon, *other = kds->shapes[1 - owner].polygon;
    const uint32_t i = pair->vertex[owner], j = pair->vertex[1 - owner];
    const uint32_t next = after ? bmr_vertex_after(other, j) : bmr_vertex_before(other, j);
    bmr_feature_pair moved = *pair;
    moved.vertex[1 - owner] = next;
    const bmr_vec2 t = along(own, i, true), x = other_vertex(kds, &moved, owner, b_in_a);
    const bmr_vec2 start = own->vertices[i], end = own->vertices[bmr_vertex_after(own, i)];
    // Both run counter-clockwise, so that the other's forward is this edge's backward.
    const bool within = after ? bmr_dot(t, bmr_sub(x, start)) > 0.0 : bmr_dot(t, bmr_sub(x, end)) < 0.0;
    if (!within) {
        moved.edge_owner = 1 - owner;
        moved.vertex[1 - owner] = after ? j : next; // the edge between them
        moved.vertex[owner] = after ? i : bmr_vertex_after(own, i);
    }
    *pair = moved;
}

static void step(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_feature_pair *pair, int label) {
    const int owner = pair->edge_owner;
    if (owner < 0) {
        step_to_edge(kds, b_in_a, pair, label);
    } else if (label == PAST_START || label == PAST_END) {
        if (label == PAST_END)
            pair->vertex[owner] = bmr_vertex_after(kds->shapes[owner].polygon, pair->vertex[owner]);
        pair->edge_owner = -1;
    } else {
        step_over_parallel(kds, b_in_a, pair, label == AFTER_CONE);
    }
}

/// The condition that is violated most; -1: none. The regions come first: the distance means nothing before
/// they hold.
static int violated(const bmr_kds *kds, const bmr_feature_pair *pair, const bmr_instant *now) {
    bmr_condition c[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_features_conditions(kds, pair, c);
    double least = INFINITY;
    int worst = -1;
    for (size_t k = 1; k < count; k++) {
        const double value = bmr_condition_value(&c[k], &now->pose);
        if (value < least && bmr_features_outside(&c[k], &now->pose)) {
            least = value;
            worst = c[k].label;
        }
    }
    return worst >= 0 || !bmr_features_violated(kds, &c[0], now) ? worst : DISTANCE;
}

/// True: at the closest features. False: within the margin, or lost.
static bool walk(const bmr_kds *kds, const bmr_instant *now, bmr_feature_pair *pair, unsigned *touched) {
    for (int k = 0; k < WALK_STEPS; k++) {
        const int label = violated(kds, pair, now);
        if (label <= 0)
            return label < 0;
        step(kds, &now->pose, pair, label);
        ++*touched;
    }
    return false;
}

/// The closest direction, fixed in A. False: contact.
static bool take_line(const bmr_kds *kds, const bmr_instant *now, bmr_feature_pair *pair) {
    bmr_vec2 direction;
    double distance;
    if (!bmr_windowed_closest(kds, &now->pose, pair->vertex, &direction, &distance))
        return false;
    bmr_windowed_line_set(&pair->line, kds, &now->pose, 0, direction, pair->vertex);
    const int spin = (now->spin > 0.0) - (now->spin < 0.0);
    bmr_windowed_exact(&pair->line, kds, &now->pose, bmr_windowed_sense(0, spin));
    pair->by_line = true;
    return true;
}

bool bmr_features_start(const bmr_kds *kds, const bmr_instant *now, bmr_feature_pair *pair,
                        unsigned *touched) {
    bmr_vec2 direction;
    double distance;
    bmr_feature_pair found = {.vertex = {pair->vertex[0], pair->vertex[1]}, .edge_owner = -1};
    if (!bmr_kds_closest(kds, &now->pose, &found.vertex[0], &found.vertex[1], &direction, &distance))
        return false;
    ++*touched;
    // The support vertices in the direction of the closest points are these or an end of their edge.
    const bool found_them = walk(kds, now, &found, touched);
    *pair = found;
    // Of a polygon thinner than rounding the walk may end behind an edge: the distance knows better.
    return found_them || take_line(kds, now, pair);
}

bool bmr_features_repair(const bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_feature_pair *pair,
                         unsigned *touched) {
    bmr_condition c[BMR_KDS_MAX_CONDITIONS];
    bmr_features_conditions(kds, pair, c);
    if (pair->by_line || c[failed].label == DISTANCE)
        return bmr_features_start(kds, now, pair, touched);
    step(kds, &now->pose, pair, c[failed].label);
    ++*touched;
    return walk(kds, now, pair, touched) || bmr_features_start(kds, now, pair, touched);
}

/// Turns a unit direction into the cone of the vertex's normals where it is out of it by a rounding.
static bmr_vec2 into_cone(const bmr_polygon *p, uint32_t i, bmr_vec2 u) {
    if (p->count == 1)
        return u;
    const bmr_vec2 before = bmr_polygon_normal(p, bmr_vertex_before(p, i)), after = bmr_polygon_normal(p, i);
    if (bmr_cross(before, u) < 0.0 && bmr_dot(before, u) > 0.0)
        return before;
    if (bmr_cross(u, after) < 0.0 && bmr_dot(after, u) > 0.0)
        return after;
    return u;
}

void bmr_features_proof(const bmr_kds *kds, const bmr_feature_pair *pair, const bmr_pose *b_in_a,
                        bmr_kds_proof *proof) {
    if (pair->by_line) {
        bmr_windowed_proof(&pair->line, proof);
        return;
    }
    const bmr_polygon *a = kds->shapes[0].polygon, *b = kds->shapes[1].polygon;
    const int owner = pair->edge_owner < 0 ? 0 : pair->edge_owner;
    proof->owner = owner;
    proof->level = 0;
    proof->nearest = kds->shapes[1 - owner].polygon->vertices[pair->vertex[1 - owner]];
    const bmr_vec2 on_line = kds->shapes[owner].polygon->vertices[pair->vertex[owner]];
    if (pair->edge_owner >= 0) {
        proof->line.normal = bmr_polygon_normal(kds->shapes[owner].polygon, pair->vertex[owner]);
    } else {
        bmr_vec2 u = unit(bmr_sub(bmr_transform(b_in_a, b->vertices[pair->vertex[1]]), on_line));
        u = into_cone(a, pair->vertex[0], u);
        const bmr_vec2 back = into_cone(b, pair->vertex[1], bmr_neg(bmr_unrotate(b_in_a, u)));
        proof->line.normal = bmr_neg(bmr_rotate(b_in_a, back));
    }
    proof->line.offset = bmr_dot(proof->line.normal, on_line);
    if (pair->edge_owner <
        0) { // cones that miss one another by the overlap leave a neighbour before the line
        const bmr_vec2 next = a->vertices[bmr_vertex_after(a, pair->vertex[0])],
                       last = a->vertices[bmr_vertex_before(a, pair->vertex[0])];
        const double most = fmax(bmr_dot(proof->line.normal, next), bmr_dot(proof->line.normal, last));
        proof->line.offset = fmax(proof->line.offset, most);
    }
}

bmr_error bmr_features_audit(const bmr_kds *kds, const bmr_feature_pair *pair, const bmr_pose *b_in_a) {
    if (pair->by_line)
        return bmr_windowed_audit(&pair->line, kds, b_in_a);
    const int owner = pair->edge_owner < 0 ? 0 : pair->edge_owner;
    const bmr_polygon *own = kds->shapes[owner].polygon;
    const uint32_t i = pair->vertex[owner];
    const bmr_vec2 x = other_vertex(kds, pair, owner, b_in_a);
    const bmr_vec2 d = bmr_sub(x, own->vertices[i]);
    double distance = hypot(d.x, d.y);
    if (pair->edge_owner >= 0) {
        const bmr_vec2 t = along(own, i, true),
                       e = bmr_sub(own->vertices[bmr_vertex_after(own, i)], own->vertices[i]);
        const double part = fmin(fmax(bmr_dot(t, d), 0.0), hypot(e.x, e.y));
        distance = hypot(d.x - part * t.x, d.y - part * t.y);
    }
    // Two points that far apart, and two parallel lines that far apart: it is the distance.
    bmr_kds_proof proof;
    bmr_features_proof(kds, pair, b_in_a, &proof);
    double most, least;
    bmr_kds_extremes(kds, owner, b_in_a, proof.line.normal, &most, &least);
    const double slop = 10.0 * bmr_features_overlap(kds) + AUDIT_TOLERANCE * distance;
    return distance - (least - most) <= slop ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE;
}

// The rival that tracks the closest pair of features (Lin and Canny, Mirtich): Theta(n) events under
// translation and Theta(n^2) under rotation, however far the polygons are apart.

typedef struct closest_features {
    bmr_feature_pair pair;
    bmr_pose last; ///< of the last event, for the line that was proved there
} closest_features;

static closest_features *state_of(bmr_kds *kds) {
    return (closest_features *)(void *)kds->state;
}
static const closest_features *view(const bmr_kds *kds) {
    return (const closest_features *)(const void *)kds->state;
}

static bool start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    closest_features *s = state_of(kds);
    s->last = now->pose;
    return bmr_features_start(kds, now, &s->pair, &report->touched);
}

static size_t conditions(const bmr_kds *kds, bmr_condition *c) {
    return bmr_features_conditions(kds, &view(kds)->pair, c);
}

static bool repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    closest_features *s = state_of(kds);
    bmr_condition c[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_features_conditions(kds, &s->pair, c);
    if (failed >= count || !bmr_features_failed(kds, &c[failed], now))
        return true;
    s->last = now->pose;
    report->kind = BMR_KDS_FEATURE;
    report->line_changed = true;
    return bmr_features_repair(kds, now, failed, &s->pair, &report->touched);
}

static void proof_at(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_kds_proof *proof) {
    bmr_features_proof(kds, &view(kds)->pair, b_in_a, proof);
}

static bmr_error prepare(bmr_kds *kds) {
    kds->proof_at = proof_at;
    return BMR_OK;
}

static void proof(const bmr_kds *kds, bmr_kds_proof *proof) {
    proof_at(kds, &view(kds)->last, proof);
}

static bmr_error audit(const bmr_kds *kds, const bmr_pose *b_in_a) {
    return bmr_features_audit(kds, &view(kds)->pair, b_in_a);
}

static const bmr_kds_class implementation = {.state_bytes = sizeof(closest_features),
                                             .prepare = prepare,
                                             .start = start,
                                             .conditions = conditions,
                                             .repair = repair,
                                             .proof = proof,
                                             .audit = audit};

BMR_KDS_INFO(closest_features, .name = "closest-features", .title = "rival: closest pair of features",
             .section = "5, introduction", .domain = BMR_KDS_RIGID, .role = BMR_KDS_RIVAL, .hierarchy = -1,
             .implementation = &implementation);
