// SPDX-License-Identifier: MIT
// Distance, cast and time of impact of polygons of any size: up to 255 vertices against Box2D's own
// algorithms fed with all of them, and of the largest polygons against rational arithmetic. (Of others,
// what is true: tests/random/fuzz_convex32.cpp.)
#include <box2d/b2_time_of_impact.h>

#include "boomerang/convex_shape.h"
#include "cases.h"
#include "convex_oracle.h"
#include "glue/proofs/convex_distance.h"

using namespace oracle;
using namespace shapes;

namespace {

// Radii of polygons of Box2D's, of none, and of a fat one.
float RandomRadius(Engine &engine) {
    const int kind = Below(engine, 4);
    return kind == 0 ? 0.0f : kind == 1 ? UniformF(engine, 0.0, 0.3) : b2_polygonRadius;
}

Polygon RandomShape(Engine &engine, int most) {
    const int kind = Below(engine, 8);
    if (kind == 0) // a circle
        return Polygon({b2Vec2(UniformF(engine, -1.0, 1.0), UniformF(engine, -1.0, 1.0))},
                       UniformF(engine, 0.05, 1.0));
    if (kind == 1) // an edge
        return Polygon({b2Vec2(UniformF(engine, -2.0, 2.0), UniformF(engine, -2.0, 2.0)),
                        b2Vec2(UniformF(engine, -2.0, 2.0), UniformF(engine, -2.0, 2.0))},
                       b2_polygonRadius);
    return oracle::RandomPolygon(engine, 3 + Below(engine, kind == 2 ? 6 : most - 2), RandomRadius(engine));
}

const bmr_transform32 *Pose32(const b2Transform &xf) {
    return reinterpret_cast<const bmr_transform32 *>(&xf);
}

float Reach(const Polygon &a, const Polygon &b) {
    return std::max(a.Ours().reach, b.Ours().reach);
}

bmr_distance32 Ask(const Polygon &a, const b2Transform &xfA, const Polygon &b, const b2Transform &xfB,
                   bmr_closest32 *closest) {
    const bmr_proxy32 pa = a.Ours(), pb = b.Ours();
    return bmr_convex32_distance(&pa, Pose32(xfA), &pb, Pose32(xfB), closest);
}

/// A pose of b from where the two overlap to some way off.
b2Transform NearbyPose(Engine &engine, const Polygon &a, const Polygon &b) {
    return shapes::RandomPose(engine, 1.5 * double{a.Ours().reach + b.Ours().reach});
}

} // namespace

TEST_CASE("the distance of the largest polygons is the exact one") {
    Engine engine(6);
    double worst = 0.0;
    for (size_t i = 0; i < test_scaled(60); ++i) {
        const Polygon a = oracle::RandomPolygon(engine, i % 3 == 0 ? 65535 : 4096, b2_polygonRadius);
        const Polygon b = RandomShape(engine, 40);
        bmr_closest32 closest = {0, 0};
        for (int k = 0; k < 4; ++k) {
            const b2Transform xfA = shapes::RandomPose(engine, 10.0);
            b2Transform xfB = NearbyPose(engine, a, b);
            xfB.p += xfA.p;
            const double truth = Distance(Placed(a, xfA), Placed(b, xfB));
            const bmr_distance32 found = Ask(a, xfA, b, xfB, &closest);
            const double scale = std::max(truth, double{Reach(a, b)});
            worst = std::max(worst, std::fabs(double{found.distance} - truth) / scale);
            CHECK(found.iterations < 40);
        }
    }
    MESSAGE("worst error ", worst);
    CHECK(worst <= 1e-6);
}

