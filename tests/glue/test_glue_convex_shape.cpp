// SPDX-License-Identifier: MIT
// bmr::ConvexShape as a shape: what it is up to 8 vertices and above, and what goes wrong.
#include <csignal>

#include <box2d/box2d.h>

#include "boomerang/convex_shape.h"
#include "box2d_shapes.h"
#include "in_child.h"
#include "shapes/big_polygons.h"

using bmr::ConvexShape;
using namespace shapes;
using Points = std::vector<b2Vec2>;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

bmr_error Set(ConvexShape &shape, const Points &points) {
    return shape.Set(points.data(), static_cast<int32>(points.size()));
}

bool SameBits(const b2PolygonShape &a, const b2PolygonShape &b) {
    const size_t size = static_cast<size_t>(a.m_count) * sizeof(b2Vec2);
    return a.m_count == b.m_count && std::memcmp(a.m_vertices, b.m_vertices, size) == 0 &&
           std::memcmp(a.m_normals, b.m_normals, size) == 0 &&
           std::memcmp(&a.m_centroid, &b.m_centroid, sizeof a.m_centroid) == 0 && a.m_radius == b.m_radius;
}

/// Does Box2D's own Set end the program on these points? In a child, for it may.
bool StockAsserts(const Points &points) {
    const auto set = [&points](as_stock::Run &) {
        const rlimit none = {0, 0};
        setrlimit(RLIMIT_CORE, &none);
        std::signal(SIGABRT, SIG_DFL);
        std::fclose(stderr);
        b2PolygonShape().Set(points.data(), static_cast<int32>(points.size()));
    };
    return as_stock::InChild(set) != "";
}

bool Welds(const Points &points) {
    const float weld = 0.5f * b2_linearSlop;
    for (size_t i = 0; i < points.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            if (b2DistanceSquared(points[i], points[j]) < weld * weld)
                return true;
    return false;
}

/// 3 to 8 points, many of them bad ones: lattices (points on lines), tiny, huge, next to each other.
Points AnyPoints(Engine &engine) {
    Points points;
    const int count = 3 + Below(engine, 6), kind = Below(engine, 6);
    const float size = static_cast<float>(std::pow(10.0, kind == 0   ? Uniform(engine, -4.0, -2.0)
                                                         : kind == 1 ? Uniform(engine, 5.0, 38.0)
                                                                     : Uniform(engine, -2.5, 3.0)));
    for (int i = 0; i < count; ++i) {
        b2Vec2 p(UniformF(engine, -1.0, 1.0), UniformF(engine, -1.0, 1.0));
        if (kind == 2)
            p.Set(static_cast<float>(Below(engine, 4)), static_cast<float>(Below(engine, 4)));
        if (kind == 3)
            p.y = p.x + 1e-7f * static_cast<float>(Below(engine, 3));
        points.push_back(size * p);
    }
    if (kind == 4)
        points[0] = points[1] + b2Vec2(UniformF(engine, 0.0, 0.004), 0.0f);
    return points;
}

/// Is the shape counter-clockwise and convex, of some of the points, with all of them inside but for
/// rounding?
bool IsHull(const ConvexShape &shape, const Points &points) {
    const int32 count = shape.GetVertexCount();
    double size = 0.0;
    for (const b2Vec2 &p : points)
        size = std::max({size, std::fabs(double{p.x}), std::fabs(double{p.y})});
    for (int32 i = 0; i < count; ++i) {
        const b2Vec2 &a = shape.GetVertex(i), &b = shape.GetVertex((i + 1) % count);
        if (std::find(points.begin(), points.end(), a) == points.end())
            return false;
        const double x = double{b.x} - double{a.x}, y = double{b.y} - double{a.y}, length = std::hypot(x, y);
        for (const b2Vec2 &p : points) {
            const double left = (x * (double{p.y} - double{a.y}) - y * (double{p.x} - double{a.x})) / length;
            if (left < -0.5 * double{b2_linearSlop} - 2e-7 * size)
                return false;
        }
    }
    return count >= 3;
}

struct Drawn : IdleDraw {
    struct Polygon {
        Points points;
        b2Color color;
    };
    std::vector<Polygon> polygons;
    void DrawSolidPolygon(const b2Vec2 *v, int32 count, const b2Color &color) override {
        polygons.push_back({Points(v, v + count), color});
    }
};

} // namespace

