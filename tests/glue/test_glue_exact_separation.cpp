// SPDX-License-Identifier: MIT
// What hulls and pictures say of distances against rational arithmetic: a slack is never above the true
// distance, and "apart" is apart, at poses a unit in the last place from touching, ten kilometres out, at any
// angle, of slivers and of polygons of hundreds of metres. (Sweeps and overlaps: test_glue_sweeps and
// test_glue_overlaps, against Box2D itself.)
#include <box2d/box2d.h>

#include "boomerang/box2d_glue.h"
#include "box2d_shapes.h"
#include "cases.h"
#include "debug/inspect.h"
#include "exact_distance.h"
#include "glue/proofs/hull_pair.h"
#include "glue/proofs/thresholds.h"
#include "in_child.h"
#include "start/settings.h"

namespace {

using namespace as_stock;
using namespace exact;
using shapes::Below;
using shapes::Engine;
using shapes::PosedOf;
using shapes::Uniform;
using shapes::UniformF;

/// A few must always run, or the counts below see nothing.
size_t Rounds(size_t count) {
    return std::max<size_t>(test_scaled(count), 100);
}

const b2PolygonShape &PolygonOf(const b2Fixture *fixture) {
    return *static_cast<const b2PolygonShape *>(fixture->GetShape());
}

Posed Placed(const b2Fixture &fixture) {
    return PosedOf(PolygonOf(&fixture), fixture.GetBody()->GetTransform());
}

/// The squared distance of all polygons of two bodies.
mpq_class Truth(const b2Body *a, const b2Body *b) {
    mpq_class least(-1);
    for (const b2Fixture *f = a->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        for (const b2Fixture *g = b->GetFixtureList(); g != nullptr; g = g->GetNext()) {
            const mpq_class d = SquaredDistance(Placed(*f), Placed(*g));
            if (least < 0 || d < least)
                least = d;
        }
    }
    return least;
}

/// Is a claimed lower bound one?
bool IsTrue(double claimed, const mpq_class &squaredDistance) {
    return claimed <= 0.0 || Square(claimed) <= squaredDistance;
}

/// The largest float that is no larger than the root.
float LargestTrue(const mpq_class &squaredDistance) {
    auto f = static_cast<float>(std::sqrt(squaredDistance.get_d()));
    while (!IsTrue(double{f}, squaredDistance))
        f = std::nextafterf(f, 0.0f);
    while (IsTrue(double{std::nextafterf(f, INFINITY)}, squaredDistance))
        f = std::nextafterf(f, INFINITY);
    return f;
}

/// Boxes, needles of half a millimetre, anything of up to 8 sides; one in six of hundreds of metres.
b2PolygonShape RandomShape(Engine &engine) {
    const int kind = Below(engine, 6);
    b2PolygonShape shape;
    if (kind == 0) { // a sliver
        const float length = UniformF(engine, 0.5, 20.0), tip = UniformF(engine, 0.004, 0.02);
        const b2Vec2 points[] = {{-length, 0.0f}, {length, -tip}, {length, tip}};
        shape.Set(points, 3);
    } else if (kind == 1) { // its body's origin is far from its sides
        const float width = UniformF(engine, 50.0, 200.0);
        shape.SetAsBox(width, UniformF(engine, 1.0, 100.0));
    } else {
        shape = shapes::RandomPolygon(engine, 10.0);
    }
    if (Below(engine, 3) == 0)
        shape.m_radius = 0.0f;
    return shape;
}

b2Vec2 Middle(const b2Body *body) {
    const b2PolygonShape &polygon = PolygonOf(body->GetFixtureList());
    return body->GetWorldPoint(0.5f * (polygon.m_vertices[0] + polygon.m_vertices[polygon.m_count / 2]));
}

/// The distance in long double, to find a place by.
double Near(const b2Body *a, const b2Body *b) {
    double least = INFINITY;
    for (const b2Fixture *f = a->GetFixtureList(); f != nullptr; f = f->GetNext())
        for (const b2Fixture *g = b->GetFixtureList(); g != nullptr; g = g->GetNext())
            least = std::min(least, static_cast<double>(NearDistance(Placed(*f), Placed(*g))));
    return least;
}

struct BodyPair {
    b2World world{b2Vec2(0.0f, 0.0f)};
    b2Body *a, *b;

    explicit BodyPair(Engine &engine) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.allowSleep = false;
        a = world.CreateBody(&def);
        b = world.CreateBody(&def);
        for (b2Body *body : {a, b}) {
            for (int i = Below(engine, 3); i >= 0; --i) {
                const b2PolygonShape shape = RandomShape(engine);
                body->CreateFixture(&shape, 0.0f);
            }
        }
    }

