// SPDX-License-Identifier: MIT
// ContactMargin and kReach against Box2D itself: just beyond the margin, within the reach, never a point.
#include <box2d/b2_block_allocator.h>
#include <box2d/box2d.h>

#include "box2d_shapes.h"
#include "cases.h"
#include "glue/proofs/hull_pair.h"
#include "glue/proofs/thresholds.h"
#include "start/settings.h"

namespace {

struct Pair {
    b2PolygonShape a, b;
    b2Transform xfA, xfB;

    double RadiusSum() const { return double{a.m_radius} + double{b.m_radius}; }
    int Points() const {
        b2Manifold manifold;
        b2CollidePolygons(&manifold, &a, xfA, &b, xfB);
        return manifold.pointCount;
    }
};

/// Two fixtures around (x, y), not placed yet. A third has Box2D's own radius, the others anything up to 1.
Pair RandomPair(shapes::Engine &engine, double x, double y, double extent) {
    Pair pair;
    pair.a = shapes::RandomPolygon(engine, extent);
    pair.b = shapes::RandomPolygon(engine, extent);
    if (shapes::Below(engine, 3) != 0) {
        pair.a.m_radius = static_cast<float>(std::pow(10.0, shapes::Uniform(engine, -4.0, 0.0)));
        pair.b.m_radius = static_cast<float>(std::pow(10.0, shapes::Uniform(engine, -4.0, 0.0)));
    }
    pair.xfA = shapes::RandomPose(engine, 0.0);
    pair.xfB = shapes::RandomPose(engine, 0.0);
    // Axis-aligned boxes meet corner to corner in the most symmetric way.
    if (shapes::Below(engine, 8) == 0) {
        pair.a.SetAsBox(shapes::UniformF(engine, 0.1, 1.0), shapes::UniformF(engine, 0.1, 1.0));
        pair.b.SetAsBox(shapes::UniformF(engine, 0.1, 1.0), shapes::UniformF(engine, 0.1, 1.0));
        pair.xfA.q.SetIdentity();
        pair.xfB.q.SetIdentity();
    }
    pair.xfA.p.Set(static_cast<float>(x), static_cast<float>(y));
    return pair;
}

bool IsBeyond(const exact::Gap &gap, double distance) {
    return !gap.overlap && exact::IsMoreThan(exact::Square(gap.way), distance);
}

b2Vec2 Middle(const b2PolygonShape &polygon) {
    b2Vec2 sum(0.0f, 0.0f);
    for (int32 i = 0; i < polygon.m_count; ++i)
        sum += polygon.m_vertices[i];
    return (1.0f / static_cast<float>(polygon.m_count)) * sum;
}

/// Moves b in along a random line through the middle of a, to where the distance is just above `wanted`:
/// rounded outward, a few floats more.
bool PlaceOnLine(shapes::Engine &engine, Pair *pair, double wanted, exact::Gap *gap) {
    const double angle = shapes::Uniform(engine, -3.2, 3.2);
    const double ux = std::cos(angle), uy = std::sin(angle);
    const shapes::Point a = shapes::Place(pair->xfA, Middle(pair->a)),
                        b = shapes::Place(pair->xfB, Middle(pair->b));
    const shapes::Point from = {double{pair->xfB.p.x} + a.x - b.x, double{pair->xfB.p.y} + a.y - b.y};
    const exact::Posed still = shapes::PosedOf(pair->a, pair->xfA);
    exact::Posed moved = shapes::PosedOf(pair->b, pair->xfB);
    const auto move = [&](double t) {
        pair->xfB.p.Set(static_cast<float>(from.x + t * ux), static_cast<float>(from.y + t * uy));
        moved.pose.position = {pair->xfB.p.x, pair->xfB.p.y};
    };
    // The distance changes no faster than t does: a step by what is left never goes too far.
    double t = 300.0;
    for (int i = 0; i < 100; ++i) {
        move(t);
        const double left = static_cast<double>(exact::NearDistance(still, moved)) - wanted;
        if (left < 1e-6)
            break;
        t -= left;
    }
    *gap = exact::GapOf(still, moved);
    for (double outward = 1e-7; outward < 0.1 && !IsBeyond(*gap, wanted); outward *= 2.0) {
        move(t + outward);
        *gap = exact::GapOf(still, moved);
    }
    return IsBeyond(*gap, wanted);
}

/// Puts a corner of b at the wanted distance from a corner of a, until these are the closest points. Every
/// other time in the direction of the diagonal of Box2D's clipping box there, where it gives points longest.
bool PlaceCorners(shapes::Engine &engine, Pair *pair, double wanted, exact::Gap *gap) {
    const b2Transform start = pair->xfB;
    const exact::Posed still = shapes::PosedOf(pair->a, pair->xfA);
    exact::Posed moved = shapes::PosedOf(pair->b, start);
    for (int tries = 0; tries < 200; ++tries) {
        const int corner = shapes::Below(engine, pair->a.m_count);
        double angle = shapes::Uniform(engine, -3.2, 3.2);
        if (tries % 2 == 0) {
            const b2Vec2 normal = b2Mul(pair->xfA.q, pair->a.m_normals[corner]);
            const double towards = shapes::Below(engine, 2) == 0 ? -1.0 : 1.0; // either end of its edge
            angle = std::atan2(double{normal.y}, double{normal.x}) + towards * 0.785398163397448 +
                    shapes::Uniform(engine, -1.0, 1.0) * std::pow(10.0, shapes::Uniform(engine, -6.0, -1.0));
        }
        const double d = wanted * (1.0 + std::pow(10.0, shapes::Uniform(engine, -9.0, -4.0)));
        const b2Vec2 &mine = pair->a.m_vertices[(corner + shapes::Below(engine, 2)) % pair->a.m_count],
                     &theirs = pair->b.m_vertices[shapes::Below(engine, pair->b.m_count)];
        const shapes::Point a = shapes::Place(pair->xfA, mine), b = shapes::Place(start, theirs);
        pair->xfB.p.Set(static_cast<float>(double{start.p.x} + a.x - b.x + d * std::cos(angle)),
                        static_cast<float>(double{start.p.y} + a.y - b.y + d * std::sin(angle)));
        moved.pose.position = {pair->xfB.p.x, pair->xfB.p.y};
        if (exact::NearDistance(still, moved) < 0.9 * wanted)
            continue; // other corners are nearer
        *gap = exact::GapOf(still, moved);
        if (gap->corners && IsBeyond(*gap, wanted))
            return true;
    }
    return false;
}

struct Tally {
    size_t placed = 0, cornersOnly = 0, points = 0;
};

/// `margin(radius sum)` is what is claimed to mean: no points.
template <typename Margin> Tally Try(size_t count, double lowest, double highest, Margin margin) {
    shapes::Engine engine(5);
    Tally tally;
    constexpr double kExtent = 30.0;
    for (size_t i = 0; i < count; ++i) {
        const double far = shapes::Uniform(engine, lowest, highest),
                     along = shapes::Uniform(engine, -far, far);
        const bool flip = shapes::Below(engine, 2) == 0;
        Pair pair = RandomPair(engine, flip ? along : far, flip ? -far : along, kExtent);
        const double wanted = margin(pair.RadiusSum());
        exact::Gap gap;
        if (!(i % 2 == 0 ? PlaceOnLine : PlaceCorners)(engine, &pair, wanted, &gap))
            continue;
        ++tally.placed;
        tally.cornersOnly += gap.corners;
        tally.points += pair.Points() > 0;
    }
    return tally;
}

// Extents included, as kReach is meant: two fixtures, each within 30 of its body's origin (times sqrt(2) for
// the offset of its centre), the second body's origin up to 100 farther out.
constexpr double kInner = bmr::kReach - 200.0;

} // namespace

