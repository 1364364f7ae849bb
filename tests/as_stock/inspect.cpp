// SPDX-License-Identifier: MIT
// What Inspect shows of a pair is a proof that anybody can check, and looking at it changes nothing.
#include <set>

#include "as_stock.h"
#include "boomerang/convex_shape.h"
#include "boomerang/inspect.h"
#include "box2d_shapes.h"

using namespace as_stock;

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

/// Calls `visit` with each vertex, in the world, that one side of a proof speaks of.
template <typename Visit> void VisitVertices(const bmr::ProofSide &side, Visit visit) {
    for (const b2Fixture *f = side.body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        const bmr::ConvexShape *big = bmr::ConvexShape::From(f->GetShape());
        const auto &polygon = static_cast<const b2PolygonShape &>(*f->GetShape());
        const b2Vec2 *vertices = big != nullptr ? big->GetVertices() : polygon.m_vertices;
        const int32 count = big != nullptr ? big->GetVertexCount() : polygon.m_count;
        for (int32 i = 0; i < count && (side.fixture == nullptr || side.fixture == f); ++i)
            visit(b2Mul(side.body->GetTransform(), vertices[i]));
    }
}

double Farthest(const bmr::ProofSide &side, b2Vec2 direction) {
    double most = -INFINITY;
    VisitVertices(side, [&](b2Vec2 v) { most = std::max(most, double{b2Dot(v, direction)}); });
    return most;
}

/// The gap that the disks of a proof leave; -1 where one of them does not hold its side.
double GapOfDisks(const bmr::Proof &proof) {
    const b2Vec2 a = proof.a.body->GetWorldPoint(proof.a.support),
                 b = proof.b.body->GetWorldPoint(proof.b.support);
    bool hold = true;
    for (const bmr::ProofSide *side : {&proof.a, &proof.b}) {
        VisitVertices(*side, [&](b2Vec2 v) {
            const double distance = double{b2Distance(v, side == &proof.a ? a : b)};
            hold = hold && distance <= double{side->diskRadius} + kRounding;
        });
    }
    const double radii = double{proof.a.diskRadius} + double{proof.b.diskRadius};
    return hold ? double{b2Distance(a, b)} - radii : -1.0;
}

/// The gap between all of one side and all of the other along the line of a proof, found from nothing but the
/// line.
double GapOfLine(const bmr::Proof &proof, float turnedBy) {
    const bmr::ProofSide &owner = proof.ownerIsB ? proof.b : proof.a,
                         &other = proof.ownerIsB ? proof.a : proof.b;
    const b2Vec2 n = b2Mul(b2Rot(turnedBy), owner.body->GetWorldVector(proof.normal));
    return -Farthest(other, -n) - Farthest(owner, n);
}

double GapOf(const bmr::Proof &proof, float turnedBy = 0.0f) {
    return proof.kind == bmr::ProofKind::Disks ? GapOfDisks(proof) : GapOfLine(proof, turnedBy);
}

/// Do the points that a proof names lie where it says: the owner's and the other's on their sides of the gap?
bool PointsAreNearest(const bmr::Proof &proof) {
    if (proof.kind == bmr::ProofKind::Disks)
        return true;
    const bmr::ProofSide &owner = proof.ownerIsB ? proof.b : proof.a,
                         &other = proof.ownerIsB ? proof.a : proof.b;
    const b2Vec2 n = owner.body->GetWorldVector(proof.normal);
    const auto along = [n](const bmr::ProofSide &side, b2Vec2 local) {
        return double{b2Dot(n, side.body->GetWorldPoint(local))};
    };
    const double own = along(owner, owner.support), others = along(other, other.support);
    bool nearest = own >= Farthest(owner, n) - kRounding && others <= -Farthest(other, -n) + kRounding &&
                   others - own >= double{proof.slack} - kRounding;
    if (proof.kind != bmr::ProofKind::Direction)
        nearest =
            nearest && std::fabs(along(owner, proof.edge[0]) - along(owner, proof.edge[1])) <= kRounding;
    return nearest;
}