TEST_CASE("up to 8 vertices a shape is what Set makes, to the bit, where Set does not assert") {
    const bool assertsAreOn = StockAsserts({{0, 0}, {1, 1}, {2, 2}});
    Engine engine(1);
    size_t accepted = 0, refused = 0, mended = 0, welding = 0;
    for (size_t k = 0; k < test_scaled(2000); ++k) {
        const Points points = AnyPoints(engine);
        ConvexShape shape;
        bmr::Welded welded;
        const bmr_error error = shape.Set(points.data(), static_cast<int32>(points.size()), &welded);
        if (error == BMR_OK && (!assertsAreOn || StockAsserts(points))) {
            ++mended;
            CHECK(IsHull(shape, points));
        } else if (error == BMR_OK) {
            ++accepted;
            CHECK((welded.count > 0) == Welds(points));
            welding += welded.count > 0 ? 1u : 0u;
            b2PolygonShape stock;
            stock.Set(points.data(), static_cast<int32>(points.size()));
            CHECK(SameBits(shape, stock));
            CHECK(bmr::BigPolygonOf(shape) == nullptr);
            CHECK(shape.GetVertexCount() == stock.m_count);
            CHECK(shape.GetVertices() == shape.m_vertices);
            // Raw, from any vertex on.
            const int first = Below(engine, stock.m_count);
            Points turned;
            for (int i = 0; i < stock.m_count; ++i)
                turned.push_back(stock.m_vertices[(first + i) % stock.m_count]);
            ConvexShape raw;
            if (raw.SetRaw(turned.data(), stock.m_count) == BMR_OK)
                CHECK(std::memcmp(raw.m_vertices, turned.data(), turned.size() * sizeof(b2Vec2)) == 0);
        } else if (assertsAreOn && refused++ < 200) {
            CAPTURE(error);
            // Or its numbers overflowed.
            CHECK((StockAsserts(points) || error == BMR_ERROR_OUT_OF_RANGE));
            CHECK(shape.m_count == 0);
            // Nothing is refused that more points make a hull of.
            Points more = points;
            while (more.size() <= b2_maxPolygonVertices)
                more.push_back(points[0]);
            CHECK((Set(shape, more) != BMR_OK || error == BMR_ERROR_OUT_OF_RANGE ||
                   error == BMR_ERROR_TOO_CLOSE)); // the hull's points alone may weld to more
        }
    }
    MESSAGE(accepted, " as Set makes them, ", welding, " of them welded; ", mended, " on which it asserts; ",
            refused, " refused");
    CHECK(accepted > 0);
    CHECK(welding > 0);
    CHECK((refused > 0 || !assertsAreOn));

    // More than 8 points with a small hull: Set gets the hull.
    Points cloud = {{2, 0}, {2, 1}, {-1, 1}, {-1, 0}};
    for (int i = 0; i < 20; ++i)
        cloud.emplace_back(UniformF(engine, -1.0, 2.0), UniformF(engine, 0.0, 1.0));
    ConvexShape shape;
    REQUIRE(Set(shape, cloud) == BMR_OK);
    b2PolygonShape stock;
    stock.Set(cloud.data(), 4);
    CHECK(SameBits(shape, stock));
    cloud[4].Set(2.0f, 0.001f);
    cloud[0].Set(1.9999f, 0.0f);
    bmr::Welded welded;
    REQUIRE(shape.Set(cloud.data(), static_cast<int32>(cloud.size()), &welded) == BMR_OK);
    CHECK(shape.m_count == 4);
    CHECK(welded.count == 1);
    CHECK(welded.distance == doctest::Approx(0.001005).epsilon(0.01));
}

