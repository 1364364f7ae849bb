// SPDX-License-Identifier: MIT
// CertainOverlap against b2TestOverlap itself: what is certain is what Box2D says, wherever the two are, most
// of all about the threshold.
#include <cfenv>

#include <box2d/b2_chain_shape.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_edge_shape.h>

#include "boomerang/convex_shape.h"
#include "box2d_shapes.h"
#include "cases.h"
#include "glue/proofs/overlap.h"

extern B2_API int32 b2_gjkMaxIters;

namespace {

using bmr::Overlap;
using namespace shapes;

struct Part {
    std::unique_ptr<b2Shape> shape;
    int32 child = 0;
};

b2Vec2 RandomPoint(Engine &engine, double extent) {
    return b2Vec2(UniformF(engine, -extent, extent), UniformF(engine, -extent, extent));
}

Part RandomPart(Engine &engine) {
    Part part;
    const int kind = Below(engine, 8);
    if (kind == 0) {
        auto circle = std::make_unique<b2CircleShape>();
        circle->m_p = RandomPoint(engine, 2.0);
        circle->m_radius = UniformF(engine, 0.05, 3.0);
        part.shape = std::move(circle);
    } else if (kind == 1) {
        auto edge = std::make_unique<b2EdgeShape>();
        edge->SetTwoSided(RandomPoint(engine, 5.0), RandomPoint(engine, 5.0));
        part.shape = std::move(edge);
    } else if (kind == 2) {
        auto chain = std::make_unique<b2ChainShape>();
        const b2Vec2 points[] = {
            {-3.0f, UniformF(engine, -1.0, 1.0)}, {-1.0f, 0.5f}, {1.0f, UniformF(engine, -1.0, 1.0)}};
        chain->CreateLoop(points, 3);
        part.child = Below(engine, 3);
        part.shape = std::move(chain);
    } else {
        auto polygon = std::make_unique<b2PolygonShape>(shapes::RandomPolygon(engine, 10.0));
        if (kind == 3)
            polygon->m_radius = UniformF(engine, 0.0, 1.0);
        part.shape = std::move(polygon);
    }
    return part;
}

struct Pair {
    Part a, b;
    b2Transform xfA, xfB;

    bool Box2D() const { return b2TestOverlap(a.shape.get(), a.child, b.shape.get(), b.child, xfA, xfB); }
    bool IsOfPolygons() const {
        return a.shape->GetType() == b2Shape::e_polygon && b.shape->GetType() == b2Shape::e_polygon;
    }
    Overlap Ours() const { return bmr::CertainOverlap(*a.shape, a.child, *b.shape, b.child, xfA, xfB); }
};

Pair RandomPair(Engine &engine, double range) {
    Pair pair;
    pair.a = RandomPart(engine);
    pair.b = RandomPart(engine);
    pair.xfA = shapes::RandomPose(engine, range);
    pair.xfB = shapes::RandomPose(engine, 0.0);
    if (Below(engine, 4) == 0)
        pair.xfB.q = pair.xfA.q; // sides in parallel
    pair.xfB.p = pair.xfA.p + RandomPoint(engine, 6.0);
    return pair;
}

/// Towards where Box2D changes its mind, to within `off`.
void MoveToTheThreshold(Engine &engine, Pair *pair, double off) {
    const float angle = UniformF(engine, -3.2, 3.2);
    const b2Vec2 way(std::cos(angle), std::sin(angle)), from = pair->xfB.p;
    float near = 0.0f, far = 60.0f;
    for (int i = 0; i < 26; ++i) {
        const float middle = 0.5f * (near + far);
        pair->xfB.p = from + middle * way;
        (pair->Box2D() ? near : far) = middle;
    }
    pair->xfB.p = from + (near + UniformF(engine, -off, off)) * way;
}

/// Vertices in place, with the normals that were there; or normals alone.
void EditAlone(int kind, b2PolygonShape *polygon) {
    const int32 count = polygon->m_count;
    b2Vec2 *v = polygon->m_vertices, *n = polygon->m_normals;
    switch (kind) {
    case 0:
        v[1] *= 1.6f;
        break;
    case 1:
        v[1] = 0.1f * v[0];
        break;
    case 2:
        std::swap(v[0], v[2]);
        break;
    case 3:
        for (int32 i = 0; i < count; ++i)
            v[i] = b2Mul(b2Rot(0.4f), v[i]);
        break;
    case 4:
        std::reverse(v, v + count);
        break;
    case 5:
        for (int32 i = 0; i < count; ++i)
            n[i] *= 2.0f;
        break;
    default:
        for (int32 i = 0; i < count; ++i)
            n[i].SetZero();
    }
}

/// `answer()`, and which operations a game may trap it has raised.
template <typename Answer> auto Ask(int *raised, Answer answer) {
    std::feclearexcept(FE_ALL_EXCEPT);
    const auto given = answer();
    *raised = std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    return given;
}

struct Tally {
    size_t asked = 0, apart = 0, overlapping = 0, wrong = 0;
    size_t trapped = 0; ///< where nothing of Box2D's would

