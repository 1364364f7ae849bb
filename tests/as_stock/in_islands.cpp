// SPDX-License-Identifier: MIT
// A listener changes in an island or an impact what the rest of the step is made of. A step of its world that
// it makes there, ends by an exception and catches leaves the world locked, as if there had been none. And
// islands that share a ground.
#include "as_stock.h"

using namespace as_stock;

namespace {

struct Thrown {};

/// A step in the midst of another one, thrown out of at the next PreSolve.
void StepAndThrow(Game &game, Run &run) {
    game.listener.preSolve.Once([] { throw Thrown(); });
    try {
        game.StepWithin();
        run.Print("!nothing was thrown");
    } catch (const Thrown &) {
    }
}

} // namespace

AS_STOCK("caught: PostSolve has bodies meet in a step that ends by an exception") {
    Game game(run);
    game.Leaning({-20.0f, 0.0f}); // last of those that touch
    std::vector<b2Body *> right;
    for (int i = 0; i < 60; ++i)
        right.push_back(game.Near({6.0f * Real(i % 8), 6.0f * Real(i / 8)}, 0.05f));
    game.Leaning({-20.0f, 10.0f}); // their island is the first
    game.Listen();
    game.Step(3);
    game.listener.postSolve.Once([&] {
        game.StepWithin(); // unlocks it
        for (b2Body *body : right)
            body->SetTransform(body->GetPosition() - b2Vec2(0.053f, 0.0f), 0.0f);
        game.listener.begin = [&](b2Contact *contact) {
            if (contact->GetFixtureB()->GetBody() == right[0])
                throw Thrown();
        };
        try {
            game.StepWithin();
            run.Print("!nothing was thrown");
        } catch (const Thrown &) {
        }
        game.listener.begin = nullptr;
    });
    game.Step(4);
}

// The contact of the shot and the post is the newest before and after, at the same place in memory.
AS_STOCK_HOW(kMayBeSilent,
             "heaped: a listener in an impact makes a post kinematic that a shot went through, and steps the "
             "world until its contact begins; an exception ends the step") {
    Game game(run, {0.0f, -10.0f});
    game.Wall({0.0f, -1.0f}, {60.0f, 1.0f});
    for (int i = 0; i < 12; ++i)
        for (int k = 0; k < 8; ++k)
            game.Awake({-9.0f + 1.3f * Real(i), 0.5f + Real(k)});
    b2Body *thrown[3];
    for (b2Body *&body : thrown) {
        const int i = static_cast<int>(&body - thrown);
        body = game.Awake({i == 1 ? 0.0f : -1.0f, i < 2 ? 40.0f : 20.0f}, {0.1f, 0.1f});
        body->SetGravityScale(0.0f);
    }
    b2Body *const post = thrown[1];
    game.Wall({0.0f, 20.0f}, {0.05f, 1.0f});
    game.Step(40);
    game.Listen();
    for (b2Body *shot : {thrown[0], thrown[2]})
        shot->SetLinearVelocity({120.0f, 0.0f});
    game.listener.begin.Once([&] {
        const b2Contact *const newest = game.world.GetContactList();
        game.StepWithin(); // unlocks it
        post->SetType(b2_kinematicBody);
        post->SetTransform(post->GetPosition(), 0.0f); // new contacts are looked for
        StepAndThrow(game, run);
        if (game.world.GetContactList() != newest)
            run.Print("!another contact is the newest");
    });
    game.Step(4);
}

