// SPDX-License-Identifier: MIT
// What bodies may go through while others remember how they were. Each test names what peers met; README.md
// has them all.
#include <malloc.h>

#include <set>

#include "yard.h"

using namespace as_stock;

// JoltPhysics #2125, #2134: a shape set while the body is removed kept the manifold of the old one.
// rapier #320, #538, #900: changed or disabled colliders went unnoticed.
AS_STOCK("a shape that is changed while its body is out of the world") {
    Yard yard(run);
    yard.Begin();
    for (const float thickness : {0.62f, 0.05f, 0.7f}) {
        for (const bool ofMover : {true, false}) {
            for (const Yard::Couple &couple : yard.couples) {
                b2Body *body = ofMover ? couple.mover : couple.stays;
                body->SetEnabled(false);
                yard.Thicken(body, thickness);
            }
            yard.game.Step(2);
            for (const Yard::Couple &couple : yard.couples)
                (ofMover ? couple.mover : couple.stays)->SetEnabled(true);
            yard.Place(false);
            yard.game.Step(2);
            if (thickness > 0.5f)
                yard.game.Stage(yard.TouchingCouples() >= 4, "the new shapes touch");
            yard.game.Step(5);
        }
    }
}

// box3d #155: a contact that was kept from the last step was measured from the old centre. box2d #85: a body
// jumped when it became static. box3d #35, box2d #1009: masses set by hand switched continuous collision off.
AS_STOCK("the centre of mass moves") {
    Yard yard(run);
    yard.Begin();
    for (int round = 0; round < 4; ++round) {
        for (const Yard::Couple &couple : yard.couples) {
            b2Body *body = couple.mover;
            body->SetAngularVelocity(0.4f);
            b2MassData mass;
            body->GetMassData(&mass);
            mass.center = b2Vec2(0.3f * Real(round - 1), 0.1f);
            mass.I = 2.0f + mass.mass * b2Dot(mass.center, mass.center);
            body->SetMassData(&mass);
        }
        yard.Drift(-1.5f);
        yard.game.Step(6);
        for (const Yard::Couple &couple : yard.couples)
            couple.mover->ResetMassData();
        yard.game.Step(6);
        b2Fixture *added[Yard::kCount];
        for (int i = 0; i < Yard::kCount; ++i) // a heavy one, far out
            added[i] = yard.game.Box(yard.couples[i].mover, 0.3f, 0.3f, {-2.0f, 0.4f});
        yard.game.Step(6);
        for (int i = 0; i < Yard::kCount; ++i) {
            yard.couples[i].mover->DestroyFixture(added[i]);
            yard.couples[i].mover->SetFixedRotation(round % 2 == 0);
        }
        yard.game.Step(4);
        yard.game.Stage(yard.TouchingCouples() >= 1 || round != 0, "a collision");
        yard.Place(round % 2 == 0);
        yard.game.Step(2);
    }
}

// box3d #117, RobustToolbox #1791: bodies that a joint had joined went on colliding. PhysX #326: the same
// when a joint's flag changed. box2d #1046: jointed bodies that may collide stuck to a contact that was kept.
AS_STOCK("joints that keep bodies from colliding come and go") {
    Yard yard(run);
    yard.Begin();
    b2Joint *joints[Yard::kCount];
    const auto join = [&yard, &joints](bool collide) {
        for (int i = 0; i < Yard::kCount; ++i) {
            b2RevoluteJointDef def;
            const Yard::Couple &couple = yard.couples[i];
            def.Initialize(couple.stays, couple.mover, couple.place + Slanted(1.0f, 0.3f));
            def.collideConnected = collide;
            joints[i] = yard.game.world.CreateJoint(&def);
        }
    };
    const auto part = [&yard, &joints] {
        for (b2Joint *joint : joints)
            yard.game.world.DestroyJoint(joint);
    };
    for (const bool near : {false, true, false, true}) {
        yard.Place(near);
        yard.Refilter(); // Box2D looks for what a joint kept apart only where boxes move
        yard.game.Step();
        yard.game.Stage((yard.TouchingCouples() > 3) == near, "they touch where they are near");
        join(false);
        yard.game.Step(3);
        yard.game.Stage(yard.game.Touching() == 0, "joined, nothing touches");
        yard.Place(true);
        yard.game.Step(3);
        part();
        yard.Place(true);
        yard.game.Step(3);
        join(true);
        yard.game.Step(5);
        part();
        yard.Place(true);
        join(false);
        yard.game.Step(1);
        part(); // ahead of the next step
        join(true);
        yard.game.Step(4);
        part();
    }
}

// bullet3 #782: what a released manifold had gathered came back with the next one. box2d #450, #463: bodies
// that were replaced under others.
AS_STOCK("a new body at the address of an old one is not the old one") {
    Yard yard(run);
    yard.Begin();
    bool same = false;
    for (int round = 0; round < 6; ++round) {
        for (Yard::Couple &couple : yard.couples) {
            b2Body *old = couple.mover;
            const bool bullet = old->IsBullet();
            yard.game.world.DestroyBody(old);
            couple.mover = yard.game.Body(b2_dynamicBody, Yard::Away(couple), kSlant);
            couple.mover->SetSleepingAllowed(false);
            couple.mover->SetBullet(bullet);
            // Thick and thin, in turn; as many fixtures as before.
            const float thickness = round % 2 == 0 ? 0.55f : 0.1f;
            if (&couple == yard.couples)
                for (int i = 0; i < Game::kPlankPieces; ++i)
                    yard.game.Box(couple.mover, 0.2f, thickness, {0.4f * Real(i) - 1.8f, 0.0f});
            else
                yard.game.Box(couple.mover, 0.8f, thickness);
            same = same || couple.mover == old;
        }
        yard.game.Step();
        yard.game.Stage((yard.TouchingCouples() >= 4) == (round % 2 == 0), "the new shapes decide");
        yard.game.Step(4);
        yard.Place(false);
    }
    yard.game.Stage(same, "the same address");
}

