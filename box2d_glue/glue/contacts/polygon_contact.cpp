// SPDX-License-Identifier: MIT
#include "glue/contacts/polygon_contact.h"

#include <box2d/b2_collision.h>
#include <box2d/b2_fixture.h>

#include "base/rounding_mode.h"
#include "debug/statistics.h"
#include "shapes/big_polygons.h"
#include "shapes/shapes32.h"
#include "start/settings.h"

namespace bmr {

namespace {

const b2PolygonShape &ShapeOf(const b2Fixture *fixture) {
    return *static_cast<const b2PolygonShape *>(fixture->GetShape());
}

/// `edgeFound`: an edge was searched, and separates the two. (So it may in the end of two that were taken for
/// touching.)
ProofResult ResultOf(Answer answer, bool edgeFound) {
    if (edgeFound)
        return ProofResult::Another;
    return answer == Answer::ApartByEdge ? ProofResult::Remembered : ProofResult::Nothing;
}

} // namespace

bool PolygonContact::Serves(const b2Shape &a, const b2Shape &b) {
    return !AnyBigPolygon() || (BigPolygonOf(a) == nullptr && BigPolygonOf(b) == nullptr);
}

void PolygonContact::Evaluate(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) {
    NoteOtherCaller();
    FillManifold(Ask(xfA, xfB), manifold, xfA, xfB);
}

void PolygonContact::MakeManifold(bool touched, b2Manifold *old) {
    const b2Transform &xfA = m_fixtureA->GetBody()->GetTransform(),
                      &xfB = m_fixtureB->GetBody()->GetTransform();
    const Answer answer = Ask(xfA, xfB);
    if (touched || answer >= Answer::HandedOver)
        *old = m_manifold;
    FillManifold(answer, &m_manifold, xfA, xfB);
}

inline Answer PolygonContact::Ask(const b2Transform &xfA, const b2Transform &xfB) {
    // What touched at the last update most likely touches still: no question asked. (Its own manifold is
    // read, not the caller's, which may be uninitialised.)
    if (m_manifold.pointCount > 0)
        return Answer::Touching;
    if (!RoundsToNearest())
        return Answer::HandedOver;
    if (PairsAreHulls())
        return HullsSayApart(xfA, xfB) ? Answer::ApartByPair : Answer::HandedOver;
    if (EdgeSaysApart(xfA, xfB))
        return Answer::ApartByEdge;
    return Answer::HandedOver; // a manifold begins with the search for an edge
}

/// The manifold, once it has been asked whether the two are apart.
inline void PolygonContact::FillManifold(Answer answer, b2Manifold *manifold, const b2Transform &xfA,
                                         const b2Transform &xfB) {
    bool edgeFound = false;
    if (answer < Answer::HandedOver)
        manifold->pointCount = 0;
    else if (!ManifoldIsMadeHere())
        b2CollidePolygons(manifold, &ShapeOf(m_fixtureA), xfA, &ShapeOf(m_fixtureB), xfB);
    else
        edgeFound = CollideHere(manifold, xfA, xfB);
    if (edgeFound && answer == Answer::HandedOver)
        answer = Answer::ApartBySearch;
    if (GetSettings().options.statistics) {
        if (!PairsAreHulls()) // else the structure of the two bodies has events
            TakeResult(ResultOf(answer, edgeFound));
        CountAnswer(answer);
    }
}

void PolygonContact::CountAnswer(Answer answer) const {
    if (answer < Answer::Touching && !PairsAreHulls())
        Count(&Counts::edgeChecks);
    ReportAnswer(*this, answer, ManifoldIsMadeHere());
}

/// Are there manifolds with Box2D's bits to be had without it? (Set makes polygons of 3 vertices and more; a
/// polygon that was never Set has none.)
inline bool PolygonContact::ManifoldIsMadeHere() const {
    const auto known = [](const b2PolygonShape &shape) { return shape.m_count >= 3 && shape.m_count <= 8; };
    return RoundsToNearest() && known(ShapeOf(m_fixtureA)) && known(ShapeOf(m_fixtureB));
}

/// b2CollidePolygons; where a face separates the two, remembers it and returns true.
inline bool PolygonContact::CollideHere(b2Manifold *manifold, const b2Transform &xfA,
                                        const b2Transform &xfB) {
    constexpr float kTolerance = 0.1f * b2_linearSlop; // Box2D's: B's face must be better by this
    const bmr_polygon32 a = Polygon32(ShapeOf(m_fixtureA)), b = Polygon32(ShapeOf(m_fixtureB));
    const int32_t edge = bmr_exact32_collide(Manifold32(manifold), &a, Transform32(xfA), &b, Transform32(xfB),
                                             RadiusSum(), kTolerance);
    // (With Options::pairsBy no update asks this edge: it is the direction of the pair's line.)
    state.edge.ofB = edge >= BMR_EDGES_OF_B32;
    state.edge.number = static_cast<uint8_t>(edge == BMR_NO_EDGE32 ? kNoEdge : edge & (BMR_EDGES_OF_B32 - 1));
    return edge != BMR_NO_EDGE32;
}

/// Box2D's own test on one edge alone: where that edge's separation is larger than the radii, so is the
/// largest.
inline bool PolygonContact::EdgeSeparates(uint8_t number, bool ofB, const b2Transform &xfA,
                                          const b2Transform &xfB) const {
    const b2PolygonShape &a = ShapeOf(m_fixtureA), &b = ShapeOf(m_fixtureB);
    const b2PolygonShape &owner = ofB ? b : a, &other = ofB ? a : b;
    // Also where no edge is remembered; and vertices may have been edited in place: the edge may be gone.
    if (number >= owner.m_count)
        return false;
    const float separation = bmr_exact32_posed_separation(
        Vectors32(owner.m_vertices) + number, Vectors32(owner.m_normals) + number,
        Transform32(ofB ? xfB : xfA), Vectors32(other.m_vertices), other.m_count,
        Transform32(ofB ? xfA : xfB));
    return separation > a.m_radius + b.m_radius;
}

inline bool PolygonContact::EdgeSaysApart(const b2Transform &xfA, const b2Transform &xfB) const {
    return EdgeSeparates(state.edge.number, state.edge.ofB, xfA, xfB);
}

bmr_vec2 PolygonContact::KnownDirection() const {
    const EdgeMemory &memory = state.edge;
    const bool ofB = memory.ofB;
    const b2Fixture *owner = ofB ? m_fixtureB : m_fixtureA;
    if (memory.isVertex || memory.number >= ShapeOf(owner).m_count)
        return {0.0, 0.0};
    const b2Vec2 normal = b2Mul(owner->GetBody()->GetTransform().q, ShapeOf(owner).m_normals[memory.number]);
    const bmr_vec2 d = {static_cast<double>(normal.x), static_cast<double>(normal.y)};
    return ofB ? bmr_neg(d) : d;
}

} // namespace bmr
