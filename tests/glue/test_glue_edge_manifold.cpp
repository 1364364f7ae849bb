// SPDX-License-Identifier: MIT
// The manifold of an edge and a polygon of core/exact32 against b2CollideEdgeAndPolygon itself, byte by byte,
// what is not written included. Where Box2D has another one, it is left alone: this program stands in front
// of the function (ELF lets it).
#include <box2d/b2_edge_shape.h>
#include <dlfcn.h>

#include "as_stock.h"
#include "box2d_shapes.h"
#include "glue/contacts/solid_contact.h"
#include "shapes/shapes32.h"
#include "start/install.h"

using namespace as_stock;

namespace {

/// What a game could make of Box2D's rules for edges, or a compiler of its function.
enum class Rules { kBox2Ds, kTwoSided, kOneSided, kNormalOff, kPointOff, kOtherId };
Rules rules = Rules::kBox2Ds;

} // namespace

void CollideEdge(b2Manifold *manifold, const b2EdgeShape *a, const b2Transform &xfA, const b2PolygonShape *b,
                 const b2Transform &xfB) __asm__("_Z23b2CollideEdgeAndPolygonP10b2ManifoldPK11b2EdgeShapeRK11"
                                                 "b2TransformPK14b2PolygonShapeS6_");
void CollideEdge(b2Manifold *manifold, const b2EdgeShape *a, const b2Transform &xfA, const b2PolygonShape *b,
                 const b2Transform &xfB) {
    static const auto real = reinterpret_cast<decltype(&CollideEdge)>(
        dlsym(RTLD_NEXT,
              "_Z23b2CollideEdgeAndPolygonP10b2ManifoldPK11b2EdgeShapeRK11b2TransformPK14b2PolygonShapeS6_"));
    b2EdgeShape edge = *a;
    if (rules == Rules::kTwoSided || rules == Rules::kOneSided)
        edge.m_oneSided = rules == Rules::kOneSided;
    real(manifold, &edge, xfA, b, xfB);
    b2ManifoldPoint &last = manifold->points[manifold->pointCount > 1];
    if (manifold->pointCount > 0 && rules == Rules::kNormalOff)
        manifold->localNormal.y = std::nextafter(manifold->localNormal.y, b2_maxFloat);
    if (manifold->pointCount > 0 && rules == Rules::kPointOff)
        last.localPoint.x = std::nextafter(last.localPoint.x, b2_maxFloat);
    if (manifold->pointCount > 0 && rules == Rules::kOtherId)
        last.id.cf.indexB ^= 1;
}

namespace {

using namespace shapes;

struct Scene {
    b2EdgeShape edge;
    b2PolygonShape polygon;
    b2Transform xfA, xfB;
};

struct Tally {
    size_t scenes = 0, different = 0, leftOut = 0, points[3] = {}, faceB = 0, cut = 0, skipped = 0;
};

/// True where ours left it to Box2D.
bool Ours(const Scene &s, b2Manifold *manifold) {
    const bmr_edge32 edge = bmr::Edge32(s.edge);
    const bmr_polygon32 polygon = bmr::Polygon32(s.polygon);
    return !bmr_exact32_collide_edge(bmr::Manifold32(manifold), &edge, bmr::Transform32(s.xfA), &polygon,
                                     *bmr::Vectors32(&s.polygon.m_centroid), bmr::Transform32(s.xfB),
                                     s.polygon.m_radius + s.edge.m_radius);
}

void Compare(const Scene &s, Tally *t) {
    constexpr int kUnwritten = 0x5a; // neither side writes that by accident
    b2Manifold expected, found;
    std::memset(static_cast<void *>(&expected), kUnwritten, sizeof expected);
    std::memset(static_cast<void *>(&found), kUnwritten, sizeof found);
    b2CollideEdgeAndPolygon(&expected, &s.edge, s.xfA, &s.polygon, s.xfB);
    ++t->scenes;
    if (Ours(s, &found)) {
        ++t->leftOut;
        return;
    }
    ++t->points[expected.pointCount];
    t->faceB += expected.pointCount > 0 && expected.type == b2Manifold::e_faceB;
    for (int i = 0; i < expected.pointCount; ++i)
        t->cut += expected.type == b2Manifold::e_faceA &&
                  expected.points[i].id.cf.typeA == b2ContactFeature::e_vertex;
    Scene twoSided = s;
    twoSided.edge.m_oneSided = false;
    b2Manifold other;
    b2CollideEdgeAndPolygon(&other, &twoSided.edge, s.xfA, &s.polygon, s.xfB);
    t->skipped += other.pointCount > 0 && expected.pointCount == 0;
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bits
    t->different += std::memcmp(&expected, &found, sizeof found) != 0;
}

/// A multiple of a quarter, so that many things are equal to the bit.
float Rounded(float x, bool onGrid) {
    return onGrid ? 0.25f * std::round(4.0f * x) : x;
}

/// A link between two neighbours, and a polygon of which a vertex or the middle of a face lies close by.
Scene Near(Engine &engine, bool onGrid) {
    Scene s;
    const auto point = [&](float size) {
        return b2Vec2(Rounded(UniformF(engine, -size, size), onGrid),
                      Rounded(UniformF(engine, -size, size), onGrid));
    };
    b2Vec2 chain[4] = {point(2.0f), {}, {}, {}};
    for (int i = 1; i < 4; ++i) {
        do
            chain[i] = chain[i - 1] + point(2.0f);
        while ((chain[i] - chain[i - 1]).LengthSquared() < 1e-4f);
    }
    if (Below(engine, 3) == 0)
        s.edge.SetTwoSided(chain[1], chain[2]);
    else
        s.edge.SetOneSided(chain[0], chain[1], chain[2], chain[3]);
    if (onGrid)
        s.polygon.SetAsBox(0.25f * Real(1 + Below(engine, 4)), 0.5f);
    else
        s.polygon = shapes::RandomPolygon(engine, 1.0 + Below(engine, 3));
    if (Below(engine, 4) == 0)
        s.polygon.m_radius = UniformF(engine, 0.0, 0.2);
    s.xfA.Set(point(5.0f), onGrid ? 0.0f : UniformF(engine, -3.2, 3.2));
    s.xfB.Set(b2Vec2_zero, onGrid ? 0.0f : UniformF(engine, -3.2, 3.2));
    const int32 i = Below(engine, s.polygon.m_count), next = i + 1 < s.polygon.m_count ? i + 1 : 0;
    const float along = Rounded(UniformF(engine, -0.2, 1.2), onGrid),
                on = Below(engine, 2) == 0 ? 0.0f : 0.5f;
    if (!onGrid && Below(engine, 3) == 0) { // the face lies on the edge
        const b2Vec2 e = chain[2] - chain[1], f = s.polygon.m_vertices[next] - s.polygon.m_vertices[i];
        s.xfB.q.Set(s.xfA.q.GetAngle() + std::atan2(-e.y, -e.x) - std::atan2(f.y, f.x) +
                    UniformF(engine, -0.01, 0.01));
    }
    const b2Vec2 on_edge = chain[1] + along * (chain[2] - chain[1]);
    const b2Vec2 on_face =
        s.polygon.m_vertices[i] + on * (s.polygon.m_vertices[next] - s.polygon.m_vertices[i]);
    const float off = onGrid ? 0.0f : UniformF(engine, -0.04, 0.06);
    b2Vec2 normal = b2Cross(chain[2] - chain[1], Below(engine, 4) == 0 ? -1.0f : 1.0f);
    normal.Normalize();
    s.xfB.p = b2Mul(s.xfA, on_edge + off * normal) - b2Mul(s.xfB.q, on_face);
    return s;
}

void CheckAllCameUp(const Tally &t) {
    CHECK(t.different == 0);
    for (const size_t points : t.points)
        CHECK(points > t.scenes / 100);
    CHECK(t.faceB > t.scenes / 500);
    CHECK(t.cut > t.scenes / 500);
    CHECK(t.skipped > t.scenes / 500);
}

} // namespace