TEST_CASE("where Set's wrapping finds no hull, the exact one is taken") {
    const uint32_t bits[][2] = {{0xC1078533, 0x3F0BAB5E}, {0xC0F5B2E8, 0x3F28AF8C}, {0xC0E2B14A, 0x3F3E72AE},
                                {0xC0EBC298, 0x402E521E}, {0xC1158EA9, 0x401C2F82}, {0xC1110602, 0x3EEBD078}};
    Points points(6);
    for (size_t i = 0; i < 6; ++i) {
        std::memcpy(&points[i].x, &bits[i][0], sizeof(float));
        std::memcpy(&points[i].y, &bits[i][1], sizeof(float));
    }
    ConvexShape shape, nine;
    REQUIRE(Set(shape, points) == BMR_OK);
    CHECK(shape.m_count == 5);
    CHECK(IsHull(shape, points));
    CHECK(shape.Validate());
    b2MassData mass;
    shape.ComputeMass(&mass, 1.0f);
    CHECK(mass.mass == doctest::Approx(4.0).epsilon(0.1));
    // The same points, some of them twice: one rule for all counts.
    bmr::Welded welded;
    points.insert(points.end(), {points[0], points[0], points[3]});
    REQUIRE(nine.Set(points.data(), 9, &welded) == BMR_OK);
    CHECK(SameBits(nine, shape));
    CHECK(welded.count == 3);
    CHECK(welded.distance == 0.0f);
    // An area that ComputeMass takes for nothing.
    CHECK(Set(shape, {{-1.59567082f, 17.0135956f},
                      {-1.59138489f, 17.0341377f},
                      {-1.59669149f, 17.0086594f},
                      {-1.59607673f, 17.0115528f},
                      {-1.59285641f, 17.0270634f}}) == BMR_ERROR_OUT_OF_RANGE);
}

TEST_CASE("points in the place of others are left out, whatever their number, and that is told") {
    Points square = {{0, 0}, {80, 0}, {80, 80}, {80, 80}};
    for (int more = 0; more < 8; ++more, square.push_back(square[0])) {
        ConvexShape shape;
        bmr::Welded welded;
        REQUIRE(shape.Set(square.data(), static_cast<int32>(square.size()), &welded) == BMR_OK);
        CHECK(shape.m_count == 3);
        CHECK(welded.count == 1 + more);
        CHECK(welded.distance == 0.0f);
    }
    // A finer polygon than welding allows keeps its vertices; one of few vertices that is made by its size is
    // not made of less.
    ConvexShape fine;
    bmr::Welded welded;
    Points circle = Circle(200, 0.05);
    circle.push_back(circle[7]);
    REQUIRE(fine.Set(circle.data(), 201, &welded) == BMR_OK);
    CHECK(fine.GetVertexCount() == 200);
    CHECK(welded.count == 1);
    CHECK(fine.SetRegular(8, 0.003f) == BMR_ERROR_TOO_CLOSE);
    CHECK(fine.GetVertexCount() == 200);
    CHECK(fine.Set(circle.data(), 201, nullptr) == BMR_ERROR_NULL_ARGUMENT);
    const Points close = {{0, 0}, {0.001f, 0}, {0, 0.001f}}, equal = {{1, 1}, {1, 1}, {1, 1}};
    welded.count = 77;
    CHECK(fine.Set(close.data(), 3, &welded) == BMR_ERROR_TOO_CLOSE);
    CHECK(fine.Set(equal.data(), 3, &welded) == BMR_ERROR_TOO_FEW_POINTS);
    CHECK(welded.count == 77);
}

