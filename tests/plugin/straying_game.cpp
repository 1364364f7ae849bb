// SPDX-License-Identifier: MIT
//
//   straying_game crossing FIRST COUNT
//   straying_game corners
//
// Worlds far from the origin, where numbers have few bits left of a millimetre. Prints a line for each world.
// A plain program of Box2D's: with the plugin preloaded it prints the same.
//
//   crossing  random crowds that fly out and in across 480, 960, 1920, 3840 and 7680 metres from the origin,
//             past walls that move, bullets and sensors among them; origins are shifted, crowds carried
//             elsewhere
//   corners   pairs of triangles whose tips come near each other, also where nothing is exact to a millimetre
#include <cstdlib>
#include <random>
#include <vector>

#include "small_world.h"

namespace {

class Random {
public:
    explicit Random(uint32_t seed) : m_engine(seed) {}
    int Below(int n) { return static_cast<int>(m_engine() % static_cast<uint32_t>(n)); }
    float Between(float low, float high) {
        return low + (high - low) * static_cast<float>(Below(4096)) / 4096.0f;
    }

private:
    std::minstd_rand m_engine;
};

class Crowd {
public:
    explicit Crowd(uint32_t seed) : m_random(seed), m_world(b2Vec2(0.0f, seed % 3 == 0 ? -10.0f : 0.0f)) {
        static constexpr float kBorders[] = {480.0f, 960.0f, 1920.0f, 3840.0f, 7680.0f};
        const b2Rot toward(0.25f * b2_pi * static_cast<float>(seed % 8));
        m_out = {static_cast<float>(b2Abs(toward.c) > 0.5f) * (toward.c < 0.0f ? -1.0f : 1.0f),
                 static_cast<float>(b2Abs(toward.s) > 0.5f) * (toward.s < 0.0f ? -1.0f : 1.0f)};
        m_border = (kBorders[seed % 5] - 1.0f) * m_out;
        const int count = 50 + m_random.Below(30);
        for (int i = 0; i < count; ++i)
            Add();
        for (const float side : {-1.0f, 1.0f}) { // walls that close in, across the border
            b2Body *wall = AddBox(m_world, b2_kinematicBody, m_border + 16.0f * side * m_out.Skew(),
                                  {m_out.x == 0.0f ? 0.3f : 12.0f, m_out.y == 0.0f ? 0.3f : 12.0f}, 0.0f);
            wall->SetLinearVelocity(-1.5f * side * m_out.Skew());
            wall->SetAngularVelocity(0.1f * side);
        }
    }

    void Play(int steps, Hash *hash) {
        for (int i = 0; i < steps; ++i) {
            if (i % 12 == 0) // out, and in again
                Drive(i % 24 == 0 ? 1.0f : -1.0f);
            Change();
            m_world.Step(1.0f / 60.0f, 8, 3);
            hash->Add(m_world);
        }
    }

private:
    void Add() {
        const b2Vec2 at = m_border + b2Vec2(m_random.Between(-14.0f, 14.0f), m_random.Between(-14.0f, 14.0f));
        if (m_random.Below(9) == 0) {
            m_bodies.push_back(AddWheel(m_world, at, 3 + m_random.Below(5), m_random.Between(0.2f, 0.7f)));
        } else {
            const b2Vec2 half(m_random.Between(0.05f, 0.8f), m_random.Between(0.05f, 0.3f));
            m_bodies.push_back(AddBox(m_world, b2_dynamicBody, at, half, m_random.Between(0.0f, 3.0f),
                                      m_random.Below(6) == 0));
        }
        m_bodies.back()->SetBullet(m_random.Below(4) == 0);
        m_bodies.back()->SetAngularVelocity(m_random.Between(-2.0f, 2.0f));
    }

    /// All of them, at nearly the same speed: a few metres a second or, one time in four, too fast for
    /// budgets.
    void Drive(float sign) {
        const float speed =
            sign * (m_random.Below(4) == 0 ? m_random.Between(10.0f, 70.0f) : m_random.Between(0.0f, 3.0f));
        for (b2Body *body : m_bodies)
            body->SetLinearVelocity(speed * m_out +
                                    b2Vec2(m_random.Between(-0.5f, 0.5f), m_random.Between(-0.5f, 0.5f)));
    }

