// SPDX-License-Identifier: MIT
#include "glue/proofs/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <box2d/b2_distance.h>

#include "exact32/swept32.h"
#include "glue/proofs/convex_distance.h"
#include "glue/proofs/thresholds.h"
#include "shapes/shapes32.h"

namespace bmr {

namespace {

/// Two shapes at their poses. thresholds.md beside this derives what b2Distance says of them. Of shapes that
/// are deep inside each other it says 0, or what its arithmetic is off by (Rounding), which their skins must
/// cover. Of others it is right where it ends because a support came twice.
struct PlacedShapes {
    b2DistanceProxy a, b;
    const b2Transform &xfA, &xfB;

    float Radius() const { return a.m_radius + b.m_radius; }
};

float LargestCoordinate(const b2Vec2 &p) {
    return std::max(std::fabs(p.x), std::fabs(p.y));
}

/// By how much Box2D's arithmetic may be off; `reach` is the largest coordinate of a point in its shape's
/// frame.
float Rounding(const PlacedShapes &q, float reach) {
    constexpr float kDiagonal = 1.41422f;
    const float x = std::max(LargestCoordinate(q.xfA.p), LargestCoordinate(q.xfB.p)) + kDiagonal * reach;
    if (!(x <= kSweepReach))
        return INFINITY;
    return 2.0f * kUnit * (kErrorPerCoordinate * x + kErrorPerReach * kDiagonal * reach);
}

/// b2TestOverlap's threshold is 10 epsilon beyond the radii. Radii below zero take nothing off a distance of
/// the shapes themselves, which is 0 as soon as they overlap: they count as 0. (A NaN stays one.)
float ApartBeyond(const PlacedShapes &q, float rounding) {
    return std::max(q.Radius(), 0.0f) * (1.0f + kUnit * kErrorPerDistance) + 10.0f * b2_epsilon + rounding;
}

/// Do these turn only, and not scale too? What b2Rot makes does, to 2.4 units of its square's length and 2 of
/// the sum here; a caller may bring any numbers.
bool IsRotation(const b2Rot &q) {
    constexpr float kMost = 8.0f * kUnit;
    return std::fabs(q.s * q.s + q.c * q.c - 1.0f) <= kMost;
}

/// A normal's length may be off by 6 units; so that of a direction that is as long as it should be.
bool IsDirection(bmr_vec32 n) {
    constexpr float kMost = 12.0f * kUnit;
    return std::fabs(n.x * n.x + n.y * n.y - 1.0f) <= kMost;
}

/// How far apart the two are along a direction.
float PosedGap(const PlacedShapes &q, bmr_vec32 direction, float *reach) {
    return bmr_posed32_gap(Vectors32(q.a.m_vertices), q.a.m_count, Transform32(q.xfA),
                           Vectors32(q.b.m_vertices), q.b.m_count, Transform32(q.xfB), direction, reach);
}

/// Of a shape that rests in its pose.
bmr_swept32 AtRest(const b2DistanceProxy &proxy, const b2Transform &xf) {
    const bmr_motion32 rest = {{0.0f, 0.0f}, *Vectors32(&xf.p), *Vectors32(&xf.p), xf.q.s, xf.q.c, 0.0f};
    bmr_swept32 shape;
    bmr_swept32_make(&shape, Vectors32(proxy.m_vertices), proxy.m_count, &rest);
    return shape;
}

/// (Three vertices: b2PolygonShape::Set makes no fewer.)
bool IsPlainPolygon(const b2Shape &shape, const b2DistanceProxy &proxy) {
    return shape.GetType() == b2Shape::e_polygon && proxy.m_count >= 3 &&
           proxy.m_vertices == static_cast<const b2PolygonShape &>(shape).m_vertices;
}

/// Of any two shapes: are they apart?
Overlap Search(const PlacedShapes &q) {
    bmr_vec32 direction = {0.0f, 0.0f};
    const bmr_swept32 a = AtRest(q.a, q.xfA), b = AtRest(q.b, q.xfB);
    const float rounding = Rounding(q, std::max(a.radius, b.radius)), apart = ApartBeyond(q, rounding);
    return rounding <= std::numeric_limits<float>::max() && bmr_swept32_find_apart(&a, &b, apart, &direction)
               ? Overlap::kApart
               : Overlap::kUnknown;
}

/// Two polygons, tested by their sides. b2Distance reads only vertices, and so do these proofs: a game that
/// edited vertices in place may have left the normals as they were.
class Polygons {
public:
    Polygons(const PlacedShapes &q, const b2Shape &a, const b2Shape &b)
        : m_q(q), m_a(Polygon32(static_cast<const b2PolygonShape &>(a))),
          m_b(Polygon32(static_cast<const b2PolygonShape &>(b))) {}

    /// Does what was found the last time still say which it is?
    Overlap FromMemory(const EdgeMemory &memory) const {
        if (memory.number >= Owner(memory.ofB).count)
            return Overlap::kUnknown;
        if (memory.isVertex)
            return Holds(memory.ofB, memory.number) ? Overlap::kOverlapping : Overlap::kUnknown;
        const Side side = TestSide(memory.ofB, memory.number);
        return side.gap > ApartBeyond(m_q, side.rounding) ? Overlap::kApart : Overlap::kUnknown;
    }