TEST_CASE("a shape whose vertices are changed in place is what they say") {
    const b2Transform origin(b2Vec2_zero, b2Rot(0.0f));
    ConvexShape shape, copy;
    REQUIRE(shape.SetRegular(100, 1.0f) == BMR_OK);
    b2PolygonShape *const base = &shape;
    const b2Vec2 before = base->m_vertices[3];
    base->m_vertices[3] = 0.5f * before; // and back
    CHECK(shape.GetVertexCount() == 8);
    base->m_vertices[3] = before;
    CHECK(shape.GetVertexCount() == 100);
    base->SetAsBox(3.0f, 0.25f);
    copy = shape;
    b2PolygonShape box;
    box.SetAsBox(3.0f, 0.25f);
    for (const ConvexShape *s : {&shape, &copy}) {
        CHECK(bmr::BigPolygonOf(*s) == nullptr);
        CHECK(s->GetVertexCount() == 4);
        CHECK(s->TestPoint(origin, b2Vec2(2.5f, 0.0f)));
        CHECK_FALSE(s->TestPoint(origin, b2Vec2(0.0f, 0.75f)));
        b2MassData mass, boxMass;
        s->ComputeMass(&mass, 1.0f);
        box.ComputeMass(&boxMass, 1.0f);
        CHECK(mass.mass == boxMass.mass);
        CHECK(mass.I == boxMass.I);
        b2AABB bounds;
        s->ComputeAABB(&bounds, origin, 0);
        CHECK(bounds.upperBound.x == doctest::Approx(3.01));
    }
    REQUIRE(shape.SetRegular(50, 1.0f) == BMR_OK);
    CHECK(shape.GetVertexCount() == 50);
    const size_t polygons = bmr::registry::Count();
    copy = shape;
    CHECK(bmr::registry::Count() == polygons - 1); // what was changed was kept until then
}

TEST_CASE("above 8 vertices every question is answered from the real polygon, as a loop over it would") {
    Engine engine(2);
    size_t inside = 0, hits = 0, octagonDiffers = 0;
    for (size_t k = 0; k < test_scaled(200); ++k) {
        const int count = 9 + Below(engine, k % 8 == 0 ? 2000 : 100);
        ConvexShape shape;
        REQUIRE(Set(shape, Circle(count, Uniform(engine, 0.1, 10.0), Uniform(engine, -5.0, 5.0), 1.0)) ==
                BMR_OK);
        shape.m_radius = UniformF(engine, 0.0, 0.1);
        const int32 n = shape.GetVertexCount();
        REQUIRE(n > 8);
        REQUIRE(bmr::BigPolygonOf(shape) != nullptr);
        CHECK(shape.m_count >= 7);
        CHECK(shape.Validate());
        CHECK(shape.GetChildCount() == 1);
        for (int q = 0; q < 40; ++q) {
            const b2Transform xf = shapes::RandomPose(engine, 20.0);
            b2AABB box, octagon;
            shape.ComputeAABB(&box, xf, 0);
            shape.b2PolygonShape::ComputeAABB(&octagon, xf, 0);
            CHECK(box.Contains(octagon));
            octagonDiffers += !octagon.Contains(box);
            b2Vec2 lower(kInfinity, kInfinity), upper(-kInfinity, -kInfinity);
            for (int32 i = 0; i < n; ++i) {
                lower = b2Min(lower, b2Mul(xf, shape.GetVertex(i)));
                upper = b2Max(upper, b2Mul(xf, shape.GetVertex(i)));
            }
            const b2Vec2 skin(shape.m_radius, shape.m_radius);
            CHECK(box.lowerBound == lower - skin);
            CHECK(box.upperBound == upper + skin);

            const b2Vec2 point(UniformF(engine, lower.x, upper.x), UniformF(engine, lower.y, upper.y));
            const b2Vec2 local = b2MulT(xf.q, point - xf.p);
            bool in = true;
            for (int32 i = 0; i < n && in; ++i)
                in = !(b2Dot(shape.GetNormal(i), local - shape.GetVertex(i)) > 0.0f);
            CHECK(shape.TestPoint(xf, point) == in);
            inside += in;

            b2RayCastInput ray;
            ray.p1.Set(UniformF(engine, -40.0, 40.0), UniformF(engine, -40.0, 40.0));
            ray.p2 = point;
            ray.maxFraction = 1.0f;
            b2RayCastOutput output;
            output.fraction = -1.0f;
            const b2Vec2 p1 = b2MulT(xf.q, ray.p1 - xf.p), d = b2MulT(xf.q, ray.p2 - xf.p) - p1;
            const bool hit = shape.RayCast(&output, ray, xf, 0);
            CHECK((hit || !in || shape.TestPoint(xf, ray.p1)));
            if (hit) {
                ++hits;
                const b2Vec2 at = p1 + output.fraction * d;
                float most = -kInfinity;
                for (int32 i = 0; i < n; ++i)
                    most = std::max(most, b2Dot(shape.GetNormal(i), at - shape.GetVertex(i)));
                CHECK(std::abs(most) < 1e-4f);
                CHECK(b2Dot(output.normal, b2Mul(xf.q, d)) < 0.0f);
            }
        }
        // Many small triangles, in double.
        double area = 0.0, x = 0.0, y = 0.0, inertia = 0.0;
        for (int32 i = 0; i < n; ++i) {
            const double ax = shape.GetVertex(i).x, ay = shape.GetVertex(i).y;
            const double bx = shape.GetVertex((i + 1) % n).x, by = shape.GetVertex((i + 1) % n).y;
            const double cross = ax * by - ay * bx;
            area += cross / 2.0;
            x += cross * (ax + bx) / 6.0;
            y += cross * (ay + by) / 6.0;
            inertia += cross * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by) / 12.0;
        }
        b2MassData mass;
        shape.ComputeMass(&mass, 2.5f);
        CHECK(mass.mass == doctest::Approx(2.5 * area).epsilon(1e-6));
        CHECK(mass.I == doctest::Approx(2.5 * inertia).epsilon(1e-6));
        CHECK(mass.center.x == doctest::Approx(x / area).epsilon(1e-5));
        CHECK(mass.center.y == doctest::Approx(y / area).epsilon(1e-5));
        CHECK(mass.center == shape.m_centroid);
    }
    CHECK(inside > 0);
    CHECK(hits > 0);
    CHECK(octagonDiffers > 0);
}

