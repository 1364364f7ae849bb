// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_PLUGIN_SMALL_WORLD_H
#define BOOMERANG_TEST_PLUGIN_SMALL_WORLD_H

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

#include <box2d/box2d.h>

/// @file
/// What games share. They are plain Box2D programs: they know nothing of Boomerang.

inline b2Body *AddBox(b2World &world, b2BodyType type, b2Vec2 at, b2Vec2 half, float angle,
                      bool sensor = false) {
    b2BodyDef def;
    def.type = type;
    def.position = at;
    def.angle = angle;
    b2Body *body = world.CreateBody(&def);
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
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position = at;
    b2Body *body = world.CreateBody(&def);
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

/// What happened, to the last bit; numbers that are none are one number.
class Hash {
public:
    /// If there is one it gets a line for each number, with its name.
    std::string *words = nullptr;

    /// Of what comes next.
    void Name(const char *object, int number, const char *field) { m_name = {object, number, field}; }
    void Add(float value) {
        uint32_t bits = 0x7fc00000u;
        if (value == value)
            std::memcpy(&bits, &value, sizeof bits);
        if (words != nullptr)
            Write("%.9g", static_cast<double>(value));
        Mix(bits);
    }
    void Add(uint32_t word) {
        if (words != nullptr)
            Write("%.0f", static_cast<double>(word));
        Mix(word);
    }
    void Add(const b2Vec2 &v) {
        Add(v.x);
        Add(v.y);
    }
    /// By its number, which is all that a game's user data may be here.
    void Add(const b2Fixture &fixture) {
        Add(static_cast<uint32_t>(const_cast<b2Fixture &>(fixture).GetUserData().pointer));
    }
    void Add(const b2World &world) {
        int number = 0;
        for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext(), ++number) {
            const struct {
                const char *name;
                b2Vec2 value;
            } fields[] = {{"position", body->GetPosition()},
                          {"rotation", body->GetTransform().q.GetXAxis()},
                          {"centre", body->GetWorldCenter()},
                          {"velocity", body->GetLinearVelocity()},
                          {"angle and spin", b2Vec2(body->GetAngle(), body->GetAngularVelocity())}};
            for (const auto &field : fields) {
                Name("body", number, field.name);
                Add(field.value);
            }
            Name("body", number, "awake");
            Add(static_cast<uint32_t>(body->IsAwake()));
        }
        Name("world", 0, "contacts");
        Add(static_cast<uint32_t>(world.GetContactCount()));
        number = 0;
        for (const b2Contact *contact = world.GetContactList(); contact != nullptr;
             contact = contact->GetNext(), ++number)
            Add(*contact, number);
    }
    /// Of a sensor's contact all that Box2D finds is whether it touches.
    void Add(const b2Contact &contact, int number = 0) {
        Name("contact", number, "fixtures");
        Add(*contact.GetFixtureA());
        Add(*contact.GetFixtureB());
        Name("contact", number, "touching");
        Add(static_cast<uint32_t>(contact.IsTouching()));
        Name("contact", number, "manifold");
        if (!contact.GetFixtureA()->IsSensor() && !contact.GetFixtureB()->IsSensor())
            Add(*contact.GetManifold());
    }
    void Add(const b2Manifold &manifold) {
        Add(static_cast<uint32_t>(manifold.pointCount));
        if (manifold.pointCount == 0)
            return; // what is left in it is whatever was there
        Add(static_cast<uint32_t>(manifold.type));
        Add(manifold.localNormal);
        Add(manifold.localPoint);
        for (int32 i = 0; i < manifold.pointCount; ++i) {
            const b2ManifoldPoint &point = manifold.points[i];
            Add(point.id.key);
            Add(point.localPoint);
            Add(b2Vec2(point.normalImpulse, point.tangentImpulse));
        }
    }
    uint64_t Value() const { return m_value; }

private:
    void Mix(uint32_t word) { m_value = (m_value ^ word) * UINT64_C(1099511628211); }
    void Write(const char *format, double value) {
        char number[40];
        std::snprintf(number, sizeof number, format, value);
        *words += std::string("  ") + m_name.object + ' ' + std::to_string(m_name.number) + ' ' +
                  m_name.field + ": " + number + '\n';
    }

    uint64_t m_value = UINT64_C(14695981039346656037);
    struct {
        const char *object;
        int number;
        const char *field;
    } m_name = {"number", 0, "of the game"};
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