TEST_CASE("up to 255 vertices the distance and its points are those of b2Distance") {
    Engine engine(2);
    double worst = 0.0, worstPoint = 0.0;
    for (size_t i = 0; i < test_scaled(4000); ++i) {
        const Polygon a = oracle::RandomPolygon(engine, 9 + Below(engine, 247), b2_polygonRadius);
        const Polygon b = RandomShape(engine, 255);
        b2DistanceInput input;
        input.proxyA = a.Stock();
        input.proxyB = b.Stock();
        input.transformA = shapes::RandomPose(engine, 5.0);
        input.transformB = NearbyPose(engine, a, b);
        input.useRadii = false;
        b2SimplexCache cache;
        cache.count = 0;
        b2DistanceOutput stock;
        b2Distance(&stock, &cache, &input);
        bmr_closest32 closest = {0, 0};
        const bmr_distance32 ours = Ask(a, input.transformA, b, input.transformB, &closest);
        // What Box2D's coordinates of the world are rounded to.
        const double scale = 10.0 + double{a.Ours().reach + b.Ours().reach};
        worst = std::max(worst, std::fabs(double{stock.distance - ours.distance}) / scale);
        if (stock.distance == 0.0f || stock.iterations >= 20)
            continue;
        // Of points, what lies between them; where two sides are parallel any of them may be said.
        const b2Vec2 between(ours.point_b.x - ours.point_a.x, ours.point_b.y - ours.point_a.y);
        const double off = double{(between - (stock.pointB - stock.pointA)).Length()};
        if (stock.distance > 0.01f)
            worstPoint = std::max(worstPoint, off / scale);
    }
    MESSAGE("worst distance ", worst, ", worst vector ", worstPoint);
    CHECK(worst <= 1e-6);
    CHECK(worstPoint <= 1e-4);
}

namespace {

b2Sweep RandomSweep(Engine &engine, double range, double way, double turn) {
    b2Sweep sweep;
    sweep.localCenter.Set(UniformF(engine, -1.0, 1.0), UniformF(engine, -1.0, 1.0));
    sweep.c0.Set(UniformF(engine, -range, range), UniformF(engine, -range, range));
    sweep.c = sweep.c0 + b2Vec2(UniformF(engine, -way, way), UniformF(engine, -way, way));
    sweep.a0 = UniformF(engine, -10.0, 10.0);
    sweep.a = sweep.a0 + UniformF(engine, -turn, turn);
    sweep.alpha0 = 0.0f;
    return sweep;
}

struct Motion {
    b2Sweep a, b;
};

Motion RandomMotion(Engine &engine, const Polygon &a, const Polygon &b) {
    const double size = double{a.Ours().reach + b.Ours().reach};
    const double turn = Below(engine, 2) == 0 ? 0.3 : 6.0;
    Motion m = {RandomSweep(engine, size, size, Below(engine, 3) == 0 ? 0.0 : turn),
                RandomSweep(engine, size, 2.0 * size, Below(engine, 3) == 0 ? 0.0 : turn)};
    if (Below(engine, 3) == 0)
        m.a.c = m.a.c0;
    return m;
}

struct Impact {
    bmr_impact32 state;
    float t;
};

Impact AskImpact(const Polygon &a, const Polygon &b, const Motion &motion, float tMax, bmr_vec32 *direction) {
    const bmr_proxy32 pa = a.Ours(), pb = b.Ours();
    const bmr_sweep32 sa = oracle::Sweep32(motion.a), sb = oracle::Sweep32(motion.b);
    Impact impact;
    impact.state = bmr_convex32_impact(&pa, &sa, &pb, &sb, tMax, b2_linearSlop, direction, &impact.t);
    return impact;
}

double DistanceAt(const Polygon &a, const Polygon &b, const Motion &motion, double t) {
    return Distance(oracle::At(a, motion.a, t), oracle::At(b, motion.b, t));
}

/// Is the proxy known for that of a big polygon?
bool IsBig(const b2DistanceProxy &proxy) {
    b2Transform origin;
    origin.SetIdentity();
    return bmr::BigOverlap(proxy, origin, proxy, origin) != bmr::Overlap::kUnknown;
}

} // namespace