TEST_CASE("regular, rounded and simplified polygons have the vertices that they should") {
    ConvexShape shape;
    for (const int32 count : {3, 4, 8, 9, 100, 4096, 12000}) {
        REQUIRE(shape.SetRegular(count, 2.0f) == BMR_OK);
        CHECK(shape.GetVertexCount() == count);
        CHECK(shape.GetVertex(0) == b2Vec2(2.0f, 0.0f));
        for (int32 i = 0; i < count; ++i)
            CHECK(std::abs(shape.GetVertex(i).Length() - 2.0f) < 3e-7f);
    }
    REQUIRE(shape.SetRegular(65535, 0.5f) == BMR_OK);
    CHECK(shape.GetVertexCount() > 20000);

    REQUIRE(shape.SetEllipse(64, 4.0f, 0.5f) == BMR_OK);
    CHECK(shape.GetVertexCount() == 64);
    CHECK(shape.GetVertex(16) == b2Vec2(0.0f, 0.5f));

    REQUIRE(shape.SetRounded(2.0f, 1.0f, 0.25f, 8) == BMR_OK);
    CHECK(shape.GetVertexCount() == 32);
    b2AABB box;
    b2Transform identity;
    identity.SetIdentity();
    shape.ComputeAABB(&box, identity, 0);
    CHECK(box.upperBound.x == 2.0f + shape.m_radius);
    CHECK(box.lowerBound.y == -1.0f - shape.m_radius);
    REQUIRE(shape.SetRounded(2.0f, 1.0f, 1.0f, 16) == BMR_OK); // a capsule: its sides' ends are shared
    CHECK(shape.GetVertexCount() == 62);
    b2MassData mass;
    shape.ComputeMass(&mass, 1.0f);
    CHECK(mass.mass == doctest::Approx(4.0 + 3.14159265).epsilon(0.01));
    REQUIRE(shape.SetRounded(1.0f, 1.0f, 1.0f, 17) == BMR_OK); // a disk
    CHECK(shape.GetVertexCount() == 64);
    REQUIRE(shape.SetRounded(2.0f, 1.0f, 0.5f, 2) == BMR_OK); // a box without corners
    CHECK(shape.GetVertexCount() == 8);

    REQUIRE(shape.SetRegular(4096, 1.0f) == BMR_OK);
    REQUIRE(shape.Simplify(1e-3f) == BMR_OK);
    CHECK(shape.GetVertexCount() < 200);
    CHECK(shape.GetVertexCount() > 60);
    REQUIRE(shape.Simplify(0.2f) == BMR_OK); // Box2D's own from here on
    CHECK(shape.GetVertexCount() <= 8);
    CHECK(bmr::BigPolygonOf(shape) == nullptr);
    const int32 left = shape.GetVertexCount();
    REQUIRE(shape.Simplify(0.0f) == BMR_OK);
    CHECK(shape.GetVertexCount() == left);
}

