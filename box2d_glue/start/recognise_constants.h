// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_RECOGNISE_CONSTANTS_H
#define BOOMERANG_GLUE_RECOGNISE_CONSTANTS_H

#include <cstddef>

#include <box2d/b2_math.h>

class b2PolygonShape;
class b2World;
struct b2DistanceProxy;

/// @file
/// Part of WhyBox2DIsUnknown (recognise.h): the constants of Box2D's headers. They are compiled into Box2D
/// and into the glue, which computes its thresholds from them; so each is told by what Box2D does. All of:
///
///     b2_maxPolygonVertices    where SetAsBox puts a box's normals
///     b2_aabbExtension         the fat box of a proxy
///     b2_aabbMultiplier        the same, of a proxy that moved
///     b2_linearSlop            the distance at which two points that fly at each other touch
///     b2_polygonRadius         the distance at which b2ShapeCast stops
///     b2_lengthUnitsPerMeter   named instead where it explains the others
///
/// b2_maxManifoldPoints is in the layout of b2Manifold. The others (b2_maxSubSteps, b2_maxTOIContacts,
/// b2_maxTranslation, b2_baumgarte, b2_timeToSleep, ...) are read by Box2D's own solver and sleep alone:
/// nothing that is answered here depends on them, and a game may have its own.

namespace bmr {

/// A metre or more, in units of length. A power of two, for nothing is to be rounded.
constexpr float kTrialMetre = [] {
    float metre = 1.0f;
    while (metre < b2_lengthUnitsPerMeter)
        metre *= 2.0f;
    return metre;
}();

/// Why the polygons of this Box2D are laid out otherwise, or nullptr. Makes `shape`, which has `margin` bytes
/// of room behind it, a box whose half-width is a metre.
const char *WhyVerticesAreOthers(b2PolygonShape *shape, size_t margin);

/// Why the other constants are unknown, or nullptr, in a world whose fields are where they should be; `world`
/// is as it was afterwards. The answer lives until the next call.
const char *WhyConstantsAreOthers(b2World *world);

/// When `flying`, which moves from the origin by `way`, touches `resting`, which is at `place`; below 0 where
/// b2TimeOfImpact does not say that they touch.
float TrialImpact(const b2DistanceProxy &flying, b2Vec2 way, const b2DistanceProxy &resting, b2Vec2 place);

} // namespace bmr

#endif
