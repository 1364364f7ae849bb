// SPDX-License-Identifier: MIT
// NeverTouch against b2TimeOfImpact itself: whatever it proves apart, Box2D does not find touching. Pairs are
// moved to where the proof just still holds, near the origin and at the end of the reach.
#include <cfenv>

#include <box2d/b2_distance.h>
#include <box2d/b2_time_of_impact.h>

#include "box2d_shapes.h"
#include "cases.h"
#include "glue/proofs/sweep_apart.h"
#include "glue/proofs/thresholds.h"

extern B2_API int32 b2_gjkMaxIters;

namespace {

using namespace shapes;

/// How far from the origin, how turned, how fast.
struct Setting {
    double coordinate, angle, way, turn;
};

constexpr double kExtent = 10.0;
// Within kSweepReach with all that is added to the centre of a body.
constexpr double kFar = 450.0;
constexpr Setting kSettings[] = {
    {0.0, 3.0, 0.0, 0.0}, // at rest
    {5.0, 3.0, 0.05, 0.01},  {30.0, 3.0, 1.0, 0.1},  {kFar, 3.0, 0.05, 0.01},
    {kFar, 490.0, 0.5, 0.2}, {5.0, 490.0, 0.0, 0.0},
};

struct Shape {
    b2Vec2 points[b2_maxPolygonVertices];
    int32 count;
    float radius;
};

Shape FromPolygon(const b2PolygonShape &polygon) {
    Shape shape;
    shape.count = polygon.m_count;
    shape.radius = polygon.m_radius;
    for (int32 i = 0; i < polygon.m_count; ++i)
        shape.points[i] = polygon.m_vertices[i];
    return shape;
}

Shape RandomShape(Engine &engine) {
    const int kind = Below(engine, 8);
    Shape shape = FromPolygon(shapes::RandomPolygon(engine, kExtent));
    if (kind == 0) { // a circle
        shape.count = 1;
        shape.radius = UniformF(engine, 0.02, 2.0);
    } else if (kind == 1) { // an edge
        shape.count = 2;
        if (Below(engine, 2) == 0)
            shape.points[1] = shape.points[0] + b2Vec2(UniformF(engine, -0.1, 0.1), 0.01f);
    } else if (kind == 2) { // a short side across from long ones
        const float width = UniformF(engine, 0.002, 0.05), length = UniformF(engine, 1.0, 10.0);
        const b2Vec2 wedge[] = {{0.0f, -width}, {length, -0.3f}, {length, 0.3f}, {0.0f, width}};
        shape.count = 4;
        std::copy(wedge, wedge + 4, shape.points);
    }
    if (Below(engine, 4) == 0)
        shape.radius = static_cast<float>(std::pow(10.0, Uniform(engine, -4.0, 0.0)));
    return shape;
}

float Angle(b2Vec2 v) {
    return std::atan2(v.y, v.x);
}

/// Outward normal of a side, or anything of a circle.
float SideAngle(const Shape &shape, int side) {
    const b2Vec2 e = shape.points[(side + 1) % shape.count] - shape.points[side % shape.count];
    return Angle({e.y, -e.x});
}

struct Pair {
    Shape a, b;
    b2TOIInput input;
    b2Vec2 away;          ///< along which b is moved off
    b2Vec2 start0, start; ///< of b's sweep
};

b2Sweep RandomSweep(Engine &engine, const Setting &setting) {
    b2Sweep sweep;
    const double c = setting.coordinate, w = setting.way, t = setting.turn;
    sweep.localCenter.Set(UniformF(engine, -1.0, 1.0), UniformF(engine, -1.0, 1.0));
    sweep.c.Set(UniformF(engine, -c, c), UniformF(engine, -c, c));
    sweep.c0 = sweep.c + b2Vec2(UniformF(engine, -w, w), UniformF(engine, -w, w));
    sweep.a = UniformF(engine, -setting.angle, setting.angle);
    sweep.a0 = sweep.a + UniformF(engine, -t, t) * (Below(engine, 2) == 0 ? 1.0f : 0.01f);
    sweep.alpha0 = 0.0f;
    return sweep;
}

Pair RandomPair(Engine &engine, const Setting &setting) {
    Pair pair;
    pair.a = RandomShape(engine);
    pair.b = RandomShape(engine);
    b2TOIInput &in = pair.input;
    in.sweepA = RandomSweep(engine, setting);
    in.sweepB = RandomSweep(engine, setting);
    in.tMax = 1.0f;
    float angle = UniformF(engine, -3.2, 3.2);
    if (Below(engine, 2) == 0) { // face to face, or nearly so: where Box2D's axis is least certain
        angle = in.sweepA.a + SideAngle(pair.a, Below(engine, pair.a.count));
        const double tilt =
            std::pow(10.0, Uniform(engine, -8.0, -2.0)) * (Below(engine, 2) == 0 ? 1.0 : -1.0);
        in.sweepB.a0 -= in.sweepB.a;
        in.sweepB.a = static_cast<float>(double{angle} + 3.14159265358979 + tilt -
                                         double{SideAngle(pair.b, Below(engine, pair.b.count))});
        in.sweepB.a0 += in.sweepB.a;
    }
    pair.away.Set(std::cos(angle), std::sin(angle));
    // Somewhere along the side.
    const b2Vec2 along = UniformF(engine, -1.0, 1.0) * b2Vec2(-pair.away.y, pair.away.x);
    pair.start = in.sweepA.c + along;
    pair.start0 = pair.start + in.sweepB.c0 - in.sweepB.c;
    return pair;
}

void MoveOff(Pair *pair, float distance) {
    b2TOIInput &in = pair->input;
    in.sweepB.c = pair->start + distance * pair->away;
    in.sweepB.c0 = pair->start0 + distance * pair->away;
    in.proxyA.Set(pair->a.points, pair->a.count, pair->a.radius);
    in.proxyB.Set(pair->b.points, pair->b.count, pair->b.radius);
}

bool NeverTouch(const b2TOIInput &in) {
    bmr_vec32 direction = {0.0f, 0.0f};
    return bmr::NeverTouch(bmr::Sweep(in.proxyA, in.sweepA, b2Rot(in.sweepA.a)),
                           bmr::Sweep(in.proxyB, in.sweepB, b2Rot(in.sweepB.a)), &direction);
}

/// The proof with `share` of the margin. (In 100,000 pairs of each setting, touches were seen up to a share
/// of 0.15.)
bool Proved(const Pair &pair, float share) {
    const b2TOIInput &in = pair.input;
    bmr::SweptShape a = bmr::Sweep(in.proxyA, in.sweepA, b2Rot(in.sweepA.a)),
                    b = bmr::Sweep(in.proxyB, in.sweepB, b2Rot(in.sweepB.a));
    for (bmr::SweptShape *shape : {&a, &b}) {
        shape->rounding *= share;
        shape->tilt *= share;
    }
    bmr_vec32 direction = {0.0f, 0.0f};
    return bmr::NeverTouch(a, b, &direction);
}

/// To where the proof just holds; the last float, or nearly.
bool MoveToTheEdge(Engine &engine, Pair *pair, float share) {
    float near = 0.0f, far = 40.0f;
    MoveOff(pair, far);
    if (!Proved(*pair, share))
        return false;
    for (int i = 0; i < 30; ++i) {
        const float middle = 0.5f * (near + far);
        MoveOff(pair, middle);
        (Proved(*pair, share) ? far : near) = middle;
    }
    MoveOff(pair, far);
    if (Proved(*pair, share))
        return true;
    // Rounding makes the edge ragged.
    for (int i = 0; i < 20; ++i) {
        far += UniformF(engine, 0.0, 1e-4);
        MoveOff(pair, far);
        if (Proved(*pair, share))
            return true;
    }
    return false;
}

bool Touches(const b2TOIInput &input) {
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input);
    return output.state == b2TOIOutput::e_touching;
}

