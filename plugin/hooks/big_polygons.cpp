// SPDX-License-Identifier: MIT
// Box2D's questions about big polygons: b2DistanceProxy::Set makes a proxy of all vertices, and b2Distance,
// b2ShapeCast and b2World::DrawShape answer for it, also if nothing is installed. All else goes to Box2D. (So
// does b2TimeOfImpact, which has more to do: time_of_impact.cpp. b2TestOverlap asks b2Distance.)
#include <box2d/b2_distance.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world.h>

#include "proofs/convex_distance.h"
#include "reach/stock.h"
#include "shapes/convex_draw.h"
#include "shapes/convex_geometry.h"
#include "start/settings.h"

using namespace bmr;

BMR_FOR_LOADERS("_ZN15b2DistanceProxy3SetEPK7b2Shapei");
BMR_FOR_LOADERS("_Z10b2DistanceP16b2DistanceOutputP14b2SimplexCachePK15b2DistanceInput");
BMR_FOR_LOADERS("_Z11b2ShapeCastP17b2ShapeCastOutputPK16b2ShapeCastInput");
BMR_FOR_LOADERS("_ZN7b2World9DrawShapeEP9b2FixtureRK11b2TransformRK7b2Color");

void b2DistanceProxy::Set(const b2Shape *shape, int32 child) {
    // (Shapes of a Box2D that is none we know are not ours to read.)
    if (!(PassesRun() || AnyBigPolygon()) || !SetCommonProxy(this, *shape))
        stock::SetProxy(this, shape, child);
}

void b2Distance(b2DistanceOutput *output, b2SimplexCache *cache, const b2DistanceInput *input) {
    if (BMR_RARELY(AnyBigPolygon()) && BigDistance(output, cache, *input))
        return;
    stock::Distance(output, cache, input);
}

bool b2ShapeCast(b2ShapeCastOutput *output, const b2ShapeCastInput *input) {
    bool hit;
    if (AnyBigPolygon() && BigCast(output, *input, &hit))
        return hit;
    return stock::ShapeCast(output, input);
}

/// The real outline, in pieces that every b2Draw has room for unless Options::outlines asks for it whole.
void b2World::DrawShape(b2Fixture *fixture, const b2Transform &xf, const b2Color &color) {
    const bmr_convex32_block *block = AnyBigPolygon() ? BigPolygonOf(*fixture->GetShape()) : nullptr;
    if (block == nullptr) {
        stock::DrawShape(this, fixture, xf, color);
        return;
    }
    NoteDrawnByBox2D(this, m_debugDraw);
    DrawOutline(*block, xf, color, GetSettings().options.outlines, *m_debugDraw);
}