TEST_CASE("drawn are the real polygons, in the colours of DebugDraw") {
    b2World world(b2Vec2(0.0f, -10.0f));
    Drawn box2d, ours;
    box2d.SetFlags(b2Draw::e_shapeBit);
    world.SetDebugDraw(&box2d);
    ConvexShape shape;
    REQUIRE(shape.SetRegular(40, 0.5f) == BMR_OK);
    for (int i = 0; i < 6; ++i) {
        b2BodyDef def;
        def.type = i == 0 ? b2_staticBody : i == 1 ? b2_kinematicBody : b2_dynamicBody;
        def.position.Set(10.0f * static_cast<float>(i), 3.0f);
        def.awake = i != 2;
        def.enabled = i != 3;
        world.CreateBody(&def)->CreateFixture(&shape, i == 4 ? 0.0f : 1.0f);
    }
    b2PolygonShape plain;
    plain.SetAsBox(1.0f, 1.0f);
    b2BodyDef def;
    def.position.Set(0.0f, -20.0f);
    world.CreateBody(&def)->CreateFixture(&plain, 1.0f);
    world.DebugDraw();
    bmr::DrawConvexShapes(world, ours, bmr::DrawAs::Whole);
    REQUIRE(ours.polygons.size() == 6);
    REQUIRE(box2d.polygons.size() == 7); // newest body first
    for (size_t i = 0; i < 6; ++i) {
        CHECK(ours.polygons[i].points.size() == 40);
        const b2Color &a = ours.polygons[i].color, &b = box2d.polygons[i + 1].color;
        CHECK((a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a));
        CHECK((ours.polygons[i].points[0] - box2d.polygons[i + 1].points[0]).Length() < 1e-5f);
    }
}

namespace {

double AreaOf(const Points &points) {
    double area = 0.0;
    for (size_t i = 0; i < points.size(); ++i) {
        const b2Vec2 &p = points[i], &q = points[(i + 1) % points.size()];
        area += 0.5 * (double{p.x} * double{q.y} - double{q.x} * double{p.y});
    }
    return area;
}

} // namespace

