// SPDX-License-Identifier: MIT
// core/exact32 and the loops that polygons of any size are compared with have Box2D's bits. Box2D keeps its
// separations to itself, but its early exit tells: with the sum of the radii set to exactly the largest
// separation it goes on, with one float less it leaves.
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_polygon_shape.h>

#include "box2d_shapes.h"
#include "cases.h"
#include "convex32/convex32_collide.h"
#include "convex32_poses.h"
#include "convex32_reference.h"
#include "exact32/exact32.h"
#include "shapes/shapes32.h"
#include "start/install.h"

namespace {

// A value of b2Manifold::Type that b2CollidePolygons never sets.
using bmr::Polygon32;
using bmr::Transform32;
using namespace shapes;

constexpr b2Manifold::Type kUntouched = b2Manifold::e_circles;

/// Did b2CollidePolygons leave at one of its two separation tests? It sets the type right after them.
bool LeavesEarly(b2PolygonShape a, const b2Transform &xfA, b2PolygonShape b, const b2Transform &xfB,
                 float radiusSum) {
    a.m_radius = radiusSum;
    b.m_radius = 0.0f;
    b2Manifold manifold;
    manifold.type = kUntouched;
    b2CollidePolygons(&manifold, &a, xfA, &b, xfB);
    return manifold.type == kUntouched;
}

struct Pair {
    b2PolygonShape a, b;
    b2Transform xfA, xfB;
};

/// Apart, touching or overlapping, anywhere in a level of a kilometre.
Pair RandomPair(Engine &engine) {
    Pair pair;
    pair.a = RandomPolygon(engine, 60.0);
    pair.b = RandomPolygon(engine, 60.0);
    const double range = std::pow(10.0, Uniform(engine, -1.0, 3.0));
    pair.xfA = RandomPose(engine, range);
    pair.xfB = RandomPose(engine, std::pow(10.0, Uniform(engine, -2.0, 2.0)));
    pair.xfB.p += pair.xfA.p;
    return pair;
}

using MaxSeparation = float (*)(const bmr_polygon32 *, const bmr_polygon32 *, const bmr_transform32 *,
                                int32_t *);

float LargestSeparation(const Pair &pair, MaxSeparation max) {
    const bmr_polygon32 a = Polygon32(pair.a), b = Polygon32(pair.b);
    const bmr_transform32 *const ta = Transform32(pair.xfA), *const tb = Transform32(pair.xfB);
    const bmr_transform32 aInB = bmr_exact32_relative(tb, ta), bInA = bmr_exact32_relative(ta, tb);
    int32_t edge = 0;
    const float ofA = max(&a, &b, &aInB, &edge);
    const float ofB = max(&b, &a, &bInA, &edge);
    return ofB > ofA ? ofB : ofA;
}

/// Is this, to the bit, the larger of the two separations that Box2D computes?
bool IsBox2Ds(const Pair &pair, float separation) {
    return !LeavesEarly(pair.a, pair.xfA, pair.b, pair.xfB, separation) &&
           LeavesEarly(pair.a, pair.xfA, pair.b, pair.xfB, std::nextafterf(separation, -FLT_MAX));
}

/// As a compiler that contracts would compute <n, w - v>.
float ContractedMax(const bmr_polygon32 *reference, const bmr_polygon32 *other, const bmr_transform32 *f,
                    int32_t *edge) {
    float best = -FLT_MAX;
    for (int32_t i = 0; i < reference->count; ++i) {
        const bmr_vec32 m = reference->normals[i], w = reference->vertices[i];
        const bmr_vec32 n = {f->c * m.x - f->s * m.y, f->s * m.x + f->c * m.y};
        const bmr_vec32 v = {(f->c * w.x - f->s * w.y) + f->p.x, (f->s * w.x + f->c * w.y) + f->p.y};
        float least = FLT_MAX;
        for (int32_t j = 0; j < other->count; ++j) {
            const float x = other->vertices[j].x - v.x, y = other->vertices[j].y - v.y;
            least = std::fmin(least, std::fmaf(n.x, x, n.y * y));
        }
        best = std::fmax(best, least);
    }
    *edge = 0;
    return best;
}

} // namespace

TEST_CASE("largest separations have the bits of b2CollidePolygons' own") {
    Engine engine(1);
    const size_t count = test_scaled(100000);
    size_t apart = 0, different = 0, differentContracted = 0;
    for (size_t i = 0; i < count; ++i) {
        const Pair pair = RandomPair(engine);
        const float separation = LargestSeparation(pair, bmr_exact32_max_separation);
        apart += separation > 0.0f;
        different += !IsBox2Ds(pair, separation);
        differentContracted += !IsBox2Ds(pair, LargestSeparation(pair, ContractedMax));
    }
    CHECK(apart > count / 10);
    CHECK(apart < count - count / 10);
    CHECK(different == 0);
    // Control: fused multiply-add, mathematically the same, is told apart.
    CHECK(differentContracted > count / 10);
}

TEST_CASE("relative frames have the bits of b2MulT") {
    Engine engine(2);
    size_t different = 0;
    for (size_t i = 0; i < test_scaled(100000); ++i) {
        const double range = std::pow(10.0, Uniform(engine, -3.0, 5.0));
        const b2Transform a = RandomPose(engine, range), b = RandomPose(engine, range);
        const b2Transform expected = b2MulT(a, b);
        const bmr_transform32 frame = bmr_exact32_relative(Transform32(a), Transform32(b));
        different += std::memcmp(&frame, &expected, sizeof frame) != 0;
    }
    CHECK(different == 0);
}

