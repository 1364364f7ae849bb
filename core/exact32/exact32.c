// SPDX-License-Identifier: MIT
#include "exact32/clip.h"

// Regrouping any formula breaks the contract of the header. Box2D's minimum over vertices starts at FLT_MAX
// and replaces on "less", so a NaN never enters it; every form here keeps to that.

// The largest edge separation, lanes over edges.
//
// A search that starts from last step's winner was measured: its separation first, then vertex after vertex
// until each other edge has one below it, which gives the same winner. In lanes it costs more than it saves:
// four edges come for the price of one, and the winner's own separation takes as long as two vertices do for
// all. Instructions of bmr_exact32_collide, in all: pyramid +17 %, vertical stack +17 %, piled coins +8 %,
// gears +28 %; used for five edges and more alone, coins +5 %, gears +12 %.

/// Normals and first vertices of four edges, posed.
typedef struct four_edges {
    float4 nx, ny, vx, vy;
} four_edges;

/// Edges past `count` (of the group's four, and more) come out as zeros.
static inline four_edges pose_edges(const bmr_vec32 *normals, const bmr_vec32 *vertices, int32_t count,
                                    float4 frame) {
    quad n = load_four(normals), v = load_four(vertices);
    if (count < 4) {
        const mask4 mask = first_lanes4(count, 0);
        n.x = keep4(mask, n.x);
        n.y = keep4(mask, n.y);
        v.x = keep4(mask, v.x);
        v.y = keep4(mask, v.y);
    }
    const float4 s = splat4(frame, 2), c = splat4(frame, 3);
    four_edges e;
    e.nx = sub4(mul4(c, n.x), mul4(s, n.y));
    e.ny = add4(mul4(s, n.x), mul4(c, n.y));
    e.vx = add4(sub4(mul4(c, v.x), mul4(s, v.y)), splat4(frame, 0));
    e.vy = add4(add4(mul4(s, v.x), mul4(c, v.y)), splat4(frame, 1));
    return e;
}

/// The smaller of `least` and the separations of one point; a NaN gives `least` back.
static inline float4 lower_by(float4 least, const four_edges *e, float4 x, float4 y) {
    return min4(add4(mul4(e->nx, sub4(x, e->vx)), mul4(e->ny, sub4(y, e->vy))), least);
}

/// Separations of four edges from all points of `other`, two points at a time. Where the count is odd, one is
/// done twice, which changes no minimum.
static inline float4 separate_four(const four_edges *e, const bmr_polygon32 *other) {
    float4 least = all4(FLT_MAX);
    if (other->count < 2) {
        const bmr_vec32 point = other->vertices[0];
        return lower_by(least, e, all4(point.x), all4(point.y));
    }
    const int32_t last = other->count - 2;
    for (int32_t j = 0;; j = j + 2 < last ? j + 2 : last) {
        const float4 two = load4(&other->vertices[j].x);
        least = lower_by(least, e, splat4(two, 0), splat4(two, 1));
        least = lower_by(least, e, splat4(two, 2), splat4(two, 3));
        if (j >= last)
            return least;
    }
}

typedef struct max_edge {
    float separation;
    int32_t edge;
} max_edge;

static inline float4 only_below(int32_t count, float4 separations) {
    return count < 4 ? select4(first_lanes4(count, 0), separations, all4(-FLT_MAX)) : separations;
}

/// Of all edges; -FLT_MAX past the count.
typedef struct separations {
    float4 low, high;
} separations;

/// `frame` as bmr_exact32_max_separation's, in a register.
static inline separations separate_all(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                       float4 frame) {
    const int32_t count = reference->count;
    const four_edges low = pose_edges(reference->normals, reference->vertices, count, frame);
    separations s = {only_below(count, separate_four(&low, other)), all4(-FLT_MAX)};
    if (count > 4) {
        const four_edges high = pose_edges(reference->normals + 4, reference->vertices + 4, count - 4, frame);
        s.high = only_below(count - 4, separate_four(&high, other));
    }
    return s;
}

