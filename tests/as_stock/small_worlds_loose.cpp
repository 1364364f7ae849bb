// SPDX-License-Identifier: MIT
// Worlds of a few bodies, as most games step them and some programs by the thousand: without joints. The
// library mostly leaves these to Box2D.
#include "small_worlds.h"

using namespace as_stock;

namespace {

constexpr float kDown = 10.0f, kNone = 0.0f;

void Stack(b2World &world) {
    AddGround(world);
    for (int i = 0; i < 10; ++i)
        Box(world, {0.0f, 0.5f + Real(i)});
}

void Pile(b2World &world) {
    AddGround(world);
    Wall(world, {-2.5f, 2.0f}, {0.2f, 2.0f});
    Wall(world, {2.5f, 2.0f}, {0.2f, 2.0f});
    for (int i = 0; i < 12; ++i)
        AddRegular(world, {0.9f * Real(i % 4) - 1.4f, 1.0f + Real(i / 4)}, 3 + i % 6, 0.4f);
}

void Terrain(b2World &world) {
    b2Vec2 hills[40];
    for (int i = 0; i < 40; ++i)
        hills[i].Set(2.0f * Real(i - 20), Real(i * 7 % 5) * 0.3f);
    b2ChainShape chain;
    chain.CreateChain(hills, 40, hills[0] - b2Vec2(1.0f, 0.0f), hills[39] + b2Vec2(1.0f, 0.0f));
    AddBody(world, b2_staticBody, b2Vec2_zero, chain, 0.0f, 0.6f);
}

void Kick(b2World &world, int step) {
    if (step % 200 == 0)
        ForEachDynamic(world, [](b2Body *body, int i) {
            body->ApplyLinearImpulseToCenter(body->GetMass() * b2Vec2(i % 2 == 0 ? 3.0f : -3.0f, 6.0f), true);
        });
}

const SmallWorld kWorlds[] = {
    {"empty", kDown, [](b2World &) {}, nullptr},
    {"one-box", kDown,
     [](b2World &world) {
         AddGround(world);
         Box(world, {0.0f, 5.0f}, {0.5f, 0.5f}, 0.3f);
     },
     nullptr},
    {"one-ball", kDown,
     [](b2World &world) {
         AddGround(world);
         Ball(world, {0.0f, 5.0f}, 0.5f, 1.0f);
     },
     nullptr},
    {"projectile", kDown,
     [](b2World &world) {
         // One box thrown through the air, without a contact.
         Box(world, {0.0f, 0.0f})->SetAngularVelocity(1.0f);
     },
     [](b2World &world, int step) {
         if (step % 100 == 0)
             ForEachDynamic(world, [](b2Body *body, int) {
                 body->SetTransform(b2Vec2_zero, 0.0f);
                 body->SetLinearVelocity({5.0f, 9.0f});
             });
     }},
    {"stack", kDown, Stack, nullptr},
    {"kicked-stack", kDown, Stack, Kick},
    {"pyramid", kDown,
     [](b2World &world) {
         AddGround(world);
         for (int row = 0; row < 4; ++row)
             for (int i = 0; i < 4 - row; ++i)
                 Box(world, {1.1f * Real(i) + 0.55f * Real(row), 0.5f + Real(row)});
     },
     Kick},
    {"pile", kDown, Pile, nullptr},
    {"kicked-pile", kDown, Pile, Kick},
    {"dominoes", kDown,
     [](b2World &world) {
         AddGround(world);
         for (int i = 0; i < 15; ++i)
             Box(world, {Real(i), 1.0f}, {0.1f, 1.0f});
     },
     [](b2World &world, int step) {
         // The first one is pushed; from time to time all are set up again.
         if (step % 400 == 0)
             ForEachDynamic(world, [](b2Body *body, int i) {
                 body->SetTransform({Real(i), 1.0f}, 0.0f);
                 body->SetLinearVelocity(b2Vec2_zero);
                 body->SetAngularVelocity(i == 0 ? -2.0f : 0.0f);
                 body->SetAwake(true);
             });
     }},
    {"pinball", kDown,
     [](b2World &world) {
         AddRoom(world, {6.0f, 10.0f}, false, 0.5f);
         for (int i = 0; i < 9; ++i)
             AddBall(world, b2_staticBody, {4.0f * Real(i % 3 - 1), 4.0f * Real(i / 3 - 1)}, 0.7f, 1.1f);
         Platform(world, {-2.0f, -8.0f}, {1.5f, 0.2f});
         Platform(world, {2.0f, -8.0f}, {1.5f, 0.2f});
         Ball(world, {0.3f, 8.0f}, 0.4f, 0.6f)->SetBullet(true);
     },
     [](b2World &world, int step) {
         const float spin = step % 40 < 10 ? 4.0f : step % 40 < 20 ? -4.0f : 0.0f;
         ForEachKinematic(world, [spin](b2Body *body) { body->SetAngularVelocity(spin); });
         if (step % 300 == 0)
             ForEachDynamic(world, [](b2Body *body, int) { body->SetLinearVelocity({5.0f, 25.0f}); });
     }},
    {"pool", kNone,
     [](b2World &world) {
         AddRoom(world, {12.0f, 6.0f}, true, 0.8f);
         for (int i = 0; i < 16; ++i) {
             b2Body *ball = Ball(world, {1.1f * Real(i % 4), 1.1f * Real(i / 4) - 1.6f}, 0.5f, 0.9f);
             ball->SetLinearDamping(0.3f);
         }
     },
     [](b2World &world, int step) {
         if (step % 300 == 0)
             ForEachDynamic(world, [step](b2Body *body, int i) {
                 if (i == step / 300 % 16)
                     body->ApplyLinearImpulseToCenter({15.0f, 9.0f}, true);
             });
     }},
    {"breakout", kNone,
     [](b2World &world) {
         AddRoom(world, {10.0f, 8.0f}, false, 1.0f);
         for (int i = 0; i < 30; ++i)
             Wall(world, {1.8f * Real(i % 10) - 8.1f, 4.0f + Real(i / 10)}, {0.8f, 0.3f});
         Platform(world, {0.0f, -7.0f}, {1.5f, 0.3f});
         Ball(world, {0.0f, 0.0f}, 0.3f, 1.0f, 0.0f)->SetLinearVelocity({7.0f, 9.0f});
     },
     [](b2World &world, int step) {
         ForEachKinematic(world, [step](b2Body *body) {
             body->SetLinearVelocity({step % 200 < 100 ? 4.0f : -4.0f, 0.0f});
         });
     }},
    {"sensors", kNone,
     [](b2World &world) {
         AddRoom(world, {10.0f, 5.0f}, true, 1.0f);
         for (int i = 0; i < 4; ++i)
             Wall(world, {5.0f * Real(i) - 7.5f, 0.0f}, {1.0f, 4.0f}, 0.2f, true);
         for (int i = 0; i < 6; ++i) {
             b2Body *body = AddRegular(world, {2.5f * Real(i) - 6.0f, 0.0f}, 4 + i % 3, 0.5f, 1.0f);
             body->SetLinearVelocity({3.0f, Real(i) - 2.0f});
         }
     },
     nullptr},
    {"bullets", kNone,
     [](b2World &world) {
         AddRoom(world, {15.0f, 6.0f}, true, 1.0f);
         for (int i = 0; i < 4; ++i)
             Wall(world, {5.0f * Real(i) - 7.5f, 0.0f}, {0.05f, 2.0f}, 0.3f);
         for (int i = 0; i < 6; ++i) {
             b2Body *body = AddRegular(world, {2.5f * Real(i) - 6.0f, 4.0f}, 4, 0.2f, 1.0f);
             body->SetBullet(true);
             body->SetLinearVelocity({80.0f, 11.0f * Real(i)});
         }
     },
     nullptr},
    {"platformer", kDown,
     [](b2World &world) {
         Terrain(world);
         for (int i = 0; i < 3; ++i)
             Platform(world, {6.0f * Real(i), 4.0f}, {1.5f, 0.2f});
         for (int i = 0; i < 5; ++i)
             Box(world, {3.0f * Real(i) - 5.0f, 2.0f});
         Wall(world, {4.0f, 3.0f}, {0.5f, 0.5f}, 0.0f, true);
         Box(world, {0.0f, 3.0f}, {0.4f, 0.8f})->SetFixedRotation(true);
     },
     [](b2World &world, int step) {
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
     }},
    {"elevator", kDown,
     [](b2World &world) {
         AddGround(world);
         Platform(world, {0.0f, 1.0f}, {3.0f, 0.2f});
         for (int i = 0; i < 4; ++i)
             Box(world, {1.3f * Real(i) - 2.0f, 2.0f});
     },
     [](b2World &world, int step) {
         ForEachKinematic(world, [step](b2Body *body) {
             body->SetLinearVelocity({0.0f, step % 300 < 150 ? 2.0f : -2.0f});
         });
     }},
    {"slides", kDown,
     [](b2World &world) {
         for (int i = 0; i < 4; ++i)
             Wall(world, {i % 2 == 0 ? -2.0f : 2.0f, 10.0f - 3.0f * Real(i)}, {4.0f, 0.2f},
                  i % 2 == 0 ? -0.4f : 0.4f);
         for (int i = 0; i < 5; ++i)
             AddRegular(world, {Real(i) - 4.0f, 14.0f}, 4 + i % 3, 0.4f);
     },
     [](b2World &world, int) {
         // What fell out comes in again above.
         ForEachDynamic(world, [](b2Body *body, int i) {
             if (body->GetPosition().y > -10.0f)
                 return;
             body->SetTransform({Real(i) - 4.0f, 14.0f}, body->GetAngle());
             body->SetLinearVelocity(b2Vec2_zero);
         });
     }},
    {"marbles", kDown,
     [](b2World &world) {
         b2Vec2 bowl[16];
         for (int i = 0; i < 16; ++i)
             bowl[i] = 6.0f * b2Rot(2.0f * b2_pi * Real(i) / 16.0f).GetXAxis();
         b2ChainShape chain;
         chain.CreateLoop(bowl, 16);
         AddBody(world, b2_staticBody, b2Vec2_zero, chain, 0.2f, 0.2f);
         for (int i = 0; i < 10; ++i)
             Ball(world, {Real(i % 5) - 2.0f, Real(i / 5)}, 0.4f, 0.4f);
     },
     Kick},
    {"asteroids", kNone,
     [](b2World &world) {
         AddRoom(world, {15.0f, 10.0f}, false, 1.0f);
         for (int i = 0; i < 8; ++i) {
             b2Body *body = AddRegular(world, {3.5f * Real(i % 4) - 5.0f, 4.0f * Real(i / 4) - 2.0f},
                                       5 + i % 4, 1.0f, 1.0f);
             body->SetLinearVelocity({Real(i % 3) - 1.0f, Real(i % 5) - 2.0f});
             body->SetAngularVelocity(0.3f * Real(i));
         }
     },
     nullptr},
    {"polygon-gas", kNone,
     [](b2World &world) {
         AddRoom(world, {6.0f, 6.0f}, true, 1.0f);
         for (int i = 0; i < 16; ++i) {
             b2Body *body = AddRegular(world, {2.5f * Real(i % 4) - 4.0f, 2.5f * Real(i / 4) - 4.0f},
                                       3 + i % 6, 0.6f, 1.0f);
             body->SetLinearVelocity({Real(i % 5) - 2.0f, Real(i % 7) - 3.0f});
         }
     },
     nullptr},
    {"ball-gas", kNone,
     [](b2World &world) {
         AddRoom(world, {6.0f, 6.0f}, false, 1.0f);
         for (int i = 0; i < 16; ++i) {
             b2Body *body =
                 Ball(world, {2.5f * Real(i % 4) - 4.0f, 2.5f * Real(i / 4) - 4.0f}, 0.6f, 1.0f, 0.0f);
             body->SetLinearVelocity({Real(i % 5) - 2.0f, Real(i % 7) - 3.0f});
         }
     },
     nullptr},
    {"spinner", kDown,
     [](b2World &world) {
         AddRoom(world, {5.0f, 5.0f}, true, 0.2f);
         Platform(world, {0.0f, -2.0f}, {3.0f, 0.3f})->SetAngularVelocity(1.5f);
         for (int i = 0; i < 8; ++i)
             AddRegular(world, {Real(i % 4) - 2.0f, 2.0f + Real(i / 4)}, 4, 0.5f);
     },
     nullptr},
    {"top-down", kNone,
     [](b2World &world) {
         AddRoom(world, {12.0f, 12.0f}, true, 0.0f);
         for (int i = 0; i < 5; ++i)
             Wall(world, {4.0f * Real(i) - 8.0f, Real(i * 3 % 5) - 2.0f}, {0.8f, 1.5f});
         for (int i = 0; i < 10; ++i)
             Ball(world, {2.0f * Real(i) - 9.0f, -8.0f}, 0.4f)->SetFixedRotation(true);
     },
     [](b2World &world, int step) {
         ForEachDynamic(world, [step](b2Body *body, int i) {
             body->SetLinearVelocity(3.0f * b2Rot(0.01f * Real(step) + Real(i)).GetXAxis());
         });
     }},
    {"level", kDown,
     [](b2World &world) {
         // A level at rest, and one ball in it.
         for (int i = 0; i < 100; ++i)
             Wall(world, {2.0f * Real(i % 20) - 20.0f, 3.0f * Real(i / 20)}, {0.8f, 0.2f},
                  0.1f * Real(i % 3));
         AddRoom(world, {22.0f, 16.0f}, false, 0.9f);
         Ball(world, {0.5f, 14.0f}, 0.3f, 0.9f);
     },
     nullptr},
    {"sleepers", kDown,
     [](b2World &world) {
         AddGround(world);
         for (int i = 0; i < 20; ++i)
             Box(world, {2.0f * Real(i) - 20.0f, 0.5f});
         Ball(world, {25.0f, 5.0f}, 0.5f, 1.0f);
     },
     nullptr},
};

/// A kinematic floor of tiles, which makes one island of the boxes on it.
b2Body *AddFloor(b2World &world) {
    b2Body *const floor = Platform(world, b2Vec2_zero, {1.0f, 1.0f});
    for (int i = 1; i < 28; ++i) {
        const bool isHalf = i / 2 % 2 == 1; // two tiles, on both of which a box stands
        b2PolygonShape tile;
        tile.SetAsBox(1.0f, 1.0f, {4.0f * Real(i / 2) + (isHalf ? 2.0f * Real(i % 2) - 1.0f : 0.0f), 0.0f},
                      0.0f);
        if (isHalf || i % 2 == 0)
            floor->CreateFixture(&tile, 0.0f);
    }
    return floor;
}

/// Boxes that slide to and fro are put back, at times one place further on: contacts differ in one of their
/// bodies alone. `zero`: how fast the floor is; a box that slides to the right turns the sign of -0.0.
void PlaySliding(Run &run, float zero, int iterations) {
    Game game(run, {0.0f, -kDown});
    b2Body *const floor = AddFloor(game.world);
    for (int i = 0; i < 12; ++i)
        Box(game.world, {4.0f * Real(i), 1.5f});
    for (int step = 0; step < 60; ++step) {
        floor->SetLinearVelocity({zero, zero});
        if (step % 3 == 0)
            ForEachDynamic(game.world, [step](b2Body *body, int i) {
                body->SetTransform({4.0f * Real(i + step % 2), 1.5f}, 0.0f);
                body->SetLinearVelocity({i % 2 == 0 ? 1.0f : -1.0f, 0.0f});
            });
        game.world.Step(1.0f / 60.0f, iterations, 3);
        game.WriteDown();
    }
}

/// Balls far from each other on one ground: an island each, of which one hands the ground on to the next as
/// it leaves it. `drift`: how fast the ground is; `fall`: how fast one ball is at last, downwards.
void PlayApart(Run &run, float drift, float fall) {
    Game game(run, {0.0f, -kDown});
    b2BodyDef def;
    def.linearVelocity.Set(drift, 0.0f);
    b2PolygonShape ground;
    ground.SetAsBox(50.0f, 1.0f);
    game.world.CreateBody(&def)->CreateFixture(&ground, 0.0f);
    b2Body *early = nullptr;
    for (int i = 0; i < 13; ++i) {
        b2Body *const ball = Ball(game.world, {4.0f * Real(i) - 24.0f, 1.5f}, 0.5f);
        early = i == 10 ? ball : early;
    }
    game.Step(10);
    early->SetLinearVelocity({0.0f, -fall});
    game.Step(3);
}

} // namespace

TEST_CASE("islands share a ground that moves") {
    AsStock([](Run &run) { PlayApart(run, 0.3f, 0.0f); }, kMayBeSilent);
}

TEST_CASE("islands share a ground whose velocity becomes NaN") {
    AsStock([](Run &run) { PlayApart(run, 0.0f, std::numeric_limits<float>::infinity()); }, kMayBeSilent);
}

TEST_CASE("boxes slide on a floor") {
    AsStock([](Run &run) { PlaySliding(run, 0.0f, 8); }, kMayBeSilent);
}

TEST_CASE("boxes slide on a floor that is as fast as -0.0") {
    AsStock([](Run &run) { PlaySliding(run, -0.0f, 1); }, kMayBeSilent);
}

TEST_CASE("small worlds without joints") {
    PlayAll(kWorlds);
}
