// SPDX-License-Identifier: MIT
// Rays and drawings of outlines, whose pieces' seams neither lets a ray through nor stops it, and nobody
// sees: against the outline itself.
#include <box2d/box2d.h>

#include "boomerang/box2d_glue.h"
#include "boomerang/outline_shape.h"
#include "box2d_shapes.h"
#include "cases.h"
#include "small_world.h"

using Ring = std::vector<b2Vec2>;

namespace {

const Ring kTee = {{-1, -3}, {1, -3}, {1, 0}, {4, 0}, {4, 2}, {-4, 2}, {-4, 0}, {-1, 0}};
const Ring kPlus = {{-1, -3}, {1, -3}, {1, -1}, {3, -1}, {3, 1},   {1, 1},
                    {1, 3},   {-1, 3}, {-1, 1}, {-3, 1}, {-3, -1}, {-1, -1}};
const Ring kWindow = {{-0.5f, -0.75f}, {-0.75f, 0.5f}, {0.75f, 0.75f}, {0.5f, -0.5f}}; // of kPlus, clockwise
const Ring kSteps = {{-3, 0}, {1, 0}, {1, 2}, {3, 2}, {3, 4}, {-1, 4}, {-1, 2}, {-3, 2}};

using shapes::Below, shapes::UniformF, shapes::Engine;

/// (Braces: arguments in their order, whatever the compiler.)
b2Vec2 GridPoint(Engine &engine, int most) {
    return b2Vec2{static_cast<float>(Below(engine, 2 * most + 1) - most),
                  static_cast<float>(Below(engine, 2 * most + 1) - most)};
}
b2Vec2 Point(Engine &engine, double most) {
    return b2Vec2{UniformF(engine, -most, most), UniformF(engine, -most, most)};
}

double Cross(b2Vec2 a, b2Vec2 b) {
    return double{a.x} * double{b.y} - double{a.y} * double{b.x};
}

/// Around the origin, through points of a grid: counter-clockwise, all its products exact.
Ring Star(Engine &engine) {
    Ring ring;
    const int count = 6 + Below(engine, 8);
    for (int i = 0; i < count; ++i) {
        const b2Vec2 p = GridPoint(engine, 8);
        bool alone = p.x != 0.0f || p.y != 0.0f;
        for (const b2Vec2 &q : ring)
            alone = alone && !(Cross(p, q) == 0.0 && b2Dot(p, q) > 0.0f);
        if (alone)
            ring.push_back(p);
    }
    std::sort(ring.begin(), ring.end(),
              [](b2Vec2 a, b2Vec2 b) { return std::atan2(a.y, a.x) < std::atan2(b.y, b.x); });
    return ring;
}

b2Vec2 Next(const Ring &ring, size_t i) {
    return ring[i + 1 < ring.size() ? i + 1 : 0];
}
b2Vec2 Last(const Ring &ring, size_t i) {
    return ring[i > 0 ? i - 1 : ring.size() - 1];
}

/// Adds where the line from p1 to p2 crosses edges, and whether it comes in there: all in order. False where
/// it is too near to a vertex, or p1 to an edge, to say by floats.
bool Crossings(const Ring &ring, b2Vec2 p1, b2Vec2 p2, std::vector<std::pair<double, bool>> *found) {
    const b2Vec2 way = p2 - p1;
    for (size_t i = 0; i < ring.size(); ++i) {
        const b2Vec2 a = ring[i], edge = Next(ring, i) - a;
        const double begin = Cross(way, a - p1), end = Cross(way, Next(ring, i) - p1);
        if (std::fabs(begin) < 0.01 * double{way.Length()})
            return false;
        if (std::fabs(Cross(edge, p1 - a)) < 0.01 * double{edge.Length()})
            return false;
        if ((begin > 0.0) == (end > 0.0))
            continue;
        const double at = Cross(a - p1, edge) / Cross(way, edge);
        if (at > 0.0 && at < 1.0)
            found->emplace_back(at, begin > 0.0);
    }
    std::sort(found->begin(), found->end());
    return true;
}

/// Exactly: from p1, does one see vertex i, and is the outline's inside right behind it?
bool SeesInside(const Ring &ring, b2Vec2 p1, size_t i) {
    const b2Vec2 to = ring[i], way = to - p1, ahead = Next(ring, i) - to, behind = Last(ring, i) - to;
    const bool corner = Cross(ahead, behind) > 0.0; // less than half a turn from ahead to behind is inside
    const bool left = Cross(ahead, way) > 0.0, right = Cross(way, behind) > 0.0;
    if (Cross(ahead, way) == 0.0 || Cross(way, behind) == 0.0 || !(corner ? left && right : left || right))
        return false;
    bool inside = false;
    for (size_t k = 0; k < ring.size(); ++k) {
        const b2Vec2 a = ring[k], b = Next(ring, k), edge = b - a;
        if ((a.y > p1.y) != (b.y > p1.y))
            inside = inside != ((Cross(edge, p1 - a) > 0.0) == (b.y > a.y));
        if (k == i || (k + 1) % ring.size() == i)
            continue;
        const double begin = Cross(way, a - p1), end = Cross(way, b - p1), from = Cross(edge, p1 - a),
                     here = Cross(edge, to - a);
        if (begin * end <= 0.0 && from * here <= 0.0)
            return false;
    }
    const b2Vec2 back = -way; // and it comes from outside
    const bool fromLeft = Cross(ahead, back) > 0.0, fromRight = Cross(back, behind) > 0.0;
    return !inside && !(corner ? fromLeft && fromRight : fromLeft || fromRight);
}

struct Cast final : b2RayCastCallback {
    float ReportFixture(b2Fixture *, const b2Vec2 &, const b2Vec2 &n, float f) override {
        fraction = f;
        normal = n;
        return f;
    }
    float fraction = 2.0f; ///< none
    b2Vec2 normal = {0.0f, 0.0f};
};

Cast CastRay(const b2World &world, b2Vec2 p1, b2Vec2 p2) {
    Cast cast;
    world.RayCast(&cast, p1, p2);
    return cast;
}

b2Body *AddOutline(b2World &world, const bmr::OutlineShape &outline, b2Vec2 place = {0.0f, 0.0f}) {
    b2Body *body = AddBody(world, b2_staticBody, place);
    REQUIRE(outline.CreateFixtures(body, 1.0f) == BMR_OK);
    return body;
}

bool Cut(const Ring &ring, bmr::OutlineShape *outline, const Ring &window = {}) {
    const bmr::OutlineHole hole = {window.data(), static_cast<int32>(window.size())};
    return outline->Set(ring.data(), static_cast<int32>(ring.size()), &hole, window.empty() ? 0 : 1) ==
           BMR_OK;
}

struct Pen final : IdleDraw {
    void DrawSolidPolygon(const b2Vec2 *v, int32 count, const b2Color &) override {
        for (int32 i = 2; i < count; ++i)
            area += 0.5 * Cross(v[i - 1] - v[0], v[i] - v[0]);
    }
    void DrawSegment(const b2Vec2 &a, const b2Vec2 &b, const b2Color &) override {
        segments.emplace_back(a, b);
    }
    double area = 0.0; ///< of the pieces
    std::vector<std::pair<b2Vec2, b2Vec2>> segments;
};

} // namespace

