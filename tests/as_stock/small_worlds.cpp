// SPDX-License-Identifier: MIT
// Worlds of a few bodies, as most games step them and some programs by the thousand: without joints, and with
// joints of each type. The library mostly leaves these to Box2D.
#include "as_stock.h"

using namespace as_stock;

namespace {

constexpr float kDown = 10.0f, kNone = 0.0f;

b2Body *Box(b2World &world, b2Vec2 at, b2Vec2 half = {0.5f, 0.5f}, float angle = 0.0f) {
    return AddBox(world, b2_dynamicBody, at, half, angle);
}
b2Body *Wall(b2World &world, b2Vec2 at, b2Vec2 half = {0.5f, 0.5f}, float angle = 0.0f, bool sensor = false) {
    return AddBox(world, b2_staticBody, at, half, angle, sensor);
}
b2Body *Platform(b2World &world, b2Vec2 at, b2Vec2 half) {
    return AddBox(world, b2_kinematicBody, at, half, 0.0f);
}
b2Body *AddBody(b2World &world, b2BodyType type, b2Vec2 at, const b2Shape &shape, float restitution,
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
b2Body *AddBall(b2World &world, b2BodyType type, b2Vec2 at, float radius, float restitution = 0.0f,
                float friction = 0.2f) {
    b2CircleShape circle;
    circle.m_radius = radius;
    return AddBody(world, type, at, circle, restitution, friction);
}
b2Body *Ball(b2World &world, b2Vec2 at, float radius, float restitution = 0.0f, float friction = 0.2f) {
    return AddBall(world, b2_dynamicBody, at, radius, restitution, friction);
}
/// A regular polygon.
b2Body *AddRegular(b2World &world, b2Vec2 at, int count, float radius, float restitution = 0.0f) {
    b2Vec2 corners[b2_maxPolygonVertices];
    for (int i = 0; i < count; ++i)
        corners[i] = radius * b2Rot(2.0f * b2_pi * Real(i) / Real(count)).GetXAxis();
    b2PolygonShape polygon;
    polygon.Set(corners, count);
    return AddBody(world, b2_dynamicBody, at, polygon, restitution, 0.2f);
}
b2Body *AddGround(b2World &world) {
    return Wall(world, {0.0f, -0.5f}, {30.0f, 0.5f});
}
/// A closed room around the origin: a loop of edges, or four boxes.
void AddRoom(b2World &world, b2Vec2 half, bool ofBoxes, float restitution) {
    for (const float side : {-1.0f, 1.0f}) {
        if (!ofBoxes)
            break;
        Wall(world, {0.0f, side * (half.y + 0.5f)}, {half.x + 1.0f, 0.5f});
        Wall(world, {side * (half.x + 0.5f), 0.0f}, {0.5f, half.y});
    }
    const b2Vec2 corners[4] = {-half, {half.x, -half.y}, half, {-half.x, half.y}};
    b2ChainShape chain;
    chain.CreateLoop(corners, 4);
    if (!ofBoxes)
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

b2Body *AddAnchor(b2World &world) {
    const b2BodyDef def;
    return world.CreateBody(&def);
}

b2RevoluteJoint *Hinge(b2World &world, b2Body *a, b2Body *b, b2Vec2 at, float speed = 0.0f,
                       float torque = 0.0f) {
    b2RevoluteJointDef def;
    def.Initialize(a, b, at);
    def.enableMotor = torque > 0.0f;
    def.motorSpeed = speed;
    def.maxMotorTorque = torque;
    return static_cast<b2RevoluteJoint *>(world.CreateJoint(&def));
}

void Kick(b2World &world, int step) {
    if (step % 200 == 0)
        ForEachDynamic(world, [](b2Body *body, int i) {
            body->ApplyLinearImpulseToCenter(body->GetMass() * b2Vec2(i % 2 == 0 ? 3.0f : -3.0f, 6.0f), true);
        });
}

struct SmallWorld {
    const char *name;
    float gravity; ///< downwards
    void (*build)(b2World &);
    /// What the game does ahead of each step; may be nullptr.
    void (*play)(b2World &, int step) = nullptr;
};

const SmallWorld kLoose[] = {
    {"empty", kDown, [](b2World &) {}},
    {"pile", kDown,
     [](b2World &world) {
         AddGround(world);
         Wall(world, {-2.5f, 2.0f}, {0.2f, 2.0f});
         Wall(world, {2.5f, 2.0f}, {0.2f, 2.0f});
         for (int i = 0; i < 12; ++i)
             AddRegular(world, {0.9f * Real(i % 4) - 1.4f, 1.0f + Real(i / 4)}, 3 + i % 6, 0.4f);
     },
     Kick},
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
    {"sensors", kNone,
     [](b2World &world) {
         AddRoom(world, {10.0f, 5.0f}, true, 1.0f);
         for (int i = 0; i < 4; ++i)
             Wall(world, {5.0f * Real(i) - 7.5f, 0.0f}, {1.0f, 4.0f}, 0.2f, true);
         for (int i = 0; i < 6; ++i) {
             b2Body *body = AddRegular(world, {2.5f * Real(i) - 6.0f, 0.0f}, 4 + i % 3, 0.5f, 1.0f);
             body->SetLinearVelocity({3.0f, Real(i) - 2.0f});
         }
     }},
    {"platformer", kDown,
     [](b2World &world) {
         b2Vec2 hills[40];
         for (int i = 0; i < 40; ++i)
             hills[i].Set(2.0f * Real(i - 20), Real(i * 7 % 5) * 0.3f);
         b2ChainShape chain;
         chain.CreateChain(hills, 40, hills[0] - b2Vec2(1.0f, 0.0f), hills[39] + b2Vec2(1.0f, 0.0f));
         AddBody(world, b2_staticBody, b2Vec2_zero, chain, 0.0f, 0.6f);
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
    {"level", kDown,
     [](b2World &world) {
         // A level at rest, and one ball in it.
         for (int i = 0; i < 100; ++i)
             Wall(world, {2.0f * Real(i % 20) - 20.0f, 3.0f * Real(i / 20)}, {0.8f, 0.2f},
                  0.1f * Real(i % 3));
         AddRoom(world, {22.0f, 16.0f}, false, 0.9f);
         Ball(world, {0.5f, 14.0f}, 0.3f, 0.9f);
     }},
    {"sleepers", kDown,
     [](b2World &world) {
         AddGround(world);
         for (int i = 0; i < 20; ++i)
             Box(world, {2.0f * Real(i) - 20.0f, 0.5f});
         Ball(world, {25.0f, 5.0f}, 0.5f, 1.0f);
     }},
};

const SmallWorld kJointed[] = {
    {"rope", kDown,
     [](b2World &world) {
         b2Body *holder = AddAnchor(world);
         for (int i = 0; i < 20; ++i) {
             b2Body *link = Box(world, {0.5f + Real(i), 20.0f}, {0.5f, 0.125f});
             Hinge(world, holder, link, {Real(i), 20.0f});
             holder = link;
         }
     },
     Kick},
    {"car", kDown,
     [](b2World &world) {
         b2Vec2 hills[60];
         for (int i = 0; i < 60; ++i)
             hills[i].Set(4.0f * Real(i - 30), Real(i * 7 % 4) * 0.4f);
         hills[0].y = hills[59].y = 20.0f;
         b2ChainShape chain;
         chain.CreateChain(hills, 60, hills[0] + b2Vec2(0.0f, 1.0f), hills[59] + b2Vec2(0.0f, 1.0f));
         AddBody(world, b2_staticBody, b2Vec2_zero, chain, 0.0f, 0.8f);
         b2Body *hull = Box(world, {0.0f, 3.0f}, {1.5f, 0.4f});
         for (const float x : {-1.0f, 1.0f}) {
             b2Body *wheel = Ball(world, {x, 2.4f}, 0.4f, 0.0f, 0.9f);
             b2WheelJointDef def;
             def.Initialize(hull, wheel, wheel->GetPosition(), {0.0f, 1.0f});
             def.enableMotor = x < 0.0f;
             def.maxMotorTorque = 20.0f;
             b2LinearStiffness(def.stiffness, def.damping, 4.0f, 0.7f, hull, wheel);
             world.CreateJoint(&def);
         }
     },
     [](b2World &world, int step) {
         for (b2Joint *joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext())
             static_cast<b2WheelJoint *>(joint)->SetMotorSpeed(step % 800 < 400 ? -20.0f : 20.0f);
     }},
    {"gears", kDown,
     [](b2World &world) {
         b2Body *anchor = AddAnchor(world);
         b2Body *small = Ball(world, {0.0f, 5.0f}, 1.0f), *large = Ball(world, {3.1f, 5.0f}, 2.0f);
         b2Body *rack = Box(world, {6.0f, 5.0f}, {0.5f, 5.0f});
         b2GearJointDef gear;
         gear.joint1 = Hinge(world, anchor, small, small->GetPosition(), 2.0f, 100.0f);
         gear.joint2 = Hinge(world, anchor, large, large->GetPosition());
         gear.bodyA = small;
         gear.bodyB = large;
         gear.ratio = 2.0f;
         world.CreateJoint(&gear);
         b2PrismaticJointDef slide;
         slide.Initialize(anchor, rack, rack->GetPosition(), {0.0f, 1.0f});
         gear.joint1 = gear.joint2;
         gear.joint2 = world.CreateJoint(&slide);
         gear.bodyA = large;
         gear.bodyB = rack;
         gear.ratio = -0.5f;
         world.CreateJoint(&gear);
     },
     [](b2World &world, int step) {
         if (step % 200 != 0)
             return;
         for (b2Joint *joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext())
             if (joint->GetType() == e_revoluteJoint &&
                 static_cast<b2RevoluteJoint *>(joint)->IsMotorEnabled())
                 static_cast<b2RevoluteJoint *>(joint)->SetMotorSpeed(step % 400 == 0 ? 2.0f : -2.0f);
     }},
    {"gears whose frame is disabled", kDown,
     [](b2World &world) {
         b2Body *const anchor = AddAnchor(world);
         b2GearJointDef gear;
         gear.bodyA = Box(world, {0.0f, 5.0f}, {0.5f, 0.25f});
         gear.bodyB = Box(world, {3.0f, 5.0f}, {0.5f, 0.25f});
         b2Body *const frame = Box(world, {6.0f, 5.0f}, {0.5f, 0.25f});
         gear.joint1 = Hinge(world, frame, gear.bodyA, {0.0f, 5.0f}, 1.0f, 5.0f);
         gear.joint2 = Hinge(world, anchor, gear.bodyB, {3.0f, 5.0f}, 2.0f, 5.0f);
         gear.ratio = 1.5f;
         world.CreateJoint(&gear);
     },
     [](b2World &world, int step) { // the gear goes on with the frame's last place in an island
         if (step == 40)
             for (b2Joint *joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext())
                 if (joint->GetType() == e_revoluteJoint && joint->GetBodyA()->GetType() == b2_dynamicBody)
                     joint->GetBodyA()->SetEnabled(false);
     }},
    {"geared wheels", kDown,
     [](b2World &world) {
         AddGround(world);
         b2Body *const hull = Box(world, {0.0f, 1.2f}, {3.0f, 0.3f});
         b2GearJointDef gear;
         for (const float x : {-2.5f, 2.5f}) {
             b2Body *const wheel = Ball(world, {x, 0.5f}, 0.5f);
             (x < 0.0f ? gear.joint1 : gear.joint2) = Hinge(world, hull, wheel, {x, 0.5f}, -3.0f, 20.0f);
             (x < 0.0f ? gear.bodyA : gear.bodyB) = wheel;
         }
         gear.ratio = -1.0f;
         world.CreateJoint(&gear);
         for (int i = 0; i < 10; ++i)
             Box(world, {3.4f + 0.8f * Real(i), 0.4f}, {0.4f, 0.4f});
         Box(world, {0.0f, 1.9f}, {0.4f, 0.4f});
     },
     Kick},
    {"pulley", kDown,
     [](b2World &world) {
         AddGround(world);
         b2Body *a = Box(world, {-5.0f, 8.0f});
         b2Body *b = Box(world, {5.0f, 8.0f}, {0.6f, 0.6f});
         b2PulleyJointDef def;
         def.Initialize(a, b, {-5.0f, 14.0f}, {5.0f, 14.0f}, a->GetPosition(), b->GetPosition(), 1.0f);
         world.CreateJoint(&def);
     },
     Kick},
    {"lift", kDown,
     [](b2World &world) {
         b2Body *ground = AddGround(world);
         b2Body *cabin = Box(world, {0.0f, 2.0f}, {2.0f, 0.3f});
         b2PrismaticJointDef def;
         def.Initialize(ground, cabin, cabin->GetPosition(), {0.0f, 1.0f});
         def.enableMotor = def.enableLimit = true;
         def.maxMotorForce = 1000.0f;
         def.motorSpeed = 2.0f;
         def.upperTranslation = 8.0f;
         world.CreateJoint(&def);
         for (int i = 0; i < 3; ++i)
             Box(world, {Real(i) - 1.0f, 3.0f}, {0.4f, 0.4f});
     },
     [](b2World &world, int step) {
         if (step % 240 == 0)
             static_cast<b2PrismaticJoint *>(world.GetJointList())
                 ->SetMotorSpeed(step % 480 == 0 ? 2.0f : -2.0f);
     }},
    {"blob", kDown,
     [](b2World &world) {
         AddGround(world);
         b2Body *ring[12];
         for (int i = 0; i < 12; ++i)
             ring[i] =
                 Ball(world, b2Vec2(0.0f, 5.0f) + 2.0f * b2Rot(b2_pi / 6.0f * Real(i)).GetXAxis(), 0.4f);
         for (int i = 0; i < 12; ++i)
             for (const int step : {1, 5}) {
                 b2Body *other = ring[(i + step) % 12];
                 b2DistanceJointDef def;
                 def.Initialize(ring[i], other, ring[i]->GetPosition(), other->GetPosition());
                 b2LinearStiffness(def.stiffness, def.damping, 5.0f, 0.1f, ring[i], other);
                 world.CreateJoint(&def);
             }
     },
     Kick},
    {"drag", kDown,
     [](b2World &world) {
         b2Body *ground = AddGround(world);
         b2Body *box = Box(world, {0.0f, 2.0f});
         b2MouseJointDef def;
         def.bodyA = ground;
         def.bodyB = box;
         def.target = box->GetPosition();
         def.maxForce = 500.0f;
         b2LinearStiffness(def.stiffness, def.damping, 5.0f, 0.7f, ground, box);
         world.CreateJoint(&def);
         for (int i = 0; i < 4; ++i)
             Box(world, {2.0f * Real(i) - 3.0f, 0.5f});
     },
     [](b2World &world, int step) {
         auto *joint = static_cast<b2MouseJoint *>(world.GetJointList());
         joint->SetTarget(b2Vec2(0.0f, 2.0f) + 3.0f * b2Rot(0.05f * Real(step)).GetXAxis());
     }},
    {"weld", kDown,
     [](b2World &world) {
         b2Body *below = AddGround(world);
         for (int i = 0; i < 8; ++i) {
             b2Body *floor = Box(world, {0.0f, 0.5f + Real(i)}, {0.3f, 0.5f});
             b2WeldJointDef def;
             def.Initialize(below, floor, {0.0f, Real(i)});
             b2AngularStiffness(def.stiffness, def.damping, 5.0f, 0.2f, below, floor);
             world.CreateJoint(&def);
             below = floor;
         }
     },
     Kick},
};

template <size_t count> void PlayAll(Run &run, const SmallWorld (&worlds)[count]) {
    for (const SmallWorld &world : worlds) {
        run.Print("%s", world.name);
        Game game(run, {0.0f, -world.gravity});
        world.build(game.world);
        int met = 0;
        for (int step = 0; step < 600; ++step) {
            if (world.play != nullptr)
                world.play(game.world, step);
            game.Step();
            for (const b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext())
                met += c->IsTouching();
        }
        game.Stage(met + game.world.GetJointCount() > 0 || game.world.GetBodyCount() == 0,
                   "bodies touch, or are joined");
    }
}

} // namespace

AS_STOCK_HOW(kMayBeSilent, "small worlds without joints") {
    PlayAll(run, kLoose);
}

AS_STOCK_HOW(kMayBeSilent, "small worlds with joints") {
    PlayAll(run, kJointed);
}