    void Add(const Pair &pair, Overlap ours) { Add(ours, pair.Box2D()); }
    void Add(const Pair &pair) {
        int ours = 0, theirs = 0;
        Add(Ask(&ours, [&pair] { return pair.Ours(); }), Ask(&theirs, [&pair] { return pair.Box2D(); }));
        trapped += (ours & ~theirs) != 0;
    }
    /// Nothing wrong, and enough of both answers.
    void Check() const {
        CheckNothingWrong();
        CHECK(apart > asked / 20);
        CHECK(overlapping > asked / 100);
    }
    void CheckNothingWrong() const {
        CHECK(wrong == 0);
        CHECK(trapped == 0);
    }

private:
    void Add(Overlap ours, bool box2d) {
        ++asked;
        apart += ours == Overlap::kApart;
        overlapping += ours == Overlap::kOverlapping;
        wrong += ours != Overlap::kUnknown && (ours == Overlap::kOverlapping) != box2d;
    }
};

/// Boxes on a grid of 5 cm, side on side: the most symmetric way to meet.
Pair RandomTiles(Engine &engine, double range) {
    const auto cell = [&engine](double most) {
        return 0.05f * std::round(UniformF(engine, -20.0 * most, 20.0 * most));
    };
    Pair pair;
    for (Part *part : {&pair.a, &pair.b}) {
        auto box = std::make_unique<b2PolygonShape>();
        box->SetAsBox(0.05f + std::fabs(cell(1.0)), 0.05f + std::fabs(cell(1.0)));
        part->shape = std::move(box);
    }
    pair.xfA.SetIdentity();
    pair.xfA.p.Set(cell(range), cell(range));
    pair.xfB = pair.xfA;
    pair.xfB.p += b2Vec2(cell(1.0), cell(1.0));
    return pair;
}

} // namespace

TEST_CASE("what is certain is what Box2D says, anywhere") {
    b2_gjkMaxIters = 0;
    for (const double range : {1.0, 50.0, 450.0}) {
        CAPTURE(range);
        Engine engine(3);
        Tally polygons, others;
        for (size_t i = 0; i < test_scaled(60000); ++i) {
            const Pair pair = RandomPair(engine, range);
            (pair.IsOfPolygons() ? polygons : others).Add(pair);
        }
        polygons.CheckNothingWrong();
        others.CheckNothingWrong();
        CHECK(others.apart > others.asked / 8);
        CHECK(polygons.apart > polygons.asked / 8);
        CHECK(polygons.overlapping > polygons.asked / 12);
        // Most are one or the other. (Others that are not apart are left to Box2D.)
        CHECK(polygons.apart + polygons.overlapping > polygons.asked * 9 / 10);
    }
    // The reasoning takes b2Distance to end by itself.
    CHECK(b2_gjkMaxIters < 20);
}

TEST_CASE("what is certain is what Box2D says, about the threshold") {
    for (const double range : {1.0, 50.0, 450.0}) {
        for (const double off : {1e-6, 1e-4, 3e-3, 5e-2}) {
            CAPTURE(range);
            CAPTURE(off);
            Engine engine(4);
            Tally t;
            for (size_t i = 0; i < test_scaled(8000); ++i) {
                Pair pair = RandomPair(engine, range);
                MoveToTheThreshold(engine, &pair, off);
                t.Add(pair);
            }
            t.CheckNothingWrong();
            if (off > 1e-2)
                CHECK(t.apart > t.asked / 8);
        }
    }
}

