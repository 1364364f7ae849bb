// SPDX-License-Identifier: MIT
#include "convex32_poses.h"

#include <math.h>
#include <stdlib.h>

static const double turn = 6.283185307179586;

convex32_kind random_kind(test_random *d) {
    return (convex32_kind)test_random_below(d, KINDS);
}

static bmr_vec32 at_angle(double angle, double width, double height) {
    const bmr_vec32 v = {(float)(width * cos(angle)), (float)(height * sin(angle))};
    return v;
}

static bmr_vec32 on_rounded(double angle, double corner) {
    const double x = cos(angle), y = sin(angle);
    const bmr_vec32 v = {(float)(copysign(1.0 - corner, x) + corner * x),
                         (float)(copysign(0.6 - corner, y) + corner * y)};
    return v;
}

static bmr_vec32 nth_point(test_random *d, convex32_kind kind, uint32_t i, uint32_t count, double shape) {
    const double share = (double)i / (double)count;
    switch (kind) {
    case KIND_ELLIPSE:
        return at_angle(turn * share, 1.0, pow(10.0, -3.0 * shape));
    case KIND_RANDOM:
        return at_angle(test_random_uniform(d, 0.0, turn), 1.0, 1.0);
    case KIND_CLUSTERED:
        return i < 3 ? at_angle(turn * (double)i / 3.0 + shape, 1.0, 1.0)
                     : at_angle(turn * (double)(i % 3) / 3.0 + shape +
                                    test_random_uniform(d, 0.0, pow(10.0, -1.0 - 2.0 * shape)),
                                1.0, 1.0);
    case KIND_ROUNDED:
        return on_rounded(turn * (share + 0.5 / (double)count), 0.05 + 0.5 * shape);
    case KIND_HALF:
        return at_angle(0.5 * turn * (double)i / (double)(count - 1), 1.0, 1.0);
    case KIND_BOX: {
        const bmr_vec32 v = {i == 1 || i == 2 ? 1.0f : -1.0f,
                             (i >= 2 ? 1.0f : -1.0f) * (float)pow(10.0, -2.0 * shape)};
        return v;
    }
    case KIND_TRIANGLE:
        return at_angle(test_random_uniform(d, 0.0, turn), 1.0, 1.0);
    case KIND_REGULAR:
    default:
        return at_angle(turn * share, 1.0, 1.0);
    }
}

bmr_convex32_block *random_convex32(test_random *d, convex32_kind kind, uint32_t count) {
    if (kind == KIND_BOX || kind == KIND_TRIANGLE)
        count = kind == KIND_BOX ? 4 : 3;
    bmr_vec32 *const points = malloc(count * sizeof *points);
    bmr_convex32_block *block = NULL;
    while (points && !block) {
        const double shape = test_random_uniform(d, 0.0, 1.0),
                     size = pow(10.0, test_random_uniform(d, -1.3, 0.7));
        const double offset = test_random_below(d, 3) == 0 ? size : 0.0,
                     angle = test_random_uniform(d, 0.0, turn);
        const double x = test_random_uniform(d, -offset, offset), y = test_random_uniform(d, -offset, offset);
        const bool turned = test_random_below(d, 2) == 0;
        for (uint32_t i = 0; i < count; ++i) {
            const bmr_vec32 p = nth_point(d, kind, i, count, shape);
            const double c = turned ? cos(angle) : 1.0, s = turned ? sin(angle) : 0.0;
            points[i].x = (float)(size * (c * (double)p.x - s * (double)p.y) + x);
            points[i].y = (float)(size * (s * (double)p.x + c * (double)p.y) + y);
        }
        if (bmr_convex32_create(points, count, NULL, &block) != BMR_OK)
            block = NULL;
    }
    free(points);
    if (!block)
        abort();
    return block;
}

static bmr_transform32 pose_of(double x, double y, double angle) {
    const bmr_transform32 pose = {{(float)x, (float)y}, (float)sin(angle), (float)cos(angle)};
    return pose;
}

bmr_transform32 random_pose32(test_random *d, double range) {
    const double angle = test_random_below(d, 4) == 0 ? 0.25 * turn * test_random_below(d, 4)
                                                      : test_random_uniform(d, -4.0, 4.0);
    return pose_of(test_random_uniform(d, -range, range), test_random_uniform(d, -range, range), angle);
}

typedef struct point {
    double x, y;
} point;

static point placed(const bmr_transform32 *pose, bmr_vec32 v) {
    const double c = (double)pose->c, s = (double)pose->s, x = (double)v.x, y = (double)v.y;
    const point p = {c * x - s * y + (double)pose->p.x, s * x + c * y + (double)pose->p.y};
    return p;
}

