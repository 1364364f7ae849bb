// SPDX-License-Identifier: MIT
#include "glue/contacts/convex_contact.h"

#include <utility>

#include <box2d/b2_chain_shape.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>

#include "base/private_members.h"
#include "base/rounding_mode.h"
#include "convex32/convex32_distance.h"
#include "debug/statistics.h"
#include "glue/proofs/thresholds.h"
#include "start/settings.h"

namespace bmr {

namespace {

/// Box2D's: the second polygon's face must be better by this to be the reference.
constexpr float kTolerance = 0.1f * b2_linearSlop;

/// The polygon of a fixture, with its seams or without.
bmr_convex32 PolygonWith(Seams seams, const b2Fixture &fixture) {
    bmr_convex32 polygon = RealPolygon(fixture);
    if (seams == Seams::Ignored)
        polygon.seams = nullptr;
    return polygon;
}

} // namespace

b2EdgeShape LinkOf(const b2Fixture &fixture, int32 child) {
    if (fixture.GetType() == b2Shape::e_edge)
        return *static_cast<const b2EdgeShape *>(fixture.GetShape());
    b2EdgeShape link;
    static_cast<const b2ChainShape *>(fixture.GetShape())->GetChildEdge(&link, child);
    return link;
}

bmr_edge32 EdgeOf(const b2Fixture *fixture, int32 child) {
    return fixture->GetType() == b2Shape::e_edge
               ? Edge32(*static_cast<const b2EdgeShape *>(fixture->GetShape()))
               : Edge32(LinkOf(*fixture, child));
}

/// Which it is is decided by what the fixtures are, and by no more: their shapes may be changed in place.
void CollideConvex(const TwoFixtures &two, Seams seams, b2Manifold *manifold, const b2Transform &xfA,
                   const b2Transform &xfB, bmr_convex32_memory *memory) {
    bmr_manifold32 *const made = Manifold32(manifold);
    const float radii = two.RadiusSum();
    if (two.b->GetType() == b2Shape::e_circle) {
        const bmr_convex32 polygon = PolygonWith(seams, *two.a);
        const auto *circle = static_cast<const b2CircleShape *>(two.b->GetShape());
        bmr_convex32_collide_circle(made, &polygon, Transform32(xfA), *Vectors32(&circle->m_p),
                                    Transform32(xfB), radii, memory);
        return;
    }
    const bmr_convex32 b = PolygonWith(seams, *two.b);
    if (two.a->GetType() != b2Shape::e_polygon) {
        const bmr_edge32 edge = EdgeOf(two.a, two.childA);
        const auto *polygon = static_cast<const b2PolygonShape *>(two.b->GetShape());
        bmr_convex32_collide_edge(made, &edge, Transform32(xfA), &b, *Vectors32(&polygon->m_centroid),
                                  Transform32(xfB), radii, memory);
        return;
    }
    const bmr_convex32 a = PolygonWith(seams, *two.a);
    bmr_convex32_collide(made, &a, Transform32(xfA), &b, Transform32(xfB), radii, kTolerance, memory);
}

double ReachOf(const b2Fixture &fixture) {
    if (const bmr_convex32_block *big = BigPolygonOf(*fixture.GetShape()))
        return static_cast<double>(big->reach);
    const b2PolygonShape &small = *PolygonOf(fixture);
    return static_cast<double>(
        bmr_proxy32_points(Vectors32(small.m_vertices), static_cast<uint32_t>(small.m_count), 0.0f).reach);
}

namespace {

/// A point that the last manifold did not have goes on with the impulse of the nearest one it had, however
/// far: that of a polygon that rolls over a corner is two edges off, and a pile whose contacts begin anew
/// with every edge sinks into itself.
constexpr float kFeatureDistance = 1e9f; // beyond every polygon

/// Are the disks around the bodies' origins that hold the two polygons farther apart than this? Coins are
/// known apart by that nearly always, and it is a tenth of the search's work.
bool DisksSayApart(const b2Fixture *fixtureA, const b2Transform &xfA, const b2Fixture *fixtureB,
                   const b2Transform &xfB, float margin) {
    const bmr_convex32_block *a = BigPolygonOf(*fixtureA->GetShape()),
                             *b = BigPolygonOf(*fixtureB->GetShape());
    if (a == nullptr || b == nullptr)
        return false;
    constexpr auto kFar = static_cast<float>(kReach); // the margin holds what rounding takes up to there
    const b2Vec2 between = xfB.p - xfA.p, sum = b2Abs(xfA.p) + b2Abs(xfB.p);
    const float least = a->reach + b->reach + margin;
    return b2Dot(between, between) > least * least && sum.x + sum.y + least < kFar;
}

/// Puts the deeper of two points first. Of two points that are near each other (a fortieth of a disc's
/// radius) b2ContactSolver takes the first alone: were that always the one behind, a wheel would roll by
/// itself.
void PutDeeperFirst(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) {
    if (manifold->pointCount < 2)
        return;
    const bool faceOfA = manifold->type == b2Manifold::e_faceA;
    const b2Rot &reference = faceOfA ? xfA.q : xfB.q, &incident = faceOfA ? xfB.q : xfA.q;
    b2ManifoldPoint *const points = manifold->points;
    const b2Vec2 between = b2Mul(incident, points[1].localPoint - points[0].localPoint);
    if (b2Dot(b2Mul(reference, manifold->localNormal), between) < 0.0f)
        std::swap(points[0], points[1]);
}

} // namespace

bool ConvexContact::Serves(const b2Shape &a, const b2Shape &b) {
    return BigPolygonOf(a) != nullptr || BigPolygonOf(b) != nullptr;
}

inline Answer ConvexContact::Ask(const b2Transform &xfA, const b2Transform &xfB) {
    if (!RoundsToNearest())
        return Answer::HandedOver;
    // As PolygonContact has it: what touched most likely does still.
    if (m_manifold.pointCount > 0)
        return Answer::Touching;
    if (!IsOfPolygons()) // there the search for the manifold begins with that search
        return Answer::HandedOver;
    if (PairsAreHulls())
        return HullsSayApart(xfA, xfB) ? Answer::ApartByPair : Answer::HandedOver;
    return SearchApart(xfA, xfB);
}

bmr_vec2 ConvexContact::KnownDirection() const {
    return {static_cast<double>(state.closest.axis_x), static_cast<double>(state.closest.axis_y)};
}

inline float ConvexContact::Margin() const {
    return static_cast<float>(ContactMargin(static_cast<double>(RadiusSum())));
}

inline Answer ConvexContact::SearchApart(const b2Transform &xfA, const b2Transform &xfB) {
    const float margin = Margin();
    if (DisksSayApart(m_fixtureA, xfA, m_fixtureB, xfB, margin))
        return Answer::ApartByEdge;
    if (!WithinReach(xfA, ReachOf(*m_fixtureA)) || !WithinReach(xfB, ReachOf(*m_fixtureB)))
        return Answer::HandedOver;
    const bmr_convex32 a = RealPolygon(*m_fixtureA), b = RealPolygon(*m_fixtureB);
    const bmr_convex32_memory before = state.closest;
    if (!bmr_convex32_apart(&a, Transform32(xfA), &b, Transform32(xfB), margin, &state.closest))
        return Answer::HandedOver;
    const bool isSame = before.axis_x == state.closest.axis_x && before.axis_y == state.closest.axis_y;
    return isSame ? Answer::ApartByEdge : Answer::ApartBySearch;
}

/// For the events of the contact alone: what is asked here changes no memory.
ProofResult ConvexContact::ResultOf(Answer answer, bool points, const b2Transform &xfA,
                                    const b2Transform &xfB) const {
    if (answer == Answer::ApartBySearch)
        return ProofResult::Another;
    if (answer == Answer::HandedOver || points)
        return ProofResult::Nothing;
    if (DisksSayApart(m_fixtureA, xfA, m_fixtureB, xfB, Margin()))
        return ProofResult::ByDisks;
    if (answer == Answer::ApartByEdge)
        return ProofResult::Remembered;
    // The two were taken for touching, and do not touch: no proof was looked for.
    const bmr_convex32 a = RealPolygon(*m_fixtureA), b = RealPolygon(*m_fixtureB);
    bmr_convex32_memory memory = state.closest;
    return WithinReach(xfA, ReachOf(*m_fixtureA)) && WithinReach(xfB, ReachOf(*m_fixtureB)) &&
                   bmr_convex32_apart(&a, Transform32(xfA), &b, Transform32(xfB), Margin(), &memory)
               ? ProofResult::Another
               : ProofResult::Nothing;
}

void ConvexContact::Fill(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) {
    const b2Manifold old = m_manifold; // most likely the one that is written
    const Answer answer = Ask(xfA, xfB);
    if (IsApart(answer)) {
        manifold->pointCount = 0;
    } else {
        const TwoFixtures two = Two();
        CollideConvex(two, Seams::Known, manifold, xfA, xfB, &state.closest);
        if (manifold->pointCount == 0 && HasSeams(two))
            AnswerForOthers(*this, two, IsAtImpact(), manifold, xfA, xfB, state.closest);
        PutDeeperFirst(manifold, xfA, xfB);
        if (manifold->pointCount > 0)
            bmr_convex32_keep_features(Manifold32(manifold), Manifold32(&old), kFeatureDistance);
    }
    if (GetSettings().options.statistics) {
        if (IsOfPolygons() && !PairsAreHulls())
            TakeResult(ResultOf(answer, manifold->pointCount > 0, xfA, xfB));
        ReportAnswer(*this, answer, true);
    }
}

/// As b2World::SolveTOI has it when it asks whether a contact that it found to impact touches: both bodies
/// are where the impact is, and nowhere else, and the contact still says when that is.
bool ConvexContact::IsAtImpact() const {
    const b2Sweep &a = SweepOf(*m_fixtureA->GetBody()), &b = SweepOf(*m_fixtureB->GetBody());
    const float time = (m_flags & e_toiFlag) != 0 ? m_toi : 1.0f;
    return time < 1.0f && a.alpha0 == time && b.alpha0 == time && a.c0 == a.c && a.a0 == a.a && b.c0 == b.c &&
           b.a0 == b.a;
}

} // namespace bmr