TEST_CASE("what is certain is what Box2D says, whatever the skins") {
    for (const double range : {0.0, 1.0, 20.0, 100.0, 450.0, 8000.0}) {
        for (const float skin : {0.0f, 1e-6f, 1e-4f, 1e-3f, b2_polygonRadius}) {
            CAPTURE(range);
            CAPTURE(skin);
            Engine engine(10);
            Tally t;
            for (size_t i = 0; i < test_scaled(20000); ++i) {
                Pair pair = i % 2 == 0 ? RandomTiles(engine, range) : RandomPair(engine, range);
                pair.a.shape->m_radius = pair.b.shape->m_radius = skin;
                t.Add(pair);
            }
            t.CheckNothingWrong();
            if (range <= 450.0)
                CHECK(t.apart > t.asked / 8);
            if (range <= 450.0 && skin == b2_polygonRadius)
                CHECK(t.overlapping > t.asked / 8);
        }
    }
}

TEST_CASE("two circles about one point, and points on points, divide nothing by nothing") {
    Tally t;
    for (const float x : {0.0f, 600.0f}) {
        for (const float radius : {0.0f, 1.0f}) {
            Pair pair;
            for (Part *part : {&pair.a, &pair.b}) {
                auto circle = std::make_unique<b2CircleShape>();
                circle->m_radius = radius;
                part->shape = std::move(circle);
            }
            pair.xfA.Set({x, 0.0f}, 0.0f);
            pair.xfB = pair.xfA;
            t.Add(pair);
        }
    }
    t.CheckNothingWrong();
}

TEST_CASE("pairs on their way are answered from what is remembered of them, and as Box2D does") {
    Engine engine(5);
    Tally t;
    for (size_t i = 0; i < test_scaled(500); ++i) {
        Pair pair = RandomPair(engine, 20.0);
        const b2Vec2 v = RandomPoint(engine, 0.1);
        const float spin = UniformF(engine, -0.1, 0.1);
        float angle = pair.xfB.q.GetAngle();
        for (int step = 0; step < 150; ++step) {
            pair.xfB.Set(pair.xfB.p + v, angle += spin);
            t.Add(pair);
            if (step % 50 == 25) // in place, as a game may
                pair.a.shape->m_radius *= 1.5f;
        }
    }
    t.CheckNothingWrong();
    CHECK(t.apart > 0);
    CHECK(t.overlapping > 0);
}

TEST_CASE("radii below zero, alone or in sum, take nothing off the shapes themselves") {
    for (const double least : {-1e-3, -0.05, -3.0}) {
        CAPTURE(least);
        Engine engine(7);
        Tally t;
        for (size_t i = 0; i < test_scaled(10000); ++i) {
            Pair pair = RandomPair(engine, 20.0);
            pair.a.shape->m_radius = UniformF(engine, least, 0.0);
            if (Below(engine, 2) == 0)
                pair.b.shape->m_radius = UniformF(engine, least, 0.0);
            if (Below(engine, 2) == 0)
                MoveToTheThreshold(engine, &pair, -0.5 * least);
            t.Add(pair);
        }
        t.CheckNothingWrong();
        CHECK(t.apart > t.asked / 20);
    }
}

TEST_CASE("radii below zero take nothing off big polygons either") {
    bmr::ConvexShape wheel;
    REQUIRE(wheel.SetRegular(40, 1.0f) == BMR_OK);
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    b2Transform at, beside;
    at.SetIdentity();
    for (const float radius : {b2_polygonRadius, 0.0f, -0.2f, -1.0f}) {
        CAPTURE(radius);
        wheel.m_radius = radius;
        const auto says = [&](float x) {
            beside.Set(b2Vec2(x, 0.0f), 0.0f);
            const Overlap answer = bmr::CertainOverlap(wheel, 0, box, 0, at, beside);
            CHECK(bmr::CertainOverlap(box, 0, wheel, 0, beside, at) == answer);
            return answer;
        };
        CHECK(says(2.0f) == Overlap::kApart);
        CHECK(says(1.49f) == Overlap::kOverlapping);
        CHECK(says(1.0f) == Overlap::kOverlapping);
        CHECK(says(1.55f) == Overlap::kApart);
    }
}

TEST_CASE("polygons whose vertices or normals were edited alone overlap where their vertices say") {
    Tally t;
    for (int kind = 0; kind < 7; ++kind) {
        CAPTURE(kind);
        Engine engine(8);
        for (size_t i = 0; i < test_scaled(6000); ++i) {
            Pair pair = RandomPair(engine, 20.0);
            for (b2Shape *shape : {pair.a.shape.get(), pair.b.shape.get()})
                if (shape->GetType() == b2Shape::e_polygon)
                    EditAlone(kind, static_cast<b2PolygonShape *>(shape));
            if (Below(engine, 2) == 0)
                MoveToTheThreshold(engine, &pair, 1e-2);
            t.Add(pair);
        }
        t.CheckNothingWrong();
    }
    t.Check();
}

