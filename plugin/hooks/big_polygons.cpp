// SPDX-License-Identifier: MIT
// What Box2D is asked of big polygons: b2DistanceProxy::Set makes a proxy of all vertices, and b2Distance,
// b2ShapeCast and b2World::DrawShape answer for it, whatever is installed. All else goes to Box2D. (So does
// b2TimeOfImpact, which has more to do: time_of_impact.cpp. b2TestOverlap asks b2Distance.)
#include <box2d/b2_distance.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world.h>

#include "proofs/convex_distance.h"
#include "reach/real.h"
#include "shapes/convex_draw.h"
#include "shapes/convex_geometry.h"
#include "start/settings.h"

namespace bmr::hooks {

namespace {

Real<void(b2DistanceProxy *, const b2Shape *, int32)> realSet("_ZN15b2DistanceProxy3SetEPK7b2Shapei");
Real<void(b2DistanceOutput *, b2SimplexCache *, const b2DistanceInput *)>
    realDistance("_Z10b2DistanceP16b2DistanceOutputP14b2SimplexCachePK15b2DistanceInput");
Real<bool(b2ShapeCastOutput *, const b2ShapeCastInput *)>
    realShapeCast("_Z11b2ShapeCastP17b2ShapeCastOutputPK16b2ShapeCastInput");

} // namespace

void SetProxy(b2DistanceProxy *proxy, const b2Shape *shape, int32 child)
    BMR_STANDS_FOR("_ZN15b2DistanceProxy3SetEPK7b2Shapei");
void Distance(b2DistanceOutput *output, b2SimplexCache *cache, const b2DistanceInput *input)
    BMR_STANDS_FOR("_Z10b2DistanceP16b2DistanceOutputP14b2SimplexCachePK15b2DistanceInput");
bool ShapeCast(b2ShapeCastOutput *output, const b2ShapeCastInput *input)
    BMR_STANDS_FOR("_Z11b2ShapeCastP17b2ShapeCastOutputPK16b2ShapeCastInput");

void SetProxy(b2DistanceProxy *proxy, const b2Shape *shape, int32 child) {
    // (Shapes of a Box2D that is none we know are not ours to read.)
    if (!(AnyHookIsOn() || AnyBigPolygon()) || !SetCommonProxy(proxy, *shape))
        realSet(proxy, shape, child);
}

void Distance(b2DistanceOutput *output, b2SimplexCache *cache, const b2DistanceInput *input) {
    if (__builtin_expect(AnyBigPolygon(), 0) && BigDistance(output, cache, *input))
        return;
    realDistance(output, cache, input);
}

bool ShapeCast(b2ShapeCastOutput *output, const b2ShapeCastInput *input) {
    bool hit;
    if (AnyBigPolygon() && BigCast(output, *input, &hit))
        return hit;
    return realShapeCast(output, input);
}

} // namespace bmr::hooks

#if !defined(BMR_STATIC_WRAP) // there b2World::DebugDraw calls DrawShape within its own, and nobody sees it

using namespace bmr;

namespace {

Real<void(b2World *, b2Fixture *, const b2Transform &, const b2Color &)>
    realDrawShape("_ZN7b2World9DrawShapeEP9b2FixtureRK11b2TransformRK7b2Color");

} // namespace

// Box2D's own header declares b2World::DrawShape, so BMR_STANDS_FOR cannot be put on its declaration.
BMR_FOR_LOADERS("_ZN7b2World9DrawShapeEP9b2FixtureRK11b2TransformRK7b2Color");

/// The real outline, in pieces that every b2Draw has room for unless Options::outlines asks for it whole.
void b2World::DrawShape(b2Fixture *fixture, const b2Transform &xf, const b2Color &color) {
    const bmr_convex32_block *block = AnyBigPolygon() ? BigPolygonOf(*fixture->GetShape()) : nullptr;
    if (block == nullptr) {
        realDrawShape(this, fixture, xf, color);
        return;
    }
    NoteDrawnByBox2D(this, m_debugDraw);
    DrawOutline(block->polygon, xf, color, GetSettings().options.outlines, *m_debugDraw);
}

#endif