/// Does a hull or envelope that Inspect gives hold its side?
bool HullHolds(const bmr::Proof &proof, bool ofB, int32_t level) {
    std::vector<b2Vec2> hull(64);
    const int32_t count = bmr::InspectHull(proof, ofB, level, hull.data(), static_cast<int32_t>(hull.size()));
    if (count < 3 || count > 64)
        return false;
    const bmr::ProofSide &side = ofB ? proof.b : proof.a;
    bool holds = true;
    VisitVertices(side, [&](b2Vec2 v) {
        const b2Vec2 local = side.body->GetLocalPoint(v);
        for (int32_t i = 0; i < count; ++i) {
            const b2Vec2 from = hull[static_cast<size_t>(i)], to = hull[static_cast<size_t>((i + 1) % count)];
            const b2Vec2 edge = to - from;
            holds =
                holds && double{b2Cross(edge, local - from)} >= -kRounding * double{edge.Length()} - 1e-12;
        }
    });
    return holds;
}

/// Whatever the room, InspectHull says how many vertices there are, and writes the first of them.
bool FillsWhatThereIsRoomFor(const bmr::Proof &proof, int32_t level) {
    constexpr int32_t kRoom = 64;
    const int32_t count = bmr::InspectHull(proof, false, level, nullptr, 0);
    bool right = count >= 3 && count < kRoom;
    for (int32_t capacity = 0; capacity <= kRoom; ++capacity) {
        b2Vec2 vertices[kRoom];
        std::fill_n(vertices, kRoom, b2Vec2(NAN, NAN));
        right = right && bmr::InspectHull(proof, false, level, vertices, capacity) == count;
        for (int32_t i = 0; i < kRoom; ++i)
            right = right && vertices[i].IsValid() == (i < std::min(count, capacity));
    }
    return right;
}

struct Tally {
    size_t proofs = 0, none = 0, tooMuch = 0, notNearest = 0, notHeld = 0, refuted = 0,
           noneThoughPositive = 0;
    double slacks = 0.0, gaps = 0.0;
    std::set<bmr::ProofKind> kinds;

    void Look(const bmr::Proof &proof) {
        if (proof.kind == bmr::ProofKind::None) {
            ++none;
            noneThoughPositive += proof.slack != 0.0f;
            return;
        }
        ++proofs;
        kinds.insert(proof.kind);
        const double slack = double{proof.slack};
        slacks += slack;
        gaps += GapOf(proof);
        tooMuch += slack > GapOf(proof) + kRounding;
        refuted += slack > GapOf(proof, 0.5f) + kRounding;
        notNearest += !PointsAreNearest(proof);
        if (proof.structure != nullptr)
            for (const bool ofB : {false, true})
                notHeld += !HullHolds(proof, ofB, proof.level) || !HullHolds(proof, ofB, bmr::kHullLevel);
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
        std::vector<b2Body *> bodies;
        for (int i = 0; i < 6; ++i)
            bodies.push_back(Burr(game, engine,
                                  {shapes::UniformF(engine, -4.0, 4.0), shapes::UniformF(engine, -4.0, 4.0)},
                                  i % 2 == 0 ? 4 : 1));
        for (int step = 0; step < 20; ++step) {
            game.Step();
            pairs += game.world.GetContactCount();
            if (!run.HasPlugin())
                continue;
            for (const b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext())
                tally.Look(bmr::Inspect(*c));
        }
    }
    run.Stage(pairs > 0, "bodies are near each other");
    if (!run.HasPlugin())
        return;
    run.Expect(tally.proofs > 100, "there are proofs");
    run.Expect(tally.none > 0, "and pairs without");
    run.Expect(tally.noneThoughPositive == 0, "no slack without a proof");
    run.Expect(tally.tooMuch == 0, "no proof claims more than its own line shows");
    run.Expect(tally.slacks > 0.5 * tally.gaps, "and most of what it shows");
    run.Expect(tally.notNearest == 0, "its points are the nearest to the line");
    run.Expect(tally.notHeld == 0, "hulls and envelopes hold their bodies");
    run.Expect(tally.refuted > tally.proofs / 10, "control: lines turned by half a radian prove less");
    run.Expect(tally.kinds.count(bmr::ProofKind::RememberedEdge) == (run.RemembersEdges() ? 1u : 0u),
               "edges where they are remembered");
    run.Expect(run.RemembersEdges() || tally.kinds.size() > 1, "proofs of several kinds");
}