TEST_CASE("unless asked for whole polygons, a drawer gets no more than 8 vertices at a time") {
    for (const int32 count : {9, 13, 14, 15, 20, 1000}) {
        CAPTURE(count);
        b2World world({0.0f, 0.0f});
        ConvexShape shape;
        REQUIRE(shape.SetRegular(count, 1.0f) == BMR_OK);
        b2BodyDef def;
        def.position.Set(3.0f, -2.0f);
        def.angle = 0.7f;
        world.CreateBody(&def)->CreateFixture(&shape, 1.0f);
        Drawn pieces, whole;
        bmr::DrawConvexShapes(world, pieces);
        bmr::DrawConvexShapes(world, whole, bmr::DrawAs::Whole);
        REQUIRE(whole.polygons.size() == 1);
        double area = 0.0;
        size_t corners = 2; // each piece shares two with the one before
        for (const Drawn::Polygon &piece : pieces.polygons) {
            CHECK(piece.points.size() >= 3);
            CHECK(piece.points.size() <= b2_maxPolygonVertices);
            const double part = AreaOf(piece.points);
            CHECK(part > 0.0); // the same way around
            area += part;
            corners += piece.points.size() - 2;
        }
        CHECK(corners == static_cast<size_t>(count));
        CHECK(area == doctest::Approx(AreaOf(whole.polygons[0].points)).epsilon(1e-5));
    }
}

TEST_CASE("a polygon that is a point beside what it reaches is taken") {
    // Ten vertices, eight of them nearer to each other than the rounding of the others' products.
    std::vector<b2Vec2> points = {{0x1p+29f, 0x1.09fc78p+27f}, {-0x1p+29f, 0x1.9f0ca8p+28f}};
    const float near[][2] = {{-0x1.3b9402p-24f, -0x1.ea529cp-26f}, {-0x1.39c4b2p-24f, -0x1.edc692p-26f},
                             {-0x1.37f22cp-24f, -0x1.f11f2ap-26f}, {-0x1.361c8ep-24f, -0x1.f45c36p-26f},
                             {-0x1.3443fp-24f, -0x1.f77d8ap-26f},  {-0x1.32686cp-24f, -0x1.fa82f6p-26f},
                             {-0x1.308a1ep-24f, -0x1.fd6c52p-26f}, {-0x1.2ea92p-24f, -0x1.001cbap-25f}};
    for (const auto &p : near)
        points.push_back({p[0], p[1]});
    ConvexShape shape;
    CHECK(shape.Set(points.data(), static_cast<int32>(points.size())) == BMR_OK);
    CHECK(shape.GetVertexCount() == 10);
    // What Box2D would see of it are vertices of its own.
    for (int32 i = 0; i < shape.m_count; ++i)
        CHECK(std::find(points.begin(), points.end(), shape.m_vertices[i]) != points.end());
}

TEST_CASE("SetAsBox makes Box2D's box of any shape, and lets the polygon go") {
    const b2Vec2 center(0.25f, -3.0f);
    b2PolygonShape box, turned;
    box.SetAsBox(1.5f, 0.25f);
    turned.SetAsBox(1.5f, 0.25f, center, 0.7f);
    for (const b2PolygonShape *expected : {&box, &turned}) {
        bmr::ConvexShape shape;
        REQUIRE(shape.SetRegular(100, 1.0f) == BMR_OK);
        CHECK(shape.SetAsBox(0.0f, 1.0f) == BMR_ERROR_OUT_OF_RANGE);
        CHECK(shape.SetAsBox(1.0f, NAN, center, 0.0f) == BMR_ERROR_NOT_FINITE);
        CHECK(shape.SetAsBox(1.0f, 1.0f, center, INFINITY) == BMR_ERROR_NOT_FINITE);
        CHECK(shape.GetVertexCount() == 100); // an error leaves it
        const bmr_error error =
            expected == &box ? shape.SetAsBox(1.5f, 0.25f) : shape.SetAsBox(1.5f, 0.25f, center, 0.7f);
        CHECK(error == BMR_OK);
        CHECK(shape.GetVertexCount() == 4);
        CHECK(std::memcmp(shape.GetVertices(), expected->m_vertices, 4 * sizeof(b2Vec2)) == 0);
        CHECK(std::memcmp(&shape.GetNormal(0), expected->m_normals, 4 * sizeof(b2Vec2)) == 0);
        CHECK(std::memcmp(&shape.m_centroid, &expected->m_centroid, sizeof(b2Vec2)) == 0);
    }
}
