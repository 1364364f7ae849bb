// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTS_CONVEX_GROUND_H
#define BOOMERANG_TESTS_CONVEX_GROUND_H

#include "as_stock.h"
#include "boomerang/convex_shape.h"

/// @file
/// What tests of contacts of big shapes let fall, and on what.

namespace ground {

using as_stock::Game;
using as_stock::Real;
using bmr::ConvexShape;

constexpr float kRadius = 0.5f;
constexpr float kPi = 3.14159265358979f;

/// With an edge at the bottom: one that an octagon of its vertices does not have.
inline ConvexShape Coin(int32 count, float radius = kRadius) {
    std::vector<b2Vec2> vertices;
    for (int32 i = 0; i < count; ++i) {
        const float angle = 2.0f * kPi * (Real(i) + 0.5f) / Real(count) - 0.5f * kPi;
        vertices.push_back(radius * b2Vec2(std::cos(angle), std::sin(angle)));
    }
    ConvexShape shape;
    REQUIRE(shape.Set(vertices.data(), count) == BMR_OK);
    return shape;
}

inline b2EdgeShape Edge(bool oneSided) {
    b2EdgeShape edge;
    const b2Vec2 left(-5.0f, 0.0f), right(5.0f, 0.0f);
    if (oneSided)
        edge.SetOneSided(right + b2Vec2(1.0f, 0.0f), right, left, left - b2Vec2(1.0f, 0.0f));
    else
        edge.SetTwoSided(left, right);
    return edge;
}

inline b2ChainShape Chain() {
    b2Vec2 points[11];
    for (int i = 0; i < 11; ++i)
        points[i].Set(5.0f - Real(i), 0.0f);
    b2ChainShape chain;
    chain.CreateChain(points, 11, {6.0f, 0.0f}, {-6.0f, 0.0f});
    return chain;
}

inline b2Body *Falling(Game &game, b2Vec2 place) {
    return game.Body(b2_dynamicBody, place);
}

} // namespace ground

#endif