struct Tally {
    size_t placed = 0, touching = 0;
};

/// Without a share, which is the control, one that touches is enough.
Tally Try(size_t count, const Setting &setting, float share) {
    Engine engine(17);
    Tally tally;
    for (size_t i = 0; i < count && (share > 0.0f || tally.touching == 0); ++i) {
        Pair pair = RandomPair(engine, setting);
        if (!MoveToTheEdge(engine, &pair, share))
            continue;
        ++tally.placed;
        tally.touching += Touches(pair.input);
    }
    return tally;
}

b2TOIInput TwoBoxes(b2PolygonShape *box, float distance) {
    box->SetAsBox(0.5f, 0.5f);
    b2TOIInput in;
    in.proxyA.Set(box, 0);
    in.proxyB.Set(box, 0);
    in.sweepA.localCenter.SetZero();
    in.sweepA.c0.SetZero();
    in.sweepA.c.SetZero();
    in.sweepA.a0 = in.sweepA.a = 0.0f;
    in.sweepA.alpha0 = 0.0f;
    in.sweepB = in.sweepA;
    in.sweepB.c0.Set(1.0f + distance, 0.0f);
    in.sweepB.c = in.sweepB.c0;
    in.tMax = 1.0f;
    return in;
}

} // namespace

TEST_CASE("what is proved apart never touches, at the very edge of the proof") {
    b2_gjkMaxIters = 0;
    for (const Setting &setting : kSettings) {
        CAPTURE(setting.coordinate);
        CAPTURE(setting.angle);
        const Tally t = Try(test_scaled(20000), setting, 1.0f);
        CHECK(t.placed > test_scaled(20000) / 2);
        CHECK(t.touching == 0);
    }
    // The derivation of the margin takes b2Distance to end by itself.
    CHECK(b2_gjkMaxIters < 20);
}

