// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cfloat>
#include <cmath>

#include <box2d/b2_body.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_fixture.h>

#include "boomerang/box2d_glue.h"
#include "proofs/face_gap.h"
#include "proofs/polygon_view.h"
#include "start/reach.h"

namespace bmr {

namespace {

/// By how much rounding may have enlarged the bounds of a polygon's box: a point is turned (off by 2 units of
/// its place in its body), moved (one of where it is, on both counts) and the skin added (one); of big ones
/// the farthest point may be the wrong one of two (4 more). Not in proportion to the bounds: those may be
/// small where the point is far from its body's origin. Half an epsilon is a unit.
double BoxRounding(const b2Fixture &fixture) {
    const b2Vec2 place = b2Abs(fixture.GetBody()->GetPosition());
    return 4.0 * FLT_EPSILON *
           (Extent(RealPolygon(fixture)) + static_cast<double>(std::max(place.x, place.y)) +
            std::fabs(static_cast<double>(fixture.GetShape()->m_radius)));
}

/// Distance of two boxes, less what their bounds may be off by; 0 where they overlap.
double BoxGap(const b2AABB &a, const b2AABB &b, double rounding) {
    const auto apart = [rounding](float low, float high) {
        return static_cast<double>(low) - static_cast<double>(high) - rounding;
    };
    const double x =
        std::max({0.0, apart(a.lowerBound.x, b.upperBound.x), apart(b.lowerBound.x, a.upperBound.x)});
    const double y =
        std::max({0.0, apart(a.lowerBound.y, b.upperBound.y), apart(b.lowerBound.y, a.upperBound.y)});
    return std::hypot(x, y);
}

/// Each of them is a lower bound of the distance: the boxes hold the shapes and their skins, the face is
/// one direction of all.
double FixtureGap(const b2Fixture &a, const b2Fixture &b) {
    b2AABB boxA, boxB;
    a.GetShape()->ComputeAABB(&boxA, a.GetBody()->GetTransform(), 0);
    b.GetShape()->ComputeAABB(&boxB, b.GetBody()->GetTransform(), 0);
    return std::max({BoxGap(boxA, boxB, BoxRounding(a) + BoxRounding(b)), LargestFaceGap(a, b).proved,
                     LargestFaceGap(b, a).proved});
}

bool IsSolidPolygon(const b2Fixture *fixture) {
    return fixture->GetType() == b2Shape::e_polygon && !fixture->IsSensor();
}

} // namespace

float CertifiedSlack(const b2Body *bodyA, const b2Body *bodyB) {
    if (bodyA == nullptr || bodyB == nullptr || bodyA == bodyB || bodyA->GetWorld() != bodyB->GetWorld())
        return 0.0f;
    double least = INFINITY;
    for (const b2Fixture *a = bodyA->GetFixtureList(); a != nullptr; a = a->GetNext()) {
        for (const b2Fixture *b = bodyB->GetFixtureList(); b != nullptr && IsSolidPolygon(a);
             b = b->GetNext()) {
            if (IsSolidPolygon(b))
                least = std::min(least, FixtureGap(*a, *b));
        }
    }
    return std::isfinite(least) ? std::nextafterf(static_cast<float>(least), 0.0f) : 0.0f;
}

void internal::LinkOfSlack() {}

} // namespace bmr
