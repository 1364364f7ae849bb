// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_SMALL_WORLDS_H
#define BOOMERANG_TEST_SMALL_WORLDS_H

#include "as_stock.h"

/// @file
/// What worlds of a few bodies are made of.

namespace as_stock {

struct SmallWorld {
    const char *name;
    float gravity; ///< downwards
    void (*build)(b2World &);
    /// What the game does ahead of each step; may be nullptr.
    void (*play)(b2World &, int step);
};

/// Each is played for 600 steps.
template <size_t count> void PlayAll(const SmallWorld (&worlds)[count]) {
    for (const SmallWorld &what : worlds) {
        const std::string world = what.name;
        CAPTURE(world);
        AsStock(
            [&what](Run &run) {
                Game game(run, {0.0f, -what.gravity});
                what.build(game.world);
                for (int step = 0; step < 600; ++step) {
                    if (what.play != nullptr)
                        what.play(game.world, step);
                    game.Step();
                }
            },
            kMayBeSilent);
    }
}

inline b2Body *Box(b2World &world, b2Vec2 at, b2Vec2 half = {0.5f, 0.5f}, float angle = 0.0f) {
    return AddBox(world, b2_dynamicBody, at, half, angle);
}
inline b2Body *Wall(b2World &world, b2Vec2 at, b2Vec2 half = {0.5f, 0.5f}, float angle = 0.0f,
                    bool sensor = false) {
    return AddBox(world, b2_staticBody, at, half, angle, sensor);
}
inline b2Body *Platform(b2World &world, b2Vec2 at, b2Vec2 half) {
    return AddBox(world, b2_kinematicBody, at, half, 0.0f);
}
inline b2Body *AddBody(b2World &world, b2BodyType type, b2Vec2 at, const b2Shape &shape, float restitution,
                       float friction) {
    b2BodyDef def;
    def.type = type;
    def.position = at;
    b2Body *body = world.CreateBody(&def);
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = 1.0f;
    fixture.restitution = restitution;
    fixture.friction = friction;
    body->CreateFixture(&fixture);
    return body;
}
inline b2Body *AddBall(b2World &world, b2BodyType type, b2Vec2 at, float radius, float restitution = 0.0f,
                       float friction = 0.2f) {
    b2CircleShape circle;
    circle.m_radius = radius;
    return AddBody(world, type, at, circle, restitution, friction);
}
inline b2Body *Ball(b2World &world, b2Vec2 at, float radius, float restitution = 0.0f,
                    float friction = 0.2f) {
    return AddBall(world, b2_dynamicBody, at, radius, restitution, friction);
}
/// A regular polygon.
inline b2Body *AddRegular(b2World &world, b2Vec2 at, int count, float radius, float restitution = 0.0f) {
    b2Vec2 corners[b2_maxPolygonVertices];
    for (int i = 0; i < count; ++i)
        corners[i] = radius * b2Rot(2.0f * b2_pi * Real(i) / Real(count)).GetXAxis();
    b2PolygonShape polygon;
    polygon.Set(corners, count);
    return AddBody(world, b2_dynamicBody, at, polygon, restitution, 0.2f);
}
inline b2Body *AddGround(b2World &world) {
    return Wall(world, {0.0f, -0.5f}, {30.0f, 0.5f});
}
/// A closed room around the origin: a loop of edges, or four boxes.
inline void AddRoom(b2World &world, b2Vec2 half, bool ofBoxes, float restitution) {
    for (const float side : {-1.0f, 1.0f}) {
        if (!ofBoxes)
            break;
        Wall(world, {0.0f, side * (half.y + 0.5f)}, {half.x + 1.0f, 0.5f});
        Wall(world, {side * (half.x + 0.5f), 0.0f}, {0.5f, half.y});
    }
    const b2Vec2 corners[4] = {-half, {half.x, -half.y}, half, {-half.x, half.y}};
    b2ChainShape chain;
    chain.CreateLoop(corners, 4);
    if (!ofBoxes)
        AddBody(world, b2_staticBody, b2Vec2_zero, chain, restitution, 0.0f);
}

/// Calls `act(body, i)` for each dynamic body, the youngest first.
template <typename Act> void ForEachDynamic(b2World &world, const Act &act) {
    int i = 0;
    for (b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        if (body->GetType() == b2_dynamicBody)
            act(body, i++);
}
/// Calls `act(body)` for each kinematic one.
template <typename Act> void ForEachKinematic(b2World &world, const Act &act) {
    for (b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        if (body->GetType() == b2_kinematicBody)
            act(body);
}

} // namespace as_stock

#endif