    /// So far from the origin; b so far from a, to within rounding, or a few floats off.
    void Put(Engine &engine, double far, double wanted) {
        const double angle = Below(engine, 3) == 0 ? 1e6 : 4.0;
        a->SetTransform({UniformF(engine, -far, far), UniformF(engine, -far, far)},
                        Below(engine, 3) == 0 ? 0.0f : UniformF(engine, -angle, angle));
        b->SetTransform(a->GetPosition(), Below(engine, 3) == 0 ? a->GetAngle() + 0.5f * b2_pi
                                                                : UniformF(engine, -angle, angle));
        const double way = Below(engine, 4) == 0 ? 0.0 : Uniform(engine, -3.2, 3.2);
        const b2Vec2 start = b->GetPosition() + Middle(a) - Middle(b);
        const auto move = [&](double t) {
            b->SetTransform(
                start + b2Vec2(static_cast<float>(t * std::cos(way)), static_cast<float>(t * std::sin(way))),
                b->GetAngle());
            return Near(a, b);
        };
        double t = 1500.0;
        for (int i = 0; i < 60; ++i) {
            const double left = move(t) - wanted;
            if (std::fabs(left) < 1e-9)
                break;
            t -= left;
        }
        b2Vec2 p = b->GetPosition();
        for (int i = Below(engine, 4); i > 0; --i)
            (Below(engine, 2) == 0 ? p.x : p.y) =
                std::nextafterf(Below(engine, 2) == 0 ? p.x : p.y, Below(engine, 2) == 0 ? -1e9f : 1e9f);
        b->SetTransform(p, b->GetAngle());
    }
};

constexpr double kFar[] = {0.0, 1.0, 100.0, 300.0, 10000.0};
constexpr double kWanted[] = {0.0, 1e-6, 1e-4, 0.001, 0.0015, 0.02, 0.03, 0.5, 20.0};

/// One of some values.
template <size_t n> double OneOf(Engine &engine, const double (&values)[n]) {
    return values[Below(engine, static_cast<int>(n))];
}

struct Tally {
    size_t claims = 0, lies = 0, caught = 0;

    void Add(double claimed, const mpq_class &truth) {
        claims += claimed > 0.0;
        lies += !IsTrue(claimed, truth);
        // The control: what is one float above the truth is a lie.
        if (truth > 0)
            caught += !IsTrue(double{std::nextafterf(LargestTrue(truth), INFINITY)}, truth);
    }
};

} // namespace

TEST_CASE("the oracle tells a claim from one that is a unit in the last place higher") {
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    b2Transform here, there;
    here.SetIdentity();
    there.SetIdentity();
    for (const float gap : {0.25f, 0x1p-20f}) {
        there.p.x = 1.0f + gap;
        const mpq_class truth = SquaredDistance(PosedOf(box, here), PosedOf(box, there));
        CHECK(IsTrue(double{gap}, truth));
        CHECK_FALSE(IsTrue(std::nextafter(double{gap}, 1.0), truth));
        // The same shapes, turned by an angle of which nothing is exact, 10 km out.
        b2Transform farHere, farThere;
        farHere.Set(b2Vec2(10000.0f, -7000.0f), 1e6f);
        farThere = b2Mul(farHere, there);
        const mpq_class far = SquaredDistance(PosedOf(box, farHere), PosedOf(box, farThere));
        CHECK(IsTrue(double{LargestTrue(far)}, far));
        CHECK_FALSE(IsTrue(double{std::nextafterf(LargestTrue(far), 1.0f)}, far));
    }
    there.p.x = 1.0f;
    CHECK(SquaredDistance(PosedOf(box, here), PosedOf(box, there)) == 0);
}

