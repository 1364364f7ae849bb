// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_EXACT32_CLIP_H
#define BOOMERANG_EXACT32_CLIP_H

#include <float.h>
#include <math.h>
#include <string.h>

#include "exact32/exact32.h"
#include "exact32/float4.h"

/// @file
/// What the files of core/exact32 share: formulas whose parentheses fix their rounding, and the same in
/// lanes. A difference may be a sum with the sign bit of one product's factor turned, which rounds the same.

static inline bmr_vec32 turn(const bmr_transform32 *t, bmr_vec32 v) {
    const bmr_vec32 r = {t->c * v.x - t->s * v.y, t->s * v.x + t->c * v.y};
    return r;
}

static inline bmr_vec32 move(const bmr_transform32 *t, bmr_vec32 v) {
    const bmr_vec32 r = {(t->c * v.x - t->s * v.y) + t->p.x, (t->s * v.x + t->c * v.y) + t->p.y};
    return r;
}

/// Two vectors side by side, each turned a quarter to the left: (x, y) becomes (-y, x).
static inline float4 quarter_left(float4 vectors) {
    return flip_even4(swap4(vectors));
}

/// bmr_exact32_relative on transforms in a register: px, py, s, c. `d`: dx, dy, and the reference's s, c.
static inline float4 relative_of(float4 other, float4 d) {
    const float4 e = flip_inner4(swap4(d)); // d beside dy, -dx, -rc, rs
    return add4(mul4(splat4(other, 3), d), mul4(splat4(other, 2), e));
}
static inline float4 relative(float4 other, float4 reference) {
    return relative_of(other, low_high4(sub4(reference, other), reference));
}

/// Four points, x and y apart.
typedef struct quad {
    float4 x, y;
} quad;

static inline quad load_four(const bmr_vec32 *points) {
    const float4 a = load4(&points[0].x), b = load4(&points[2].x);
    const quad q = {evens4(a, b), odds4(a, b)};
    return q;
}

/// Lanes outside `mask` are zero: what lies past a polygon's count is never computed with.
static inline quad load_quad(const bmr_vec32 *points, mask4 mask) {
    quad q = load_four(points);
    q.x = keep4(mask, q.x);
    q.y = keep4(mask, q.y);
    return q;
}

// How Box2D makes points of an incident edge and a reference edge, one float after the other.

/// A point of the incident edge on its way through the cuts.
typedef struct clip_corner {
    bmr_vec32 v;
    bmr_feature32 feature;
} clip_corner;

static inline float dot(bmr_vec32 a, bmr_vec32 b) {
    return a.x * b.x + a.y * b.y;
}

static inline float cross(bmr_vec32 a, bmr_vec32 b) {
    return a.x * b.y - a.y * b.x;
}

static inline bmr_vec32 minus(bmr_vec32 a, bmr_vec32 b) {
    const bmr_vec32 r = {a.x - b.x, a.y - b.y};
    return r;
}

/// A quarter turn to the right: the outward normal of an edge that runs along v.
static inline bmr_vec32 quarter_right(bmr_vec32 v) {
    const bmr_vec32 r = {v.y, -v.x};
    return r;
}

static inline bmr_vec32 turn_back(const bmr_transform32 *t, bmr_vec32 v) {
    const bmr_vec32 r = {t->c * v.x + t->s * v.y, -t->s * v.x + t->c * v.y};
    return r;
}

/// From a point in the world to the frame of the pose.
static inline bmr_vec32 move_back(const bmr_transform32 *t, bmr_vec32 v) {
    return turn_back(t, minus(v, t->p));
}

/// Its unit vector; too short an edge is left as it is.
static inline bmr_vec32 direction(bmr_vec32 v) {
    const float length = sqrtf(v.x * v.x + v.y * v.y);
    if (length < FLT_EPSILON)
        return v;
    const float inverse = 1.0f / length;
    const bmr_vec32 r = {v.x * inverse, v.y * inverse};
    return r;
}