TEST_CASE("just beyond ContactMargin and within kReach Box2D gives no points") {
    for (const double range : {1.0, kInner}) {
        const Tally t = Try(test_scaled(150000), 0.0, range, [](double r) { return bmr::ContactMargin(r); });
        CHECK(t.placed > test_scaled(150000) * 9 / 10);
        CHECK(t.cornersOnly > t.placed / 3);
        CHECK(t.points == 0);
    }
}

TEST_CASE("nor farther out, beyond the margin of the band") {
    for (int band = 1; band < bmr::kBands; ++band) {
        const double reach = std::ldexp(double{bmr::kBandReach}, band);
        const Tally t = Try(test_scaled(30000), 0.5 * reach, reach - 200.0,
                            [band](double r) { return bmr::ContactMargin(r, bmr::BandMargin(band)); });
        CHECK(t.placed > test_scaled(30000) * 9 / 10);
        CHECK(t.points == 0);
    }
}

TEST_CASE("control: a margin without the diagonal is refuted") {
    const Tally t = Try(test_scaled(20000), 0.0, 1.0, [](double r) { return r + bmr::kRoundingMargin; });
    CHECK(t.points > 0);
}

TEST_CASE("control: a margin a tenth of the rounding margin inside the diagonal is refuted, near and far") {
    for (const double range : {1.0, kInner}) {
        const Tally t = Try(test_scaled(20000), 0.0, range,
                            [](double r) { return bmr::ContactMargin(r) - 1.1 * bmr::kRoundingMargin; });
        CHECK(t.points > 0);
    }
}

