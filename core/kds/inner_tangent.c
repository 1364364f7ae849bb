// SPDX-License-Identifier: MIT
// The rival that keeps an inner common tangent: the line through a vertex of A and one of B that has A on its
// left and B on its right. Theta(n) events under translation, Theta(n^2) under rotation, however far the
// polygons are apart.
//
// A tangent alone proves no margin. So one body, the thick one, is taken with its edges moved out by the
// margin: the line then keeps the margin from it. Where the thick body is nearer to the other than a tangent
// can be found (at sharp corners that is up to margin / sin(angle/2)), the closest features serve until it is
// not.
#include <float.h>
#include <math.h>

#include "geometry/distance.h"
#include "kds/features.h"
#include "kds/registry.h"

/// The two points of tangency are at least this far apart, in parts of the extents. Through nearer points the
/// overlap of the conditions would let the tangent turn too far.
#define LEAST_LENGTH 1e-4
/// Moving the edges of the thick body out moves its corners out farther, the sharper they are: by no more
/// than this part of the extents. A body with a sharper corner cannot be the thick one.
#define MOST_MITRE 1e-2
/// What the sum of two unit normals may be off by. Each normal is off by five halves of an ulp (from the
/// edge, its length and the division), and the sum by another half.
#define SUM_ROUNDING (6.0 * DBL_EPSILON)
/// The most steps of the search for a tangent from nothing (Newton's iteration, which takes some five), and
/// of the walk from the last tangent.
#define SEARCH_STEPS 64
#define WALK_STEPS 64
/// The most steps by which the line of a proof is corrected: the overlap lets the held tangent be off by a
/// vertex.
#define POLISH_STEPS 8

/// Labels: 2 * body + (backward ? 1 : 0) for the vertices' sides, and the length.
enum { LENGTH = 4 };

typedef struct inner_tangent {
    uint32_t vertex[2];
    int thick; ///< body, or -1: neither will do
    bool by_features;
    bmr_feature_pair pair; ///< while by_features
    bmr_pose last;         ///< of the last event
} inner_tangent;

static inner_tangent *state_of(bmr_kds *kds) {
    return (inner_tangent *)(void *)kds->state;
}
static const inner_tangent *view(const bmr_kds *kds) {
    return (const inner_tangent *)(const void *)kds->state;
}

/// The sum of the normals of the edges at corner i.
static bmr_vec2 corner_normals(const bmr_polygon *p, uint32_t i) {
    return bmr_add(bmr_polygon_normal(p, bmr_vertex_before(p, i)), bmr_polygon_normal(p, i));
}

/// The corner i of the polygon with its edges moved out by the margin: along the sum s of their normals by
/// 2 margin / |s|. (That is margin / (1 + <m, n>) times s, where the digits of the denominator would be lost
/// at a sharp corner.)
static bmr_vec2 thick_corner(const bmr_polygon *p, uint32_t i, double margin) {
    const bmr_vec2 s = corner_normals(p, i);
    return bmr_add(p->vertices[i], bmr_scale(2.0 * margin / bmr_dot(s, s), s));
}

static bmr_vec2 tangent_point(const bmr_kds *kds, int body, uint32_t i) {
    const bmr_polygon *p = kds->shapes[body].polygon;
    return view(kds)->thick == body ? thick_corner(p, i, kds->def.margin) : p->vertices[i];
}

static double extents(const bmr_kds *kds) {
    return kds->shapes[0].polygon->extent + kds->shapes[1].polygon->extent;
}

/// Can the body be the thick one? All its corners must be blunt enough, and rounding must move them by less
/// than the conditions overlap. (The sum of two normals that are opposite up to rounding is nothing but
/// rounding.)
static bool can_be_thick(const bmr_kds *kds, int body) {
    const bmr_polygon *p = kds->shapes[body].polygon;
    for (uint32_t i = 0; i < p->count && p->count > 2; i++) {
        const bmr_vec2 s = corner_normals(p, i);
        const double sum = hypot(s.x, s.y), mitre = 2.0 * kds->def.margin / sum;
        if (!(mitre <= MOST_MITRE * extents(kds) && mitre * SUM_ROUNDING <= bmr_features_overlap(kds) * sum))
            return false;
    }
    return p->count > 2;
}

static size_t tangent_conditions(const bmr_kds *kds, const uint32_t vertex[2], double overlap,
                                 bmr_condition *c) {
    const bmr_vec2 point[2] = {tangent_point(kds, 0, vertex[0]), tangent_point(kds, 1, vertex[1])};
    size_t count = 0;
    for (int body = 0; body < 2; body++) {
        const bmr_polygon *p = kds->shapes[body].polygon;
        if (p->count == 1)
            continue;
        // The other's point is beyond the edge that leaves the vertex and behind the one that comes to it.
        const bmr_vec2 n = bmr_polygon_normal(p, vertex[body]),
                       m = bmr_neg(bmr_polygon_normal(p, bmr_vertex_before(p, vertex[body])));
        c[count++] =
            bmr_condition_beyond(body, n, bmr_dot(n, point[body]) - overlap, point[1 - body], 2 * body);
        c[count++] =
            bmr_condition_beyond(body, m, bmr_dot(m, point[body]) - overlap, point[1 - body], 2 * body + 1);
    }
    c[count++] = bmr_condition_disks(point[0], point[1], LEAST_LENGTH * extents(kds), LENGTH);
    return count;
}

