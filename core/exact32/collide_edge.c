// SPDX-License-Identifier: MIT
#include "exact32/clip.h"

/// A polygon in the edge's frame, four at a time.
typedef struct posed_polygon {
    quad vertices[2], normals[2];
    mask4 inside[2];
    int groups;
} posed_polygon;

static inline quad turn_four(const bmr_vec32 *vectors, mask4 inside, const bmr_transform32 *frame) {
    const float4 c = all4(frame->c), s = all4(frame->s);
    const quad v = load_quad(vectors, inside);
    const quad turned = {sub4(mul4(c, v.x), mul4(s, v.y)), add4(mul4(s, v.x), mul4(c, v.y))};
    return turned;
}

static inline void pose_vertices(posed_polygon *p, const bmr_polygon32 *polygon,
                                 const bmr_transform32 *frame) {
    p->groups = polygon->count > 4 ? 2 : 1;
    for (int g = 0; g < p->groups; ++g) {
        p->inside[g] = first_lanes4(polygon->count, g);
        p->vertices[g] = turn_four(polygon->vertices + 4 * g, p->inside[g], frame);
        p->vertices[g].x = add4(p->vertices[g].x, all4(frame->p.x));
        p->vertices[g].y = add4(p->vertices[g].y, all4(frame->p.y));
    }
}

static inline void pose_normals(posed_polygon *p, const bmr_polygon32 *polygon,
                                const bmr_transform32 *frame) {
    for (int g = 0; g < p->groups; ++g)
        p->normals[g] = turn_four(polygon->normals + 4 * g, p->inside[g], frame);
}

/// Four products of a vector with the way from a point to a vertex.
static inline float4 products(float4 x, float4 y, const quad *vertices, bmr_vec32 from) {
    return add4(mul4(x, sub4(vertices->x, all4(from.x))), mul4(y, sub4(vertices->y, all4(from.y))));
}

/// Least of the lanes inside, and the first lane that has it.
static inline float least_inside(const posed_polygon *p, const float4 of[2], int32_t *index) {
    const float4 none = all4(FLT_MAX);
    const float4 low = select4(p->inside[0], of[0], none),
                 high = p->groups > 1 ? select4(p->inside[1], of[1], none) : none;
    const float least = least_of4(min4(low, high));
    const float4 all = all4(least);
    *index = lowest_bit(bits4(equal4(low, all)) | bits4(equal4(high, all)) << 4 | 0x100u);
    return least;
}

/// A direction and how far it separates the two.
typedef struct axis {
    bmr_vec32 normal;
    float separation;
    int32_t face; ///< of the polygon; BMR_NO_EDGE32: the edge's own
} axis;

/// Along the edge's normal, or against it where that is more. False where a number is none, or is too large.
static inline bool separate_edge(const posed_polygon *p, bmr_vec32 first, bmr_vec32 normal, axis *best) {
    float4 before[2], behind[2];
    for (int g = 0; g < p->groups; ++g) {
        before[g] = products(all4(normal.x), all4(normal.y), &p->vertices[g], first);
        behind[g] = sub4(zero4(), before[g]);
        if (any4(unordered4(before[g], before[g])))
            return false;
    }
    int32_t any;
    const float one = least_inside(p, before, &any), other = least_inside(p, behind, &any);
    const bmr_vec32 opposite = {-normal.x, -normal.y};
    best->normal = other > one ? opposite : normal;
    best->separation = other > one ? other : one;
    best->face = BMR_NO_EDGE32;
    return best->separation > -FLT_MAX;
}

/// The first of the polygon's faces that are farthest from both ends of the edge.
static inline bool separate_faces(const posed_polygon *p, const bmr_edge32 *edge, axis *best) {
    float4 behind[2]; // how far the ends lie behind the faces: the larger one
    for (int g = 0; g < p->groups; ++g) {
        const quad *const n = &p->normals[g];
        // Of a normal that is infinite Box2D's loops and `facing` do not find the same face.
        if (any4(unordered4(sub4(n->x, n->x), sub4(n->y, n->y))))
            return false;
        const float4 first = products(n->x, n->y, &p->vertices[g], edge->first),
                     second = products(n->x, n->y, &p->vertices[g], edge->second);
        if (any4(unordered4(first, second)))
            return false;
        behind[g] = max4(first, second);
    }
    best->separation = -least_inside(p, behind, &best->face);
    return best->separation > -FLT_MAX && best->face < 8;
}

/// A one-sided edge leaves to its neighbours what lies in their directions: false where the axis does. At a
/// corner that is not convex it keeps its own axis.
static inline bool admits(const bmr_edge32 *edge, bmr_vec32 along, const axis *own, axis *primary) {
    static const float tolerance = 0.1f;
    if (dot(primary->normal, along) <= 0.0f) {
        const bmr_vec32 before = direction(minus(edge->first, edge->before));
        if (cross(before, along) >= 0.0f)
            return !(cross(primary->normal, quarter_right(before)) > tolerance);
    } else {
        const bmr_vec32 after = direction(minus(edge->after, edge->second));
        if (cross(along, after) >= 0.0f)
            return !(cross(quarter_right(after), primary->normal) > tolerance);
    }
    *primary = *own;
    return true;
}