    void Change() {
        switch (m_random.Below(24)) {
        case 0: // the world's origin, into another band or just a little
            m_world.ShiftOrigin(m_random.Below(2) == 0 ? 0.5f * m_border : 0.01f * m_border);
            break;
        case 1: // and away from it
            m_world.ShiftOrigin(-m_random.Between(0.0f, 1.0f) * m_border);
            break;
        case 2: { // all of them
            const b2Vec2 by = m_random.Between(-1.0f, 0.5f) * m_border;
            for (b2Body *body : m_bodies)
                body->SetTransform(body->GetPosition() + by, body->GetAngle());
            break;
        }
        case 3: {
            b2Body *some = m_bodies[static_cast<size_t>(m_random.Below(static_cast<int>(m_bodies.size())))];
            some->SetBullet(!some->IsBullet());
            some->GetFixtureList()->SetSensor(m_random.Below(3) == 0);
            break;
        }
        default:
            break;
        }
    }

    Random m_random;
    b2World m_world;
    b2Vec2 m_out, m_border;
    std::vector<b2Body *> m_bodies;
};

/// A triangle whose tip is at a place, and which lies in some direction of it, more or less.
b2Body *AddTip(b2World &world, b2BodyType type, b2Vec2 at, float direction, Random &random) {
    const float width = random.Between(0.05f, 1.2f), lies = direction + random.Between(-0.6f, 0.6f);
    const b2Vec2 corners[3] = {{0.0f, 0.0f},
                               random.Between(0.3f, 0.9f) * b2Rot(lies - width).GetXAxis(),
                               random.Between(0.3f, 0.9f) * b2Rot(lies + width).GetXAxis()};
    b2BodyDef def;
    def.type = type;
    def.position = at;
    def.allowSleep = false;
    b2Body *body = world.CreateBody(&def);
    b2PolygonShape triangle;
    triangle.Set(corners, 3);
    body->CreateFixture(&triangle, 1.0f);
    return body;
}

/// One triangle of each pair is carried towards the tip of the other, tip first. Where two tips meet,
/// two touch that are as far apart as any can be that do, give or take what is rounded.
void PlayCorners() {
    constexpr int kSteps = 60;
    constexpr float kApart = 0.09f;
    for (const float far : {400.0f, 900.0f, 1800.0f, 3700.0f, 7500.0f, 30000.0f, 100000.0f}) {
        b2World world(b2Vec2(0.0f, 0.0f));
        Random random(static_cast<uint32_t>(far));
        Hash hash;
        struct Pair {
            b2Body *moved;
            b2Vec2 tip, from;
        };
        std::vector<Pair> pairs;
        for (int i = 0; i < 150; ++i) {
            const b2Vec2 tip(far + 3.0f * static_cast<float>(i % 12),
                             far + 3.0f * static_cast<float>(i / 12));
            const float direction = random.Between(0.0f, 6.3f);
            AddTip(world, b2_staticBody, tip, direction + b2_pi, random);
            const b2Vec2 from = kApart * b2Rot(direction).GetXAxis();
            pairs.push_back({AddTip(world, b2_dynamicBody, tip + from, direction, random), tip, from});
        }
        for (int step = 0; step < kSteps; ++step) {
            const float left = 1.0f - static_cast<float>(step) / static_cast<float>(kSteps);
            for (const Pair &pair : pairs) {
                pair.moved->SetTransform(pair.tip + left * pair.from, 0.0f);
                pair.moved->SetLinearVelocity({0.0f, 0.0f});
                pair.moved->SetAngularVelocity(0.0f);
            }
            Step(world, 1, &hash);
        }
        Print("corners", hash);
    }
}

} // namespace

int main(int argc, char **argv) {
    if (argc == 2 && std::strcmp(argv[1], "corners") == 0) {
        PlayCorners();
        return 0;
    }
    if (argc != 4 || std::strcmp(argv[1], "crossing") != 0) {
        std::fputs("usage: straying_game crossing FIRST COUNT | corners\n", stderr);
        return 2;
    }
    const auto first = static_cast<uint32_t>(std::atoi(argv[2])),
               count = static_cast<uint32_t>(std::atoi(argv[3]));
    for (uint32_t seed = first; seed != first + count; ++seed) {
        Hash hash;
        Crowd(seed).Play(60, &hash);
        std::printf("seed %u ", seed);
        Print("ends with", hash);
    }
    return 0;
}