AS_STOCK("the proof of two big shapes is an edge of one of them, and holds for all their vertices") {
    shapes::Engine engine(13);
    Tally tally;
    int touching = 0, edgesOf[2] = {0, 0};
    for (int round = 0; round < 60; ++round) {
        Heard game(run);
        const b2Body *bodies[2];
        for (int i = 0; i < 2; ++i) {
            b2Body *body =
                game.Body(b2_dynamicBody, {1.12f * Real(i), 0.0f}, shapes::UniformF(engine, -3.0, 3.0));
            bmr::ConvexShape shape;
            run.Expect(shape.SetRegular(9 + shapes::Below(engine, round < 30 ? 1 : 60), 0.55f) == BMR_OK,
                       "a shape");
            game.Fixture(body, shape);
            bodies[i] = body;
        }
        game.world.Step(1.0f / 60.0f, 8, 3);
        if (!run.HasPlugin())
            continue;
        const bmr::Proof proof = bmr::Inspect(bodies[0], bodies[1]);
        tally.Look(proof);
        touching += proof.kind == bmr::ProofKind::None;
        if (proof.kind == bmr::ProofKind::RememberedEdge)
            ++edgesOf[proof.ownerIsB];
    }
    run.Print("looked");
    // (Hulls must be farther apart than Box2D asks of an edge.)
    run.Expect(!run.RemembersEdges() || touching < 10, "nearly all are apart");
    run.Expect(!run.RemembersEdges() || (edgesOf[0] > 0 && edgesOf[1] > 0), "edges of either");
    run.Expect(tally.tooMuch == 0, "no proof claims more than its own line shows");
    run.Expect(tally.slacks > 0.5 * tally.gaps, "and most of what it shows");
    run.Expect(tally.notNearest == 0, "its points are the nearest to the line");
}

AS_STOCK("no more vertices of a hull are filled in than there are and than there is room for") {
    shapes::Engine engine(14);
    size_t looked = 0, wrong = 0;
    int32_t finer = 0;
    for (int world = 0; world < 20; ++world) {
        Heard game(run);
        Burr(game, engine, {0.0f, 0.0f}, 4);
        Burr(game, engine, {1.2f, 0.3f}, 4);
        game.world.Step(1.0f / 60.0f, 8, 3);
        if (!run.HasPlugin())
            continue;
        for (const b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext()) {
            const bmr::Proof proof = bmr::Inspect(*c);
            if (proof.structure == nullptr)
                continue;
            finer += bmr::InspectHull(proof, false, 99, nullptr, 0) -
                     bmr::InspectHull(proof, false, 0, nullptr, 0);
            for (const int32_t level : {0, bmr::kHullLevel}) {
                ++looked;
                wrong += !FillsWhatThereIsRoomFor(proof, level);
            }
        }
    }
    run.Print("looked");
    run.Expect(!run.HasPlugin() || run.RemembersEdges() || looked > 0, "there is something to look at");
    run.Expect(wrong == 0, "these, and no others");
    const char *by = std::getenv("BOOMERANG_PAIRS_BY");
    run.Expect(!run.HasPlugin() || run.RemembersEdges() || std::strncmp(by, "lazy", 4) != 0 || finer > 0,
               "more on a finer level");
}

AS_STOCK("two bodies are as far apart as the weakest proof between them") {
    shapes::Engine engine(12);
    size_t looked = 0, unlike = 0;
    for (int world = 0; world < 100; ++world) { // at every scale: few worlds have such a pair
        Heard game(run);
        const b2Body *a = Burr(game, engine, {0.0f, 0.0f}, 3), *b = Burr(game, engine, {0.9f, 0.3f}, 3);
        game.world.Step(1.0f / 60.0f, 8, 3);
        if (!run.HasPlugin() || game.world.GetContactCount() == 0)
            continue;
        float least = INFINITY;
        for (const b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext())
            least = std::min(least, bmr::Inspect(*c).slack);
        ++looked;
        unlike += bmr::Inspect(a, b).slack != least || bmr::Inspect(b, a).slack != least;
    }
    run.Print("looked");
    run.Expect(!run.HasPlugin() || looked > 10, "there is something to look at");
    run.Expect(unlike == 0, "the least of them");
}

TEST_CASE("every kind of proof has a name of its own") {
    std::set<std::string> names;
    for (int kind = 0; kind < static_cast<int>(bmr::ProofKind::Count); ++kind)
        names.insert(bmr::NameOf(static_cast<bmr::ProofKind>(kind)));
    CHECK(names == std::set<std::string>{"none", "disks", "edge-line", "direction", "remembered-edge"});
    CHECK(bmr::NameOf(bmr::ProofKind::Count) == nullptr);
}
