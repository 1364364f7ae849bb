// SPDX-License-Identifier: MIT
#ifndef AS_STOCK_ACTOR_ACTOR_H
#define AS_STOCK_ACTOR_ACTOR_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "world.h"

namespace actor {

/// All actions in the order of their codes, on which the corpus hangs (codes behind the last do nothing), and
/// how many bytes each reads, more or less: for a generator. What comes AGAIN comes more often by chance.
// clang-format off
#define ACTOR_ACTIONS(DO, AGAIN) \
    DO(CreateBody, 9) AGAIN(CreateBody, 9) AGAIN(CreateBody, 9) DO(CreateBeside, 9) \
    AGAIN(CreateBeside, 9) DO(AddFixtureToSome, 5) DO(DestroyFixture, 2) DO(DestroyBody, 1) \
    DO(Teleport, 4) DO(NudgePose, 4) DO(SwapPoses, 2) DO(CopyPose, 4) DO(PutBeside, 6) DO(SetType, 2) \
    DO(SetEnabled, 1) DO(SetAwake, 1) DO(SetBullet, 1) DO(SetVelocity, 5) DO(SetExtremeVelocity, 4) \
    DO(Push, 6) DO(SetFreedoms, 2) DO(SetMass, 5) DO(SetFilter, 2) DO(SetMaterial, 2) DO(SetSensor, 2) \
    DO(ResizeInPlace, 5) DO(NudgeShapeInPlace, 3) DO(ChangeRadiusInPlace, 2) DO(ChangeRoundInPlace, 4) \
    DO(CreateJoint, 5) DO(DestroyJoint, 1) DO(ChangeJoint, 2) DO(ShiftOrigin, 3) DO(SetGravity, 2) \
    DO(SetTimeStep, 1) DO(SetIterations, 1) DO(SetSolver, 1) DO(SetReactions, 9) DO(SetRefusals, 1) \
    DO(AskWorld, 4) DO(ProbeContact, 3) DO(ProbeFixtures, 2) DO(SwitchWorld, 0) DO(RecreateWorld, 0) \
    DO(MoveElsewhere, 3) DO(WakeAll, 0) DO(Inspect, 0) DO(EmptyWorld, 0) DO(Crowd, 3) \
    DO(ChangeHands, 2) DO(ExchangeFixtures, 3) DO(ReplaceFixture, 3) DO(ReplaceBody, 3) \
    DO(MoveCentre, 4) DO(SetDensities, 3) DO(TurnOften, 3) DO(Throw, 5) DO(Carry, 4) DO(ThereAndBack, 3) \
    DO(DisableContacts, 2) DO(MaskBody, 2) DO(JoinContact, 2) DO(EditAllInPlace, 2) DO(Throng, 5) \
    DO(BuildLevel, 2) DO(CreateCompound, 5) DO(CreatePairs, 2) DO(CreateDrums, 1) DO(Drive, 4) \
    DO(RestSome, 1) DO(FillAgain, 5) DO(ShiftThereAndBack, 3) DO(SetRounding, 1) DO(SetThrowing, 1) \
    DO(SetTicks, 1) DO(Draw, 0) DO(SetFilterReactions, 1) DO(AddOutline, 4) DO(Scatter, 3) \
    DO(SendNowhere, 2) DO(PutBack, 1)
// clang-format on

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
/// step more, up to four), below one of ACTOR_ACTIONS, which are what a game may do
///
///   to bodies    create, destroy, replace, teleport, nudge by units in the last place, swap, put beside at
///                a gap that something hangs on, turn by thousands of rounds, throw, drive, send where
///                numbers are none, and back; type, enabled, awake, bullet, freedoms, centre of mass,
///                damping, gravity
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
    int dumpAt = -1;    ///< this record is put into `dump`, a line for each field
    std::string dump;

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
    bool MayGrow() { return Box2D().GetBodyCount() < m_mostBodies; }

    void BuildBin();
    bool End(Record *record);
    void Tell(Record *record);
    void Perturb();

    void AddFixture(b2Body *body);
    void MakePolygon(b2PolygonShape *shape);
    void MakeChain(b2Body *body, const b2FixtureDef &def, bool loop);
    void PullVerticesInPlace(b2PolygonShape *polygon, b2Body *body);
    b2Body *PlaceBeside(b2Body *fixed, b2Body *moved);
    void DestroyGears();

// What a game may do: bodies.cpp, replacing.cpp, crowds.cpp, shapes.cpp, joints.cpp, worlds.cpp.
#define DECLARE(name, bytes) void name();
#define NOT_AGAIN(name, bytes)
    ACTOR_ACTIONS(DECLARE, NOT_AGAIN)
#undef DECLARE
#undef NOT_AGAIN

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

/// Plays what comes from `in`, each input in a process of its own, and writes to `out` the records up to
/// where it ends, be it by an assertion of Box2D's. Returns when `in` is closed.
void Serve(int in, int out);

/// A process that serves.
class Server {
public:
    /// `process` is what the new process does; it does not return.
    explicit Server(const std::function<void(int in, int out)> &process);
    Server(const Server &) = delete;
    Server &operator=(const Server &) = delete;
    /// `dump`: what the actor dumps of record `dumpAt`.
    std::vector<Record> Ask(const uint8_t *data, size_t size, int dumpAt = -1, std::string *dump = nullptr);

private:
    int m_to = -1, m_from = -1;
};

} // namespace actor

#endif