TEST_CASE("every threshold derives from Box2D's constants") {
    // Radii below a slop count as one.
    CHECK(bmr::ContactMargin(0.0) == bmr::ContactMargin(double{b2_linearSlop}));
    CHECK(bmr::ContactMargin(-1.0) == bmr::ContactMargin(0.0));
    CHECK(bmr::ContactMargin(std::nan("")) == bmr::ContactMargin(0.0)); // Box2D gives no points there
    const double polygons = 2.0 * b2_polygonRadius, exact = std::sqrt(2.0) * polygons + bmr::kRoundingMargin;
    CHECK(bmr::ContactMargin(polygons) > exact);
    CHECK(bmr::ContactMargin(polygons) < exact + 1e-6);
}

namespace {

/// A needle that points to the right. A side too short for Box2D to make a unit vector of cuts its tip off;
/// its normal is nearly that of the needle's upper side.
b2PolygonShape CutNeedle(float side) {
    b2PolygonShape needle;
    const b2Vec2 points[] = {{-10.0f, -0.5f}, {0.0f, 0.0f}, {-10.0f, 0.5f}};
    needle.Set(points, 3);
    int32 tip = 0;
    while (needle.m_vertices[tip].x != 0.0f)
        ++tip;
    REQUIRE(needle.m_count == 3);
    const b2Vec2 below = needle.m_vertices[(tip + 2) % 3], above = needle.m_vertices[(tip + 1) % 3];
    const b2Vec2 lower = needle.m_normals[(tip + 2) % 3];
    const b2Vec2 cut(0.1f, std::sqrt(0.99f));
    needle.m_count = 4;
    needle.m_vertices[0] = below;
    needle.m_normals[0] = lower;
    needle.m_vertices[1].SetZero();
    needle.m_normals[1] = cut;
    needle.m_vertices[2] = side * b2Vec2(-cut.y, cut.x);
    needle.m_vertices[3] = above;
    needle.m_normals[2] = b2Cross(above - needle.m_vertices[2], 1.0f);
    needle.m_normals[2].Normalize();
    needle.m_normals[3].Set(-1.0f, 0.0f);
    return needle;
}

} // namespace