AS_STOCK("a new world at the address of an old one is not the old one") {
    // malloc maps each of Box2D's chunks alone: a new chunk gets the address of one that was freed.
    mallopt(M_MMAP_THRESHOLD, 16 * 1024);
    std::set<const b2Body *> before;
    bool same = false;
    for (int round = 0; round < 5; ++round) {
        Yard yard(run); // where the last one was, with its bodies and fixtures where some of its were
        for (const Yard::Couple &couple : yard.couples)
            same = same || before.count(couple.mover) != 0;
        for (const b2Body *body = yard.game.world.GetBodyList(); body != nullptr; body = body->GetNext())
            before.insert(body);
        yard.Drift();
        if (round % 2 == 1)
            for (const Yard::Couple &couple : yard.couples)
                yard.Thicken(couple.mover, 0.6f);
        yard.Place(false);
        yard.game.Step();
        yard.game.Stage((yard.TouchingCouples() >= 4) == (round % 2 == 1), "the new shapes decide");
        yard.Drift(-2.0f);
        yard.game.Step(10);
    }
#if !defined(IN_CHILD_ASAN) // which keeps freed memory back, so that nothing lies where something lay
    if (!same)
        run.Print("!not staged: the same address");
#endif
    static_cast<void>(same);
}

// Torque2D #421, reactphysics3d #225, box2d #85: contacts and masses went wrong where bodies changed their
// type.
AS_STOCK("bodies change their type") {
    Yard yard(run);
    yard.Begin();
    constexpr b2BodyType kTypes[] = {b2_staticBody, b2_dynamicBody, b2_kinematicBody, b2_dynamicBody};
    for (int round = 0; round < 12; ++round) {
        for (const Yard::Couple &couple : yard.couples) {
            b2Body *changed = round % 3 == 2 ? couple.stays : couple.mover;
            changed->SetType(kTypes[round % 4]);
            changed->SetSleepingAllowed(false);
            if (round % 4 == 1) // outside what a level's fixture has for a hull
                changed->DestroyFixture(yard.game.Box(changed, 0.2f, 0.2f, {-1.0f, -0.7f}));
            if (round % 5 == 1)
                yard.game.Box(changed, 0.1f, 0.1f, {0.2f, 0.02f * Real(round)});
        }
        yard.Drift(round % 2 == 0 ? -1.0f : 0.5f);
        yard.game.Step(4);
        yard.Place(round % 2 == 0);
        yard.game.Step();
        if (round % 4 == 2 && round < 10)
            yard.game.Stage(yard.TouchingCouples() >= 2, "a collision");
    }
}

// box2d #357, #636, #227, bepuphysics2 #259, PhysX #125: what is done to sleepers is seen late or never.
AS_STOCK("sleepers are moved, changed and built upon") {
    Yard yard(run);
    yard.Begin();
    for (int round = 0; round < 6; ++round) {
        const bool near = round % 2 == 0;
        for (const Yard::Couple &couple : yard.couples) {
            for (b2Body *body : {couple.stays, couple.mover}) {
                body->SetSleepingAllowed(true);
                body->SetAwake(false);
            }
            couple.mover->SetTransform(near ? Yard::Near(couple) : Yard::Away(couple), kSlant);
            if (round == 3)
                yard.Thicken(couple.mover, 0.62f);
            if (round == 4)
                yard.game.Box(couple.stays, 0.1f, 0.1f, {0.0f, 0.5f});
            if (round == 5)
                yard.game.Box(yard.game.Body(b2_staticBody, Yard::Away(couple)), 0.3f, 0.3f);
        }
        yard.game.Step(3);
        for (const Yard::Couple &couple : yard.couples)
            (round % 3 == 0 ? couple.stays : couple.mover)->SetAwake(true);
        yard.game.Step(2);
        if (near)
            yard.game.Stage(yard.TouchingCouples() >= 3, "those who wake up touch");
        yard.game.Step(20);
    }
}

// bullet3 #1739, #2646: points and normals of a turning platform stayed as they first were.
AS_STOCK("a platform turns under what lies on it") {
    Heard game(run, {0.0f, -10.0f});
    b2Body *platforms[3];
    for (int i = 0; i < 3; ++i) {
        platforms[i] = game.Body(b2_kinematicBody, {9.0f * Real(i), 0.0f});
        if (i == 1)
            game.Plank(platforms[i]);
        else
            game.Box(platforms[i], 2.0f, 0.1f);
        platforms[i]->SetAngularVelocity(i == 2 ? -3.0f : 0.6f);
        b2Body *body = game.Body(b2_dynamicBody, {9.0f * Real(i) + 0.5f, 0.6f});
        if (i == 1)
            game.Plank(body);
        else
            game.Box(body, 0.4f, 0.4f);
    }
    game.Step(3);
    game.Step(60);
    game.Stage(game.Touching() > 0, "they lie on it");
    for (b2Body *platform : platforms)
        platform->SetAngularVelocity(-8.0f);
    game.Step(90);
}
