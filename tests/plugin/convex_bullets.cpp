// SPDX-License-Identifier: MIT
// Bullets of big polygons at 60 to 110 m/s against thin walls, and against each other: nothing gets
// through. Built as convex_queries.cpp is: with real polygons and with octagons for b2TimeOfImpact.
//
// Bullets in one room do not see each other: one that a heavier one squeezes against a wall is overlapped by
// both after Box2D's correction of positions, and Box2D gives up on it, whatever its shape.
//
// usage: convex_bullets [SHOTS] [control]
// In the control the world is not continuous: many get through. Exit codes: 0 none is through, 1 some
// are, 2 wrong usage.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <box2d/box2d.h>

#include "boomerang/box2d.h"
#include "box2d_shapes.h"
#include "test_scale.h"

using namespace shapes;

namespace {

constexpr float kHalfRoom = 10.0f;
constexpr int kBulletsOfARoom = 25, kSteps = 45;
constexpr float kStep = 1.0f / 60.0f;

bool continuous = true;

bmr::ConvexShape RandomBullet(Engine &engine, float *inner) {
    constexpr int kCounts[] = {9, 12, 16, 32, 64, 256, 1024, 4096};
    const int count = kCounts[Below(engine, 8)];
    const float radius = UniformF(engine, 0.05, 0.3);
    bmr::ConvexShape shape;
    const bmr_error error = Below(engine, 4) == 0 ? shape.SetEllipse(count, radius, 0.6f * radius)
                                                  : shape.SetRegular(count, radius);
    if (error != BMR_OK) {
        std::printf("no bullet of %d vertices: %s\n", count, bmr_error_describe(error));
        std::exit(2);
    }
    *inner = 0.0f;
    for (int i = 0; i < 8; ++i)
        *inner =
            *inner == 0.0f ? shape.m_vertices[i].Length() : std::min(*inner, shape.m_vertices[i].Length());
    return shape;
}

b2Body *Shoot(b2World *world, Engine &engine, const b2Shape &shape, b2Vec2 from, float angle, int16 group) {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.bullet = true;
    def.position = from;
    def.angle = UniformF(engine, -3.2, 3.2);
    const float speed = UniformF(engine, 60.0, 110.0);
    def.linearVelocity.Set(speed * std::cos(angle), speed * std::sin(angle));
    def.angularVelocity = UniformF(engine, -50.0, 50.0);
    b2Body *body = world->CreateBody(&def);
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = 1.0f;
    fixture.friction = 0.3f;
    fixture.restitution = UniformF(engine, 0.0, 1.0);
    fixture.filter.groupIndex = group;
    body->CreateFixture(&fixture);
    return body;
}

enum class Walls { kPlanks, kEdges, kChain, kBigPlanks, kCount };

void Build(b2World *world, Walls walls) {
    b2BodyDef def;
    b2Body *ground = world->CreateBody(&def);
    const float h = kHalfRoom;
    const b2Vec2 corners[] = {{-h, -h}, {h, -h}, {h, h}, {-h, h}};
    if (walls == Walls::kChain) { // its links push inwards
        const b2Vec2 inwards[] = {corners[3], corners[2], corners[1], corners[0]};
        b2ChainShape chain;
        chain.CreateLoop(inwards, 4);
        ground->CreateFixture(&chain, 0.0f);
        return;
    }
    for (int i = 0; i < 4; ++i) {
        const b2Vec2 from = corners[i], to = corners[(i + 1) % 4];
        if (walls == Walls::kEdges) {
            b2EdgeShape edge;
            edge.SetTwoSided(from, to);
            ground->CreateFixture(&edge, 0.0f);
            continue;
        }
        constexpr float kThin = 0.02f;
        const b2Vec2 middle = 0.5f * (from + to);
        if (walls == Walls::kPlanks) {
            b2PolygonShape plank;
            plank.SetAsBox(h + 0.1f, kThin, middle, i % 2 == 0 ? 0.0f : 0.5f * b2_pi);
            ground->CreateFixture(&plank, 0.0f);
            continue;
        }
        bmr::ConvexShape rounded;
        if (rounded.SetRounded(h + 0.1f, kThin, kThin, 6) != BMR_OK)
            std::exit(2);
        def.position = middle;
        def.angle = i % 2 == 0 ? 0.0f : 0.5f * b2_pi;
        world->CreateBody(&def)->CreateFixture(&rounded, 0.0f);
    }
}

/// Bullets bounce about in a room of thin walls: how many are outside at the end?
int ShootInARoom(Engine &engine, Walls walls) {
    b2World world(b2Vec2(0.0f, -10.0f));
    world.SetContinuousPhysics(continuous);
    Build(&world, walls);
    std::vector<b2Body *> bullets;
    for (int i = 0; i < kBulletsOfARoom; ++i) {
        float inner;
        const bmr::ConvexShape shape = RandomBullet(engine, &inner);
        const b2Vec2 from(UniformF(engine, -8.0, 8.0), UniformF(engine, -8.0, 8.0));
        bullets.push_back(Shoot(&world, engine, shape, from, UniformF(engine, -3.2, 3.2), -1));
    }
    for (int i = 0; i < kSteps; ++i)
        world.Step(kStep, 8, 3);
    int outside = 0;
    for (const b2Body *bullet : bullets) {
        const b2Vec2 at = bullet->GetPosition();
        outside += std::fabs(at.x) > kHalfRoom || std::fabs(at.y) > kHalfRoom || !at.IsValid() ? 1 : 0;
    }
    return outside;
}

class Touches : public b2ContactListener {
public:
    void BeginContact(b2Contact *) override { touched = true; }
    bool touched = false;
};

/// Two bullets fly at each other, so that what is certain to be inside of them overlaps on the way: do they
/// pass without a touch?
int ShootAtEachOther(Engine &engine) {
    b2World world(b2Vec2_zero);
    world.SetContinuousPhysics(continuous);
    Touches touches;
    world.SetContactListener(&touches);
    float innerA, innerB;
    const bmr::ConvexShape a = RandomBullet(engine, &innerA), b = RandomBullet(engine, &innerB);
    const float offset = UniformF(engine, -0.5, 0.5) * (innerA + innerB) * 0.8f;
    const float apart = UniformF(engine, 3.0, 6.0);
    const b2Body *left = Shoot(&world, engine, a, b2Vec2(-apart, 0.0f), 0.0f, 0);
    const b2Body *right = Shoot(&world, engine, b, b2Vec2(apart, offset), b2_pi, 0);
    for (int i = 0; i < 12 && !touches.touched; ++i)
        world.Step(kStep, 8, 3);
    return !touches.touched && left->GetPosition().x > right->GetPosition().x ? 1 : 0;
}

} // namespace

int main(int argc, char **argv) {
    const size_t shots = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : test_scaled(1000);
    if (argc > 3 || (argc == 3 && std::strcmp(argv[2], "control") != 0) || shots == 0) {
        std::puts("usage: convex_bullets [SHOTS] [control]");
        return 2;
    }
    continuous = argc < 3;
    Engine engine(1);
    constexpr const char *kNames[] = {"planks", "edges", "a chain", "big planks"};
    int through = 0;
    const size_t each = shots / 5 + 1;
    for (int walls = 0; walls < static_cast<int>(Walls::kCount); ++walls) {
        int here = 0;
        for (size_t shot = 0; shot < each; shot += kBulletsOfARoom)
            here += ShootInARoom(engine, static_cast<Walls>(walls));
        std::printf("%s: %d through\n", kNames[walls], here);
        through += here;
    }
    int passed = 0;
    for (size_t shot = 0; shot < each; shot += 2)
        passed += ShootAtEachOther(engine);
    std::printf("each other: %d through\n", passed);
    through += passed;
    std::printf("%d through of %zu shots\n", through, shots);
    return through == 0 ? 0 : 1;
}
