// SPDX-License-Identifier: MIT
// Small worlds without joints.
#include "small_worlds/worlds.h"

namespace {

constexpr float kDown = 10.0f, kNone = 0.0f;

void Empty(b2World &) {}

void OneBox(b2World &world) {
    AddGround(world);
    AddBox(world, b2_dynamicBody, {0.0f, 5.0f}, {0.5f, 0.5f}, 0.3f);
}

void OneBall(b2World &world) {
    AddGround(world);
    AddBall(world, b2_dynamicBody, {0.0f, 5.0f}, 0.5f, 1.0f);
}

void Stack(b2World &world) {
    AddGround(world);
    for (int i = 0; i < 10; ++i)
        AddBox(world, b2_dynamicBody, {0.0f, 0.5f + static_cast<float>(i)}, {0.5f, 0.5f}, 0.0f);
}

void Pyramid(b2World &world) {
    AddGround(world);
    for (int row = 0; row < 4; ++row)
        for (int i = 0; i < 4 - row; ++i)
            AddBox(world, b2_dynamicBody,
                   {1.1f * static_cast<float>(i) + 0.55f * static_cast<float>(row),
                    0.5f + static_cast<float>(row)},
                   {0.5f, 0.5f}, 0.0f);
}

void Pile(b2World &world) {
    AddGround(world);
    AddBox(world, b2_staticBody, {-2.5f, 2.0f}, {0.2f, 2.0f}, 0.0f);
    AddBox(world, b2_staticBody, {2.5f, 2.0f}, {0.2f, 2.0f}, 0.0f);
    for (int i = 0; i < 12; ++i)
        AddRegular(world, {0.9f * static_cast<float>(i % 4) - 1.4f, 1.0f + static_cast<float>(i / 4)},
                   3 + i % 6, 0.4f);
}

void Dominoes(b2World &world) {
    AddGround(world);
    for (int i = 0; i < 15; ++i)
        AddBox(world, b2_dynamicBody, {static_cast<float>(i), 1.0f}, {0.1f, 1.0f}, 0.0f);
}

/// The first one is pushed; from time to time all are set up again.
void PlayDominoes(b2World &world, int step) {
    if (step % 400 == 0)
        ForEachDynamic(world, [](b2Body *body, int i) {
            body->SetTransform({static_cast<float>(i), 1.0f}, 0.0f);
            body->SetLinearVelocity(b2Vec2_zero);
            body->SetAngularVelocity(i == 0 ? -2.0f : 0.0f);
            body->SetAwake(true);
        });
}

void Pinball(b2World &world) {
    AddRoom(world, {6.0f, 10.0f}, false, 0.5f);
    for (int i = 0; i < 9; ++i)
        AddBall(world, b2_staticBody,
                {4.0f * static_cast<float>(i % 3 - 1), 4.0f * static_cast<float>(i / 3 - 1)}, 0.7f, 1.1f);
    AddBox(world, b2_kinematicBody, {-2.0f, -8.0f}, {1.5f, 0.2f}, 0.0f);
    AddBox(world, b2_kinematicBody, {2.0f, -8.0f}, {1.5f, 0.2f}, 0.0f);
    AddBall(world, b2_dynamicBody, {0.3f, 8.0f}, 0.4f, 0.6f)->SetBullet(true);
}

void PlayPinball(b2World &world, int step) {
    const float spin = step % 40 < 10 ? 4.0f : step % 40 < 20 ? -4.0f : 0.0f;
    ForEachKinematic(world, [spin](b2Body *body) { body->SetAngularVelocity(spin); });
    if (step % 300 == 0)
        ForEachDynamic(world, [](b2Body *body, int) { body->SetLinearVelocity({5.0f, 25.0f}); });
}

void Pool(b2World &world) {
    AddRoom(world, {12.0f, 6.0f}, true, 0.8f);
    for (int i = 0; i < 16; ++i) {
        b2Body *ball =
            AddBall(world, b2_dynamicBody,
                    {1.1f * static_cast<float>(i % 4), 1.1f * static_cast<float>(i / 4) - 1.6f}, 0.5f, 0.9f);
        ball->SetLinearDamping(0.3f);
    }
}

void PlayPool(b2World &world, int step) {
    if (step % 300 == 0)
        ForEachDynamic(world, [step](b2Body *body, int i) {
            if (i == step / 300 % 16)
                body->ApplyLinearImpulseToCenter({15.0f, 9.0f}, true);
        });
}

void Breakout(b2World &world) {
    AddRoom(world, {10.0f, 8.0f}, false, 1.0f);
    for (int i = 0; i < 30; ++i)
        AddBox(world, b2_staticBody,
               {1.8f * static_cast<float>(i % 10) - 8.1f, 4.0f + static_cast<float>(i / 10)}, {0.8f, 0.3f},
               0.0f);
    AddBox(world, b2_kinematicBody, {0.0f, -7.0f}, {1.5f, 0.3f}, 0.0f);
    AddBall(world, b2_dynamicBody, {0.0f, 0.0f}, 0.3f, 1.0f, 0.0f)->SetLinearVelocity({7.0f, 9.0f});
}

void PlayBreakout(b2World &world, int step) {
    ForEachKinematic(world, [step](b2Body *body) {
        body->SetLinearVelocity({step % 200 < 100 ? 4.0f : -4.0f, 0.0f});
    });
}

void Sensors(b2World &world) {
    AddRoom(world, {10.0f, 5.0f}, true, 1.0f);
    for (int i = 0; i < 4; ++i)
        AddBox(world, b2_staticBody, {5.0f * static_cast<float>(i) - 7.5f, 0.0f}, {1.0f, 4.0f}, 0.2f, true);
    for (int i = 0; i < 6; ++i) {
        b2Body *body = AddRegular(world, {2.5f * static_cast<float>(i) - 6.0f, 0.0f}, 4 + i % 3, 0.5f, 1.0f);
        body->SetLinearVelocity({3.0f, static_cast<float>(i) - 2.0f});
    }
}

void Bullets(b2World &world) {
    AddRoom(world, {15.0f, 6.0f}, true, 1.0f);
    for (int i = 0; i < 4; ++i)
        AddBox(world, b2_staticBody, {5.0f * static_cast<float>(i) - 7.5f, 0.0f}, {0.05f, 2.0f}, 0.3f);
    for (int i = 0; i < 6; ++i) {
        b2Body *body = AddRegular(world, {2.5f * static_cast<float>(i) - 6.0f, 4.0f}, 4, 0.2f, 1.0f);
        body->SetBullet(true);
        body->SetLinearVelocity({80.0f, 11.0f * static_cast<float>(i)});
    }
}

void Terrain(b2World &world) {
    b2Vec2 hills[40];
    for (int i = 0; i < 40; ++i)
        hills[i].Set(2.0f * static_cast<float>(i - 20), static_cast<float>(i * 7 % 5) * 0.3f);
    b2ChainShape chain;
    chain.CreateChain(hills, 40, hills[0] - b2Vec2(1.0f, 0.0f), hills[39] + b2Vec2(1.0f, 0.0f));
    AddBody(world, b2_staticBody, b2Vec2_zero, chain, 0.0f, 0.6f);
}

void Platformer(b2World &world) {
    Terrain(world);
    for (int i = 0; i < 3; ++i)
        AddBox(world, b2_kinematicBody, {6.0f * static_cast<float>(i), 4.0f}, {1.5f, 0.2f}, 0.0f);
    for (int i = 0; i < 5; ++i)
        AddBox(world, b2_dynamicBody, {3.0f * static_cast<float>(i) - 5.0f, 2.0f}, {0.5f, 0.5f}, 0.0f);
    AddBox(world, b2_staticBody, {4.0f, 3.0f}, {0.5f, 0.5f}, 0.0f, true);
    AddBox(world, b2_dynamicBody, {0.0f, 3.0f}, {0.4f, 0.8f}, 0.0f)->SetFixedRotation(true);
}

void PlayPlatformer(b2World &world, int step) {
    ForEachKinematic(world, [step](b2Body *body) {
        body->SetLinearVelocity({0.0f, step % 120 < 60 ? 1.5f : -1.5f});
    });
    ForEachDynamic(world, [step](b2Body *body, int i) {
        if (i != 0)
            return;
        b2Vec2 v = body->GetLinearVelocity();
        v.x = step % 400 < 200 ? 3.0f : -3.0f;
        if (step % 70 == 0)
            v.y = 7.0f;
        body->SetLinearVelocity(v);
    });
}

void Elevator(b2World &world) {
    AddGround(world);
    AddBox(world, b2_kinematicBody, {0.0f, 1.0f}, {3.0f, 0.2f}, 0.0f);
    for (int i = 0; i < 4; ++i)
        AddBox(world, b2_dynamicBody, {1.3f * static_cast<float>(i) - 2.0f, 2.0f}, {0.5f, 0.5f}, 0.0f);
}

void PlayElevator(b2World &world, int step) {
    ForEachKinematic(world, [step](b2Body *body) {
        body->SetLinearVelocity({0.0f, step % 300 < 150 ? 2.0f : -2.0f});
    });
}

void Slides(b2World &world) {
    for (int i = 0; i < 4; ++i)
        AddBox(world, b2_staticBody, {i % 2 == 0 ? -2.0f : 2.0f, 10.0f - 3.0f * static_cast<float>(i)},
               {4.0f, 0.2f}, i % 2 == 0 ? -0.4f : 0.4f);
    for (int i = 0; i < 5; ++i)
        AddRegular(world, {static_cast<float>(i) - 4.0f, 14.0f}, 4 + i % 3, 0.4f);
}

/// What fell out comes in again above.
void PlaySlides(b2World &world, int) {
    ForEachDynamic(world, [](b2Body *body, int i) {
        if (body->GetPosition().y > -10.0f)
            return;
        body->SetTransform({static_cast<float>(i) - 4.0f, 14.0f}, body->GetAngle());
        body->SetLinearVelocity(b2Vec2_zero);
    });
}

void Marbles(b2World &world) {
    b2Vec2 bowl[16];
    for (int i = 0; i < 16; ++i)
        bowl[i] = 6.0f * b2Rot(2.0f * b2_pi * static_cast<float>(i) / 16.0f).GetXAxis();
    b2ChainShape chain;
    chain.CreateLoop(bowl, 16);
    AddBody(world, b2_staticBody, b2Vec2_zero, chain, 0.2f, 0.2f);
    for (int i = 0; i < 10; ++i)
        AddBall(world, b2_dynamicBody, {static_cast<float>(i % 5) - 2.0f, static_cast<float>(i / 5)}, 0.4f,
                0.4f);
}

void Kick(b2World &world, int step) {
    if (step % 200 == 0)
        ForEachDynamic(world, [](b2Body *body, int i) {
            body->ApplyLinearImpulseToCenter(body->GetMass() * b2Vec2(i % 2 == 0 ? 3.0f : -3.0f, 6.0f), true);
        });
}

void Asteroids(b2World &world) {
    AddRoom(world, {15.0f, 10.0f}, false, 1.0f);
    for (int i = 0; i < 8; ++i) {
        b2Body *body = AddRegular(
            world, {3.5f * static_cast<float>(i % 4) - 5.0f, 4.0f * static_cast<float>(i / 4) - 2.0f},
            5 + i % 4, 1.0f, 1.0f);
        body->SetLinearVelocity({static_cast<float>(i % 3) - 1.0f, static_cast<float>(i % 5) - 2.0f});
        body->SetAngularVelocity(0.3f * static_cast<float>(i));
    }
}

void PolygonGas(b2World &world) {
    AddRoom(world, {6.0f, 6.0f}, true, 1.0f);
    for (int i = 0; i < 16; ++i) {
        b2Body *body = AddRegular(
            world, {2.5f * static_cast<float>(i % 4) - 4.0f, 2.5f * static_cast<float>(i / 4) - 4.0f},
            3 + i % 6, 0.6f, 1.0f);
        body->SetLinearVelocity({static_cast<float>(i % 5) - 2.0f, static_cast<float>(i % 7) - 3.0f});
    }
}

void BallGas(b2World &world) {
    AddRoom(world, {6.0f, 6.0f}, false, 1.0f);
    for (int i = 0; i < 16; ++i) {
        b2Body *body =
            AddBall(world, b2_dynamicBody,
                    {2.5f * static_cast<float>(i % 4) - 4.0f, 2.5f * static_cast<float>(i / 4) - 4.0f}, 0.6f,
                    1.0f, 0.0f);
        body->SetLinearVelocity({static_cast<float>(i % 5) - 2.0f, static_cast<float>(i % 7) - 3.0f});
    }
}

void Spinner(b2World &world) {
    AddRoom(world, {5.0f, 5.0f}, true, 0.2f);
    AddBox(world, b2_kinematicBody, {0.0f, -2.0f}, {3.0f, 0.3f}, 0.0f)->SetAngularVelocity(1.5f);
    for (int i = 0; i < 8; ++i)
        AddRegular(world, {static_cast<float>(i % 4) - 2.0f, 2.0f + static_cast<float>(i / 4)}, 4, 0.5f);
}

void TopDown(b2World &world) {
    AddRoom(world, {12.0f, 12.0f}, true, 0.0f);
    for (int i = 0; i < 5; ++i)
        AddBox(world, b2_staticBody,
               {4.0f * static_cast<float>(i) - 8.0f, static_cast<float>(i * 3 % 5) - 2.0f}, {0.8f, 1.5f},
               0.0f);
    for (int i = 0; i < 10; ++i)
        AddBall(world, b2_dynamicBody, {2.0f * static_cast<float>(i) - 9.0f, -8.0f}, 0.4f)
            ->SetFixedRotation(true);
}

void PlayTopDown(b2World &world, int step) {
    ForEachDynamic(world, [step](b2Body *body, int i) {
        body->SetLinearVelocity(3.0f *
                                b2Rot(0.01f * static_cast<float>(step) + static_cast<float>(i)).GetXAxis());
    });
}

/// A level at rest, and one ball in it.
void Level(b2World &world) {
    for (int i = 0; i < 100; ++i)
        AddBox(world, b2_staticBody,
               {2.0f * static_cast<float>(i % 20) - 20.0f, 3.0f * static_cast<float>(i / 20)}, {0.8f, 0.2f},
               0.1f * static_cast<float>(i % 3));
    AddRoom(world, {22.0f, 16.0f}, false, 0.9f);
    AddBall(world, b2_dynamicBody, {0.5f, 14.0f}, 0.3f, 0.9f);
}

void Sleepers(b2World &world) {
    AddGround(world);
    for (int i = 0; i < 20; ++i)
        AddBox(world, b2_dynamicBody, {2.0f * static_cast<float>(i) - 20.0f, 0.5f}, {0.5f, 0.5f}, 0.0f);
    AddBall(world, b2_dynamicBody, {25.0f, 5.0f}, 0.5f, 1.0f);
}

/// One box thrown through the air, without a contact.
void Projectile(b2World &world) {
    AddBox(world, b2_dynamicBody, {0.0f, 0.0f}, {0.5f, 0.5f}, 0.0f)->SetAngularVelocity(1.0f);
}

void PlayProjectile(b2World &world, int step) {
    if (step % 100 == 0)
        ForEachDynamic(world, [](b2Body *body, int) {
            body->SetTransform(b2Vec2_zero, 0.0f);
            body->SetLinearVelocity({5.0f, 9.0f});
        });
}

} // namespace

