// SPDX-License-Identifier: MIT
#ifndef BOX2D_BUILDS_DRAWN_H
#define BOX2D_BUILDS_DRAWN_H

#include <box2d/box2d.h>

#include "state/sinks.h"

namespace box2d_builds {

/// Hashes what b2World::DebugDraw draws, in order.
class Drawn final : public b2Draw {
public:
    uint64_t Hash() const { return m_hash.Value(); }

    void DrawPolygon(const b2Vec2 *vertices, int32 count, const b2Color &color) override {
        Add(1, vertices, count, color);
    }
    void DrawSolidPolygon(const b2Vec2 *vertices, int32 count, const b2Color &color) override {
        Add(2, vertices, count, color);
    }
    void DrawCircle(const b2Vec2 &center, float radius, const b2Color &color) override {
        m_hash.Field("radius", radius);
        Add(3, &center, 1, color);
    }
    void DrawSolidCircle(const b2Vec2 &center, float radius, const b2Vec2 &axis,
                         const b2Color &color) override {
        const b2Vec2 both[] = {center, axis};
        m_hash.Field("radius", radius);
        Add(4, both, 2, color);
    }
    void DrawSegment(const b2Vec2 &p1, const b2Vec2 &p2, const b2Color &color) override {
        const b2Vec2 both[] = {p1, p2};
        Add(5, both, 2, color);
    }
    void DrawTransform(const b2Transform &xf) override {
        m_hash.Field("s", xf.q.s);
        m_hash.Field("c", xf.q.c);
        Add(6, &xf.p, 1, b2Color(0.0f, 0.0f, 0.0f));
    }
    void DrawPoint(const b2Vec2 &p, float size, const b2Color &color) override {
        m_hash.Field("size", size);
        Add(7, &p, 1, color);
    }

private:
    void Add(uint32_t what, const b2Vec2 *points, int32 count, const b2Color &color) {
        m_hash.Field("what", what);
        for (int32 i = 0; i < count; ++i) {
            m_hash.Field("x", points[i].x);
            m_hash.Field("y", points[i].y);
        }
        for (const float part : {color.r, color.g, color.b, color.a})
            m_hash.Field("color", part);
    }

    testbed::HashSink m_hash;
};

} // namespace box2d_builds

#endif