TEST_CASE("an edge near a polygon has Box2D's manifold") {
    Engine engine(1);
    Tally t;
    for (size_t i = 0; i < test_scaled(400000); ++i)
        Compare(Near(engine, false), &t);
    CHECK(t.leftOut == 0);
    CheckAllCameUp(t);
}

TEST_CASE("so it has where many numbers are equal") {
    Engine engine(2);
    Tally t;
    for (size_t i = 0; i < test_scaled(400000); ++i)
        Compare(Near(engine, true), &t);
    CHECK(t.leftOut == 0);
    CHECK(t.different == 0);
}

TEST_CASE("what is not finite is left to Box2D, or has its manifold") {
    Engine engine(3);
    Tally t;
    for (size_t i = 0; i < test_scaled(100000); ++i) {
        Scene s = Near(engine, i % 2 == 0);
        b2Vec2 &normal = s.polygon.m_normals[Below(engine, s.polygon.m_count)];
        float *const fields[] = {&s.edge.m_vertex1.x,
                                 &s.edge.m_vertex2.y,
                                 &s.edge.m_vertex0.x,
                                 &s.edge.m_vertex3.y,
                                 &s.polygon.m_vertices[1].x,
                                 &normal.x,
                                 &normal.y,
                                 &s.xfA.p.x,
                                 &s.xfB.q.s,
                                 &s.polygon.m_radius,
                                 &s.polygon.m_centroid.x};
        constexpr float kBad[] = {std::numeric_limits<float>::quiet_NaN(),
                                  std::numeric_limits<float>::infinity(), -1e30f, 3e38f};
        *fields[Below(engine, 11)] = kBad[Below(engine, 4)];
        Compare(s, &t);
    }
    CHECK(t.leftOut > 0);
    CHECK(t.different == 0);
}

TEST_CASE("a Box2D that collides edges by other rules, or to other bits, is noticed") {
    const bool stock = bmr::Box2DCollidesEdgesAsExact32();
    for (const Rules other :
         {Rules::kTwoSided, Rules::kOneSided, Rules::kNormalOff, Rules::kPointOff, Rules::kOtherId}) {
        rules = other;
        CHECK(!bmr::Box2DCollidesEdgesAsExact32());
    }
    rules = Rules::kBox2Ds;
    CHECK(bmr::Box2DCollidesEdgesAsExact32() == stock);
}

TEST_CASE("contacts of edges are ours, and a Box2D that collides edges otherwise is refused") {
    const auto install = [](Run &run) {
        run.Print("%s", StderrOf([] { bmr::Install(); }).c_str());
        Game game(run);
        b2EdgeShape edge;
        edge.SetTwoSided({-1.0f, 0.0f}, {1.0f, 0.0f});
        game.Fixture(game.Body(b2_staticBody, {0.0f, 0.0f}), edge);
        game.Box({0.0f, 0.5f});
        game.world.Step(0.0f, 1, 1);
        run.Print("%d", bmr::EdgeContact::AsOurs(game.world.GetContactList()) != nullptr);
    };
    const auto inChild = [&install] { return InChild(install); };
    CHECK(inChild() == "\n1\n");
    rules = Rules::kTwoSided;
    CHECK(inChild() ==
          "boomerang: not at work, Box2D runs as it is: edges collide by other rules in this Box2D\n\n0\n");
    rules = Rules::kBox2Ds;
}
