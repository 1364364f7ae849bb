// SPDX-License-Identifier: MIT
// b2World::DrawShape: of big polygons the real outline, whatever is installed, in pieces that every b2Draw
// has room for unless Options::outlines asks for it whole.
#include <box2d/b2_fixture.h>
#include <box2d/b2_world.h>

#include "reach/real.h"
#include "shapes/convex_draw.h"
#include "shapes/convex_geometry.h"
#include "start/settings.h"

using namespace bmr;

namespace {

Real<void(b2World *, b2Fixture *, const b2Transform &, const b2Color &)>
    realDrawShape("_ZN7b2World9DrawShapeEP9b2FixtureRK11b2TransformRK7b2Color");

} // namespace

// Box2D's own header declares b2World::DrawShape, so BMR_STANDS_FOR cannot be put on its declaration.
BMR_FOR_LOADERS("_ZN7b2World9DrawShapeEP9b2FixtureRK11b2TransformRK7b2Color");

void b2World::DrawShape(b2Fixture *fixture, const b2Transform &xf, const b2Color &color) {
    const bmr_convex32_block *block = AnyBigPolygon() ? BigPolygonOf(*fixture->GetShape()) : nullptr;
    if (block == nullptr) {
        realDrawShape(this, fixture, xf, color);
        return;
    }
    NoteDrawnByBox2D(this, m_debugDraw);
    DrawOutline(block->polygon, xf, color, GetSettings().options.outlines, *m_debugDraw);
}
