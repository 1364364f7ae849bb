// SPDX-License-Identifier: MIT
#include "glue/prove_apart.h"

#include <algorithm>
#include <cmath>

#include <box2d/b2_polygon_shape.h>

#include "glue/contacts/solid_contact.h"
#include "shapes/big_polygons.h"
#include "shapes/shapes32.h"
#include "start/settings.h"

namespace bmr {

static_assert(static_cast<double>(kBandReach) <= kReach && kImpactReach <= kSweepReach &&
                  kImpactAngle <= kSweepAngle,
              "the margins hold wherever a pair of band 0 has a budget");

namespace {

/// A polygon in the world, in double.
struct Placed {
    const b2PolygonShape *shape;
    const bmr_convex32_block *big; ///< nullptr: a small one
    bmr_pose pose;
    double reach;

    explicit Placed(const FixtureMotion &motion) : Placed(*motion.fixture, motion.mover.reach) {}
    Placed(const b2Fixture &fixture, double reachOfVertices)
        : shape(static_cast<const b2PolygonShape *>(fixture.GetShape())),
          big(AnyBigPolygon() ? BigPolygonOf(*shape) : nullptr),
          pose(PoseOf(fixture.GetBody()->GetTransform())), reach(reachOfVertices) {}

    /// The largest <d, v> of a point, in the world, and the point. Of a big polygon the vertex may be the
    /// wrong one of two that are as far along to rounding, which `slack` covers.
    bmr_vec2 Farthest(bmr_vec2 d, double *slack) const {
        const bmr_vec2 local = bmr_unrotate(&pose, d);
        if (big != nullptr) {
            const uint32_t at = bmr_convex32_support(
                &big->polygon, {static_cast<float>(local.x), static_cast<float>(local.y)});
            *slack += reach * 0x1p-20;
            return bmr_transform(&pose, Double(big->polygon.vertices[at]));
        }
        const bmr_vec32 *const vertices = Vectors32(shape->m_vertices);
        int32 best = 0;
        double most = bmr_dot(local, Double(vertices[0]));
        for (int32 i = 1; i < shape->m_count; ++i) {
            const double along = bmr_dot(local, Double(vertices[i]));
            if (along > most) {
                most = along;
                best = i;
            }
        }
        return bmr_transform(&pose, Double(vertices[best]));
    }
};

/// How far apart two are along a direction: <d, b - a> >= gap for all their points.
struct Gap {
    bmr_vec2 d;
    double gap;
    bmr_vec2 between; ///< from a's point that is farthest along d to b's that is least far
};

Gap GapAlong(const Placed &a, const Placed &b, bmr_vec2 d) {
    // Coordinates are those of the last band at most, so the rounding of doubles is far below this.
    constexpr double kRounding = 1e-9 * static_cast<double>(b2_lengthUnitsPerMeter);
    double slack = kRounding;
    const bmr_vec2 from = a.Farthest(d, &slack), to = b.Farthest(bmr_neg(d), &slack);
    const bmr_vec2 between = bmr_sub(to, from);
    return {d, bmr_dot(d, between) - slack, between};
}

/// Of unit length; false of nothing and of what is no number.
bool Normalize(bmr_vec2 *d) {
    const double length = std::sqrt(bmr_dot(*d, *d));
    if (!(length > 1e-12 && length < 1e12))
        return false;
    *d = bmr_scale(1.0 / length, *d);
    return true;
}

/// By how much b2TimeOfImpact's arithmetic may be off, for one of the two and for coordinates up to
/// `farthest` (glue/proofs/sweep_apart.cpp has the same for the coordinates of a step).
double ImpactRounding(const FixtureMotion &motion, double farthest) {
    return static_cast<double>(kUnit) *
           (static_cast<double>(kErrorPerCoordinate) * farthest +
            static_cast<double>(kErrorPerReach) * motion.Extent() +
            static_cast<double>(kErrorPerAngle * kImpactAngle) * motion.mover.reach);
}
double ImpactTilt(const FixtureMotion &motion, double farthest) {
    return static_cast<double>(kUnit) * (static_cast<double>(kTiltPerCoordinate) * farthest +
                                         static_cast<double>(kTiltPerReach) * motion.Extent());
}

/// Does a distance of `threshold` keep b2TimeOfImpact from finding the two touching, as far out as
/// kImpactReach of `band`?
bool KeepsFromImpact(const FixtureMotion &a, const FixtureMotion &b, int band, double threshold) {
    const double farthest = std::ldexp(static_cast<double>(kImpactReach), band);
    if (!(a.shortest >= kShortestSide && b.shortest >= kShortestSide))
        return false; // and of big polygons, whose sides are not measured
    const double lever = 1.0 + 2.0 * std::max(a.mover.reach / static_cast<double>(b.shortest),
                                              b.mover.reach / static_cast<double>(a.shortest));
    const auto impact = static_cast<double>(ImpactDistance(a.radius + b.radius));
    const double tilt = ImpactTilt(a, farthest) + ImpactTilt(b, farthest) + static_cast<double>(kTiltAlways) +
                        static_cast<double>(kUnit * kTiltPerDistance) * impact;
    return impact * (1.0 + static_cast<double>(kUnit * kErrorPerDistance)) + ImpactRounding(a, farthest) +
               ImpactRounding(b, farthest) + tilt * lever <
           threshold;
}

/// How far a fixture's body most likely carries its points in a step of this length.
double ExpectedMotion(const FixtureMotion &motion, float seconds) {
    constexpr double kUnknownReach = 0.5 * static_cast<double>(b2_lengthUnitsPerMeter);
    const b2Vec2 &v = motion.body->GetLinearVelocity();
    const double reach = motion.mover.reach > 0.0 ? motion.mover.reach : kUnknownReach;
    return static_cast<double>(seconds) *
           (static_cast<double>(b2Abs(v.x) + b2Abs(v.y)) +
            static_cast<double>(b2Abs(motion.body->GetAngularVelocity())) * reach);
}

} // namespace

bool ProveApart(PairTable *table, uint32_t pair, SolidContact *contact) {
    constexpr double kFatBoxes = 6.0 * static_cast<double>(b2_aabbExtension);
    const FixtureMotion &motionA = table->motions[table->At(pair).a],
                        &motionB = table->motions[table->At(pair).b];
    // So much is to be left beyond the proof. Of two that come nearer faster than this none is worth it.
    const double soon =
        2.0 * (ExpectedMotion(motionA, table->seconds) + ExpectedMotion(motionB, table->seconds));
    if (!(soon <= kFatBoxes && table->BeginProof(pair)))
        return false;
    const Placed a(motionA), b(motionB);
    const double threshold = ApartThreshold(*table, pair);
    bmr_vec2 d = contact->GuessDirection();
    if (!Normalize(&d)) {
        d = bmr_sub(motionB.mover.center, motionA.mover.center);
        if (!Normalize(&d))
            return false;
    }
    Gap best = GapAlong(a, b, d);
    bmr_vec2 closer = best.between;
    // Where two corners face each other, or the guess is old, the line between what was found says more.
    const double length = std::sqrt(bmr_dot(closer, closer));
    if (length > threshold + soon && best.gap < 0.95 * length && Normalize(&closer)) {
        const Gap other = GapAlong(a, b, closer);
        if (other.gap > best.gap)
            best = other;
    }
    if (!(best.gap > threshold + soon))
        return false;
    const int band = table->motions.Band(table->At(pair).a, table->At(pair).b);
    table->Prove(pair, best.d, best.gap, threshold, KeepsFromImpact(motionA, motionB, band, threshold));
    if (GetSettings().options.statistics)
        contact->LeaveByLine();
    return true;
}

bool SeparatesAlong(const b2Fixture &a, const b2Fixture &b, bmr_vec2 d) {
    const Placed placed[2] = {Placed(a, 0.0), Placed(b, 0.0)};
    constexpr int32 kLeast = 3; // a polygon that was never Set has fewer
    return placed[0].shape->m_count >= kLeast && placed[1].shape->m_count >= kLeast && Normalize(&d) &&
           GapAlong(placed[0], placed[1], d).gap > 0.0;
}

} // namespace bmr
