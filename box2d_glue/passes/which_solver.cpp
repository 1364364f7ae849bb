// SPDX-License-Identifier: MIT
#include "passes/which_solver.h"

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

#include <box2d/b2_body.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_world.h>

#include "base/private_members.h"
#include "passes/impacts.h"
#include "passes/island_solver.h"
#include "passes/islands.h"

namespace bmr {

namespace {

constexpr int kPairs = 8, kBullets = 8, kBodies = 2 * kPairs + 3 * kBullets, kSteps = 4;
constexpr float kSize = b2_lengthUnitsPerMeter;

/// Pairs that overlap, far from each other: a body at rest and one that moves, of all kinds of manifolds.
void AddPairs(b2World *world) {
    b2PolygonShape boxes[2];
    b2CircleShape circle;
    boxes[0].SetAsBox(1.31f * kSize, 0.37f * kSize);
    boxes[1].SetAsBox(0.53f * kSize, 0.41f * kSize);
    circle.m_radius = 0.47f * kSize;
    for (int i = 0; i < kPairs; ++i) {
        const float x = static_cast<float>(i), angle = 0.37f * x;
        b2BodyDef def;
        def.position = kSize * b2Vec2(20.0f * x, 0.7f * x);
        def.angle = angle;
        b2FixtureDef fixture;
        fixture.friction = 0.3f;
        fixture.restitution = 0.2f * static_cast<float>(i % 2);
        fixture.density = 1.7f;
        fixture.shape = i % 4 == 3 ? static_cast<const b2Shape *>(&circle) : &boxes[0];
        world->CreateBody(&def)->CreateFixture(&fixture);
        def.type = b2_dynamicBody;
        def.position += kSize * b2Mul(b2Rot(angle), b2Vec2(0.21f, 0.73f));
        def.angle += 0.02f * x - 0.05f;
        def.linearVelocity = kSize * b2Vec2(0.9f - 0.3f * x, -1.1f);
        def.angularVelocity = 0.7f - 0.2f * x;
        def.linearDamping = 0.13f;
        def.angularDamping = 0.07f;
        fixture.shape = i % 4 == 2 || i % 4 == 3 ? static_cast<const b2Shape *>(&circle) : &boxes[1];
        world->CreateBody(&def)->CreateFixture(&fixture);
    }
}

/// Bullets on their way through walls, each beside a body that it may push. Their centres are not their
/// origins.
void AddBullets(b2World *world) {
    b2PolygonShape wall, box;
    wall.SetAsBox(2.3f * kSize, 0.05f * kSize);
    box.SetAsBox(0.31f * kSize, 0.17f * kSize, kSize * b2Vec2(0.07f, 0.11f), 0.3f);
    for (int i = 0; i < kBullets; ++i) {
        const float x = static_cast<float>(i);
        const b2Rot turn(0.29f * x);
        b2BodyDef def;
        b2FixtureDef fixture;
        def.angle = 0.29f * x;
        def.position = kSize * b2Vec2(20.0f * x, 40.0f);
        fixture.shape = &wall;
        world->CreateBody(&def)->CreateFixture(&fixture);
        const b2Vec2 wallAt = def.position;
        def.type = b2_dynamicBody;
        def.bullet = true;
        def.angle += 0.13f * x;
        def.angularVelocity = 3.1f - 0.9f * x;
        def.linearVelocity = kSize * b2Mul(turn, b2Vec2(1.7f - 0.4f * x, -71.0f - x));
        def.position = wallAt + kSize * b2Mul(turn, b2Vec2(0.0f, 0.46f));
        fixture.shape = &box;
        fixture.density = 1.3f;
        world->CreateBody(&def)->CreateFixture(&fixture);
        def.bullet = false;
        def.linearVelocity = kSize * b2Vec2(0.3f, -1.9f);
        def.position = wallAt + kSize * b2Mul(turn, b2Vec2(0.55f + 0.03f * x, 0.49f));
        world->CreateBody(&def)->CreateFixture(&fixture);
    }
}

/// Makes and updates the world's contacts; how many touch?
int Touch(b2World *world) {
    auto &manager = const_cast<b2ContactManager &>(world->GetContactManager());
    manager.FindNewContacts();
    manager.Collide();
    int touching = 0;
    for (const b2Contact *contact = world->GetContactList(); contact != nullptr; contact = contact->GetNext())
        touching += contact->IsTouching() ? 1 : 0;
    return touching;
}

/// How many bodies has the search for impacts moved?
int Displaced(b2World *world) {
    int displaced = 0;
    for (b2Body *body = world->GetBodyList(); body != nullptr; body = body->GetNext())
        displaced += SweepOf(*body).alpha0 > 0.0f ? 1 : 0;
    return displaced;
}

template <typename T> bool SameBits(const T &a, const T &b) {
    return std::memcmp(static_cast<const void *>(&a), static_cast<const void *>(&b), sizeof a) == 0;
}

bool AreAlike(const b2World &a, const b2World &b) {
    const b2Body *other = b.GetBodyList();
    for (const b2Body *body = a.GetBodyList(); body != nullptr; body = body->GetNext()) {
        if (!SameBits(body->GetTransform(), other->GetTransform()) ||
            !SameBits(SweepOf(*body), SweepOf(*other)) ||
            !SameBits(body->GetLinearVelocity(), other->GetLinearVelocity()) ||
            !SameBits(body->GetAngularVelocity(), other->GetAngularVelocity()))
            return false;
        other = other->GetNext();
    }
    return true;
}

/// A constructor that may throw asks for a `delete` of its own where `new` makes it: here memory is malloc's.
struct Unmake {
    void operator()(b2World *world) const {
        world->~b2World();
        std::free(world);
    }
};
using MadeWorld = std::unique_ptr<b2World, Unmake>;

MadeWorld Make(const b2Vec2 &gravity) {
    void *const room = std::malloc(sizeof(b2World));
    return MadeWorld(room == nullptr ? nullptr : new (room) b2World(gravity));
}

/// Do our passes, with islands solved by `solvedBy`, leave what Box2D's leave?
bool StepAlike(IslandsBy solvedBy) {
    const b2Vec2 gravity = kSize * b2Vec2(0.3f, -9.7f);
    const MadeWorld stock = Make(gravity), ours = Make(gravity);
    IslandSolvers solvers;
    IslandSolver *const solver = solvers.Take();
    if (stock == nullptr || ours == nullptr || solver == nullptr)
        return false;
    for (b2World *world : {stock.get(), ours.get()}) {
        AddPairs(world);
        AddBullets(world);
    }
    solver->SolveBy(solvedBy, ours.get());
    const float dt = 1.0f / 60.0f;
    const b2TimeStep step = {dt, 1.0f / dt, 1.0f, 8, 3, true};
    int displaced = 0;
    for (int i = 0; i < kSteps; ++i) {
        const int touching = Touch(stock.get());
        if (touching < kPairs / 2 || Touch(ours.get()) != touching ||
            !solver->Reserve(kBodies, 2 * kBodies, 0))
            return false;
        TheStockSolver().solveWorld(stock.get(), step);
        IslandPass(ours.get(), step, solver).Run();
        if (!AreAlike(*stock, *ours))
            return false;
        TheStockSolver().solveImpacts(stock.get(), step);
        ImpactPass(ours.get(), step, solver).Run();
        if (!AreAlike(*stock, *ours))
            return false;
        displaced += Displaced(stock.get());
    }
    return displaced >= kBullets;
}

IslandsBy FindOut() {
    if (TheStockSolver().solveWorld == nullptr)
        return IslandsBy::Nobody;
    if (StepAlike(IslandsBy::Ours))
        return IslandsBy::Ours;
    return TheStockSolver().solve != nullptr && StepAlike(IslandsBy::Box2D) ? IslandsBy::Box2D
                                                                            : IslandsBy::Nobody;
}

} // namespace

IslandsBy WhoSolvesIslands() {
    // (Two threads that find out at once find the same.)
    static std::atomic<int> known{-1};
    int answer = known.load(std::memory_order_relaxed);
    if (answer < 0) {
        answer = static_cast<int>(FindOut());
        known.store(answer, std::memory_order_relaxed);
    }
    return static_cast<IslandsBy>(answer);
}

} // namespace bmr