static size_t conditions(const bmr_kds *kds, bmr_condition *c) {
    const inner_tangent *s = view(kds);
    return s->by_features ? bmr_features_conditions(kds, &s->pair, c)
                          : tangent_conditions(kds, s->vertex, bmr_features_overlap(kds), c);
}

static void step(const bmr_kds *kds, uint32_t vertex[2], int label) {
    const int body = label / 2;
    const bmr_polygon *p = kds->shapes[body].polygon;
    vertex[body] = label % 2 == 0 ? bmr_vertex_after(p, vertex[body]) : bmr_vertex_before(p, vertex[body]);
}

/// The side whose condition is violated by the most; -1: none is. `touching`: a condition at zero counts as
/// violated, too.
static int worst_side(const bmr_condition *c, size_t count, const bmr_pose *b_in_a, bool touching,
                      double *value) {
    int worst = -1;
    *value = 0.0;
    for (size_t i = 0; i + 1 < count; i++) {
        const double here = bmr_condition_value(&c[i], b_in_a);
        if (worst >= 0 && here >= *value)
            continue;
        if (touching ? bmr_features_outside(&c[i], b_in_a) : here < 0.0) {
            *value = here;
            worst = c[i].label;
        }
    }
    return worst;
}

/// Steps until no side is violated. True: none is, and the two points of tangency are far enough apart.
static bool walk(const bmr_kds *kds, const bmr_instant *now, uint32_t vertex[2], unsigned *touched) {
    for (int k = 0; k <= WALK_STEPS; k++, ++*touched) {
        bmr_condition c[BMR_KDS_MAX_CONDITIONS];
        const size_t count = tangent_conditions(kds, vertex, bmr_features_overlap(kds), c);
        double value;
        const int side = worst_side(c, count, &now->pose, true, &value);
        if (side < 0)
            return !bmr_features_violated(kds, &c[count - 1], now);
        step(kds, vertex, side);
    }
    return false;
}

/// Steps by the conditions without their overlap, as long as that makes the worst violation smaller. Returns
/// the side that stays violated, or -1. (One does where a corner meets the inside of a thick edge: there is
/// no tangent any more.)
static int polish(const bmr_kds *kds, const bmr_pose *b_in_a, uint32_t vertex[2]) {
    double before = -INFINITY;
    int last = -1;
    uint32_t next[2] = {vertex[0], vertex[1]};
    for (int k = 0; k < POLISH_STEPS; k++) {
        bmr_kds_tally(kds, 1);
        bmr_condition c[BMR_KDS_MAX_CONDITIONS];
        const size_t count = tangent_conditions(kds, next, 0.0, c);
        double value;
        const int side = worst_side(c, count, b_in_a, false, &value);
        if (side >= 0 && value <= before)
            return last;
        vertex[0] = next[0];
        vertex[1] = next[1];
        last = side;
        if (side < 0)
            return side;
        before = value;
        step(kds, next, side);
    }
    return last;
}

static bmr_vec2 across(const bmr_kds *kds, const bmr_pose *b_in_a, const uint32_t vertex[2]) {
    return bmr_sub(bmr_transform(b_in_a, tangent_point(kds, 1, vertex[1])), tangent_point(kds, 0, vertex[0]));
}

/// From a separating direction, clockwise to the end of all separating directions: the separation along y is
/// concave in y, and Newton's iteration on its support pairs comes to the end from beyond. False: the thick
/// body leaves no room.
static bool find_tangent(const bmr_kds *kds, const bmr_instant *now, uint32_t vertex[2], unsigned *touched) {
    const bmr_pose *b_in_a = &now->pose;
    for (int k = 0; k < SEARCH_STEPS; k++) {
        const bmr_vec2 d = across(kds, b_in_a, vertex), n = {d.y, -d.x};
        const uint32_t i = bmr_support_from_counted(kds->shapes[0].polygon, n, vertex[0], touched);
        const uint32_t j = bmr_support_from_counted(kds->shapes[1].polygon, bmr_neg(bmr_unrotate(b_in_a, n)),
                                                    vertex[1], touched);
        ++*touched;
        if (i == vertex[0] && j == vertex[1])
            break;
        vertex[0] = i;
        vertex[1] = j;
    }
    return walk(kds, now, vertex, touched);
}