TEST_CASE("control: without the margin Box2D does touch what seems proved") {
    for (const Setting &setting : kSettings) {
        CAPTURE(setting.coordinate);
        CAPTURE(setting.angle);
        CHECK(Try(20000, setting, 0.0f).touching > 0);
    }
}

TEST_CASE("pairs that rest on each other are proved, pairs that touch are not") {
    b2PolygonShape box;
    // A resting pair stays a slop inside its skins.
    CHECK(NeverTouch(TwoBoxes(&box, 2.0f * b2_polygonRadius - b2_linearSlop)));
    CHECK(NeverTouch(TwoBoxes(&box, bmr::ImpactDistance(2.0f * b2_polygonRadius) + 1e-4f)));
    CHECK_FALSE(NeverTouch(TwoBoxes(&box, bmr::ImpactDistance(2.0f * b2_polygonRadius) - 1e-4f)));
    CHECK(Touches(TwoBoxes(&box, bmr::ImpactDistance(2.0f * b2_polygonRadius) - 1e-4f)));
    CHECK_FALSE(NeverTouch(TwoBoxes(&box, -0.1f)));
}

TEST_CASE("a motion through the other shape is not proved, whichever end is looked at") {
    b2PolygonShape box;
    for (const bool back : {false, true}) {
        b2TOIInput in = TwoBoxes(&box, 1.0f);
        (back ? in.sweepB.c0 : in.sweepB.c).x = -2.0f;
        CHECK(Touches(in));
        CHECK_FALSE(NeverTouch(in));
    }
    // A corner sweeps by between two poses that are apart.
    b2TOIInput turning = TwoBoxes(&box, 0.1f);
    turning.sweepB.a0 = turning.sweepB.a = -0.1f;
    CHECK(NeverTouch(turning));
    turning.sweepB.a0 = turning.sweepB.a = 0.5f * b2_pi + 0.1f;
    CHECK(NeverTouch(turning));
    turning.sweepB.a0 = -0.1f;
    CHECK_FALSE(NeverTouch(turning));
}