TEST_CASE("times of impact are b2TimeOfImpact's where that is sure of itself") {
    Engine engine(4);
    size_t both = 0, differing = 0, failed = 0;
    double worst = 0.0;
    for (size_t i = 0; i < test_scaled(1500); ++i) {
        const Polygon a = oracle::RandomPolygon(engine, 9 + Below(engine, 247), b2_polygonRadius);
        const Polygon b = RandomShape(engine, 255);
        Motion motion = RandomMotion(engine, a, b);
        motion.a.a = motion.a.a0 + 0.05f * (motion.a.a - motion.a.a0);
        motion.b.a = motion.b.a0 + 0.05f * (motion.b.a - motion.b.a0);
        b2TOIInput input;
        input.proxyA = a.Stock();
        input.proxyB = b.Stock();
        input.sweepA = motion.a;
        input.sweepB = motion.b;
        input.tMax = 1.0f;
        b2TOIOutput stock;
        b2TimeOfImpact(&stock, &input);
        bmr_vec32 direction = {0.0f, 0.0f};
        const Impact ours = AskImpact(a, b, motion, 1.0f, &direction);
        if (stock.state == b2TOIOutput::e_failed) { // its search takes 8 vertices at most for enough
            ++failed;
            continue;
        }
        const bool same = static_cast<int>(stock.state) == static_cast<int>(ours.state) + 1;
        if (!same) { // they may: where the two just pass by each other
            ++differing;
            continue;
        }
        if (ours.state != BMR_IMPACT_TOUCHING)
            continue;
        ++both;
        worst = std::max(worst, std::fabs(DistanceAt(a, b, motion, double{stock.t}) -
                                          DistanceAt(a, b, motion, double{ours.t})));
    }
    MESSAGE("touching ", both, ", other state ", differing, ", Box2D gave up ", failed, ", worst gap ",
            worst);
    CHECK(both > test_scaled(1500) / 10);
    CHECK(worst <= 0.5 * double{b2_linearSlop} + 1e-4);
    CHECK(50 * differing <= test_scaled(1500) + 50);
}

namespace {

/// A cast that Box2D is asked, too.
struct Cast {
    b2ShapeCastInput input;
    b2ShapeCastOutput stock;
    bmr_cast32 ours;
    bool hit, stockHits;
    double way; ///< the translation's coordinates are up to this
    double sigma;

    Cast(Engine &engine, const Polygon &a, const b2Transform &xfA, const Polygon &b, const b2Transform &xfB)
        : way(3.0 * double{a.Ours().reach + b.Ours().reach}),
          sigma(double{std::max(2.0f * b2_linearSlop, std::max(a.radius, b2_polygonRadius) +
                                                          std::max(b.radius, b2_polygonRadius) -
                                                          b2_polygonRadius)}) {
        input.proxyA = a.Stock();
        input.proxyB = b.Stock();
        input.transformA = xfA;
        input.transformB = xfB;
        input.translationB.Set(UniformF(engine, -way, way), UniformF(engine, -way, way));
        stockHits = b2ShapeCast(&stock, &input);
        const bmr_proxy32 pa = a.Ours(), pb = b.Ours();
        hit = bmr_convex32_cast(&pa, Pose32(xfA), &pb, Pose32(xfB),
                                {input.translationB.x, input.translationB.y}, b2_linearSlop, &ours);
    }
};

/// b, moved along the closest points until it is so far from a.
b2Transform MovedTo(double distance, const Polygon &a, const b2Transform &xfA, const Polygon &b,
                    b2Transform xfB) {
    bmr_closest32 closest = {0, 0};
    const bmr_distance32 now = Ask(a, xfA, b, xfB, &closest);
    const float part = static_cast<float>(distance) / now.distance - 1.0f;
    xfB.p += b2Vec2(part * (now.point_b.x - now.point_a.x), part * (now.point_b.y - now.point_a.y));
    return xfB;
}

} // namespace

