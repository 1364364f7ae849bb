// SPDX-License-Identifier: MIT
//
//   straying_game corners
//   straying_game slow
//
// Worlds where little is left of what is rounded. Prints lines of hashes. A plain program of Box2D's: with
// the plugin preloaded it prints the same.
//
//   corners   pairs of triangles whose tips come near each other, also where nothing is exact to a millimetre
//   slow      needles that turn by next to nothing in each step, until they meet: what is lost in each
//             is lost often; at the origin and 600 m away
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

void PlaySlow(float out) {
    b2World world(b2Vec2(0.0f, 0.0f));
    Hash hash;
    for (int i = 0; i < 12; ++i) {
        for (const float side : {0.0f, 0.1f}) {
            b2Body *needle = AddBox(world, b2_dynamicBody, {out + 3.0f * static_cast<float>(i), side},
                                    {1.0f, 0.02f}, 0.0f);
            needle->SetSleepingAllowed(false);
            needle->SetAngularVelocity((side > 0.0f ? -0.0006f : 0.0006f) * static_cast<float>(i + 1));
        }
    }
    Step(world, 4000, &hash);
    Print("slow", hash);
}

} // namespace

int main(int argc, char **argv) {
    if (argc == 2 && std::strcmp(argv[1], "corners") == 0) {
        PlayCorners();
    } else if (argc == 2 && std::strcmp(argv[1], "slow") == 0) {
        PlaySlow(0.0f);
        PlaySlow(600.0f);
    } else {
        std::fputs("usage: straying_game corners|slow\n", stderr);
        return 2;
    }
    return 0;
}