namespace {

using bmr::internal::Inspect, bmr::internal::Proof;

const b2Body *BodyOf(const b2Contact &contact, int side) {
    return (side == 0 ? contact.GetFixtureA() : contact.GetFixtureB())->GetBody();
}

/// Calls `visit` with each vertex, in the body's frame, that one side of a proof speaks of.
template <typename Visit>
void VisitVertices(const Proof &proof, const b2Contact &contact, int side, Visit visit) {
    for (const b2Fixture *f = BodyOf(contact, side)->GetFixtureList(); f != nullptr; f = f->GetNext())
        for (int32 i = 0; i < PolygonOf(f).m_count; ++i)
            if (proof.fixtures[side] == nullptr || proof.fixtures[side] == f)
                visit(PolygonOf(f).m_vertices[i]);
}

/// The gap between both sides along the line that a picture shows of a proof, or along one turned by so much.
double GapAlong(const Proof &proof, const b2Contact &contact, float turned) {
    const b2Vec2 n = b2Mul(b2Rot(turned), BodyOf(contact, proof.owner)->GetWorldVector(proof.normal));
    double gap = INFINITY, farthest = -INFINITY;
    const auto along = [&](int side, b2Vec2 v) {
        const shapes::Point at = shapes::Place(BodyOf(contact, side)->GetTransform(), v);
        return double{n.x} * at.x + double{n.y} * at.y;
    };
    VisitVertices(proof, contact, proof.owner,
                  [&](b2Vec2 v) { farthest = std::max(farthest, along(proof.owner, v)); });
    VisitVertices(proof, contact, 1 - proof.owner,
                  [&](b2Vec2 v) { gap = std::min(gap, along(1 - proof.owner, v) - farthest); });
    return gap;
}

void CheckPictures(Run &run) {
    Engine engine(31);
    Tally slack;
    // Hulls overlap where no two fixtures do.
    const size_t few = Rounds(1500) / (run.RemembersEdges() ? 4 : 10);
    size_t lines = 0, wrong = 0, wrongIfTurned = 0;
    for (size_t i = 0; i < Rounds(1500); ++i) {
        BodyPair t(engine);
        t.Put(engine, OneOf(engine, kFar), OneOf(engine, kWanted));
        t.world.Step(0.0f, 1, 1);
        const double far = OneOf(engine, kFar);
        t.Put(engine, far, OneOf(engine, kWanted));
        for (const b2Contact *c = t.world.GetContactList(); c != nullptr; c = c->GetNext()) {
            const b2Fixture &f = *c->GetFixtureA(), &g = *c->GetFixtureB();
            const mpq_class two = SquaredDistance(Placed(f), Placed(g));
            const Proof proof = Inspect(*c);
            slack.Add(double{proof.slack}, two);
            if (proof.slack > 0.0f && proof.normal != b2Vec2_zero && far <= 100.0) {
                ++lines;
                wrong += GapAlong(proof, *c, 0.0f) < double{proof.slack} - 1e-4;
                wrongIfTurned += GapAlong(proof, *c, 0.5f) < double{proof.slack} - 1e-4;
            }
        }
    }
    run.Expect(slack.claims > few && slack.caught > Rounds(1500) / 4, "there are slacks");
    run.Expect(slack.lies == 0, "no slack is more than the distance");
    run.Expect(lines > few / 3 && wrong == 0, "the line that is shown has the slack");
    run.Expect(wrongIfTurned > lines / 10, "control: a line that is turned has not");
}

} // namespace

TEST_CASE("no certificate of a picture claims more than the exact distance, and its line shows it") {
    const bmr::Options options;
    for (const char *structure : {static_cast<const char *>(nullptr), "lazy-compass"}) {
        const PairsBy by(structure);
        CHECK(InChild(CheckPictures, &options) == "");
    }
}

TEST_CASE(
    "what two hulls say is apart is farther apart than the diagonal of the radii, and their gap is there") {
    bmr::MakeSettings(bmr::Options());
    Engine engine(33);
    Tally gaps;
    size_t apart = 0, wrong = 0, wrongIfMore = 0, beyond = 0;
    for (size_t i = 0; i < Rounds(300); ++i) {
        BodyPair t(engine);
        bmr::Hull hullA(t.a, nullptr), hullB(t.b, nullptr);
        bmr::HullPair pair;
        pair.a = &hullA;
        pair.b = &hullB;
        const double margin = bmr::ContactMargin(double{hullA.Radius() + hullB.Radius()});
        // What Box2D's own rounding may take of it is left.
        const double proved = margin - bmr::kRoundingMargin;
        for (int step = 0; step < 6; ++step) {
            const double far = OneOf(engine, kFar);
            t.Put(engine, far, margin + OneOf(engine, {-1e-3, -1e-5, 0.0, 1e-5, 1e-3, 0.01, 1.0}));
            const mpq_class truth = Truth(t.a, t.b);
            const bool known = bmr::KnownApart(&pair, t.a->GetTransform(), t.b->GetTransform());
            apart += known;
            wrong += known && !IsTrue(proved, truth);
            wrongIfMore += known && !IsTrue(proved + 0.002, truth);
            const b2Vec2 place = b2Abs(t.a->GetPosition());
            beyond += known && double{std::max(place.x, place.y)} > bmr::kReach;
            double gap = 0.0;
            bmr::KineticPairNow(pair, &gap);
            gaps.Add(gap, truth);
        }
    }
    MESSAGE("apart ", apart, ", gaps ", gaps.claims);
    CHECK(apart > Rounds(300) / 2);
    CHECK(wrong == 0);
    CHECK(wrongIfMore > 0); // the control
    CHECK(beyond == 0);
    CHECK(gaps.claims > Rounds(300) / 2);
    CHECK(gaps.lies == 0);
}
