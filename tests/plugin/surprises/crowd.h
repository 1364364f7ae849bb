// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_PLUGIN_CROWD_H
#define BOOMERANG_TEST_PLUGIN_CROWD_H

#include <vector>

#include <box2d/box2d.h>

/// @file
/// A world full of pairs that stay apart although their fat boxes overlap, and a few drums: bodies that
/// bounce to and fro and so have listeners and filters called in every few steps.

namespace surprises {

/// What the two bodies of a pair are. `A` is on the left, `B` on the right; 0.06 m lie between them where
/// nothing else is said.
enum Kind {
    kBoxes,
    kStaticBox,    ///< B is static
    kKinematicBox, ///< B is kinematic
    kOctagon,      ///< an octagon and a triangle
    kNeedles,      ///< both long and thin, side by side
    kCircle,       ///< A is a circle
    kEdge,         ///< B is a static edge
    kChain,        ///< B is a static chain
    kWheels,       ///< six triangles each
    kAsleep,       ///< both fall asleep
    kAsleepStatic, ///< A falls asleep, B is static
    kSensor,       ///< A is a sensor
    kFullSensor,   ///< A is a sensor, and B is in it
    kBullet,       ///< A is a bullet, B a thin plate
    kTurner,       ///< A's box is 40 m away from the point about which A turns
    kBrink,        ///< next to no room between them
    kDrifting,     ///< A comes nearer by a tenth of a millimetre in a step
    kKinds
};

/// Pairs of each kind; copy kVictim is the one to which something happens.
constexpr int kCopies = 2, kVictim = 1;

struct Pair {
    b2Body *a, *b; ///< null where the body is gone
    int kind, copy;
};

/// In b2Body's user data: whose callbacks these are.
enum Drum : uintptr_t {
    kNoDrum,
    kFirstDrum,  ///< its contacts are ahead of all pairs in the world's list
    kLastDrum,   ///< behind all pairs
    kImpactDrum, ///< its contacts begin while Box2D looks for impacts
    kCommuter    ///< it gets a new contact in every step
};

class Crowd {
public:
    /// Adds everything to an empty world and steps it a few times; `at` is where the crowd stands.
    Crowd(b2World *world, b2Vec2 at);
    /// What a game does between all steps: the drums' contacts are to be filtered, the commuter goes.
    void Tick(int step);
    /// Another body in the place of one of a pair.
    b2Body *Make(int kind, bool left, b2Vec2 at);
    b2Vec2 Home(const Pair &pair, bool left) const;

    std::vector<Pair> pairs;

private:
    b2Body *Body(b2BodyType type, b2Vec2 at, Drum drum = kNoDrum);
    void AddDrums(Drum drum, float column);

    b2World *m_world;
    b2Vec2 m_at;
    std::vector<b2Body *> m_balls;
    b2Body *m_commuter = nullptr;
};

/// A fixture whose number is its user data: numbers are given in the order of creation, from 1 on in each
/// crowd's world.
b2Fixture *AddFixture(b2Body *body, const b2Shape &shape, bool sensor = false, float density = 1.0f);

} // namespace surprises

#endif