/// A tangent from nothing, or the closest features where only those fit.
static bool start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    inner_tangent *s = state_of(kds);
    bmr_vec2 u;
    double distance;
    uint32_t vertex[2] = {s->vertex[0], s->vertex[1]};
    s->last = now->pose;
    if (!bmr_kds_closest(kds, &now->pose, &vertex[0], &vertex[1], &u, &distance))
        return false;
    ++report->touched;
    const bool fits = s->thick >= 0 && bmr_dot(u, across(kds, &now->pose, vertex)) > 0.0;
    s->by_features = !fits || !find_tangent(kds, now, vertex, &report->touched);
    if (s->by_features)
        return bmr_features_start(kds, now, &s->pair, &report->touched);
    s->vertex[0] = vertex[0];
    s->vertex[1] = vertex[1];
    return true;
}

static bool repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    inner_tangent *s = state_of(kds);
    bmr_condition c[BMR_KDS_MAX_CONDITIONS];
    const size_t count = conditions(kds, c);
    if (failed >= count || !bmr_features_failed(kds, &c[failed], now))
        return true;
    report->kind = BMR_KDS_FEATURE;
    report->line_changed = true;
    s->last = now->pose;
    if (s->by_features) {
        if (!bmr_features_repair(kds, now, failed, &s->pair, &report->touched))
            return false;
        return s->thick < 0 || start(kds, now, report);
    }
    if (c[failed].label == LENGTH)
        return start(kds, now, report);
    step(kds, s->vertex, c[failed].label);
    ++report->touched;
    return walk(kds, now, s->vertex, &report->touched) || start(kds, now, report);
}

static bmr_vec2 across_normal(const bmr_kds *kds, const bmr_pose *b_in_a, const uint32_t vertex[2]) {
    const bmr_vec2 d = across(kds, b_in_a, vertex);
    const double length = hypot(d.x, d.y);
    return bmr_vec2_make(d.y / length, -d.x / length);
}

/// Of the edge on that side, from A to B.
static bmr_vec2 edge_normal(const bmr_kds *kds, const bmr_pose *b_in_a, const uint32_t vertex[2], int side) {
    const bmr_polygon *p = kds->shapes[side / 2].polygon;
    const uint32_t i = vertex[side / 2];
    const bmr_vec2 n = bmr_polygon_normal(p, side % 2 == 0 ? i : bmr_vertex_before(p, i));
    return side < 2 ? n : bmr_neg(bmr_rotate(b_in_a, n));
}

/// The line of the tangent that the state stands for up to its overlap, moved to the side of the thick body
/// so that A is behind it and B the margin beyond.
static void proof_at(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_kds_proof *proof) {
    const inner_tangent *s = view(kds);
    if (s->by_features) {
        bmr_features_proof(kds, &s->pair, b_in_a, proof);
        return;
    }
    uint32_t vertex[2] = {s->vertex[0], s->vertex[1]};
    const int side = polish(kds, b_in_a, vertex);
    proof->owner = 0;
    proof->level = 0;
    proof->line.normal =
        side < 0 ? across_normal(kds, b_in_a, vertex) : edge_normal(kds, b_in_a, vertex, side);
    proof->line.offset = bmr_dot(proof->line.normal, tangent_point(kds, 0, vertex[0]));
    if (s->thick == 0)
        proof->line.offset -= kds->def.margin;
    proof->nearest = kds->shapes[1].polygon->vertices[vertex[1]];
}

static bmr_error prepare(bmr_kds *kds) {
    state_of(kds)->thick = can_be_thick(kds, 0) ? 0 : can_be_thick(kds, 1) ? 1 : -1;
    kds->proof_at = proof_at;
    return BMR_OK;
}

static void proof(const bmr_kds *kds, bmr_kds_proof *proof) {
    proof_at(kds, &view(kds)->last, proof);
}

/// The line touches both bodies, the thick one up to its mitre: brute force.
static bmr_error audit(const bmr_kds *kds, const bmr_pose *b_in_a) {
    const inner_tangent *s = view(kds);
    if (s->by_features)
        return bmr_features_audit(kds, &s->pair, b_in_a);
    bmr_kds_proof line;
    proof_at(kds, b_in_a, &line);
    double most, least;
    bmr_kds_extremes(kds, 0, b_in_a, line.line.normal, &most, &least);
    const double mitre = MOST_MITRE * extents(kds), slop = 1e3 * bmr_features_overlap(kds);
    const double gap_a = line.line.offset - most, gap_b = least - line.line.offset - kds->def.margin;
    const bool touches = s->thick == 0 ? gap_a <= mitre && gap_b <= slop : gap_a <= slop && gap_b <= mitre;
    return touches ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE;
}

static const bmr_kds_class implementation = {.state_bytes = sizeof(inner_tangent),
                                             .prepare = prepare,
                                             .start = start,
                                             .conditions = conditions,
                                             .repair = repair,
                                             .proof = proof,
                                             .audit = audit};

BMR_KDS_INFO(inner_tangent, .name = "inner-tangent", .title = "rival: inner common tangent",
             .section = "5, introduction", .domain = BMR_KDS_RIGID, .role = BMR_KDS_RIVAL, .hierarchy = -1,
             .implementation = &implementation);
