// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_YARD_H
#define BOOMERANG_TEST_YARD_H

#include "as_stock.h"
#include "start/current_step.h"

/// @file
/// Slanted planks side by side, whose boxes overlap long before they do; and a yard of couples, one for each
/// way in which something is remembered of two shapes. In each couple one body stays and the other, near it
/// but apart, is what a test does something to.

namespace as_stock {

constexpr float kSlant = 0.785398185f; // 45 degrees: boxes of planks overlap long before the planks do

/// `along` and `across` a slanted plank, in the world.
inline b2Vec2 Slanted(float along, float across) {
    return b2Mul(b2Rot(kSlant), b2Vec2(along, across));
}

inline b2Body *Slanting(Game &game, float across, b2BodyType type = b2_dynamicBody) {
    b2Body *body = game.Body(type, Slanted(0.0f, across), kSlant);
    body->SetSleepingAllowed(false);
    return body;
}

/// Two planks, side by side, which know of each other.
struct TwoPlanks {
    TwoPlanks(Game &game, float across) : a(Slanting(game, 0.0f)), b(Slanting(game, across)) {
        game.Plank(a);
        game.Plank(b);
        game.Step(5);
        game.Stage(game.world.GetContactCount() >= 2 && game.Touching() == 0, "contacts, apart");
        game.StagePairs();
    }
    b2Body *a, *b;
};

inline void Place(b2Body *body, b2Vec2 position) {
    body->SetTransform(position, body->GetAngle());
}

inline b2PolygonShape *PolygonOf(b2Fixture *fixture) {
    return fixture->GetType() == b2Shape::e_polygon ? static_cast<b2PolygonShape *>(fixture->GetShape())
                                                    : nullptr;
}

class Yard {
public:
    struct Couple {
        b2Body *stays, *mover;
        b2Vec2 place;
    };
    // By what is remembered: the structure of two bodies; an edge; an edge of eight; a direction or a vertex
    // of a sensor's overlap; directions that no impact was along.
    enum { kPlanks, kBoxes, kOctagon, kSensor, kBullet, kChain, kCount };

    explicit Yard(Run &run, b2Vec2 gravity = {0.0f, 0.0f}) : game(run, gravity) {
        game.Listen();
        for (int i = 0; i < kCount; ++i) {
            Couple &couple = couples[i];
            couple.place = b2Vec2(14.0f * Real(i), 0.0f);
            couple.stays = game.Body(i < kBullet ? b2_dynamicBody : b2_staticBody, couple.place, kSlant);
            couple.mover = game.Body(b2_dynamicBody, Away(couple), kSlant);
            Fill(i, couple);
            couple.stays->SetSleepingAllowed(false);
            couple.mover->SetSleepingAllowed(false);
        }
        couples[kBullet].mover->SetBullet(true);
    }

    /// Until contacts are there and know their pairs.
    void Begin() {
        Drift();
        game.Step(5);
        game.Stage(game.world.GetContactCount() >= kCount && game.Touching() == 0, "contacts, apart");
        game.StagePairs();
    }

    static b2Vec2 Away(const Couple &couple) { return couple.place + Slanted(0.0f, 0.6f); }
    static b2Vec2 Near(const Couple &couple) { return couple.place + Slanted(0.0f, 0.15f); }

    /// Movers to where they are apart, or touch; at rest.
    void Place(bool near) {
        for (const Couple &couple : couples) {
            couple.stays->SetTransform(couple.place, kSlant);
            couple.mover->SetTransform(near ? Near(couple) : Away(couple), kSlant);
            for (b2Body *body : {couple.stays, couple.mover}) {
                body->SetLinearVelocity({0.0f, 0.0f});
                body->SetAngularVelocity(0.0f);
            }
        }
    }
    /// Movers glide along what stays, the bullet fast.
    void Drift(float across = 0.0f) {
        for (int i = 0; i < kCount; ++i)
            couples[i].mover->SetLinearVelocity(Slanted(i == kBullet ? 4.0f : 0.3f, across));
    }
    /// The newest polygon of a body becomes a box so thick, in place.
    void Thicken(b2Body *body, float thickness) {
        for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
            b2PolygonShape *polygon = PolygonOf(f);
            if (polygon == nullptr)
                continue;
            polygon->SetAsBox(0.8f, thickness);
            return;
        }
    }
    /// Asks Box2D to filter and to look for the movers' contacts anew.
    void Refilter() {
        for (const Couple &couple : couples)
            for (b2Fixture *f = couple.mover->GetFixtureList(); f != nullptr; f = f->GetNext())
                f->Refilter();
    }
    /// Pairs of fixtures of one couple of which both are no sensors, that touch.
    int Touching(int number) {
        int count = 0;
        for (b2ContactEdge *edge = couples[number].mover->GetContactList(); edge != nullptr;
             edge = edge->next)
            count += edge->contact->IsTouching();
        return count;
    }
    int TouchingCouples() {
        int count = 0;
        for (int i = 0; i < kCount; ++i)
            count += Touching(i) > 0;
        return count;
    }

    Game game;
    Couple couples[kCount];

private:
    void Fill(int kind, const Couple &couple) {
        b2PolygonShape octagon;
        b2Vec2 corners[8];
        for (int i = 0; i < 8; ++i)
            corners[i] = b2Mul(b2Rot((Real(i) + 0.5f) * 0.785398185f), b2Vec2(0.35f, 0.0f));
        octagon.Set(corners, 8);
        switch (kind) {
        case kPlanks:
            game.Plank(couple.stays);
            game.Plank(couple.mover);
            return;
        case kBoxes:
            game.Box(couple.stays, 2.0f, 0.1f);
            game.Box(couple.mover, 1.0f, 0.1f);
            return;
        case kOctagon:
            game.Box(couple.stays, 2.0f, 0.1f);
            game.Fixture(couple.mover, octagon);
            return;
        case kSensor: {
            b2PolygonShape eye;
            eye.SetAsBox(2.0f, 0.1f);
            game.Fixture(couple.stays, eye, true);
            game.Fixture(couple.mover, octagon);
            return;
        }
        case kBullet:
            game.Box(couple.stays, 2.0f, 0.05f);
            game.Box(couple.mover, 0.3f, 0.1f);
            return;
        default: {
            const b2Vec2 links[4] = {{2.0f, 0.0f}, {0.5f, 0.05f}, {-0.5f, -0.05f}, {-2.0f, 0.0f}};
            b2ChainShape chain;
            chain.CreateChain(links, 4, {3.0f, 0.0f}, {-3.0f, 0.0f});
            game.Fixture(couple.stays, chain);
            game.Box(couple.mover, 0.5f, 0.1f);
        }
        }
    }
};

} // namespace as_stock

#endif
