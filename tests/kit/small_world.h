// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_PLUGIN_SMALL_WORLD_H
#define BOOMERANG_TEST_PLUGIN_SMALL_WORLD_H

#include <cinttypes>
#include <cstdint>
#include <cstdio>

#include <box2d/box2d.h>

#include "../../testbed_scenes/state/visit.h"

/// @file
/// What games share. They are plain Box2D programs: they know nothing of Boomerang.

inline b2Body *AddBody(b2World &world, b2BodyType type = b2_dynamicBody, b2Vec2 at = {0.0f, 0.0f},
                       float angle = 0.0f) {
    b2BodyDef def;
    def.type = type;
    def.position = at;
    def.angle = angle;
    def.userData.pointer = static_cast<uintptr_t>(world.GetBodyCount());
    return world.CreateBody(&def);
}

inline b2Body *AddBox(b2World &world, b2BodyType type, b2Vec2 at, b2Vec2 half, float angle,
                      bool sensor = false) {
    b2Body *body = AddBody(world, type, at, angle);
    b2PolygonShape box;
    box.SetAsBox(half.x, half.y);
    b2FixtureDef fixture;
    fixture.shape = &box;
    fixture.density = 1.0f;
    fixture.isSensor = sensor;
    body->CreateFixture(&fixture);
    return body;
}

/// A wheel of `count` triangles: bodies of many fixtures, whose contacts share the hulls of the two.
inline b2Body *AddWheel(b2World &world, b2Vec2 at, int count, float radius) {
    b2Body *body = AddBody(world, b2_dynamicBody, at);
    for (int i = 0; i < count; ++i) {
        const b2Rot from(2.0f * b2_pi * static_cast<float>(i) / static_cast<float>(count));
        const b2Rot to(2.0f * b2_pi * static_cast<float>(i + 1) / static_cast<float>(count));
        const b2Vec2 corners[3] = {{0.0f, 0.0f}, radius * from.GetXAxis(), radius * to.GetXAxis()};
        b2PolygonShape triangle;
        triangle.Set(corners, 3);
        body->CreateFixture(&triangle, 1.0f);
    }
    return body;
}

/// Boxes that fall on planks past a sensor, bullets between them.
inline void FillWithBoxes(b2World &world) {
    for (int i = 0; i < 6; ++i) {
        const float x = static_cast<float>(i);
        AddBox(world, b2_staticBody, {6.0f * (x - 2.5f), -x}, {3.5f, 0.2f}, 0.15f * (x - 2.5f));
    }
    AddBox(world, b2_staticBody, {0.0f, 6.0f}, {12.0f, 0.5f}, 0.0f, true);
    for (int i = 0; i < 60; ++i) {
        const float x = static_cast<float>(i % 10), y = static_cast<float>(i / 10);
        b2Body *box =
            AddBox(world, b2_dynamicBody, {2.3f * (x - 4.5f), 8.0f + 1.3f * y}, {0.4f, 0.3f}, 0.3f * x);
        if (i % 7 == 0) {
            box->SetBullet(true);
            box->SetLinearVelocity({0.0f, -60.0f});
        }
    }
}

/// What happened, to the last bit: of worlds, the testbed's fields.
class Hash {
public:
    /// If there is one it gets a line for each number.
    testbed::TextSink *words = nullptr;

    // A sink of the testbed's.
    void Begin(const char *kind, uint64_t number) {
        m_sink.Begin(kind, number);
        if (words != nullptr)
            words->Begin(kind, number);
    }
    void Key(const char *name, uint64_t number) {
        m_sink.Key(name, number);
        if (words != nullptr)
            words->Key(name, number);
    }
    template <typename Number> void Field(const char *name, Number number) {
        m_sink.Field(name, number);
        if (words != nullptr)
            words->Field(name, number);
    }

    void Add(float value) { Field("number", value); }
    void Add(uint32_t value) { Field("number", value); }
    /// Contacts first: of what differs they are named, and not the bodies that their impulses move.
    void Add(const b2World &world) {
        uint64_t number = 0;
        for (const b2Contact *c = world.GetContactList(); c != nullptr; c = c->GetNext())
            Add(*c, number++);
        for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
            testbed::VisitBody(*this, *body);
        Begin("world", 0);
        Field("contacts", world.GetContactCount());
    }
    /// Of a sensor's contact all that Box2D finds is whether it touches.
    void Add(const b2Contact &contact, uint64_t number) {
        Begin("contact", number);
        testbed::NameContact(*this, contact);
        Field("touching", static_cast<uint32_t>(contact.IsTouching()));
        if (!contact.GetFixtureA()->IsSensor() && !contact.GetFixtureB()->IsSensor())
            testbed::VisitManifold(*this, *contact.GetManifold());
    }
    uint64_t Value() const { return m_sink.Value(); }

private:
    testbed::HashSink m_sink;
};

inline void Step(b2World &world, int steps, Hash *hash) {
    for (int i = 0; i < steps; ++i) {
        world.Step(1.0f / 60.0f, 8, 3);
        hash->Add(world);
    }
}

inline void Print(const char *what, const Hash &hash) {
    std::printf("%s %016" PRIx64 "\n", what, hash.Value());
    std::fflush(stdout);
}

#endif