TEST_CASE("poses that scale are left to Box2D") {
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    for (const float angle : {0.0f, 0.4f, 1.5707964f, 100.0f}) {
        b2Transform at, beside;
        at.Set(b2Vec2(0.0f, 0.0f), angle);
        beside.Set(b2Vec2(0.5f, 0.1f), 2.0f * angle);
        CHECK(bmr::CertainOverlap(box, 0, box, 0, at, beside) == Overlap::kOverlapping);
        for (const float scale : {0.0f, 0.5f, 0.9999f, 1.0001f, 1.01f, -2.0f}) {
            CAPTURE(scale);
            b2Transform scaled = beside;
            scaled.q.s *= scale;
            scaled.q.c *= scale;
            CHECK(bmr::CertainOverlap(box, 0, box, 0, at, scaled) == Overlap::kUnknown);
            CHECK(bmr::CertainOverlap(box, 0, box, 0, scaled, at) == Overlap::kUnknown);
        }
    }
    // Nothing that b2Rot makes does.
    b2PolygonShape small;
    small.SetAsBox(0.3f, 0.3f);
    Engine engine(9);
    size_t left = 0;
    for (size_t i = 0; i < test_scaled(100000); ++i) {
        b2Transform at, beside;
        at.Set(b2Vec2(0.0f, 0.0f), UniformF(engine, -400.0, 400.0));
        beside.Set(b2Vec2(0.3f, 0.2f), UniformF(engine, -400.0, 400.0));
        left += bmr::CertainOverlap(box, 0, small, 0, at, beside) == Overlap::kUnknown;
    }
    CHECK(left == 0);
}

TEST_CASE("control: a wrong answer is counted") {
    Engine engine(6);
    Tally t;
    for (int i = 0; i < 100; ++i) {
        const Pair pair = RandomPair(engine, 1.0);
        t.Add(pair, pair.Box2D() ? Overlap::kApart : Overlap::kOverlapping);
    }
    CHECK(t.wrong == 100);
}

TEST_CASE("what is not a number, not finite or out of reach is left to Box2D, or answered as it does") {
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    b2CircleShape circle;
    circle.m_radius = 1.0f;
    b2Transform at, elsewhere;
    at.SetIdentity();
    for (const float x : {0.5f, 20.0f}) {
        elsewhere.Set(b2Vec2(x, 0.0f), 0.3f);
        REQUIRE(bmr::CertainOverlap(box, 0, box, 0, at, elsewhere) != Overlap::kUnknown);
        for (const float bad :
             {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f}) {
            CAPTURE(x);
            CAPTURE(bad);
            b2Transform spoilt = elsewhere;
            spoilt.p.y = bad;
            CHECK(bmr::CertainOverlap(box, 0, box, 0, at, spoilt) == Overlap::kUnknown);
            CHECK(bmr::CertainOverlap(circle, 0, box, 0, spoilt, at) == Overlap::kUnknown);
            spoilt = elsewhere;
            spoilt.q.s = bad;
            if (!std::isfinite(bad))
                CHECK(bmr::CertainOverlap(box, 0, box, 0, spoilt, at) == Overlap::kUnknown);
            for (int i = 0; i < 4; ++i) {
                b2PolygonShape other = box;
                other.m_vertices[i].x = bad;
                CHECK(bmr::CertainOverlap(box, 0, other, 0, at, elsewhere) == Overlap::kUnknown);
                CHECK(bmr::CertainOverlap(other, 0, circle, 0, at, elsewhere) == Overlap::kUnknown);
            }
        }
    }
    b2Transform far = at;
    far.p.Set(700.0f, 0.0f);
    CHECK(bmr::CertainOverlap(box, 0, box, 0, at, far) == Overlap::kUnknown);
}

TEST_CASE("a polygon that was never set, which has no vertices, is left to Box2D") {
    const b2PolygonShape never;
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    b2Transform xf, beside;
    xf.SetIdentity();
    beside.Set(b2Vec2(0.3f, 0.2f), 0.0f);
    CHECK(bmr::CertainOverlap(never, 0, box, 0, xf, beside) == bmr::Overlap::kUnknown);
    CHECK(bmr::CertainOverlap(box, 0, never, 0, xf, beside) == bmr::Overlap::kUnknown);
    // The control: two boxes are not.
    CHECK(bmr::CertainOverlap(box, 0, box, 0, xf, beside) == bmr::Overlap::kOverlapping);
}
