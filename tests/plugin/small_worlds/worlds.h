// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_SMALL_WORLDS_H
#define BOOMERANG_TEST_SMALL_WORLDS_H

#include <cmath>

#include <box2d/box2d.h>

#include "small_world.h"

/// @file
/// Worlds of a few bodies, as most games step them and some programs by the thousand. For measurements and
/// for a differential test. They are plain Box2D: they know nothing of Boomerang.

struct SmallWorld {
    const char *name;
    float gravity; ///< downwards
    void (*build)(b2World &);
    /// What the game does ahead of each step; may be nullptr.
    void (*play)(b2World &, int step);
};

/// Without joints, and with. The last has no name.
extern const SmallWorld kLooseWorlds[];
extern const SmallWorld kJointedWorlds[];

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

/// A regular polygon.
inline b2Body *AddRegular(b2World &world, b2Vec2 at, int count, float radius, float restitution = 0.0f) {
    b2Vec2 corners[b2_maxPolygonVertices];
    for (int i = 0; i < count; ++i)
        corners[i] =
            radius * b2Rot(2.0f * b2_pi * static_cast<float>(i) / static_cast<float>(count)).GetXAxis();
    b2PolygonShape polygon;
    polygon.Set(corners, count);
    return AddBody(world, b2_dynamicBody, at, polygon, restitution, 0.2f);
}

inline b2Body *AddGround(b2World &world, float half = 30.0f) {
    return AddBox(world, b2_staticBody, {0.0f, -0.5f}, {half, 0.5f}, 0.0f);
}

/// A closed room around the origin: a loop of edges, or four boxes.
inline void AddRoom(b2World &world, b2Vec2 half, bool ofBoxes, float restitution) {
    if (ofBoxes) {
        AddBox(world, b2_staticBody, {0.0f, -half.y - 0.5f}, {half.x + 1.0f, 0.5f}, 0.0f);
        AddBox(world, b2_staticBody, {0.0f, half.y + 0.5f}, {half.x + 1.0f, 0.5f}, 0.0f);
        AddBox(world, b2_staticBody, {-half.x - 0.5f, 0.0f}, {0.5f, half.y}, 0.0f);
        AddBox(world, b2_staticBody, {half.x + 0.5f, 0.0f}, {0.5f, half.y}, 0.0f);
        return;
    }
    const b2Vec2 corners[4] = {-half, {half.x, -half.y}, half, {-half.x, half.y}};
    b2ChainShape chain;
    chain.CreateLoop(corners, 4);
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

#endif