TEST_CASE("casts are b2ShapeCast's") {
    Engine engine(5);
    size_t hits = 0, misses = 0, differing = 0;
    double worst = 0.0;
    for (size_t i = 0; i < test_scaled(4000); ++i) {
        const Polygon a = oracle::RandomPolygon(engine, 9 + Below(engine, 247), b2_polygonRadius);
        const Polygon b = RandomShape(engine, 255);
        const b2Transform xfA = shapes::RandomPose(engine, 5.0), xfB = NearbyPose(engine, a, b);
        const Cast cast(engine, a, xfA, b, xfB);
        const bmr_cast32 &ours = cast.ours;
        if (cast.hit != cast.stockHits) {
            ++differing;
            continue;
        }
        if (!cast.hit) {
            ++misses;
            CHECK(ours.lambda == cast.stock.lambda);
            CHECK(ours.normal.x == 0.0f);
            CHECK(ours.point.y == 0.0f);
            continue;
        }
        ++hits;
        const auto at = [&](float lambda) {
            b2Transform xf = xfB;
            xf.p += lambda * cast.input.translationB;
            return Distance(Placed(a, xfA), Placed(b, xf));
        };
        if (cast.stock.iterations < 20)
            worst = std::max(worst, std::fabs(at(ours.lambda) - at(cast.stock.lambda)));
    }
    MESSAGE("hits ", hits, ", misses ", misses, ", differing ", differing, ", worst gap ", worst);
    CHECK(hits > test_scaled(4000) / 20);
    CHECK(100 * differing <= test_scaled(4000) + 100);
    CHECK(worst <= 0.5 * double{b2_linearSlop} + 1e-4);
}

// How near is reached, to the rounding of Box2D's coordinates. Between sigma and half a slop more Box2D's
// answer follows from the vertices that it looks at: it may miss, or go on a little.
TEST_CASE("casts that begin in touch, or nearly, are b2ShapeCast's") {
    constexpr double rounding = 2e-5;
    Engine engine(7);
    size_t within = 0, between = 0, beyond = 0, within_hits = 0, differing = 0, differing_within = 0;
    for (size_t i = 0; i < test_scaled(4000); ++i) {
        const Polygon a =
            oracle::RandomPolygon(engine, 3 + Below(engine, i % 2 == 0 ? 6 : 40), b2_polygonRadius);
        const Polygon b = RandomShape(engine, 40);
        const b2Transform xfA = shapes::RandomPose(engine, 5.0), away = NearbyPose(engine, a, b);
        if (Distance(Placed(a, xfA), Placed(b, away)) < 0.1)
            continue;
        const double most = double{a.radius + b.radius} + 0.01;
        const b2Transform xfB = MovedTo(Uniform(engine, 0.001, most), a, xfA, b, away);
        const Cast cast(engine, a, xfA, b, xfB);
        const double begin = Distance(Placed(a, xfA), Placed(b, xfB));
        const double reached = cast.sigma + 0.5 * double{b2_linearSlop};
        if (begin < cast.sigma - rounding) {
            ++within;
            within_hits += cast.hit ? 1 : 0;
            differing_within += cast.hit != cast.stockHits ? 1 : 0;
            CHECK((!cast.hit || cast.ours.lambda == 0.0f));
            CHECK((!cast.stockHits || cast.stock.lambda == 0.0f));
        } else if (begin < reached - rounding) {
            ++between;
            CHECK((cast.hit ? cast.ours.lambda == 0.0f : !cast.stockHits));
        } else if (begin > reached + rounding) {
            ++beyond;
            differing += cast.hit != cast.stockHits ? 1 : 0;
            CHECK((!cast.hit || cast.ours.lambda > 0.0f));
        }
    }
    MESSAGE("within sigma ", within, ", hits ", within_hits, ", differing ", differing_within, "; between ",
            between, "; beyond ", beyond, ", differing ", differing);
    CHECK(within_hits > within / 10);
    CHECK(within_hits < within);
    CHECK(between > 0);
    CHECK(1000 * differing_within <= within + 1000);
    CHECK(100 * differing <= beyond + 100);
}