TEST_CASE("a side too short for a direction: Box2D gives points far away, and no hull says apart") {
    bmr::MakeSettings(bmr::Options());
    for (const float side : {1e-8f, 1e-3f}) {
        CAPTURE(side);
        b2World world(b2Vec2(0.0f, 0.0f));
        b2BodyDef def;
        b2Body *a = world.CreateBody(&def), *b = world.CreateBody(&def);
        const b2PolygonShape needle = CutNeedle(side);
        b2PolygonShape other;
        const b2Vec2 points[] = {{0.0f, 0.0f}, {10.0f, -0.5f}, {10.0f, 0.5f}};
        other.Set(points, 3);
        a->CreateFixture(&needle, 0.0f);
        b->CreateFixture(&other, 0.0f);
        b->SetTransform({0.15f, 0.0f}, 0.0f);
        REQUIRE(exact::SignedDistance(shapes::PosedOf(needle, a->GetTransform()),
                                      shapes::PosedOf(other, b->GetTransform())) > 0.14L);
        b2Manifold manifold;
        b2CollidePolygons(&manifold, &needle, a->GetTransform(), &other, b->GetTransform());
        CHECK((manifold.pointCount > 0) == (side < FLT_EPSILON));

        bmr::Hull hullA(a, nullptr), hullB(b, nullptr);
        bmr::HullPair pair;
        pair.a = &hullA;
        pair.b = &hullB;
        if (side < FLT_EPSILON) {
            CHECK(hullA.Shape().polygon == nullptr); // contacts leave such a pair alone
            CHECK_FALSE(hullA.MakeHold(*a->GetFixtureList()));
        } else {
            CHECK(hullA.MakeHold(*a->GetFixtureList()));
            CHECK(bmr::KnownApart(&pair, a->GetTransform(), b->GetTransform()));
        }
        // In place, inside of the hull of what it was.
        if (side > FLT_EPSILON) {
            *static_cast<b2PolygonShape *>(a->GetFixtureList()->GetShape()) = CutNeedle(1e-8f);
            CHECK_FALSE(hullA.MakeHold(*a->GetFixtureList()));
        }
    }
}

TEST_CASE("normals of other sides: Box2D gives points far away, and no hull says apart") {
    bmr::MakeSettings(bmr::Options());
    b2World world(b2Vec2(0.0f, 0.0f));
    b2BodyDef def;
    b2Body *a = world.CreateBody(&def), *b = world.CreateBody(&def);
    b2PolygonShape box, spoilt;
    box.SetAsBox(0.5f, 0.5f, {3.0f, 1.0f}, 0.7f); // its vertices are rounded, turned and moved
    a->CreateFixture(&box, 0.0f);
    b->CreateFixture(&box, 0.0f);
    b->SetTransform(b2Mul(b2Rot(0.7f), b2Vec2(0.0f, 3.0f)), 0.0f);
    const auto hasHull = [](b2Body *body) { return bmr::Hull(body, nullptr).Shape().polygon != nullptr; };
    CHECK(hasHull(a)); // the control
    for (int kind = 0; kind < 6; ++kind) {
        CAPTURE(kind);
        spoilt = box;
        for (int32 i = 0; i < spoilt.m_count; ++i) {
            b2Vec2 &n = spoilt.m_normals[i];
            if (kind == 0)
                n.SetZero();
            else if (kind == 1)
                n = -n;
            else if (kind == 2)
                n *= 2.0f;
            else if (kind == 3)
                n = b2Mul(b2Rot(1e-3f), n);
            else if (kind == 5)
                n = b2Mul(b2Rot(8e-6f), n); // more than rounding does, 3 m from the body's origin
        }
        if (kind == 4)
            spoilt.m_vertices[1] = 1.2f * spoilt.m_vertices[1];
        b2PolygonShape &shape = *static_cast<b2PolygonShape *>(a->GetFixtureList()->GetShape());
        shape = spoilt;
        CHECK_FALSE(hasHull(a));
        if (kind == 0) {
            b2Manifold manifold;
            b2CollidePolygons(&manifold, &shape, a->GetTransform(), &shape, b->GetTransform());
            CHECK(manifold.pointCount > 0);
        }
    }
}