TEST_CASE("a ray that aims at a vertex of an outline comes in there") {
    Engine engine(19);
    int aimed = 0, wrong = 0, sideways = 0;
    for (int trial = 0; trial < 600; ++trial) {
        const Ring ring = Star(engine);
        bmr::OutlineShape outline;
        if (ring.size() < 5 || !Cut(ring, &outline) || outline.GetPieceCount() < 3)
            continue;
        b2World world(b2Vec2(0.0f, 0.0f));
        AddOutline(world, outline);
        for (int i = 0; i < 20; ++i) {
            const size_t at = static_cast<size_t>(Below(engine, static_cast<int>(ring.size())));
            const b2Vec2 to = ring[at], from = GridPoint(engine, 32);
            if (!SeesInside(ring, from, at))
                continue;
            ++aimed;
            // (The end is exact, and so is the vertex on the ray.)
            const Cast hit = CastRay(world, from, from + 3.0f * (to - from));
            wrong += !(std::fabs(hit.fraction - 1.0f / 3.0f) < 1e-4f);
            sideways += hit.fraction < 1.0f && !(b2Dot(hit.normal, to - from) < 0.0f);
        }
    }
    CHECK(aimed > 1000);
    CHECK(wrong == 0);
    CHECK(sideways == 0);
}

TEST_CASE("a ray hits where it comes in from outside, and nowhere else, wherever it begins") {
    Engine engine(20);
    int fromInside = 0, inAgain = 0;
    std::vector<std::pair<double, bool>> crossings;
    for (int trial = 0; trial < 60; ++trial) {
        const Ring ring = trial % 4 == 0   ? Star(engine)
                          : trial % 4 == 1 ? kTee
                          : trial % 4 == 2 ? kPlus
                                           : kSteps;
        const Ring window = trial % 8 == 2 ? kWindow : Ring();
        bmr::OutlineShape outline;
        if (!Cut(ring, &outline, window))
            continue;
        b2World world(b2Vec2(0.0f, 0.0f));
        AddOutline(world, outline);
        for (int i = 0; i < 40; ++i) {
            const b2Vec2 p1 = Point(engine, 8.0f), p2 = Point(engine, 8.0f);
            crossings.clear();
            if (!Crossings(ring, p1, p2, &crossings) || !Crossings(window, p1, p2, &crossings))
                continue;
            double expected = 2.0;
            for (auto c = crossings.rbegin(); c != crossings.rend(); ++c)
                expected = c->second ? c->first : expected;
            const bool inside = !crossings.empty() && !crossings.front().second;
            fromInside += inside;
            inAgain += inside && expected < 1.0;
            CAPTURE(trial);
            CAPTURE(i);
            CHECK(CastRay(world, p1, p2).fraction == doctest::Approx(expected).epsilon(1e-4));
        }
    }
    CHECK(fromInside > 100);
    CHECK(inAgain > 10);
}

