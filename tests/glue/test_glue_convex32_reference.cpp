// SPDX-License-Identifier: MIT
// The loops over all vertices that polygons of any size are compared with are Box2D's: here, where Box2D can
// say so. The same poses go through the code for any size.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cstring>
#include <memory>

#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_polygon_shape.h>

#include "convex32/convex32_collide.h"
#include "convex32_poses.h"
#include "convex32_reference.h"
#include "test_scale.h"

namespace {

constexpr float kTolerance = 0.1f * b2_linearSlop;

b2Vec2 Vector(bmr_vec32 v) {
    return b2Vec2(v.x, v.y);
}

b2Transform Transform(const bmr_transform32 &t) {
    b2Rot q;
    q.s = t.s;
    q.c = t.c;
    return b2Transform(Vector(t.p), q);
}

struct Freed {
    void operator()(bmr_convex32_block *block) const { bmr_convex32_destroy(block, nullptr); }
};

/// A polygon of at most 8 vertices, Box2D's and ours with the same arrays.
struct Small {
    explicit Small(dice *d) {
        for (;;) {
            const std::unique_ptr<bmr_convex32_block, Freed> block(
                random_convex32(d, random_kind(d), 3 + dice_below(d, 6)));
            if (block->polygon.count > b2_maxPolygonVertices)
                continue;
            // Set would weld and assert on some of these; its arrays are what counts.
            box2d.m_count = static_cast<int32>(block->polygon.count);
            for (uint32_t i = 0; i < block->polygon.count; ++i) {
                box2d.m_vertices[i] = Vector(block->polygon.vertices[i]);
                box2d.m_normals[i] = Vector(block->polygon.normals[i]);
            }
            box2d.m_centroid = Vector(block->mass.centroid);
            centroid = block->mass.centroid;
            std::memcpy(vertices, block->polygon.vertices, block->polygon.count * sizeof *vertices);
            std::memcpy(normals, block->polygon.normals, block->polygon.count * sizeof *normals);
            view = {vertices, normals, nullptr, block->polygon.count, 0, {0.0f, 0.0f}, nullptr};
            return;
        }
    }
    Small(const Small &) = delete;
    Small &operator=(const Small &) = delete;

    b2PolygonShape box2d;
    bmr_vec32 vertices[b2_maxPolygonVertices], normals[b2_maxPolygonVertices], centroid;
    bmr_convex32 view;
};

bmr_manifold32 Ours(const b2Manifold &m) {
    bmr_manifold32 r = {};
    r.count = m.pointCount;
    r.type = static_cast<int32_t>(m.type);
    r.normal = {m.localNormal.x, m.localNormal.y};
    r.plane_point = {m.localPoint.x, m.localPoint.y};
    for (int i = 0; i < m.pointCount; ++i) {
        r.points[i].point = {m.points[i].localPoint.x, m.points[i].localPoint.y};
        const b2ContactFeature &f = m.points[i].id.cf;
        r.points[i].feature = {f.indexA, f.indexB, f.typeA, f.typeB};
    }
    return r;
}

struct Compared {
    size_t touching = 0, referenceDiffers = 0, searchDiffers = 0, perturbedPasses = 0;

    void Add(const b2Manifold &box2d, const bmr_manifold32 &reference, const bmr_manifold32 &found) {
        bmr_manifold32 expected = Ours(box2d);
        touching += expected.count > 0;
        referenceDiffers += !reference_same_manifold(&expected, &reference);
        searchDiffers += !reference_same_manifold(&expected, &found);
        expected.normal.x = std::nextafter(expected.normal.x, 2.0f);
        perturbedPasses += reference_same_manifold(&expected, &reference);
    }

    void Check(size_t poses) const {
        CHECK(referenceDiffers == 0);
        CHECK(searchDiffers == 0);
        CHECK(perturbedPasses == 0);
        CHECK(touching > poses / 5);
    }
};

template <typename Pose> void ForPolygons(uint64_t seed, size_t poses, Pose pose) {
    dice d = {seed};
    for (size_t n = 0; n < poses; ++n)
        pose(&d);
}

bmr_convex32_memory Anything(dice *d) {
    return {static_cast<uint16_t>(dice_roll(d)), static_cast<uint16_t>(dice_roll(d)),
            static_cast<int16_t>(dice_below(d, 65535) - 32767),
            static_cast<int16_t>(dice_below(d, 65535) - 32767)};
}

b2Manifold Blank() {
    b2Manifold m;
    std::memset(static_cast<void *>(&m), 0, sizeof m);
    return m;
}

} // namespace

