// SPDX-License-Identifier: MIT
#include "convex_draw.h"

#include <cstdlib>

#include <box2d/b2_body.h>
#include <box2d/b2_draw.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world.h>

#include "boomerang/convex_shape.h"
#include "convex_access.h"
#include "convex_geometry.h"

namespace bmr {

namespace {

/// What b2World::DebugDraw shows of a body by its colour.
b2Color ColorOf(const b2Body &body) {
    if (body.GetType() == b2_dynamicBody && body.GetMass() == 0.0f)
        return b2Color(1.0f, 0.0f, 0.0f);
    if (!body.IsEnabled())
        return b2Color(0.5f, 0.5f, 0.3f);
    if (body.GetType() == b2_staticBody)
        return b2Color(0.5f, 0.9f, 0.5f);
    if (body.GetType() == b2_kinematicBody)
        return b2Color(0.5f, 0.5f, 0.9f);
    return body.IsAwake() ? b2Color(0.9f, 0.7f, 0.7f) : b2Color(0.6f, 0.6f, 0.6f);
}

} // namespace

void DrawOutline(const bmr_convex32 &polygon, const b2Transform &xf, const b2Color &color, b2Draw &draw) {
    auto *outline = static_cast<b2Vec2 *>(std::malloc(polygon.count * sizeof(b2Vec2)));
    if (outline == nullptr)
        return;
    for (uint32_t i = 0; i < polygon.count; ++i)
        outline[i] = b2Mul(xf, b2Vec2(polygon.vertices[i].x, polygon.vertices[i].y));
    draw.DrawSolidPolygon(outline, static_cast<int32>(polygon.count), color);
    std::free(outline);
}

void DrawConvexShapes(const b2World &world, b2Draw &draw) {
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        for (const b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
            if (const bmr_convex32_block *block = BigPolygonOf(*f->GetShape()))
                DrawOutline(block->polygon, body->GetTransform(), ColorOf(*body), draw);
}

} // namespace bmr