// --- Proxies of big polygons, by hand: who is known by the mark, and Box2D's questions asked of them.

namespace {

/// A wheel of 20 corners that flies past or into a box within a step.
struct Flight {
    bmr::ConvexShape wheel;
    b2PolygonShape box;
    b2TOIInput input;

    explicit Flight(float speed) {
        REQUIRE(wheel.SetRegular(20, 1.0f) == BMR_OK);
        box.SetAsBox(0.5f, 0.5f);
        REQUIRE(bmr::SetBigProxy(&input.proxyA, wheel));
        input.proxyB.Set(&box, 0);
        input.sweepA = input.sweepB = b2Sweep();
        input.sweepB.c0.Set(4.0f, 0.0f);
        input.sweepB.c.Set(4.0f - speed, 0.0f);
        input.tMax = 1.0f;
    }
    b2TOIOutput Ask() const {
        b2TOIOutput output;
        output.state = b2TOIOutput::e_unknown;
        REQUIRE(bmr::BigImpact(&output, input));
        return output;
    }
};

} // namespace

TEST_CASE("impacts are told by all of their states") {
    CHECK(Flight(1.0f).Ask().state == b2TOIOutput::e_separated);
    const b2TOIOutput touching = Flight(4.0f).Ask();
    CHECK(touching.state == b2TOIOutput::e_touching);
    CHECK(std::fabs(touching.t - 2.5f / 4.0f) < 0.01f);
    Flight within(1.0f);
    within.input.sweepB.c0.SetZero();
    CHECK(within.Ask().state == b2TOIOutput::e_overlapped);
}

TEST_CASE("sweeps go on beyond their end; before their beginning only the beginning is looked at") {
    Flight flight(1.0f);
    flight.input.tMax = 2.0f;
    CHECK(flight.Ask().state == b2TOIOutput::e_separated);
    CHECK(flight.Ask().t == 2.0f);
    flight.input.tMax = 4.0f;
    CHECK(flight.Ask().state == b2TOIOutput::e_touching);
    CHECK(std::fabs(flight.Ask().t - 2.5f) < 0.01f);
    // Whether a direction is remembered or not.
    Flight back(-1.0f);
    back.input.tMax = -4.0f;
    CHECK(back.Ask().state == b2TOIOutput::e_separated);
    CHECK(back.Ask().t == -4.0f);
    back.input.tMax = 1.0f;
    CHECK(back.Ask().state == b2TOIOutput::e_separated);
    back.input.tMax = -0.5f;
    CHECK(back.Ask().state == b2TOIOutput::e_separated);
    CHECK(back.Ask().t == -0.5f);
}

TEST_CASE("what is nowhere has no time of impact") {
    Flight flight(1.0f);
    for (float *number : {&flight.input.sweepB.c0.x, &flight.input.sweepA.c0.y, &flight.input.sweepB.a0}) {
        const float before = *number;
        *number = NAN;
        CHECK(flight.Ask().state == b2TOIOutput::e_failed);
        *number = before;
    }
    CHECK(flight.Ask().state == b2TOIOutput::e_separated);
}

TEST_CASE("a mark counts for the vertices that it was made with") {
    Flight flight(1.0f);
    CHECK(IsBig(flight.input.proxyA));
    CHECK_FALSE(IsBig(flight.input.proxyB));
    b2DistanceProxy other = flight.input.proxyA;
    other.m_vertices = flight.box.m_vertices;
    CHECK_FALSE(IsBig(other));
    const b2DistanceProxy kept = flight.input.proxyA;
    REQUIRE(flight.wheel.SetRegular(30, 1.0f) == BMR_OK); // the polygon of 20 is gone
    CHECK_FALSE(IsBig(kept));
    CHECK_FALSE(bmr::SetBigProxy(&other, flight.box));
    b2TOIInput plain = flight.input;
    plain.proxyA.Set(&flight.box, 0);
    b2TOIOutput output;
    CHECK_FALSE(bmr::BigImpact(&output, plain));
}