/// The largest separation and the first edge that has it, as a plain loop from -FLT_MAX on would find them.
static inline max_edge largest_of(const separations *s) {
    max_edge found;
    found.separation = most_of4(max4(s->low, s->high));
    const float4 all = all4(found.separation);
    const unsigned hits = bits4(equal4(s->low, all)) | bits4(equal4(s->high, all)) << 4;
    found.edge = lowest_bit(hits);
    if (!(found.separation > -FLT_MAX)) { // nothing beats what the loop began with
        found.separation = -FLT_MAX;
        found.edge = 0;
    }
    return found;
}

static inline max_edge find_max_edge(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                     float4 frame) {
    const separations s = separate_all(reference, other, frame);
    return largest_of(&s);
}

bmr_transform32 bmr_exact32_relative(const bmr_transform32 *other, const bmr_transform32 *reference) {
    bmr_transform32 r;
    r.s = other->c * reference->s - other->s * reference->c;
    r.c = other->c * reference->c + other->s * reference->s;
    r.p = move_back(other, reference->p);
    return r;
}

float bmr_exact32_edge_separation(const bmr_polygon32 *reference, int32_t edge, const bmr_polygon32 *other,
                                  const bmr_transform32 *frame) {
    const bmr_vec32 n = turn(frame, reference->normals[edge]);
    const bmr_vec32 v = move(frame, reference->vertices[edge]);
    float least = FLT_MAX;
    for (int32_t j = 0; j < other->count; ++j) {
        const float s = n.x * (other->vertices[j].x - v.x) + n.y * (other->vertices[j].y - v.y);
        if (s < least)
            least = s;
    }
    return least;
}

/// The first four points' minimum into `least`, lanes past `count` left out.
static inline float4 lower(float4 least, const bmr_vec32 *points, int32_t count, float4 nx, float4 ny,
                           float4 vx, float4 vy) {
    if (count >= 4) { // no lane to leave out: the common case of boxes and octagons
        const quad q = load_four(points);
        const float4 s = add4(mul4(nx, sub4(q.x, vx)), mul4(ny, sub4(q.y, vy)));
        return min4(s, least);
    }
    const mask4 mask = first_lanes4(count, 0);
    const quad q = load_quad(points, mask);
    const float4 s = add4(mul4(nx, sub4(q.x, vx)), mul4(ny, sub4(q.y, vy)));
    return min4(select4(mask, s, all4(FLT_MAX)), least);
}

/// One edge in the frame of the other polygon: each line is two or four of the scalar formulas side by side.
typedef struct posed_edge {
    float4 d; ///< dx, dy, s, c of what the frame is made of
    float4 a; ///< normal and vertex in their own frame
    float4 n; ///< the normal, and the vertex before it is moved
    float4 v; ///< (unused, unused), vertex
    float4 at_other;
} posed_edge;

static inline posed_edge pose_edge(const bmr_vec32 *vertex, const bmr_vec32 *normal,
                                   const bmr_transform32 *reference, const bmr_transform32 *other) {
    posed_edge e;
    e.at_other = load4(&other->p.x);
    const float4 at_reference = load4(&reference->p.x);
    e.d = low_high4(sub4(at_reference, e.at_other), at_reference);
    const float4 f = relative_of(e.at_other, e.d); // px, py, s, c
    e.a = load_pairs4(&normal->x, &vertex->x);
    e.n = add4(mul4(splat4(f, 3), e.a), mul4(splat4(f, 2), quarter_left(e.a)));
    e.v = add4(e.n, lows4(f, f));
    return e;
}

static inline float least_separation(const posed_edge *e, const bmr_vec32 *points, int32_t count) {
    const float4 nx = splat4(e->n, 0), ny = splat4(e->n, 1), vx = splat4(e->v, 2), vy = splat4(e->v, 3);
    float4 least = lower(all4(FLT_MAX), points, count, nx, ny, vx, vy);
    if (count > 4)
        least = lower(least, points + 4, count - 4, nx, ny, vx, vy);
    return least_of4(least);
}