/// Keeps of two corners what lies behind the plane and puts in the point where they cross it; false where
/// less than two are left.
static inline bool cut(clip_corner corners[2], bmr_vec32 normal, float offset, int32_t index) {
    const clip_corner first = corners[0], second = corners[1];
    const float d0 = dot(normal, first.v) - offset, d1 = dot(normal, second.v) - offset;
    int count = 0;
    if (d0 <= 0.0f)
        corners[count++] = first;
    if (d1 <= 0.0f)
        corners[count++] = second;
    if (count < 2 && d0 * d1 < 0.0f) {
        const float along = d0 / (d0 - d1);
        corners[count].v.x = first.v.x + along * (second.v.x - first.v.x);
        corners[count].v.y = first.v.y + along * (second.v.y - first.v.y);
        corners[count].feature.index_a = (uint8_t)index;
        corners[count].feature.index_b = first.feature.index_b;
        corners[count].feature.type_a = BMR_FEATURE_VERTEX;
        corners[count].feature.type_b = BMR_FEATURE_FACE;
        ++count;
    }
    return count == 2;
}

/// Adds a point, which is given in the frame that it belongs to.
static inline void keep(bmr_manifold32 *manifold, bmr_vec32 local, bmr_feature32 f, bool swap) {
    bmr_manifold_point32 *point = manifold->points + manifold->count++;
    const bmr_feature32 swapped = {f.index_b, f.index_a, f.type_b, f.type_a};
    point->point = local;
    point->feature = swap ? swapped : f;
}

/// An edge of a polygon by its place in the arrays.
typedef struct edge_ends {
    const bmr_vec32 *first, *second;
    int32_t index, next; ///< numbers of these for the features: 0 to 255
} edge_ends;

static inline clip_corner corner_of(bmr_vec32 place, int32_t vertex, int32_t edge) {
    const clip_corner c = {place, {(uint8_t)edge, (uint8_t)vertex, BMR_FEATURE_FACE, BMR_FEATURE_VERTEX}};
    return c;
}

// The same in lanes: the same bits, two points at a time.

/// Two points with their features, side by side: x0, y0, x1, y1.
typedef struct clip_segment {
    float4 points;
    uint32_t features[2];
} clip_segment;

/// Where the byte is in a word that lies in memory as bmr_feature32 does.
#if defined(__BYTE_ORDER__) && defined(__ORDER_BIG_ENDIAN__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
#    define FEATURE_SHIFT(byte) (24 - 8 * (byte))
#else
#    define FEATURE_SHIFT(byte) (8 * (byte))
#endif

/// A feature as a word.
static inline uint32_t feature(int32_t index_a, int32_t index_b, uint32_t type_a, uint32_t type_b) {
    return (uint32_t)index_a << FEATURE_SHIFT(0) | (uint32_t)index_b << FEATURE_SHIFT(1) |
           type_a << FEATURE_SHIFT(2) | type_b << FEATURE_SHIFT(3);
}

static inline uint32_t swapped_feature(uint32_t f) {
    return (f & 0x00ff00ffu) << 8 | (f >> 8 & 0x00ff00ffu);
}

/// b, c of two vectors each: (a.x b.x + a.y b.y), in lanes 0 and 2, and again in 1 and 3.
static inline float4 dots(float4 a, float4 b) {
    const float4 products = mul4(a, b);
    return add4(products, swap4(products));
}

static inline float4 load_two(const bmr_vec32 *first, const bmr_vec32 *second) {
    return load_pairs4(&first->x, &second->x);
}

/// Two vectors turned by the pose's rotation.
static inline float4 turn_two(float4 pose, float4 vectors) {
    return add4(mul4(splat4(pose, 3), vectors), mul4(splat4(pose, 2), quarter_left(vectors)));
}

/// (y, -x) of (x, y), twice.
static inline float4 quarter_right_two(float4 vectors) {
    return flip_odd4(swap4(vectors));
}

/// Two vectors turned back.
static inline float4 turn_back_two(float4 pose, float4 vectors) {
    return add4(mul4(splat4(pose, 3), vectors), mul4(splat4(pose, 2), quarter_right_two(vectors)));
}

