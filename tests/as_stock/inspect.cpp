// SPDX-License-Identifier: MIT
// A picture shows a pair's certificate. The certificate proves the pair apart, by exact arithmetic, and
// reading it changes nothing.
#include <cstring>
#include <set>

#include "as_stock.h"
#include "boomerang/convex_shape.h"
#include "box2d_shapes.h"
#include "debug/inspect.h"

using namespace as_stock;
using bmr::internal::Inspect, bmr::internal::InspectHull, bmr::internal::kHullLevel, bmr::internal::Proof;

namespace {

/// What floats of the proof's points and of the poses may be off by, in a world of some ten metres.
constexpr double kRounding = 2e-5;

/// Several polygons about one middle: enough contacts with another of its kind for a structure of their own.
b2Body *Burr(Game &game, shapes::Engine &engine, b2Vec2 place, int fixtures) {
    b2Body *body = game.Body(b2_dynamicBody, place, shapes::UniformF(engine, -3.0, 3.0));
    body->SetSleepingAllowed(false);
    for (int i = 0; i < fixtures; ++i)
        game.Fixture(body, shapes::RandomPolygon(engine, 1.0));
    body->SetLinearVelocity({shapes::UniformF(engine, -2.0, 2.0), shapes::UniformF(engine, -2.0, 2.0)});
    body->SetAngularVelocity(shapes::UniformF(engine, -2.0, 2.0));
    return body;
}

/// A proof, and one of the two that it is of.
struct Side {
    const Proof &proof;
    const b2Contact &contact;
    int number;

    const b2Body &Body() const {
        return *(number == 0 ? contact.GetFixtureA() : contact.GetFixtureB())->GetBody();
    }
    b2Vec2 Support() const { return Body().GetWorldPoint(proof.supports[number]); }
    /// Calls `visit` with each vertex, in the world, that the proof speaks of.
    template <typename Visit> void VisitVertices(Visit visit) const {
        for (const b2Fixture *f = Body().GetFixtureList(); f != nullptr; f = f->GetNext()) {
            const bmr::ConvexShape *big = bmr::ConvexShape::From(f->GetShape());
            const auto &polygon = static_cast<const b2PolygonShape &>(*f->GetShape());
            const b2Vec2 *vertices = big != nullptr ? big->GetVertices() : polygon.m_vertices;
            const int32 count = big != nullptr ? big->GetVertexCount() : polygon.m_count;
            const b2Fixture *const only = proof.fixtures[number];
            for (int32 i = 0; i < count && (only == nullptr || only == f); ++i)
                visit(b2Mul(Body().GetTransform(), vertices[i]));
        }
    }
    double Farthest(b2Vec2 direction) const {
        double most = -INFINITY;
        VisitVertices([&](b2Vec2 v) { most = std::max(most, double{b2Dot(v, direction)}); });
        return most;
    }
};

bool Is(const Proof &proof, const char *kind) {
    return std::strcmp(proof.kind, kind) == 0;
}

/// The gap that the disks of a proof leave; -1 where one of them does not hold its side.
double GapOfDisks(const Side &a, const Side &b) {
    bool hold = true;
    for (const Side &side : {a, b})
        side.VisitVertices([&](b2Vec2 v) {
            hold = hold &&
                   double{b2Distance(v, side.Support())} <= double{side.proof.radii[side.number]} + kRounding;
        });
    const double radii = double{a.proof.radii[0]} + double{a.proof.radii[1]};
    return hold ? double{b2Distance(a.Support(), b.Support())} - radii : -1.0;
}

/// The gap between all of one side and all of the other along the line of a proof, found from nothing but the
/// line.
double GapOf(const Proof &proof, const b2Contact &contact, float turnedBy = 0.0f) {
    if (Is(proof, "disks"))
        return GapOfDisks({proof, contact, 0}, {proof, contact, 1});
    const Side owner = {proof, contact, proof.owner}, other = {proof, contact, 1 - proof.owner};
    const b2Vec2 n = b2Mul(b2Rot(turnedBy), owner.Body().GetWorldVector(proof.normal));
    return -other.Farthest(-n) - owner.Farthest(n);
}

/// Do the points that a proof names lie where it says: the owner's and the other's on their sides of the gap?
bool PointsAreNearest(const Proof &proof, const b2Contact &contact) {
    if (Is(proof, "disks"))
        return true;
    const Side owner = {proof, contact, proof.owner}, other = {proof, contact, 1 - proof.owner};
    const b2Vec2 n = owner.Body().GetWorldVector(proof.normal);
    const double own = double{b2Dot(n, owner.Support())}, others = double{b2Dot(n, other.Support())};
    const b2Vec2 edge = owner.Body().GetWorldVector(proof.edge[1] - proof.edge[0]);
    return own >= owner.Farthest(n) - kRounding && others <= -other.Farthest(-n) + kRounding &&
           others - own >= double{proof.slack} - kRounding &&
           (Is(proof, "direction") || std::fabs(double{b2Dot(n, edge)}) <= kRounding);
}

/// Does a hull or envelope that is shown hold its side?
bool HullHolds(const Side &side, int32_t level) {
    const std::vector<b2Vec2> hull = InspectHull(side.contact, side.proof, side.number, level);
    bool holds = hull.size() >= 3;
    side.VisitVertices([&](b2Vec2 v) {
        const b2Vec2 local = side.Body().GetLocalPoint(v);
        for (size_t i = 0; i < hull.size(); ++i) {
            const b2Vec2 edge = hull[(i + 1) % hull.size()] - hull[i];
            holds =
                holds && double{b2Cross(edge, local - hull[i])} >= -kRounding * double{edge.Length()} - 1e-12;
        }
    });
    return holds;
}

struct Tally {
    size_t proofs = 0, none = 0, tooMuch = 0, notNearest = 0, notHeld = 0, refuted = 0, finer = 0,
           noneThoughPositive = 0;
    double slacks = 0.0, gaps = 0.0;
    std::set<std::string> kinds;
    size_t edgesOf[2] = {0, 0};