// A train, and behind it a plate beside a row of boxes. They are two islands as long as the plate's contacts
// with the row are disabled, and it has other joints. What joins them is then solved with the row, at the
// place that the plate had in the train.
AS_STOCK_HOW(kMayBeSilent,
             "joined: PostSolve enables contacts of a body that is solved with others of a later island") {
    Game game(run);
    std::vector<b2Body *> row, poles;
    for (int i = 0; i < 12; ++i) {
        row.push_back(game.Awake({0.9f * Real(i), 0.0f}));
        poles.push_back(game.Wall({Real(i), 40.0f}));
        game.Tie(poles.back(), game.Box({Real(i), 50.0f}));
    }
    b2Body *const plate = game.Awake({5.0f, 0.95f}, {7.0f, 0.5f});
    for (int i = 0; i < 24; ++i)
        game.Awake({12.4f + 0.95f * Real(i), 0.95f}, {0.5f, 0.3f});
    game.Listen();
    const auto enable = [plate](bool enabled) {
        for (b2ContactEdge *edge = plate->GetContactList(); edge != nullptr; edge = edge->next)
            if (edge->other->GetPosition().x < 10.5f)
                edge->contact->SetEnabled(enabled);
    };
    game.listener.preSolve = [&enable] { enable(false); };
    for (b2Body *box : row)
        box->SetLinearVelocity({0.0f, -3.0f});
    int enabled = 0;
    game.listener.postSolve = [&] {
        enable(true);
        ++enabled;
    };
    game.Step(4);
    game.TookPlace(enabled, "contacts are enabled");
}

// Box2D's gear reads the places in islands of bodies that are not in its own.
AS_STOCK("read anew: PostSolve puts bodies to sleep ahead of their island, and later a gear reads their "
         "places") {
    Game game(run);
    std::vector<b2Body *> bodies;
    std::vector<b2Joint *> joints;
    for (int i = 0; i < 4; ++i)
        bodies.push_back(game.Awake({4.0f * Real(i), 0.3f * Real(i % 2)}));
    for (const size_t i : {0u, 2u})
        joints.push_back(game.Hinge(bodies[i], bodies[i + 1], bodies[i]->GetPosition()));
    std::vector<b2Body *> sleepers = {bodies[0], bodies[1]};
    for (const float x : {-0.99f, 0.99f}) // they touch, so that there are links
        sleepers.push_back(game.Awake({x, 0.0f}));
    for (int i = 0; i < 60; ++i)
        game.Near({4.0f * Real(i % 8), 10.0f + 4.0f * Real(i / 8)});
    game.Leaning({-20.0f, 0.0f}); // their island is the first
    game.Step(20);
    const auto tie = [&] {
        bodies[0]->SetEnabled(false);
        bodies[1]->SetAwake(true);
        b2GearJointDef gear;
        gear.bodyA = bodies[1];
        gear.bodyB = bodies[3];
        gear.joint1 = joints[0];
        gear.joint2 = joints[1];
        game.world.CreateJoint(&gear);
        for (size_t i = 1; i < 4; ++i)
            bodies[i]->SetAngularVelocity(Real(static_cast<int>(i)));
    };
    game.Listen();
    int slept = 0;
    game.listener.postSolve.Once([&] {
        for (b2Body *body : sleepers)
            body->SetAwake(false);
        ++slept;
    });
    game.Step();
    tie();
    game.Step(3);
    game.TookPlace(slept, "bodies are put to sleep");
}

