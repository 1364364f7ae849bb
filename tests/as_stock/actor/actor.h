// SPDX-License-Identifier: MIT
#ifndef AS_STOCK_ACTOR_ACTOR_H
#define AS_STOCK_ACTOR_ACTOR_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "world.h"

namespace actor {

/// What was seen of both worlds after one step (or, last, after the end). `probes`: what was asked out of
/// turn since the record before.
struct Record {
    uint64_t bodies, contacts, events, probes;
};

/// Plays bytes as what a game does to its worlds. The same bytes do the same in every program whose worlds
/// have the same bits: what is drawn from them hangs on bytes and on what can be seen of a world.
///
/// Header: a byte of flags (2 without gravity, 4 sub-stepping, 8 in a bin, 32 polygons of any size, 64 large:
/// up to 320 bodies and 160 steps), a byte that says how far from the origin it plays and how far things are
/// apart. Then operations, a byte each and what it reads: from kFirstStep on steps (every fourth value one
/// step more, up to four), below one of kActions (actor.cpp), which are what a game may do
///
///   to bodies    create, destroy, replace, teleport, nudge by units in the last place, swap, put beside at
///                a gap that something hangs on, turn by thousands of rounds, throw, drive; type, enabled,
///                awake, bullet, freedoms, centre of mass, damping, gravity
///   to fixtures  create, destroy, replace, exchange with another body's, so that pairs change their A and B;
///                filters, materials, sensors; shapes edited in place, with and without a word to the plugin
///   to joints    of every kind: create, destroy, change
///   to worlds    origin, gravity, time step, iterations, solver, rounding; empty it, make it anew in
///                the same memory, ask it, draw it, step the other one
///   at once      levels, throngs, sleepers, bodies of many fixtures, pairs that stay apart, drums that call
///                listeners in every step
///   in callbacks one of kReactions (reactions.cpp), chosen by the numbers of whom they are called for
class Actor {
public:
    Actor(const uint8_t *data, size_t size);

    /// Plays on to the next record. False: that was the last one.
    bool PlayOn(Record *record);
    /// False: a body has left the numbers, which ends the play.
    bool IsFinite() const { return m_isFinite; }

    int perturbAt = -1; ///< before this record one velocity is changed by one unit in the last place
    int dumpAt = -1;    ///< this record is printed on stderr, a line for each field

    /// Do the bytes ask for polygons of any size? Stock Box2D has none.
    static bool AsksForAnySize(const uint8_t *data, size_t size) { return size > 0 && (data[0] & 32) != 0; }

    using Action = void (Actor::*)();
    struct Row {
        const char *name;
        int bytes; ///< that it reads, more or less: for a generator
        Action act;
    };
    static const Row kActions[];
    static const int kActionCount;
    static constexpr uint8_t kFirstStep = 160;

private:
    // Numbers. (One read a statement: the order of a call's arguments is the compiler's.)
    uint8_t Byte() { return m_at < m_size ? m_data[m_at++] : uint8_t{0}; }
    int Below(int bound) { return Byte() % bound; }
    float Signed(float scale) { return scale * static_cast<float>(static_cast<int8_t>(Byte())); }
    float Unsigned(float scale) { return scale * static_cast<float>(Byte()); }
    b2Vec2 Vector(float scale);
    b2Vec2 Place();
    float Angle();
    float Size();
    b2Vec2 Velocity();

    // What there is.
    b2World &Box2D() { return m_world->Box2D(); }
    b2Body *SomeBody();
    b2Fixture *SomeFixture();
    b2Fixture *SomeFixtureOf(b2Body *body);
    b2Joint *SomeJoint();
    b2Contact *SomeContact();
    bool HasRoom() { return Box2D().GetBodyCount() < m_mostBodies; }

    void BuildBin();
    bool End(Record *record);
    void Tell(Record *record);
    void Perturb();

    // shapes.cpp
    void AddFixture(b2Body *body);
    void MakePolygon(b2PolygonShape *shape);
    void MakeChain(b2Body *body, const b2FixtureDef &def, bool loop);
    void ResizeInPlace();
    void NudgeShapeInPlace();
    void PullVerticesInPlace(b2PolygonShape *polygon, b2Body *body);
    void ChangeRadiusInPlace();
    void ChangeRoundInPlace();
    void EditAllInPlace();
    void AddOutline();

    // bodies.cpp
    void CreateBody();
    void CreateBeside();
    void AddFixtureToSome();
    void DestroyFixture();
    void DestroyBody();
    void Teleport();
    void NudgePose();
    void SwapPoses();
    void CopyPose();
    void PutBeside();
    void SetType();
    void SetEnabled();
    void SetAwake();
    void SetBullet();
    void SetVelocity();
    void SetExtremeVelocity();
    void Push();
    void SetFreedoms();
    void SetMass();
    void SetFilter();
    void SetMaterial();
    void SetSensor();
    b2Body *PlaceBeside(b2Body *fixed, b2Body *moved);

    // replacing.cpp
    void ExchangeFixtures();
    void ReplaceFixture();
    void ReplaceBody();
    void MoveCentre();
    void SetDensities();
    void TurnOften();
    void Throw();
    void Carry();
    void ThereAndBack();
    void DisableContacts();
    void MaskBody();
    void JoinContact();

    // crowds.cpp
    void Crowd();
    void Throng();
    void BuildLevel();
    void CreateCompound();
    void CreatePairs();
    void CreateDrums();
    void Drive();
    void RestSome();
    void Scatter();
    void WakeAll();
    void MoveElsewhere();
    void EmptyWorld();
    void FillAgain();

    // joints.cpp
    void CreateJoint();
    void DestroyJoint();
    void ChangeJoint();
    void DestroyGears();

    // worlds.cpp
    void ShiftOrigin();
    void ShiftThereAndBack();
    void SetGravity();
    void SetTimeStep();
    void SetIterations();
    void SetSolver();
    void SetRounding();
    void SetReactions();
    void SetRefusals();
    void SetThrowing();
    void SetTicks();
    void AskWorld();
    void Draw();
    void ProbeContact();
    void ProbeFixtures();
    void SwitchWorld();
    void RecreateWorld();
    void LookAround();
    void ChangeHands();
    void SetFilterReactions();

    const uint8_t *m_data;
    size_t m_size, m_at = 0;
    bool m_anySize = false;
    int m_mostBodies = 24, m_mostFixtures = 12, m_mostJoints = 10, m_mostActions = 400, m_mostRecords = 48;
    int m_records = 0, m_actions = 0;
    uint8_t m_code = 0;
    int m_stepsLeft = 0; ///< of what m_code says
    bool m_hasEnded = false, m_isFinite = true;
    float m_spread = 0.0f, m_largest = 1e6f;
    b2Vec2 m_origin = {0.0f, 0.0f};
    float m_timeStep = 1.0f / 60.0f;
    int m_velocityIterations = 8, m_positionIterations = 3;
    // Always in the same two places: what is kept under a world's address must not outlive it.
    std::optional<World> m_worlds[2];
    World *m_world = nullptr; ///< the present one
};

/// The bytes of a seed (seeds.cpp): what chance alone would find only after long. The same on every machine.
std::vector<uint8_t> BytesOf(uint32_t seed);

} // namespace actor

#endif
