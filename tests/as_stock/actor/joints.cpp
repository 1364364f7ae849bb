// SPDX-License-Identifier: MIT
#include "actor.h"

namespace actor {

namespace {

bool Gears(const b2Joint *joint) {
    return joint->GetType() == e_revoluteJoint || joint->GetType() == e_prismaticJoint;
}

} // namespace

void Actor::CreateJoint() {
    const int how = Byte();
    b2Body *a = SomeBody();
    b2Body *b = SomeBody();
    const b2Vec2 arm = Vector(0.02f);
    if (a == nullptr || a == b || Box2D().GetJointCount() >= m_mostJoints)
        return;
    const bool collide = how / 16 % 2 == 0;
    const b2Vec2 middle = 0.5f * (a->GetPosition() + b->GetPosition()) + arm;
    const auto create = [&](auto &def) {
        def.collideConnected = collide;
        m_world->Create(def);
    };
    switch (how % 10) {
    case 0: {
        b2RevoluteJointDef def;
        def.Initialize(a, b, middle);
        def.enableLimit = how / 32 % 2 != 0;
        def.lowerAngle = -0.25f;
        def.upperAngle = 0.25f;
        create(def);
        break;
    }
    case 1: {
        b2DistanceJointDef def;
        def.Initialize(a, b, a->GetPosition() + arm, b->GetPosition());
        if (how / 32 % 2 != 0)
            b2LinearStiffness(def.stiffness, def.damping, 4.0f, 0.5f, a, b);
        create(def);
        break;
    }
    case 2: {
        b2PrismaticJointDef def;
        def.Initialize(a, b, middle, how / 32 % 2 != 0 ? b2Vec2(1.0f, 0.0f) : b2Vec2(0.6f, 0.8f));
        create(def);
        break;
    }
    case 3: {
        b2WeldJointDef def;
        def.Initialize(a, b, middle);
        create(def);
        break;
    }
    case 4: {
        b2WheelJointDef def;
        def.Initialize(a, b, middle, {0.0f, 1.0f});
        def.enableMotor = true;
        def.motorSpeed = 10.0f;
        def.maxMotorTorque = 5.0f;
        create(def);
        break;
    }
    case 5: {
        b2MouseJointDef def;
        def.bodyA = a;
        def.bodyB = b;
        def.target = middle;
        def.maxForce = 100.0f;
        def.stiffness = 50.0f;
        def.damping = 1.0f;
        create(def);
        break;
    }
    case 6: {
        b2PulleyJointDef def;
        def.Initialize(a, b, a->GetPosition() + b2Vec2(0.0f, 3.0f), b->GetPosition() + b2Vec2(0.0f, 3.0f),
                       a->GetPosition(), b->GetPosition(), 1.5f);
        create(def);
        break;
    }
    case 7: {
        b2FrictionJointDef def;
        def.Initialize(a, b, middle);
        def.maxForce = 5.0f;
        def.maxTorque = 1.0f;
        create(def);
        break;
    }
    case 8: {
        b2MotorJointDef def;
        def.Initialize(a, b);
        def.maxForce = 20.0f;
        create(def);
        break;
    }
    default: {
        b2GearJointDef def;
        for (b2Joint *joint = Box2D().GetJointList(); joint != nullptr; joint = joint->GetNext())
            if (Gears(joint) && joint->GetBodyB()->GetType() == b2_dynamicBody) {
                def.joint2 = def.joint1;
                def.joint1 = joint;
            }
        if (def.joint2 == nullptr || def.joint1->GetBodyB() == def.joint2->GetBodyB())
            return;
        def.bodyA = def.joint1->GetBodyB();
        def.bodyB = def.joint2->GetBodyB();
        create(def);
    }
    }
}

/// They hold on to two other joints, and must go before either.
void Actor::DestroyGears() {
    for (b2Joint *joint = Box2D().GetJointList(); joint != nullptr;) {
        b2Joint *const next = joint->GetNext();
        if (joint->GetType() == e_gearJoint)
            Box2D().DestroyJoint(joint);
        joint = next;
    }
}

void Actor::DestroyJoint() {
    const bool gear = Box2D().GetJointCount() > 0 && Box2D().GetJointList()->GetType() == e_gearJoint;
    if (!gear)
        DestroyGears();
    if (b2Joint *joint = gear ? Box2D().GetJointList() : SomeJoint())
        Box2D().DestroyJoint(joint);
}

void Actor::ChangeJoint() {
    b2Joint *joint = SomeJoint();
    const int how = Byte();
    if (joint == nullptr)
        return;
    const float amount = static_cast<float>(how / 2) / 8.0f;
    switch (joint->GetType()) {
    case e_revoluteJoint: {
        b2RevoluteJoint *hinge = static_cast<b2RevoluteJoint *>(joint);
        hinge->SetMaxMotorTorque(10.0f * amount);
        hinge->SetMotorSpeed(amount - 8.0f);
        hinge->EnableMotor(how % 2 == 0);
        break;
    }
    case e_prismaticJoint: {
        b2PrismaticJoint *slide = static_cast<b2PrismaticJoint *>(joint);
        slide->SetLimits(-amount, amount);
        slide->EnableLimit(how % 2 == 0);
        break;
    }
    case e_mouseJoint:
        static_cast<b2MouseJoint *>(joint)->SetTarget(joint->GetBodyB()->GetPosition() +
                                                      b2Vec2(amount, 1.0f));
        break;
    case e_distanceJoint:
        static_cast<b2DistanceJoint *>(joint)->SetLength(0.1f + amount);
        break;
    case e_wheelJoint:
        static_cast<b2WheelJoint *>(joint)->SetMotorSpeed(10.0f * amount - 50.0f);
        break;
    case e_motorJoint:
        static_cast<b2MotorJoint *>(joint)->SetLinearOffset({amount, 0.0f});
        break;
    default:
        joint->ShiftOrigin({0.0f, 0.0f});
    }
}

} // namespace actor
