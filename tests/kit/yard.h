// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_YARD_H
#define BOOMERANG_TEST_YARD_H

#include "as_stock.h"

/// @file
/// Slanted planks side by side, whose boxes overlap long before they do.

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

} // namespace as_stock

#endif
