// SPDX-License-Identifier: MIT
#include "rivals.h"

#include <algorithm>
#include <cmath>

namespace rival {

namespace {

/// Index of the vertex farthest against `u`, climbing from `vertex`.
inline uint32_t Climb(const bmr_polygon &polygon, bmr_vec2 u, uint32_t vertex) {
    const bmr_vec2 *v = polygon.vertices;
    const uint32_t count = polygon.count;
    double best = bmr_dot(u, v[vertex]);
    for (const uint32_t step : {1u, count - 1}) {
        for (;;) {
            uint32_t next = vertex + step;
            next = next >= count ? next - count : next;
            const double d = bmr_dot(u, v[next]);
            if (!(d < best))
                break;
            best = d;
            vertex = next;
        }
    }
    return vertex;
}

/// Separation of `other` (seen at `pose` from the owner) along a line of the owner; climbs `*vertex` to the
/// support.
inline double Separation(bmr_vec2 normal, double offset, const bmr_polygon &other, const bmr_pose &pose,
                         uint32_t *vertex) {
    const bmr_vec2 u = bmr_unrotate(&pose, normal);
    *vertex = Climb(other, u, *vertex);
    return bmr_dot(normal, pose.position) + bmr_dot(u, other.vertices[*vertex]) - offset;
}

} // namespace

bool CachedEdge::Apart(const bmr_polygon &a, const bmr_polygon &b, const bmr_pose &bInA) {
    if (known_) {
        const bmr_pose pose = ofB_ ? bmr_pose_inverse(&bInA) : bInA;
        if (Separation(normal_, offset_, ofB_ ? a : b, pose, &vertex_) > 0.0)
            return true;
    }
    double best = -INFINITY;
    for (const bool ofB : {false, true}) {
        const bmr_polygon &owner = ofB ? b : a, &other = ofB ? a : b;
        const bmr_pose pose = ofB ? bmr_pose_inverse(&bInA) : bInA;
        uint32_t vertex = 0;
        for (uint32_t edge = 0; edge < owner.count; ++edge) {
            const bmr_vec2 normal = bmr_polygon_normal(&owner, edge);
            const double offset = bmr_dot(normal, owner.vertices[edge]);
            const double s = Separation(normal, offset, other, pose, &vertex);
            if (s > best) {
                best = s;
                ofB_ = ofB;
                normal_ = normal;
                offset_ = offset;
                vertex_ = vertex;
            }
        }
    }
    known_ = best > 0.0;
    return known_;
}

namespace {

struct Support {
    bmr_vec2 w; // b's vertex minus a's, in a's frame
    uint32_t a, b;
};

/// Closest point to the origin on the segment or triangle of `count` supports; drops the ones it does not
/// need.
bmr_vec2 Closest(Support *simplex, int *count) {
    if (*count == 1)
        return simplex[0].w;
    int best[2] = {0, 0};
    bmr_vec2 closest = simplex[0].w;
    double least = INFINITY;
    for (int i = 0; i < *count; ++i) {
        for (int j = i + 1; j < *count; ++j) {
            const bmr_vec2 d = bmr_sub(simplex[j].w, simplex[i].w);
            const double length = bmr_dot(d, d);
            const double t = length > 0 ? std::clamp(-bmr_dot(simplex[i].w, d) / length, 0.0, 1.0) : 0.0;
            const bmr_vec2 p = bmr_add(simplex[i].w, bmr_scale(t, d));
            if (bmr_dot(p, p) < least) {
                least = bmr_dot(p, p);
                closest = p;
                best[0] = t < 1.0 ? i : j;
                best[1] = t > 0.0 ? j : i;
            }
        }
    }
    if (*count == 3) {
        const double ab = bmr_cross(simplex[0].w, simplex[1].w), bc = bmr_cross(simplex[1].w, simplex[2].w),
                     ca = bmr_cross(simplex[2].w, simplex[0].w);
        if ((ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0))
            return bmr_vec2_make(0.0, 0.0);
    }
    const Support first = simplex[best[0]], second = simplex[best[1]];
    simplex[0] = first;
    simplex[1] = second;
    *count = best[0] == best[1] ? 1 : 2;
    return closest;
}

} // namespace

double WarmGjk::Distance(const bmr_polygon &a, const bmr_polygon &b, const bmr_pose &bInA) {
    const auto support = [&](bmr_vec2 direction) {
        Support s;
        s.a = a_ = Climb(a, bmr_neg(direction), a_);
        s.b = b_ = Climb(b, bmr_unrotate(&bInA, direction), b_);
        s.w = bmr_sub(bmr_transform(&bInA, b.vertices[s.b]), a.vertices[s.a]);
        return s;
    };
    Support simplex[3];
    int count = 1;
    simplex[0] = {bmr_sub(bmr_transform(&bInA, b.vertices[b_]), a.vertices[a_]), a_, b_};
    bmr_vec2 closest = simplex[0].w;
    for (int i = 0; i < 64; ++i) {
        const Support next = support(closest);
        const double squared = bmr_dot(closest, closest);
        if (squared - bmr_dot(closest, next.w) <= 1e-10 * squared)
            break;
        simplex[count++] = next;
        closest = Closest(simplex, &count);
        if (closest.x == 0.0 && closest.y == 0.0)
            return 0.0;
    }
    return std::sqrt(bmr_dot(closest, closest));
}

} // namespace rival