namespace {

const b2Vec2 kDown(0.0f, -10.0f);

/// A kinematic floor of tiles, which makes one island of the boxes on it.
b2Body *AddFloor(Game &game) {
    b2Body *const floor = game.Body(b2_kinematicBody, {0.0f, 0.0f});
    for (int i = 1; i < 28; ++i) {
        const bool isHalf = i / 2 % 2 == 1; // two tiles, on both of which a box stands
        if (i == 1 || isHalf || i % 2 == 0)
            game.Box(floor, 1.0f, 1.0f,
                     {4.0f * Real(i / 2) + (isHalf ? 2.0f * Real(i % 2) - 1.0f : 0.0f), 0.0f});
    }
    return floor;
}

/// Boxes that slide to and fro are put back, at times one place further on: contacts differ in one of their
/// bodies alone. `zero`: how fast the floor is; a box that slides to the right turns the sign of -0.0.
void PlaySliding(Run &run, float zero, int iterations) {
    Game game(run, kDown);
    b2Body *const floor = AddFloor(game);
    for (int i = 0; i < 12; ++i)
        game.Box({4.0f * Real(i), 1.5f});
    int slid = 0;
    for (int step = 0; step < 60; ++step) {
        floor->SetLinearVelocity({zero, zero});
        int i = 0;
        for (b2Body *body = game.world.GetBodyList(); step % 3 == 0 && body != floor;
             body = body->GetNext()) {
            body->SetTransform({4.0f * Real(i + step % 2), 1.5f}, 0.0f);
            body->SetLinearVelocity({i++ % 2 == 0 ? 1.0f : -1.0f, 0.0f});
        }
        game.world.Step(1.0f / 60.0f, iterations, 3);
        game.WriteDown();
        slid += game.Touching();
    }
    game.TookPlace(slid, "boxes lie on the floor");
}

/// Balls far from each other on one ground: an island each, of which one hands the ground on to the next as
/// it leaves it. `drift`: how fast the ground is; `fall`: how fast one ball is at last, downwards. `leans`:
/// it leans on a post that drifts, too.
void PlayApart(Run &run, float drift, float fall, bool leans = false) {
    Game game(run, kDown);
    b2BodyDef def;
    def.linearVelocity.Set(drift, 0.0f);
    game.Box(game.world.CreateBody(&def), 50.0f, 1.0f);
    std::vector<b2Body *> balls;
    for (int i = 0; i < 13; ++i)
        balls.push_back(game.Disk({4.0f * Real(i) - 24.0f, 1.5f}, 0.5f));
    def.position = balls[10]->GetPosition() + b2Vec2(0.59f, 0.0f);
    def.linearVelocity.Set(0.3f, 0.0f);
    if (leans)
        game.Box(game.world.CreateBody(&def), 0.1f, 0.4f);
    game.Step(leans ? 1 : 10);
    game.TookPlace(game.Touching(), "balls lie on the ground");
    balls[10]->SetLinearVelocity({0.0f, -fall});
    game.Step(3);
    game.Stage(std::isnan(balls[12]->GetPosition().y) == std::isinf(fall), "what is NaN is handed on");
}

/// Pairs of balls, one on the ground, the other pinned to it and to the first. One pair's velocity makes the
/// ground's NaN, for all pairs that come after it. On a kinematic ground all are one island; on a static one
/// each is its own, and they are solved together.
void PlayPinned(Run &run, b2BodyType type, size_t fast) {
    Game game(run, kDown);
    b2Body *const ground = game.Body(type, {0.0f, 0.0f});
    game.Box(ground, 50.0f, 1.0f)->SetFriction(0.6f);
    std::vector<b2Body *> balls;
    for (int i = 0; i < 13; ++i) {
        const float x = 4.0f * Real(i) - 24.0f;
        balls.push_back(game.Disk({x, 1.5f}, 0.5f));
        b2Body *const other = game.Disk({x + 1.0f, 1.5f}, 0.5f);
        game.Hinge(balls.back(), other, {x + 0.6f, 1.7f});
        game.Hinge(ground, other, {x + 1.2f, 1.4f});
    }
    game.Step(10);
    balls[fast]->SetLinearVelocity({0.0f, -INFINITY});
    game.Step(3);
    game.Stage(std::isnan(balls[fast]->GetPosition().y), "a pair is NaN");
}

} // namespace

AS_STOCK_HOW(kMayBeSilent, "islands share a ground that moves") {
    PlayApart(run, 0.3f, 0.0f);
}

AS_STOCK_HOW(kMayBeSilent, "islands share a ground whose velocity becomes NaN") {
    for (const bool leans : {false, true})
        PlayApart(run, 0.0f, INFINITY, leans);
}

AS_STOCK_HOW(kMayBeSilent, "boxes slide on a floor") {
    PlaySliding(run, 0.0f, 8);
}

AS_STOCK_HOW(kMayBeSilent, "boxes slide on a floor that is as fast as -0.0") {
    PlaySliding(run, -0.0f, 1);
}

AS_STOCK_HOW(kMayBeSilent, "pinned pairs share a ground whose velocity becomes NaN") {
    for (const b2BodyType ground : {b2_staticBody, b2_kinematicBody})
        for (const size_t fast : {0u, 10u})
            PlayPinned(run, ground, fast);
}