TEST_CASE("an edge that separates by more than the radii means no points from Box2D") {
    Engine engine(3);
    size_t verdicts = 0, denied = 0, control = 0;
    for (size_t i = 0; i < test_scaled(100000); ++i) {
        Pair pair = RandomPair(engine);
        // Close calls: the second body is moved so that the best separation is about the sum of the radii.
        const float sum = pair.a.m_radius + pair.b.m_radius;
        const b2Vec2 towards = pair.xfA.p - pair.xfB.p;
        const float step = LargestSeparation(pair, bmr_exact32_max_separation) - sum;
        if (towards.Length() > 0.1f && std::fabs(step) < 5.0f)
            pair.xfB.p += (step / towards.Length()) * towards;
        b2Manifold manifold;
        b2CollidePolygons(&manifold, &pair.a, pair.xfA, &pair.b, pair.xfB);
        for (const bool ofB : {false, true}) {
            const bmr_polygon32 reference = Polygon32(ofB ? pair.b : pair.a),
                                other = Polygon32(ofB ? pair.a : pair.b);
            const bmr_transform32 frame = bmr_exact32_relative(Transform32(ofB ? pair.xfA : pair.xfB),
                                                               Transform32(ofB ? pair.xfB : pair.xfA));
            for (int32_t edge = 0; edge < reference.count; ++edge) {
                const float s = bmr_exact32_edge_separation(&reference, edge, &other, &frame);
                verdicts += s > sum;
                denied += s > sum && manifold.pointCount != 0;
                control += s > 0.9f * sum && manifold.pointCount != 0;
            }
        }
    }
    CHECK(verdicts > test_scaled(100000) / 4);
    CHECK(denied == 0);
    // Control: a threshold a tenth too low is denied by Box2D.
    CHECK(control > 0);
}

TEST_CASE("the rounding probe says yes on this machine exactly where Box2D is built without contraction") {
    Engine engine(4);
    size_t different = 0;
    for (size_t i = 0; i < 1000; ++i) {
        const Pair pair = RandomPair(engine);
        different += !IsBox2Ds(pair, LargestSeparation(pair, bmr_exact32_max_separation));
    }
    CHECK(bmr::Box2DRoundsAsExact32() == (different == 0));
}

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
    explicit Small(test_random *d) {
        for (;;) {
            const std::unique_ptr<bmr_convex32_block, Freed> block(
                random_convex32(d, random_kind(d), 3 + test_random_below(d, 6)));
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
    test_random d = {seed};
    for (size_t n = 0; n < poses; ++n)
        pose(&d);
}

bmr_convex32_memory Anything(test_random *d) {
    return {static_cast<uint16_t>((uint32_t)test_random_next(d)),
            static_cast<uint16_t>((uint32_t)test_random_next(d)),
            static_cast<int16_t>(test_random_below(d, 65535) - 32767),
            static_cast<int16_t>(test_random_below(d, 65535) - 32767)};
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
    ForPolygons(0x5eed5, poses, [&](test_random *d) {
        const Small a(d), b(d);
        const bmr_transform32 poseA = random_pose32(d, 10.0);
        const float skin = a.box2d.m_radius + b.box2d.m_radius;
        const bmr_transform32 poseB = pose_against(d, &a.view, &poseA, &b.view, double{skin});
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
    ForPolygons(0x5eed6, poses, [&](test_random *d) {
        const Small polygon(d);
        const bmr_transform32 pose = random_pose32(d, 10.0);
        b2CircleShape circle;
        circle.m_radius = static_cast<float>(test_random_uniform(d, 0.0, 0.5));
        circle.m_p = b2Vec2(static_cast<float>(test_random_uniform(d, -0.5, 0.5)),
                            static_cast<float>(test_random_uniform(d, -0.5, 0.5)));
        const bmr_vec32 centre = {circle.m_p.x, circle.m_p.y};
        const bmr_convex32 point = {&centre, &centre, nullptr, 1, 0, {0.0f, 0.0f}, nullptr};
        const float skin = polygon.box2d.m_radius + circle.m_radius;
        const bmr_transform32 at = pose_against(d, &polygon.view, &pose, &point, double{skin});
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
    ForPolygons(0x5eed7, poses, [&](test_random *d) {
        const Small polygon(d);
        const bmr_transform32 pose = random_pose32(d, 10.0);
        b2EdgeShape edge;
        const auto near = [d](const b2Vec2 &v) {
            return v + b2Vec2(static_cast<float>(test_random_uniform(d, -2.0, 2.0)),
                              static_cast<float>(test_random_uniform(d, -2.0, 2.0)));
        };
        const b2Vec2 first = near(b2Vec2_zero), second = near(first), before = near(first),
                     after = near(second);
        if (test_random_below(d, 2) == 0)
            edge.SetOneSided(before, first, second, after);
        else
            edge.SetTwoSided(first, second);
        const auto ours = [](const b2Vec2 &v) { return bmr_vec32{v.x, v.y}; };
        const bmr_edge32 same = {ours(edge.m_vertex0), ours(edge.m_vertex1), ours(edge.m_vertex2),
                                 ours(edge.m_vertex3), edge.m_oneSided};
        const bmr_vec32 ends[2] = {same.first, same.second}, normals[2] = {{1.0f, 0.0f}, {-1.0f, 0.0f}};
        const bmr_convex32 segment = {ends, normals, nullptr, 2, 0, {0.0f, 0.0f}, nullptr};
        const float skin = polygon.box2d.m_radius + edge.m_radius;
        const bmr_transform32 at = pose_against(d, &polygon.view, &pose, &segment, double{skin});
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