TEST_CASE("a ray that runs along the outline, or begins on it, finds no seam") {
    // A ground of many pieces that is flat on top.
    Ring ring;
    for (int i = 0; i <= 12; ++i)
        ring.emplace_back(static_cast<float>(i), i % 2 == 0 ? -1.0f : -0.5f);
    for (int i = 12; i >= 0; --i)
        ring.emplace_back(static_cast<float>(i), 0.0f);
    bmr::OutlineShape outline;
    REQUIRE(Cut(ring, &outline));
    REQUIRE(outline.GetPieceCount() > 4);
    b2World world(b2Vec2(0.0f, 0.0f));
    AddOutline(world, outline);
    for (const float y : {0.0f, 1e-7f, -1e-7f, -1e-3f})
        for (const float down : {0.0f, 1e-7f, -1e-7f})
            for (const float x : {0.5f, 1.0f, 3.0f})
                CHECK(CastRay(world, b2Vec2(x, y), b2Vec2(13.0f, y - down)).fraction > 1.0f);
    // Inside, a hair past a notch.
    for (const float x : {1.0f, 3.0f, 5.0f, 7.0f, 9.0f, 11.0f})
        for (const float way : {0.5f, -0.5f})
            CHECK(CastRay(world, b2Vec2(x - way, -0.39999f), b2Vec2(x + way, -0.59999f)).fraction > 1.0f);
    // From a point of it into the ground.
    for (const float x : {1.0f, 1.5f, 2.0f, 6.0f})
        for (const float along : {-1.0f, -0.3f, 0.0f, 0.3f, 1.0f})
            CHECK(CastRay(world, b2Vec2(x, 0.0f), b2Vec2(x + along, -0.4f)).fraction > 1.0f);
}

TEST_CASE("what is left of a body whose pieces go singly keeps its seams") {
    bmr::OutlineShape outline;
    REQUIRE(Cut(kTee, &outline));
    b2World world(b2Vec2(0.0f, 0.0f));
    b2Body *body = AddOutline(world, outline), *alone = AddOutline(world, outline, b2Vec2(20.0f, 0.0f));
    REQUIRE(outline.GetPieceCount() == 2);
    alone->DestroyFixture(alone->GetFixtureList());
    b2Body *other = AddOutline(world, outline, b2Vec2(40.0f, 0.0f));
    other->DestroyFixture(other->GetFixtureList()->GetNext());
    outline = bmr::OutlineShape();
    world.DestroyBody(body);
    // Down and up through the seam between the two pieces: each comes out of the other.
    int hits = 0;
    for (const float x : {20.0f, 40.0f})
        for (const float way : {1.0f, -1.0f})
            hits += CastRay(world, b2Vec2(x, 0.5f * way), b2Vec2(x, -0.5f * way)).fraction < 1.0f;
    CHECK(hits == 0);
    // By their faces they are hit.
    CHECK(CastRay(world, b2Vec2(23.0f, -1.0f), b2Vec2(23.0f, 1.0f)).fraction +
              CastRay(world, b2Vec2(43.0f, -1.0f), b2Vec2(43.0f, 1.0f)).fraction ==
          2.5f);
}

TEST_CASE("of an outline each edge is drawn once, also those that pieces share with others") {
    Engine engine(21);
    for (int trial = 0; trial < 60; ++trial) {
        CAPTURE(trial);
        const Ring ring = trial == 0 ? kTee : trial == 1 ? kPlus : trial == 2 ? kSteps : Star(engine);
        bmr::OutlineShape outline;
        if (!Cut(ring, &outline) || outline.GetPieceCount() < 2)
            continue;
        b2World world(b2Vec2(0.0f, 0.0f));
        AddOutline(world, outline);
        Pen pen;
        bmr::DrawConvexShapes(world, pen);
        float length = 0.0f, drawn = 0.0f;
        double area = 0.0;
        for (const auto &segment : pen.segments)
            drawn += (segment.second - segment.first).Length();
        for (size_t i = 0; i < ring.size(); ++i) {
            const b2Vec2 a = ring[i], b = Next(ring, i), middle = 0.5f * (a + b);
            length += (b - a).Length();
            area += 0.5 * Cross(a, b);
            int covered = 0;
            for (const auto &segment : pen.segments)
                covered += std::fabs((segment.first - middle).Length() + (segment.second - middle).Length() -
                                     (segment.first - segment.second).Length()) < 1e-5f;
            CHECK(covered == 1);
        }
        CHECK(drawn == doctest::Approx(length).epsilon(1e-5));
        CHECK(pen.area == doctest::Approx(area).epsilon(1e-5));
        if (trial < 3)
            CHECK(pen.segments.size() == ring.size());
    }
}