static inline bmr_vec32 lane_of(const quad *four, int32_t lane) {
    float x[4], y[4];
    store4(x, four->x);
    store4(y, four->y);
    const bmr_vec32 v = {x[lane], y[lane]};
    return v;
}
static inline bmr_vec32 vertex_at(const posed_polygon *p, int32_t i) {
    return lane_of(&p->vertices[i >> 2], i & 3);
}
static inline bmr_vec32 normal_at(const posed_polygon *p, int32_t i) {
    return lane_of(&p->normals[i >> 2], i & 3);
}

/// The face that looks against the normal most, the first of equals.
static inline int32_t facing(const posed_polygon *p, bmr_vec32 normal) {
    float4 along[2];
    for (int g = 0; g < p->groups; ++g)
        along[g] = add4(mul4(all4(normal.x), p->normals[g].x), mul4(all4(normal.y), p->normals[g].y));
    int32_t found;
    least_inside(p, along, &found);
    return found;
}

/// What corners are cut and measured by, in the edge's frame: a face, and the direction to the side of its
/// first end.
typedef struct reference {
    bmr_vec32 first, second, normal, side;
    int32_t index, next; ///< of the ends
} reference;

/// The two corners behind both sides; false where less is left.
static inline bool cut_sides(clip_corner corners[2], const reference *r) {
    const bmr_vec32 other = {-r->side.x, -r->side.y};
    return cut(corners, r->side, dot(r->side, r->first), r->index) &&
           cut(corners, other, dot(other, r->second), r->next);
}

static inline bool is_within(const clip_corner *c, const reference *r, float radius_sum) {
    return dot(r->normal, minus(c->v, r->first)) <= radius_sum;
}

/// False where no face looks against the normal as far as floats can tell.
static inline bool clip_polygon(bmr_manifold32 *manifold, const bmr_edge32 *edge, bmr_vec32 along,
                                bmr_vec32 normal, const posed_polygon *p, int32_t count,
                                const bmr_transform32 *frame, float radius_sum) {
    const int32_t found = facing(p, normal), next = found + 1 < count ? found + 1 : 0;
    if (found >= count)
        return false;
    clip_corner corners[2] = {corner_of(vertex_at(p, found), found, 0),
                              corner_of(vertex_at(p, next), next, 0)};
    const reference r = {edge->first, edge->second, normal, {-along.x, -along.y}, 0, 1};
    manifold->type = BMR_MANIFOLD_FACE_A;
    if (!cut_sides(corners, &r))
        return true;
    manifold->normal = normal;
    manifold->plane_point = edge->first;
    for (int i = 0; i < 2; ++i)
        if (is_within(&corners[i], &r, radius_sum))
            keep(manifold, move_back(frame, corners[i].v), corners[i].feature, false);
    return true;
}

static inline void clip_edge(bmr_manifold32 *manifold, const bmr_edge32 *edge, int32_t face,
                             const posed_polygon *p, const bmr_polygon32 *polygon, float radius_sum) {
    const int32_t next = face + 1 < polygon->count ? face + 1 : 0;
    const bmr_feature32 of_second = {1, (uint8_t)face, BMR_FEATURE_VERTEX, BMR_FEATURE_FACE},
                        of_first = {0, (uint8_t)face, BMR_FEATURE_VERTEX, BMR_FEATURE_FACE};
    clip_corner corners[2] = {{edge->second, of_second}, {edge->first, of_first}};
    const bmr_vec32 normal = normal_at(p, face);
    const reference r = {vertex_at(p, face), vertex_at(p, next), normal, quarter_right(normal), face, next};
    manifold->type = BMR_MANIFOLD_FACE_B;
    if (!cut_sides(corners, &r))
        return;
    manifold->normal = polygon->normals[face];
    manifold->plane_point = polygon->vertices[face];
    for (int i = 0; i < 2; ++i)
        if (is_within(&corners[i], &r, radius_sum))
            keep(manifold, corners[i].v, corners[i].feature, true);
}

bool bmr_exact32_collide_edge(bmr_manifold32 *manifold, const bmr_edge32 *edge,
                              const bmr_transform32 *pose_edge, const bmr_polygon32 *polygon,
                              bmr_vec32 centroid, const bmr_transform32 *pose, float radius_sum) {
    static const float part = 0.98f, tolerance = 0.001f;
    const bmr_transform32 frame = bmr_exact32_relative(pose_edge, pose);
    const bmr_vec32 along = direction(minus(edge->second, edge->first)), normal = quarter_right(along);
    manifold->count = 0;
    if (edge->one_sided && dot(normal, minus(move(&frame, centroid), edge->first)) < 0.0f)
        return true;
    posed_polygon p;
    pose_vertices(&p, polygon, &frame);
    axis own, of_faces;
    if (!separate_edge(&p, edge->first, normal, &own))
        return false;
    if (own.separation > radius_sum)
        return true;
    pose_normals(&p, polygon, &frame);
    if (!separate_faces(&p, edge, &of_faces))
        return false;
    if (of_faces.separation > radius_sum)
        return true;
    axis primary = own;
    if (of_faces.separation - radius_sum > part * (own.separation - radius_sum) + tolerance) {
        const bmr_vec32 n = normal_at(&p, of_faces.face);
        primary = of_faces;
        primary.normal.x = -n.x;
        primary.normal.y = -n.y;
    }
    if (edge->one_sided && !admits(edge, along, &own, &primary))
        return true;
    if (primary.face == BMR_NO_EDGE32)
        return clip_polygon(manifold, edge, along, primary.normal, &p, polygon->count, &frame, radius_sum);
    clip_edge(manifold, edge, primary.face, &p, polygon, radius_sum);
    return true;
}