    void Look(const b2Contact &contact) {
        const Proof proof = Inspect(contact);
        if (Is(proof, "none")) {
            ++none;
            noneThoughPositive += proof.slack != 0.0f;
            return;
        }
        ++proofs;
        kinds.insert(proof.kind);
        edgesOf[proof.owner] += Is(proof, "remembered-edge");
        const double slack = double{proof.slack};
        slacks += slack;
        gaps += GapOf(proof, contact);
        tooMuch += slack > GapOf(proof, contact) + kRounding;
        refuted += slack > GapOf(proof, contact, 0.5f) + kRounding;
        notNearest += !PointsAreNearest(proof, contact);
        if (proof.structure == nullptr)
            return;
        for (const int side : {0, 1})
            notHeld += !HullHolds({proof, contact, side}, proof.level) ||
                       !HullHolds({proof, contact, side}, kHullLevel);
        finer += InspectHull(contact, proof, 0, 99).size() > InspectHull(contact, proof, 0, 0).size();
    }
    void Check(Run &run) const {
        run.Expect(noneThoughPositive == 0, "no slack without a proof");
        run.Expect(tooMuch == 0, "no proof claims more than its own line shows");
        run.Expect(slacks > 0.5 * gaps, "and most of what it shows");
        run.Expect(notNearest == 0, "its points are the nearest to the line");
        run.Expect(notHeld == 0, "hulls and envelopes hold their bodies");
    }
};

} // namespace

AS_STOCK("every proof that is shown can be checked by hand, and looking changes nothing") {
    shapes::Engine engine(11);
    Tally tally;
    int pairs = 0;
    for (size_t world = 0; world < test_scaled(120); ++world) {
        Heard game(run);
        game.world.SetGravity({0.0f, 0.0f});
        for (int i = 0; i < 6; ++i)
            Burr(game, engine, {shapes::UniformF(engine, -4.0, 4.0), shapes::UniformF(engine, -4.0, 4.0)},
                 i % 2 == 0 ? 4 : 1);
        for (int step = 0; step < 20; ++step) {
            game.Step();
            pairs += game.world.GetContactCount();
            if (!run.HasPlugin())
                continue;
            for (const b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext())
                tally.Look(*c);
        }
    }
    run.Stage(pairs > 0, "bodies are near each other");
    if (!run.HasPlugin())
        return;
    run.Expect(tally.proofs > 100, "there are proofs");
    run.Expect(tally.none > 0, "and pairs without");
    tally.Check(run);
    run.Expect(tally.refuted > tally.proofs / 10, "control: lines turned by half a radian prove less");
    run.Expect(tally.kinds.count("remembered-edge") == (run.RemembersEdges() ? 1u : 0u),
               "edges where they are remembered");
    run.Expect(run.RemembersEdges() || tally.kinds.size() > 1, "proofs of several kinds");
    const char *by = std::getenv("BOOMERANG_PAIRS_BY");
    run.Expect(run.RemembersEdges() || std::strncmp(by, "lazy", 4) != 0 || tally.finer > 0,
               "envelopes of finer levels have more vertices");
}

AS_STOCK("the proof of two big shapes is an edge of one of them, and holds for all their vertices") {
    shapes::Engine engine(13);
    Tally tally;
    for (int round = 0; round < 60; ++round) {
        Heard game(run);
        for (int i = 0; i < 2; ++i) {
            b2Body *body =
                game.Body(b2_dynamicBody, {1.12f * Real(i), 0.0f}, shapes::UniformF(engine, -3.0, 3.0));
            bmr::ConvexShape shape;
            run.Expect(shape.SetRegular(9 + shapes::Below(engine, round < 30 ? 1 : 60), 0.55f) == BMR_OK,
                       "a shape");
            game.Fixture(body, shape);
        }
        game.world.Step(1.0f / 60.0f, 8, 3);
        if (run.HasPlugin() && game.world.GetContactCount() > 0)
            tally.Look(*game.world.GetContactList());
    }
    run.Print("looked");
    // (Hulls must be farther apart than Box2D asks of an edge.)
    run.Expect(!run.HasPlugin() || !run.RemembersEdges() || tally.proofs > 50, "nearly all are apart");
    run.Expect(!run.HasPlugin() || !run.RemembersEdges() || (tally.edgesOf[0] > 0 && tally.edgesOf[1] > 0),
               "edges of either");
    tally.Check(run);
}
