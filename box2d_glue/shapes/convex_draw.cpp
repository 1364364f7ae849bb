// SPDX-License-Identifier: MIT
#include "shapes/convex_draw.h"

#include <cstdlib>
#include <utility>

#include <box2d/b2_body.h>
#include <box2d/b2_draw.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world.h>

#include "boomerang/convex_shape.h"
#include "shapes/convex_geometry.h"

namespace bmr {

namespace {

/// The last drawing of b2World::DebugDraw on this thread.
struct Drawn {
    const b2World *world;
    const b2Draw *draw;
};
thread_local Drawn drawnByBox2D = {nullptr, nullptr};

/// The colour by which b2World::DebugDraw shows the state of a body.
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

b2Vec2 Posed(bmr_vec32 vertex, const b2Transform &xf) {
    return b2Mul(xf, b2Vec2(vertex.x, vertex.y));
}

/// A fan: each piece begins with vertex 0, and goes on from where the one before ended.
void DrawPieces(const bmr_convex32 &polygon, const b2Transform &xf, const b2Color &color, b2Draw &draw) {
    b2Vec2 piece[b2_maxPolygonVertices];
    piece[0] = Posed(polygon.vertices[0], xf);
    for (uint32_t i = 1; i + 1 < polygon.count;) {
        int32 count = 1;
        piece[count++] = Posed(polygon.vertices[i], xf);
        while (count < b2_maxPolygonVertices && i + 1 < polygon.count)
            piece[count++] = Posed(polygon.vertices[++i], xf);
        draw.DrawSolidPolygon(piece, count, color);
    }
}

/// Of a piece: those of its edges, and parts of edges, that are the outline's.
void DrawFaces(const bmr_convex32_block &block, const b2Transform &xf, const b2Color &color, b2Draw &draw) {
    const bmr_convex32 &polygon = block.polygon;
    const bmr_seams32 &seams = block.seams;
    uint32_t part = 0;
    for (uint32_t i = 0; i < polygon.count; ++i) {
        const bmr_vec32 end = polygon.vertices[i + 1 < polygon.count ? i + 1 : 0];
        const bool mixed = part < seams.part_count && seams.parts[part].edge == i;
        if (!mixed && seams.inner[i] == 0)
            draw.DrawSegment(Posed(polygon.vertices[i], xf), Posed(end, xf), color);
        for (; part < seams.part_count && seams.parts[part].edge == i; ++part) {
            const bool last = part + 1 == seams.part_count || seams.parts[part + 1].edge != i;
            if (!seams.parts[part].inner)
                draw.DrawSegment(Posed(seams.parts[part].from, xf),
                                 Posed(last ? end : seams.parts[part + 1].from, xf), color);
        }
    }
}

bool DrawWhole(const bmr_convex32 &polygon, const b2Transform &xf, const b2Color &color, b2Draw &draw) {
    auto *outline = static_cast<b2Vec2 *>(std::malloc(polygon.count * sizeof(b2Vec2)));
    if (outline == nullptr)
        return false;
    for (uint32_t i = 0; i < polygon.count; ++i)
        outline[i] = Posed(polygon.vertices[i], xf);
    draw.DrawSolidPolygon(outline, static_cast<int32>(polygon.count), color);
    std::free(outline);
    return true;
}

} // namespace

void DrawOutline(const bmr_convex32_block &block, const b2Transform &xf, const b2Color &color,
                 Outlines outlines, b2Draw &draw) {
    if (outlines != Outlines::Whole || !DrawWhole(block.polygon, xf, color, draw))
        DrawPieces(block.polygon, xf, color, draw);
    if (block.polygon.seams != nullptr || block.seams.part_count > 0)
        DrawFaces(block, xf, color, draw);
}

void NoteDrawnByBox2D(const b2World *world, const b2Draw *draw) {
    drawnByBox2D = {world, draw};
}

void DrawConvexShapes(const b2World &world, b2Draw &draw, Outlines outlines) {
    const Drawn drawn = std::exchange(drawnByBox2D, {nullptr, nullptr});
    if (drawn.world == &world && drawn.draw == &draw)
        return;
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        for (const b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
            if (const bmr_convex32_block *block = BigPolygonOf(*f->GetShape()))
                DrawOutline(*block, body->GetTransform(), ColorOf(*body), outlines, draw);
}

} // namespace bmr