TEST_CASE("what is not a number, not finite or out of reach is left to Box2D") {
    b2PolygonShape box;
    REQUIRE(NeverTouch(TwoBoxes(&box, 5.0f)));
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(), 1e30f, 600.0f}) {
        CAPTURE(bad);
        const auto left = [&](auto spoil) {
            b2TOIInput in = TwoBoxes(&box, 5.0f);
            spoil(in);
            return !NeverTouch(in);
        };
        CHECK(left([bad](b2TOIInput &in) { in.sweepA.c.x = bad; }));
        CHECK(left([bad](b2TOIInput &in) { in.sweepA.c0.y = bad; }));
        CHECK(left([bad](b2TOIInput &in) { in.sweepB.c0.y = bad; }));
        CHECK(left([bad](b2TOIInput &in) { in.sweepB.a0 = bad; }));
        CHECK(left([bad](b2TOIInput &in) { in.sweepA.a0 = in.sweepA.a = bad; }));
        CHECK(left([bad](b2TOIInput &in) { in.sweepA.localCenter.x = bad; }));
        for (int i = 0; i < 4; ++i) {
            b2PolygonShape other = box;
            other.m_vertices[i].y = bad;
            CHECK(left([&other](b2TOIInput &in) { in.proxyB.Set(&other, 0); }));
        }
    }
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        b2TOIInput in = TwoBoxes(&box, 5.0f);
        in.proxyA.m_radius = bad;
        CHECK_FALSE(NeverTouch(in));
    }
    b2TOIInput none = TwoBoxes(&box, 5.0f);
    none.proxyA.m_count = 0;
    CHECK_FALSE(NeverTouch(none));
    none.proxyA.m_count = 9;
    CHECK_FALSE(NeverTouch(none));
}

TEST_CASE("shapes that changed in place are seen as they are") {
    b2PolygonShape a, b;
    a.SetAsBox(0.5f, 0.5f);
    b2TOIInput in = TwoBoxes(&b, 1.0f);
    in.proxyA.Set(&a, 0);
    CHECK(NeverTouch(in));
    a.SetAsBox(1.495f, 0.5f);
    CHECK_FALSE(NeverTouch(in));
    a.SetAsBox(0.5f, 0.5f);
    CHECK(NeverTouch(in));
    a.m_radius = 1.1f;
    in.proxyA.Set(&a, 0);
    CHECK_FALSE(NeverTouch(in));
}

TEST_CASE("sides without length are left to Box2D, and nothing is divided by them") {
    b2PolygonShape box, spoilt;
    for (const float length : {0.0f, 1e-30f, 1e-6f}) {
        for (const float far : {3.0f, 1e4f}) {
            CAPTURE(length);
            CAPTURE(far);
            b2TOIInput in = TwoBoxes(&box, 3.0f);
            in.sweepB.c0.y = in.sweepB.c.y = far;
            spoilt = box;
            spoilt.m_vertices[1] = spoilt.m_vertices[0] + b2Vec2(length, 0.0f);
            in.proxyA.Set(&spoilt, 0);
            bmr_vec32 direction = {0.0f, 0.0f};
            std::feclearexcept(FE_ALL_EXCEPT);
            const bmr::SweptShape a = bmr::Sweep(in.proxyA, in.sweepA, b2Rot(0.0f)),
                                  b = bmr::Sweep(in.proxyB, in.sweepB, b2Rot(0.0f));
            const bool proved = bmr::NeverTouch(a, b, &direction) || bmr::NeverTouch(b, a, &direction) ||
                                bmr::NeverTouchAlong(a, b, {0.0f, 1.0f});
            CHECK(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) == 0);
            CHECK_FALSE(proved);
        }
    }
}