/// Cuts off what lies beyond the plane; false where less than two points are left. Sides are the distances
/// from it: where the segment crosses it a new point of vertex `index` of the reference takes the place of
/// the one that is lost, behind the one that stays.
static inline bool cut_segment(clip_segment *s, float4 tangent, float sign, float offset, int32_t index) {
    float t[4], p[4];
    store4(t, tangent);
    store4(p, s->points);
    const float nx = sign * t[0], ny = sign * t[1];
    const float first = (nx * p[0] + ny * p[1]) - offset, second = (nx * p[2] + ny * p[3]) - offset;
    if (first <= 0.0f && second <= 0.0f)
        return true;
    if (!(first <= 0.0f || second <= 0.0f) || !(first * second < 0.0f))
        return false;
    const float along = first / (first - second);
    const float x = p[0] + along * (p[2] - p[0]), y = p[1] + along * (p[3] - p[1]);
    const int stays = first <= 0.0f ? 0 : 1;
    const uint32_t made = feature(index, (int32_t)(s->features[0] >> FEATURE_SHIFT(1) & 0xffu),
                                  BMR_FEATURE_VERTEX, BMR_FEATURE_FACE);
    s->points = of4(p[2 * stays], p[2 * stays + 1], x, y);
    s->features[0] = s->features[stays];
    s->features[1] = made;
    return true;
}

/// Points where the incident edge lies above the reference edge: `normal` and `plane_point` where the cuts
/// leave two, and as many points as are within the skins.
static inline void clip_edges(bmr_manifold32 *manifold, edge_ends reference, float4 pose, edge_ends incident,
                              float4 incident_pose, float radius_sum, bool reference_is_b) {
    clip_segment s;
    const float4 place = lows4(incident_pose, incident_pose);
    s.points = add4(turn_two(incident_pose, load_two(incident.first, incident.second)), place);
    s.features[0] = feature(reference.index, incident.index, BMR_FEATURE_FACE, BMR_FEATURE_VERTEX);
    s.features[1] = feature(reference.index, incident.next, BMR_FEATURE_FACE, BMR_FEATURE_VERTEX);

    // The reference edge: its ends, and its tangent in both halves.
    const float4 ends = load_two(reference.first, reference.second);
    const float4 others = exchange4(ends);
    const float4 along = sub4(others, ends), backwards = lows4(along, along);
    const float length = root_of4(first_of4(dots(backwards, backwards)));
    float4 tangent = backwards;
    if (!(length < FLT_EPSILON))
        tangent = mul4(tangent, all4(1.0f / length));
    const float4 middle = mul4(all4(0.5f), add4(ends, others));
    const float4 posed_tangent = turn_two(pose, tangent);
    const float4 posed_ends = add4(turn_two(pose, ends), lows4(pose, pose));
    const float4 normal = quarter_right_two(tangent), posed_normal = quarter_right_two(posed_tangent);

    const float4 front = dots(posed_normal, posed_ends), sides = dots(posed_tangent, posed_ends);
    const float first_offset = -first_of4(sides) + radius_sum;
    const float second_offset = first_of4(highs4(sides, sides)) + radius_sum;

    if (!cut_segment(&s, posed_tangent, -1.0f, first_offset, reference.index) ||
        !cut_segment(&s, posed_tangent, 1.0f, second_offset, reference.next))
        return;

    store_low4(&manifold->normal.x, normal);
    store_low4(&manifold->plane_point.x, middle);

    const float4 depth = sub4(dots(posed_normal, s.points), splat4(front, 0));
    const unsigned kept = bits4(at_most4(depth, all4(radius_sum)));
    const float4 local = turn_back_two(incident_pose, sub4(s.points, place));
    if (reference_is_b) {
        s.features[0] = swapped_feature(s.features[0]);
        s.features[1] = swapped_feature(s.features[1]);
    }
    bmr_manifold_point32 *point = manifold->points;
    if ((kept & 1u) != 0u) {
        store_low4(&point->point.x, local);
        memcpy(&point->feature, &s.features[0], sizeof point->feature);
        ++point;
    }
    if ((kept & 4u) != 0u) {
        store_high4(&point->point.x, local);
        memcpy(&point->feature, &s.features[1], sizeof point->feature);
        ++point;
    }
    manifold->count = (int32_t)(point - manifold->points);
}

#endif