const SmallWorld kLooseWorlds[] = {
    {"empty", kDown, Empty, nullptr},
    {"one-box", kDown, OneBox, nullptr},
    {"one-ball", kDown, OneBall, nullptr},
    {"projectile", kDown, Projectile, PlayProjectile},
    {"stack", kDown, Stack, nullptr},
    {"kicked-stack", kDown, Stack, Kick},
    {"pyramid", kDown, Pyramid, Kick},
    {"pile", kDown, Pile, nullptr},
    {"kicked-pile", kDown, Pile, Kick},
    {"dominoes", kDown, Dominoes, PlayDominoes},
    {"pinball", kDown, Pinball, PlayPinball},
    {"pool", kNone, Pool, PlayPool},
    {"breakout", kNone, Breakout, PlayBreakout},
    {"sensors", kNone, Sensors, nullptr},
    {"bullets", kNone, Bullets, nullptr},
    {"platformer", kDown, Platformer, PlayPlatformer},
    {"elevator", kDown, Elevator, PlayElevator},
    {"slides", kDown, Slides, PlaySlides},
    {"marbles", kDown, Marbles, Kick},
    {"asteroids", kNone, Asteroids, nullptr},
    {"polygon-gas", kNone, PolygonGas, nullptr},
    {"ball-gas", kNone, BallGas, nullptr},
    {"spinner", kDown, Spinner, nullptr},
    {"top-down", kNone, TopDown, PlayTopDown},
    {"level", kDown, Level, nullptr},
    {"sleepers", kDown, Sleepers, nullptr},
    {nullptr, kNone, nullptr, nullptr},
};
