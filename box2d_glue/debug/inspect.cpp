// SPDX-License-Identifier: MIT
#include "debug/inspect.h"

#include <algorithm>
#include <cmath>

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

#include "convex32/convex32_collide.h"
#include "glue/contacts/convex_contact.h"
#include "glue/contacts/solid_contact.h"
#include "glue/pairs/pair_tables.h"
#include "glue/proofs/thresholds.h"
#include "start/settings.h"

namespace bmr {

using internal::Proof;

namespace {

b2Vec2 Float(const bmr_vec2 &v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

b2Vec2 FromCertificate(const float v[2]) {
    return {v[0], v[1]};
}

/// Rounded down: still a lower bound.
float Slack(double gap) {
    return gap > 0.0 ? std::nextafterf(static_cast<float>(gap), 0.0f) : 0.0f;
}

bool IsSolidPolygon(const b2Fixture &fixture) {
    return fixture.GetType() == b2Shape::e_polygon && !fixture.IsSensor();
}

// The structure of two hulls.

/// A hierarchy's own level for a level of the pair: where one is deeper, the other's polygon stays.
uint32_t LevelOf(const bmr_hierarchy &hierarchy, int32_t level) {
    return std::min(static_cast<uint32_t>(std::max(level, 0)), bmr_hierarchy_depth(&hierarchy));
}

/// Two hulls of a proof: the first one is the owner's. `sides`: of which fixture of the contact each is.
struct TwoHulls {
    const Hull &own, &other;
    int sides[2];
};

/// The pair remembers which vertex of the other was the nearest when the direction was taken; by now it may
/// be another.
void FillDirection(const TwoHulls &hulls, const bmr_pair &kinetic, Proof *proof) {
    proof->kind = "direction";
    const b2Vec2 facing = hulls.other.Body()->GetLocalVector(
        hulls.own.Body()->GetWorldVector(-FromCertificate(kinetic.certificate.normal)));
    const bmr_polygon &own = *hulls.own.Shape().polygon, &other = *hulls.other.Shape().polygon;
    proof->supports[hulls.sides[0]] = Float(own.vertices[kinetic.edge]);
    proof->supports[hulls.sides[1]] =
        Float(other.vertices[bmr_polygon_support_from(&other, Double(facing), kinetic.other)]);
}

void FillEdgeLine(const TwoHulls &hulls, const bmr_pair &kinetic, Proof *proof) {
    proof->kind = "edge-line";
    const bmr_hierarchy &own = *hulls.own.Hierarchy(), &other = *hulls.other.Hierarchy();
    const uint32_t level = LevelOf(own, kinetic.level);
    const bmr_corner ends[2] = {bmr_hierarchy_corner_before(&own, kinetic.edge, level),
                                bmr_hierarchy_corner_after(&own, kinetic.edge, level)};
    for (int i = 0; i < 2; ++i)
        proof->edge[i] = Float(bmr_hierarchy_corner_point(&own, ends[i]));
    const bmr_corner facing = bmr_hierarchy_corner(&other, kinetic.other, kinetic.other_after);
    proof->supports[hulls.sides[0]] = proof->edge[0];
    proof->supports[hulls.sides[1]] = Float(bmr_hierarchy_corner_point(&other, facing));
}

/// With Options::pairsBy: what the bodies' structure proves at their poses.
void AskHulls(const b2Contact &contact, Proof *proof) {
    PairTable *const table =
        FindPairTable(&contact.GetFixtureA()->GetBody()->GetWorld()->GetContactManager());
    const HullPair *const pair =
        table != nullptr ? table->hullPairs.Find(table->NumberOf(&contact)) : nullptr;
    double gap = 0.0;
    const bmr_pair kinetic = pair != nullptr ? KineticPairNow(*pair, &gap) : bmr_pair{};
    if (!(gap > 0.0))
        return;
    const int first = pair->IsSwapped(contact) ? 1 : 0; // the side of the pair's first hull
    proof->slack = Slack(gap);
    proof->structure = pair;
    proof->fixtures[first] = pair->a->Fixture();
    proof->fixtures[1 - first] = pair->b->Fixture();
    if (kinetic.level == BMR_LEVEL_DISKS) {
        proof->kind = "disks";
        proof->supports[first] = FromCertificate(kinetic.certificate.normal);
        proof->supports[1 - first] = FromCertificate(kinetic.certificate.window[0]);
        proof->radii[first] = static_cast<float>(pair->a->Shape().polygon->radius);
        proof->radii[1 - first] = static_cast<float>(pair->b->Shape().polygon->radius);
        return;
    }
    proof->owner = kinetic.owner == 0 ? first : 1 - first;
    proof->normal = FromCertificate(kinetic.certificate.normal);
    const Hull *const hulls[2] = {pair->a, pair->b};
    const TwoHulls two = {*hulls[kinetic.owner], *hulls[1 - kinetic.owner], {proof->owner, 1 - proof->owner}};
    if (two.own.Hierarchy() == nullptr || two.other.Hierarchy() == nullptr || kinetic.free != 0)
        FillDirection(two, kinetic, proof);
    else
        FillEdgeLine(two, kinetic, proof);
}

// An edge of one of the two fixtures.

/// The separation of a polygon fixture from another's polygon along an edge of its own.
struct FaceGap {
    float separation; ///< as Box2D computes it
    int32_t edge;
};

bmr_transform32 FrameOf(const b2Fixture &owner, const b2Fixture &other) {
    return bmr_exact32_relative(Transform32(other.GetBody()->GetTransform()),
                                Transform32(owner.GetBody()->GetTransform()));
}

/// Along the edge of the owner that has the largest; of the real polygons.
FaceGap LargestFaceGap(const b2Fixture &owner, const b2Fixture &other) {
    const bmr_transform32 frame = FrameOf(owner, other);
    const bmr_convex32 own = RealPolygon(owner), others = RealPolygon(other);
    uint32_t edge = 0, vertex = 0;
    const float separation = bmr_convex32_max_separation(&own, &others, &frame, 0, &edge, &vertex);
    return {separation, static_cast<int32_t>(edge)};
}

/// How far the owner's own vertices lie beyond the line of its edge, in units of the normal: nowhere but by
/// rounding, unless vertices or normals were edited in place. A NaN makes it infinite.
double Overhang(const bmr_convex32 &owner, int32_t edge) {
    const bmr_vec32 &n = owner.normals[edge], &foot = owner.vertices[edge];
    constexpr float kLongest = 1.0f + 1e-5f; // of a square; a shorter normal makes separations smaller
    if (!(n.x * n.x + n.y * n.y <= kLongest))
        return INFINITY;
    float most = 0.0f;
    for (uint32_t i = 0; i < owner.count; ++i) {
        const float beyond = n.x * (owner.vertices[i].x - foot.x) + n.y * (owner.vertices[i].y - foot.y);
        if (!(beyond <= most))
            most = beyond;
    }
    return static_cast<double>(most);
}

/// If the edge separates the two in Box2D's sense, it is the proof. Its slack is the separation less what its
/// arithmetic may be off by (glue/proofs/thresholds.md).
bool AskEdge(const FaceGap &gap, const b2Fixture *const (&fixtures)[2], int owner, Proof *proof) {
    const b2Fixture &mine = *fixtures[owner], &theirs = *fixtures[1 - owner];
    if (!(gap.separation > mine.GetShape()->m_radius + theirs.GetShape()->m_radius))
        return false;
    const bmr_convex32 own = RealPolygon(mine), others = RealPolygon(theirs);
    const auto first = static_cast<uint32_t>(gap.edge), second = first + 1 == own.count ? 0 : first + 1;
    proof->kind = "remembered-edge";
    proof->owner = owner;
    proof->normal = *Vectors(&own.normals[first]);
    proof->edge[0] = *Vectors(&own.vertices[first]);
    proof->edge[1] = *Vectors(&own.vertices[second]);
    const bmr_vec32 between = FrameOf(mine, theirs).p;
    const double distance = std::hypot(static_cast<double>(between.x), static_cast<double>(between.y));
    if (distance + ReachOf(mine) + ReachOf(theirs) < kReach)
        proof->slack = Slack(static_cast<double>(gap.separation) - kRoundingMargin - Overhang(own, gap.edge));
    const b2Vec2 facing =
        b2MulT(theirs.GetBody()->GetTransform().q, b2Mul(mine.GetBody()->GetTransform().q, -proof->normal));
    proof->supports[owner] = proof->edge[0];
    proof->supports[1 - owner] =
        *Vectors(&others.vertices[bmr_convex32_support(&others, *Vectors32(&facing))]);
    for (int i = 0; i < 2; ++i)
        proof->fixtures[i] = fixtures[i];
    return true;
}

bool AskRememberedEdge(const PolygonContact &contact, const b2Fixture *const (&fixtures)[2], Proof *proof) {
    const EdgeMemory &memory = contact.state.edge;
    const int owner = memory.ofB ? 1 : 0;
    const b2Fixture &mine = *fixtures[owner], &theirs = *fixtures[1 - owner];
    const bmr_polygon32 own = Polygon32(*PolygonOf(mine)), others = Polygon32(*PolygonOf(theirs));
    if (!PolygonContact::Serves(*mine.GetShape(), *theirs.GetShape()) || memory.number >= own.count)
        return false;
    const bmr_transform32 frame = FrameOf(mine, theirs);
    return AskEdge({bmr_exact32_edge_separation(&own, memory.number, &others, &frame), memory.number},
                   fixtures, owner, proof);
}

/// In the order of PolygonContact::Fill, and of ConvexContact's, which remembers vertices and no edge.
void AskEdges(const b2Contact &contact, Proof *proof) {
    const b2Fixture *const fixtures[2] = {contact.GetFixtureA(), contact.GetFixtureB()};
    const PolygonContact *const small = PolygonContact::AsOurs(&contact);
    if (small != nullptr && AskRememberedEdge(*small, fixtures, proof))
        return;
    for (int owner = 0; owner < 2; ++owner)
        if (AskEdge(LargestFaceGap(*fixtures[owner], *fixtures[1 - owner]), fixtures, owner, proof))
            return;
}

} // namespace

Proof internal::Inspect(const b2Contact &contact) {
    Proof proof;
    if (SolidContact::AsOurs(&contact) == nullptr || contact.GetManifold()->pointCount > 0 ||
        !IsSolidPolygon(*contact.GetFixtureA()) || !IsSolidPolygon(*contact.GetFixtureB()))
        return proof;
    if (PairsAreHulls())
        AskHulls(contact, &proof);
    else
        AskEdges(contact, &proof);
    return proof;
}

} // namespace bmr