    /// Is this vertex so deep inside the other polygon that b2Distance finds no more than its rounding? Their
    /// skins must cover that.
    bool Holds(bool ofB, int32 number) const {
        const b2Vec2 p = b2Mul(Pose(ofB), Vectors(Owner(ofB).vertices)[number]);
        float reach = bmr_points32_reach(Owner(ofB).vertices, Owner(ofB).count);
        const float depth = bmr_posed32_depth(&Owner(!ofB), Transform32(Pose(!ofB)), *Vectors32(&p), &reach);
        const float rounding = Rounding(m_q, reach);
        return depth > rounding && m_q.Radius() >= rounding;
    }

    /// Does the one hold the vertex of the other that is nearest to its middle, most likely?
    bool OneHoldsTheOther(EdgeMemory *memory) const {
        const b2Vec2 between = b2Mul(m_q.xfB, Middle(m_b)) - b2Mul(m_q.xfA, Middle(m_a));
        for (const bool ofB : {false, true}) {
            const b2Vec2 towards = b2MulT(Pose(ofB).q, ofB ? -between : between);
            int32 best = 0;
            for (int32 i = 1; i < Owner(ofB).count; ++i) {
                if (b2Dot(Vectors(Owner(ofB).vertices)[i], towards) >
                    b2Dot(Vectors(Owner(ofB).vertices)[best], towards))
                    best = i;
            }
            if (Holds(ofB, best)) {
                Keep(memory, best, ofB, true);
                return true;
            }
        }
        return false;
    }

    /// All sides of both: one that keeps them apart. (Normals only say which side to test.)
    Overlap TestSides(EdgeMemory *memory) const {
        for (const bool ofB : {false, true}) {
            const bmr_transform32 frame =
                bmr_exact32_relative(Transform32(Pose(!ofB)), Transform32(Pose(ofB)));
            int32_t side = 0;
            bmr_exact32_max_separation(&Owner(ofB), &Owner(!ofB), &frame, &side);
            const Side found = TestSide(ofB, side);
            if (found.gap > ApartBeyond(m_q, found.rounding)) {
                Keep(memory, side, ofB, false);
                return Overlap::kApart;
            }
        }
        return Overlap::kUnknown;
    }

private:
    /// How far apart the two are along a side's normal, and what Box2D's arithmetic may be off by.
    struct Side {
        float gap, rounding; ///< rounding is infinite where the normal is no direction
    };
    Side TestSide(bool ofB, int32 number) const {
        const b2Vec2 normal = b2Mul(Pose(ofB).q, Vectors(Owner(ofB).normals)[number]);
        const bmr_vec32 fromA = {ofB ? -normal.x : normal.x, ofB ? -normal.y : normal.y};
        if (!IsDirection(fromA))
            return {0.0f, INFINITY};
        float reach;
        const float gap = PosedGap(m_q, fromA, &reach);
        return {gap, Rounding(m_q, reach)};
    }
    static void Keep(EdgeMemory *memory, int32 number, bool ofB, bool isVertex) {
        memory->number = static_cast<uint8_t>(number);
        memory->ofB = ofB;
        memory->isVertex = isVertex;
    }
    const bmr_polygon32 &Owner(bool ofB) const { return ofB ? m_b : m_a; }
    const b2Transform &Pose(bool ofB) const { return ofB ? m_q.xfB : m_q.xfA; }
    static b2Vec2 Middle(const bmr_polygon32 &polygon) {
        return 0.5f * (Vectors(polygon.vertices)[0] + Vectors(polygon.vertices)[polygon.count / 2]);
    }

    const PlacedShapes &m_q;
    bmr_polygon32 m_a, m_b;
};

bool IsSmall(const b2DistanceProxy &proxy) {
    return proxy.m_count >= 1 && proxy.m_count <= BMR_SWEPT32_MOST;
}

} // namespace

Overlap CertainOverlap(const b2Shape &shapeA, int32 childA, const b2Shape &shapeB, int32 childB,
                       const b2Transform &xfA, const b2Transform &xfB, EdgeMemory *memory, bool touched) {
    if (!IsRotation(xfA.q) || !IsRotation(xfB.q))
        return Overlap::kUnknown;
    PlacedShapes q = {b2DistanceProxy(), b2DistanceProxy(), xfA, xfB};
    SetProxy(&q.a, shapeA, childA);
    SetProxy(&q.b, shapeB, childB);
    if (!IsSmall(q.a) || !IsSmall(q.b))
        return BigOverlap(q.a, xfA, q.b, xfB);
    Overlap answer = Overlap::kUnknown;
    if (IsPlainPolygon(shapeA, q.a) && IsPlainPolygon(shapeB, q.b)) {
        const Polygons polygons(q, shapeA, shapeB);
        EdgeMemory nothing = {kNoEdge, 0, 0};
        EdgeMemory *const known = memory != nullptr ? memory : &nothing;
        answer = polygons.FromMemory(*known);
        if (answer == Overlap::kUnknown)
            answer = polygons.OneHoldsTheOther(known) ? Overlap::kOverlapping : polygons.TestSides(known);
    }
    return answer != Overlap::kUnknown || touched ? answer : Search(q);
}

} // namespace bmr