/// How far the polygon reaches along u.
static double most_along(const bmr_convex32 *p, const bmr_transform32 *pose, point u) {
    double most = -1e300;
    for (uint32_t i = 0; i < p->count; ++i) {
        const point v = placed(pose, p->vertices[i]);
        const double along = u.x * v.x + u.y * v.y;
        most = along > most ? along : most; // not fmax: of that gcc 12 dies where it compiles for ARM64
    }
    return most;
}

static point edge_middle(const bmr_convex32 *p, const bmr_transform32 *pose, uint32_t edge, double along) {
    const point v = placed(pose, p->vertices[edge]);
    const point w = placed(pose, p->vertices[edge + 1 < p->count ? edge + 1 : 0]);
    const point r = {v.x + along * (w.x - v.x), v.y + along * (w.y - v.y)};
    return r;
}

bmr_transform32 pose_against(test_random *d, const bmr_convex32 *a, const bmr_transform32 *pose_a,
                             const bmr_convex32 *b, double skin) {
    const uint32_t how = test_random_below(d, 8), edge_a = test_random_below(d, a->count),
                   edge_b = test_random_below(d, b->count);
    bmr_transform32 pose = random_pose32(d, 0.0);
    if (how == 0) // the same way round, or by some part of a turn that shapes like these repeat after
        pose = pose_of(0.0, 0.0,
                       atan2((double)pose_a->s, (double)pose_a->c) +
                           turn * (double)test_random_below(d, b->count) / (double)b->count);
    if (how <= 1) { // concentric, more or less
        const double off = test_random_below(d, 2) == 0 ? 0.0 : pow(10.0, test_random_uniform(d, -6.0, 0.0));
        const point m = edge_middle(a, pose_a, 0, 0.0), n = edge_middle(a, pose_a, a->count / 2, 0.0);
        const point o = edge_middle(b, &pose, 0, 0.0), p = edge_middle(b, &pose, b->count / 2, 0.0);
        pose.p.x += (float)(0.5 * (m.x + n.x - o.x - p.x) + test_random_uniform(d, -off, off));
        pose.p.y += (float)(0.5 * (m.y + n.y - o.y - p.y) + test_random_uniform(d, -off, off));
        return pose;
    }
    const bmr_vec32 normal_a = a->normals[edge_a], normal_b = b->normals[edge_b];
    point u = placed(pose_a, normal_a);
    u.x -= (double)pose_a->p.x;
    u.y -= (double)pose_a->p.y;
    if (how <= 4) { // face to face; nearly so; vertices at random
        const double tilt = how == 2   ? 0.0
                            : how == 3 ? test_random_uniform(d, -1e-3, 1e-3)
                                       : test_random_uniform(d, -3.0, 3.0);
        pose = pose_of(0.0, 0.0, atan2(-u.y, -u.x) - atan2((double)normal_b.y, (double)normal_b.x) + tilt);
    } else if (how <= 6) { // any direction
        const double angle = test_random_uniform(d, 0.0, turn);
        u.x = cos(angle);
        u.y = sin(angle);
    } // else: along a face of a's, b as it is
    const point back = {-u.x, -u.y};
    const double gap = test_random_below(d, 4) == 0   ? test_random_uniform(d, -30.0, 30.0) * skin
                       : test_random_below(d, 8) == 0 ? 0.0
                                                      : test_random_uniform(d, -1.5, 2.5) * skin;
    const double push = most_along(a, pose_a, u) + most_along(b, &pose, back) + gap;
    // Some point of b's edge lies over some point of a's.
    const bool corners = test_random_below(d, 3) == 0;
    const point on_a = edge_middle(a, pose_a, edge_a, corners ? 0.0 : test_random_uniform(d, -0.5, 1.5));
    const point on_b = edge_middle(b, &pose, edge_b, corners ? 1.0 : test_random_uniform(d, -0.5, 1.5));
    const double slide = (on_a.x - on_b.x) * -u.y + (on_a.y - on_b.y) * u.x;
    pose.p.x = (float)(u.x * push - u.y * slide);
    pose.p.y = (float)(u.y * push + u.x * slide);
    return pose;
}

bmr_transform32 moved_a_little(test_random *d, const bmr_transform32 *pose, double step) {
    const double angle = atan2((double)pose->s, (double)pose->c) + test_random_uniform(d, -step, step);
    return pose_of((double)pose->p.x + 0.1 * test_random_uniform(d, -step, step),
                   (double)pose->p.y + 0.1 * test_random_uniform(d, -step, step), angle);
}
