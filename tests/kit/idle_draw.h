// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_IDLE_DRAW_H
#define BOOMERANG_TEST_IDLE_DRAW_H

#include <box2d/b2_draw.h>

/// A drawer that draws nothing: tests override what they look at.
struct IdleDraw : b2Draw {
    void DrawPolygon(const b2Vec2 *, int32, const b2Color &) override {}
    void DrawSolidPolygon(const b2Vec2 *, int32, const b2Color &) override {}
    void DrawCircle(const b2Vec2 &, float, const b2Color &) override {}
    void DrawSolidCircle(const b2Vec2 &, float, const b2Vec2 &, const b2Color &) override {}
    void DrawSegment(const b2Vec2 &, const b2Vec2 &, const b2Color &) override {}
    void DrawTransform(const b2Transform &) override {}
    void DrawPoint(const b2Vec2 &, float, const b2Color &) override {}
};

#endif
