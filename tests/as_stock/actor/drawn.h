// SPDX-License-Identifier: MIT
#ifndef AS_STOCK_ACTOR_DRAWN_H
#define AS_STOCK_ACTOR_DRAWN_H

#include <initializer_list>

#include <box2d/box2d.h>

#include "state/sinks.h"

namespace actor {

/// Hashes what b2World::DebugDraw draws, in order.
class Drawn final : public b2Draw {
public:
    explicit Drawn(testbed::HashSink *hash) : m_hash(hash) {
        SetFlags(e_shapeBit | e_aabbBit | e_pairBit | e_jointBit);
    }
    void DrawPolygon(const b2Vec2 *vertices, int32 count, const b2Color &color) override {
        for (int32 i = 0; i < count; ++i)
            Add({vertices[i].x, vertices[i].y, color.r, color.g, color.b, color.a});
    }
    void DrawSolidPolygon(const b2Vec2 *vertices, int32 count, const b2Color &color) override {
        DrawPolygon(vertices, count, color);
    }
    void DrawCircle(const b2Vec2 &p, float radius, const b2Color &color) override {
        Add({p.x, p.y, radius, color.r});
    }
    void DrawSolidCircle(const b2Vec2 &p, float radius, const b2Vec2 &axis, const b2Color &color) override {
        Add({p.x, p.y, radius, axis.x, axis.y, color.r});
    }
    void DrawSegment(const b2Vec2 &p, const b2Vec2 &q, const b2Color &color) override {
        Add({p.x, p.y, q.x, q.y, color.r});
    }
    void DrawTransform(const b2Transform &xf) override { Add({xf.p.x, xf.p.y, xf.q.s, xf.q.c}); }
    void DrawPoint(const b2Vec2 &p, float size, const b2Color &color) override {
        Add({p.x, p.y, size, color.r});
    }

private:
    void Add(std::initializer_list<float> numbers) {
        for (const float number : numbers)
            m_hash->Field("drawn", number);
    }
    testbed::HashSink *m_hash;
};

} // namespace actor

#endif