TEST_CASE("polygons of at most 8 vertices touch each other as in Box2D") {
    const size_t poses = test_scaled(100000);
    Compared compared;
    ForPolygons(0x5eed5, poses, [&](dice *d) {
        const Small a(d), b(d);
        const bmr_transform32 poseA = random_pose32(d, 10.0);
        const float skin = a.box2d.m_radius + b.box2d.m_radius;
        const bmr_transform32 poseB = pose_against(d, &a.view, &poseA, &b.view, static_cast<double>(skin));
        b2Manifold expected = Blank();
        b2CollidePolygons(&expected, &a.box2d, Transform(poseA), &b.box2d, Transform(poseB));
        bmr_manifold32 reference = {}, found = {};
        reference_collide(&reference, &a.view, &poseA, &b.view, &poseB, skin, kTolerance);
        bmr_convex32_memory memory = Anything(d);
        bmr_convex32_collide(&found, &a.view, &poseA, &b.view, &poseB, skin, kTolerance, &memory);
        compared.Add(expected, reference, found);
    });
    compared.Check(poses);
}

TEST_CASE("polygons of at most 8 vertices touch circles as in Box2D") {
    const size_t poses = test_scaled(100000);
    Compared compared;
    ForPolygons(0x5eed6, poses, [&](dice *d) {
        const Small polygon(d);
        const bmr_transform32 pose = random_pose32(d, 10.0);
        b2CircleShape circle;
        circle.m_radius = static_cast<float>(dice_in(d, 0.0, 0.5));
        circle.m_p =
            b2Vec2(static_cast<float>(dice_in(d, -0.5, 0.5)), static_cast<float>(dice_in(d, -0.5, 0.5)));
        const bmr_vec32 centre = {circle.m_p.x, circle.m_p.y};
        const bmr_convex32 point = {&centre, &centre, nullptr, 1, 0, {0.0f, 0.0f}, nullptr};
        const float skin = polygon.box2d.m_radius + circle.m_radius;
        const bmr_transform32 at = pose_against(d, &polygon.view, &pose, &point, static_cast<double>(skin));
        b2Manifold expected = Blank();
        b2CollidePolygonAndCircle(&expected, &polygon.box2d, Transform(pose), &circle, Transform(at));
        bmr_manifold32 reference = {}, found = {};
        reference_collide_circle(&reference, &polygon.view, &pose, centre, &at, skin);
        bmr_convex32_memory memory = Anything(d);
        bmr_convex32_collide_circle(&found, &polygon.view, &pose, centre, &at, skin, &memory);
        compared.Add(expected, reference, found);
    });
    compared.Check(poses);
}

TEST_CASE("polygons of at most 8 vertices touch edges as in Box2D") {
    const size_t poses = test_scaled(100000);
    Compared compared;
    ForPolygons(0x5eed7, poses, [&](dice *d) {
        const Small polygon(d);
        const bmr_transform32 pose = random_pose32(d, 10.0);
        b2EdgeShape edge;
        const auto near = [d](const b2Vec2 &v) {
            return v + b2Vec2(static_cast<float>(dice_in(d, -2.0, 2.0)),
                              static_cast<float>(dice_in(d, -2.0, 2.0)));
        };
        const b2Vec2 first = near(b2Vec2_zero), second = near(first), before = near(first),
                     after = near(second);
        if (dice_below(d, 2) == 0)
            edge.SetOneSided(before, first, second, after);
        else
            edge.SetTwoSided(first, second);
        const auto ours = [](const b2Vec2 &v) { return bmr_vec32{v.x, v.y}; };
        const bmr_edge32 same = {ours(edge.m_vertex0), ours(edge.m_vertex1), ours(edge.m_vertex2),
                                 ours(edge.m_vertex3), edge.m_oneSided};
        const bmr_vec32 ends[2] = {same.first, same.second}, normals[2] = {{1.0f, 0.0f}, {-1.0f, 0.0f}};
        const bmr_convex32 segment = {ends, normals, nullptr, 2, 0, {0.0f, 0.0f}, nullptr};
        const float skin = polygon.box2d.m_radius + edge.m_radius;
        const bmr_transform32 at = pose_against(d, &polygon.view, &pose, &segment, static_cast<double>(skin));
        b2Manifold expected = Blank();
        b2CollideEdgeAndPolygon(&expected, &edge, Transform(at), &polygon.box2d, Transform(pose));
        bmr_manifold32 reference = {}, found = {};
        reference_collide_edge(&reference, &same, &at, &polygon.view, polygon.centroid, &pose, skin);
        bmr_convex32_memory memory = Anything(d);
        bmr_convex32_collide_edge(&found, &same, &at, &polygon.view, polygon.centroid, &pose, skin, &memory);
        compared.Add(expected, reference, found);
    });
    compared.Check(poses);
}