float bmr_exact32_posed_separation(const bmr_vec32 *vertex, const bmr_vec32 *normal,
                                   const bmr_transform32 *reference, const bmr_vec32 *points, int32_t count,
                                   const bmr_transform32 *other) {
    const posed_edge e = pose_edge(vertex, normal, reference, other);
    return least_separation(&e, points, count);
}

float bmr_exact32_max_separation(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                                 const bmr_transform32 *frame, int32_t *edge) {
    const max_edge found = find_max_edge(reference, other, load4(&frame->p.x));
    *edge = found.edge;
    return found.separation;
}

/// The edge of `incident` that faces `normal` (in its own frame, in both halves) most: the first of the least
/// products.
static inline int32_t find_incident_edge(const bmr_polygon32 *incident, float4 normal) {
    const float4 none = all4(FLT_MAX), x = splat4(normal, 0), y = splat4(normal, 1);
    const int32_t count = incident->count;
    float4 least[2] = {none, none};
    for (int32_t group = 0; 4 * group < count; ++group) {
        const int32_t left = count - 4 * group;
        const mask4 mask = first_lanes4(left < 4 ? left : 4, 0);
        const quad n = load_quad(incident->normals + 4 * group, mask);
        const float4 d = add4(mul4(x, n.x), mul4(y, n.y));
        least[group] = min4(select4(mask, d, none), none); // a NaN becomes "none"
    }
    const float4 all = all4(least_of4(min4(least[0], least[1])));
    // Where nothing is less than FLT_MAX, all lanes hit, and the first is what stays.
    const unsigned hits = bits4(equal4(least[0], all)) | bits4(equal4(least[1], all)) << 4;
    return lowest_bit(hits);
}

/// The part of the manifold that hangs on which polygon is the reference.
static inline void make_points(bmr_manifold32 *manifold, const bmr_polygon32 *reference, float4 pose,
                               int32_t edge, const bmr_polygon32 *incident, float4 incident_pose,
                               float radius_sum, bool reference_is_b) {
    manifold->type = reference_is_b ? BMR_MANIFOLD_FACE_B : BMR_MANIFOLD_FACE_A;

    const bmr_vec32 *const face = reference->normals + edge;
    const int32_t second = edge + 1 < reference->count ? edge + 1 : 0;
    const int32_t found =
        find_incident_edge(incident, turn_back_two(incident_pose, turn_two(pose, load_two(face, face))));
    const int32_t next = found + 1 < incident->count ? found + 1 : 0;

    const edge_ends face_ends = {reference->vertices + edge, reference->vertices + second, edge, second};
    const edge_ends facing_ends = {incident->vertices + found, incident->vertices + next, found, next};
    clip_edges(manifold, face_ends, pose, facing_ends, incident_pose, radius_sum, reference_is_b);
}

int32_t bmr_exact32_collide(bmr_manifold32 *manifold, const bmr_polygon32 *a, const bmr_transform32 *pose_a,
                            const bmr_polygon32 *b, const bmr_transform32 *pose_b, float radius_sum,
                            float tolerance) {
    manifold->count = 0;
    const float4 at_a = load4(&pose_a->p.x), at_b = load4(&pose_b->p.x);
    const max_edge of_a = find_max_edge(a, b, relative(at_b, at_a));
    if (of_a.separation > radius_sum)
        return of_a.edge;
    const max_edge of_b = find_max_edge(b, a, relative(at_a, at_b));
    if (of_b.separation > radius_sum)
        return BMR_EDGES_OF_B32 + of_b.edge;
    if (of_b.separation > of_a.separation + tolerance)
        make_points(manifold, b, at_b, of_b.edge, a, at_a, radius_sum, true);
    else
        make_points(manifold, a, at_a, of_a.edge, b, at_b, radius_sum, false);
    return BMR_NO_EDGE32;
}
