// SPDX-License-Identifier: MIT
// Worlds of a few bodies, as most games step them and some programs by the thousand: with joints. The library
// mostly leaves these to Box2D.
#include "small_worlds.h"

using namespace as_stock;

namespace {

constexpr float kDown = 10.0f;

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

/// Links from `from` on, to the right; the last of them.
b2Body *AddLinks(b2World &world, b2Body *holder, b2Vec2 from, int count) {
    for (int i = 0; i < count; ++i) {
        const b2Vec2 at = from + b2Vec2(0.5f + Real(i), 0.0f);
        b2Body *link = Box(world, at, {0.5f, 0.125f});
        Hinge(world, holder, link, at - b2Vec2(0.5f, 0.0f));
        holder = link;
    }
    return holder;
}

void Bridge(b2World &world) {
    b2Body *anchor = AddAnchor(world);
    b2Body *last = AddLinks(world, anchor, {-7.5f, 5.0f}, 15);
    Hinge(world, last, anchor, {7.5f, 5.0f});
}

void Kick(b2World &world, int step) {
    if (step % 200 == 0)
        ForEachDynamic(world, [](b2Body *body, int i) {
            if (i % 3 == 0)
                body->ApplyLinearImpulseToCenter(body->GetMass() * b2Vec2(2.0f, 4.0f), true);
        });
}

const SmallWorld kWorlds[] = {
    {"pendulum", kDown,
     [](b2World &world) {
         b2Body *bob = Box(world, {4.0f, 10.0f});
         Hinge(world, AddAnchor(world), bob, {0.0f, 10.0f});
     },
     nullptr},
    {"double-pendulum", kDown,
     [](b2World &world) {
         b2Body *first = Ball(world, {3.0f, 10.0f}, 0.4f);
         b2Body *second = Ball(world, {6.0f, 10.0f}, 0.4f);
         Hinge(world, AddAnchor(world), first, {0.0f, 10.0f});
         Hinge(world, first, second, {3.0f, 10.0f});
     },
     nullptr},
    {"rope", kDown,
     [](b2World &world) {
         AddLinks(world, AddAnchor(world), {0.0f, 20.0f}, 20);
     },
     Kick},
    {"ball-chain", kDown,
     [](b2World &world) {
         b2Body *holder = AddAnchor(world);
         for (int i = 0; i < 10; ++i) {
             const float x = Real(i);
             b2Body *ball = Ball(world, {x + 1.0f, 15.0f}, 0.3f);
             Hinge(world, holder, ball, {x, 15.0f});
             holder = ball;
         }
     },
     Kick},
    {"bridge", kDown, Bridge, nullptr},
    {"kicked-bridge", kDown, Bridge, Kick},
    {"loaded-bridge", kDown,
     [](b2World &world) {
         Bridge(world);
         for (int i = 0; i < 6; ++i)
             AddRegular(world, {1.5f * Real(i) - 4.0f, 7.0f}, 3 + i, 0.5f);
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
    {"ragdoll", kDown,
     [](b2World &world) {
         AddRoom(world, {8.0f, 8.0f}, true, 0.0f);
         b2Body *chest = Box(world, {0.0f, 1.0f}, {0.5f, 0.8f});
         b2Body *head = Ball(world, {0.0f, 2.3f}, 0.4f);
         Hinge(world, chest, head, {0.0f, 1.9f});
         for (const float side : {-1.0f, 1.0f}) {
             for (const float height : {1.6f, 0.2f}) {
                 b2Body *holder = chest;
                 for (int i = 0; i < 2; ++i) {
                     const float x = side * (1.0f + Real(i));
                     b2Body *limb = Box(world, {x, height}, {0.5f, 0.15f});
                     b2RevoluteJoint *joint = Hinge(world, holder, limb, {x - side * 0.5f, height});
                     joint->SetLimits(-0.8f, 0.8f);
                     joint->EnableLimit(true);
                     holder = limb;
                 }
             }
         }
     },
     Kick},
    {"seesaw", kDown,
     [](b2World &world) {
         b2Body *ground = AddGround(world);
         b2Body *plank = Box(world, {0.0f, 1.0f}, {5.0f, 0.2f});
         Hinge(world, ground, plank, {0.0f, 1.0f});
         Box(world, {-4.0f, 2.0f});
         Box(world, {4.0f, 8.0f}, {0.7f, 0.7f});
     },
     Kick},
    {"cradle", kDown,
     [](b2World &world) {
         b2Body *anchor = AddAnchor(world);
         for (int i = 0; i < 5; ++i) {
             const float x = Real(i);
             b2Body *ball = Ball(world, i == 0 ? b2Vec2(-5.0f, 10.0f) : b2Vec2(x, 5.0f), 0.499f, 1.0f, 0.0f);
             Hinge(world, anchor, ball, {x, 10.0f});
         }
     },
     nullptr},
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
    {"slider-crank", kDown,
     [](b2World &world) {
         b2Body *anchor = AddAnchor(world);
         b2Body *crank = Box(world, {0.0f, 2.0f}, {0.2f, 2.0f});
         b2Body *rod = Box(world, {0.0f, 8.0f}, {0.2f, 4.0f});
         b2Body *piston = Box(world, {0.0f, 12.0f}, {1.0f, 0.5f});
         piston->SetFixedRotation(true);
         Hinge(world, anchor, crank, {0.0f, 0.0f}, 3.0f, 10000.0f);
         Hinge(world, crank, rod, {0.0f, 4.0f});
         Hinge(world, rod, piston, {0.0f, 12.0f});
         b2PrismaticJointDef slide;
         slide.Initialize(anchor, piston, {0.0f, 12.0f}, {0.0f, 1.0f});
         world.CreateJoint(&slide);
         Box(world, {0.0f, 14.0f});
     },
     nullptr},
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
    {"wrecking-ball", kDown,
     [](b2World &world) {
         AddGround(world);
         b2Body *ball = Ball(world, {11.0f, 10.0f}, 1.0f);
         Hinge(world, AddLinks(world, AddAnchor(world), {0.0f, 10.0f}, 8), ball, {8.0f, 10.0f});
         for (int i = 0; i < 6; ++i)
             Box(world, {-3.0f, 0.5f + Real(i)});
     },
     Kick},
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
    {"cart-pole", kDown,
     [](b2World &world) {
         b2Body *anchor = AddAnchor(world);
         b2Body *cart = Box(world, {0.0f, 1.0f}, {1.0f, 0.3f});
         b2Body *pole = Box(world, {0.0f, 3.0f}, {0.1f, 1.5f});
         b2PrismaticJointDef def;
         def.Initialize(anchor, cart, cart->GetPosition(), {1.0f, 0.0f});
         world.CreateJoint(&def);
         Hinge(world, cart, pole, {0.0f, 1.5f});
     },
     [](b2World &world, int) {
         // A controller that does its best.
         b2Body *pole = world.GetBodyList(), *cart = pole->GetNext();
         cart->ApplyForceToCenter(
             {-60.0f * std::sin(pole->GetAngle()) - 10.0f * pole->GetAngularVelocity(), 0.0f}, true);
     }},
};

/// Pairs of balls, one on the ground, the other pinned to it and to the first. One pair's velocity makes the
/// ground's NaN, for all pairs that come after it. On a kinematic ground all are one island; on a static one
/// each is its own, and they are solved together.
void PlayPairs(Run &run, b2BodyType type, int fast) {
    Game game(run, {0.0f, -kDown});
    b2PolygonShape box;
    box.SetAsBox(50.0f, 1.0f);
    b2Body *const ground = AddBody(game.world, type, b2Vec2_zero, box, 0.0f, 0.6f);
    b2Body *first = nullptr;
    for (int i = 0; i < 13; ++i) {
        const float x = 4.0f * Real(i) - 24.0f;
        b2Body *const ball = Ball(game.world, {x, 1.5f}, 0.5f), *const other =
                                                                    Ball(game.world, {x + 1.0f, 1.5f}, 0.5f);
        Hinge(game.world, ball, other, {x + 0.6f, 1.7f});
        Hinge(game.world, ground, other, {x + 1.2f, 1.4f});
        first = i == fast ? ball : first;
    }
    game.Step(10);
    first->SetLinearVelocity({0.0f, -std::numeric_limits<float>::infinity()});
    game.Step(3);
}

} // namespace

TEST_CASE("pinned pairs share a ground whose velocity becomes NaN") {
    for (const b2BodyType ground : {b2_staticBody, b2_kinematicBody})
        for (const int fast : {0, 10})
            AsStock([ground, fast](Run &run) { PlayPairs(run, ground, fast); }, kMayBeSilent);
}

TEST_CASE("small worlds with joints") {
    PlayAll(kWorlds);
}
