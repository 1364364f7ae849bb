// SPDX-License-Identifier: MIT
// core/exact32 against Box2D itself. Box2D keeps its separations to itself, but its early exit tells: with
// the sum of the radii set to exactly the largest separation it goes on, with one float less it leaves.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cfloat>
#include <cmath>
#include <cstring>

#include "box2d_shapes.h"
#include "exact32/exact32.h"
#include "start/rounding_probe.h"
#include "test_scale.h"

namespace {

// A value of b2Manifold::Type that b2CollidePolygons never sets.
constexpr b2Manifold::Type kUntouched = b2Manifold::e_circles;

bmr_polygon32 Polygon32(const b2PolygonShape &shape) {
    return {reinterpret_cast<const bmr_vec32 *>(shape.m_vertices),
            reinterpret_cast<const bmr_vec32 *>(shape.m_normals), shape.m_count};
}

bmr_transform32 Transform32(const b2Transform &xf) {
    return {{xf.p.x, xf.p.y}, xf.q.s, xf.q.c};
}

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
Pair RandomPair(shapes::Engine &engine) {
    Pair pair;
    pair.a = shapes::RandomPolygon(engine, 60.0);
    pair.b = shapes::RandomPolygon(engine, 60.0);
    const double range = std::pow(10.0, shapes::Uniform(engine, -1.0, 3.0));
    pair.xfA = shapes::RandomPose(engine, range);
    pair.xfB = shapes::RandomPose(engine, std::pow(10.0, shapes::Uniform(engine, -2.0, 2.0)));
    pair.xfB.p += pair.xfA.p;
    return pair;
}

using MaxSeparation = float (*)(const bmr_polygon32 *, const bmr_polygon32 *, const bmr_transform32 *,
                                int32_t *);

float LargestSeparation(const Pair &pair, MaxSeparation max) {
    const bmr_polygon32 a = Polygon32(pair.a), b = Polygon32(pair.b);
    const bmr_transform32 ta = Transform32(pair.xfA), tb = Transform32(pair.xfB);
    const bmr_transform32 aInB = bmr_exact32_relative(&tb, &ta), bInA = bmr_exact32_relative(&ta, &tb);
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
    shapes::Engine engine(1);
    const size_t count = test_scaled(100000);
    size_t apart = 0, differentSse = 0, differentScalar = 0, differentContracted = 0;
    for (size_t i = 0; i < count; ++i) {
        const Pair pair = RandomPair(engine);
        const float separation = LargestSeparation(pair, bmr_exact32_max_separation);
        apart += separation > 0.0f;
        differentSse += !IsBox2Ds(pair, separation);
        differentScalar += !IsBox2Ds(pair, LargestSeparation(pair, bmr_exact32_max_separation_scalar));
        differentContracted += !IsBox2Ds(pair, LargestSeparation(pair, ContractedMax));
    }
    CHECK(apart > count / 10);
    CHECK(apart < count - count / 10);
    CHECK(differentSse == 0);
    CHECK(differentScalar == 0);
    // Control: fused multiply-add, mathematically the same, is told apart.
    CHECK(differentContracted > count / 10);
}

TEST_CASE("relative frames have the bits of b2MulT") {
    shapes::Engine engine(2);
    size_t different = 0;
    for (size_t i = 0; i < test_scaled(100000); ++i) {
        const double range = std::pow(10.0, shapes::Uniform(engine, -3.0, 5.0));
        const b2Transform a = shapes::RandomPose(engine, range), b = shapes::RandomPose(engine, range);
        const b2Transform expected = b2MulT(a, b);
        const bmr_transform32 ta = Transform32(a), tb = Transform32(b);
        const bmr_transform32 frame = bmr_exact32_relative(&ta, &tb);
        different += std::memcmp(&frame, &expected, sizeof frame) != 0;
    }
    CHECK(different == 0);
}

TEST_CASE("an edge that separates by more than the radii means no points from Box2D") {
    shapes::Engine engine(3);
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
            const bmr_transform32 from = Transform32(ofB ? pair.xfB : pair.xfA),
                                  to = Transform32(ofB ? pair.xfA : pair.xfB);
            const bmr_transform32 frame = bmr_exact32_relative(&to, &from);
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
    shapes::Engine engine(4);
    size_t different = 0;
    for (size_t i = 0; i < 1000; ++i) {
        const Pair pair = RandomPair(engine);
        different += !IsBox2Ds(pair, LargestSeparation(pair, bmr_exact32_max_separation_scalar));
    }
    CHECK(bmr::Box2DRoundsAsExact32() == (different == 0));
}
