// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_FUZZ_GLUE_SCRIPT_H
#define BOOMERANG_FUZZ_GLUE_SCRIPT_H

#include <optional>

#include "bytes.h"
#include "run_request.h"
#include "world.h"

namespace fuzz {

/// A byte string as what a game does to its worlds. The same bytes do the same in every program whose worlds
/// have the same bits: what is drawn from them hangs on bytes and on what can be seen of a world.
///
/// Header: a byte of flags (without gravity, sub-stepping, in a bin; the upper three bits: of any size), a
/// byte that says how far from the origin it plays and how far things are apart. Then operations, a byte each
/// and what it reads: from kFirstStep on steps (every fourth value one step more, up to four), below one of
/// the actions of script.cpp's tables.
class Script {
public:
    explicit Script(const RunRequest &request);
    RunResult Run();
    const RunResult &Result() const { return m_result; }

    /// Does the script ask for polygons of any size? Stock Box2D has none.
    static bool AsksForAnySize(const uint8_t *data, size_t size) { return size > 0 && data[0] / 32 == 1; }

    /// Those that there are, also where an assertion ended the run.
    template <typename Visit> void VisitWorlds(const Visit &visit) {
        for (std::optional<World> &world : m_worlds)
            if (world)
                visit(world->Box2D());
    }

private:
    static constexpr uint8_t kFirstStep = 160;
    static constexpr int kMostActions = 400, kMostBodies = 24, kMostFixtures = 12, kMostJoints = 10;

    // Numbers. (One read a statement: the order of a call's arguments is the compiler's.)
    uint8_t Byte() { return fuzz_u8(&m_bytes); }
    int Below(int bound) { return static_cast<int>(fuzz_below(&m_bytes, static_cast<uint32_t>(bound))); }
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

    void BuildBin();
    bool Step(uint8_t code); ///< false: that was enough
    bool Record();
    void Perturb();

    // script_shapes.cpp
    void AddFixture(b2Body *body);
    void MakePolygon(b2PolygonShape *shape);
    void MakeChain(b2Body *body, const b2FixtureDef &def, bool loop);
    void ResizeInPlace();
    void NudgeShapeInPlace();
    void PullVerticesInPlace(b2PolygonShape *polygon, b2Body *body);
    void ChangeRadiusInPlace();
    void ChangeRoundInPlace();

    // script_bodies.cpp
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

    // script_joints.cpp
    void CreateJoint();
    void DestroyJoint();
    void ChangeJoint();
    void DestroyGears();

    // script_worlds.cpp
    void ShiftOrigin();
    void SetGravity();
    void SetTimeStep();
    void SetIterations();
    void SetSolver();
    void SetReactions();
    void SetRefusals();
    void AskWorld();
    void ProbeContact();
    void ProbeFixtures();
    void SwitchWorld();
    void RecreateWorld();
    void MoveElsewhere();
    void WakeAll();
    void LookAround();
    void EmptyWorld();
    void Crowd();
    void ChangeHands();

    using Action = void (Script::*)();
    static const Action kActions[];
    static const int kActionCount;
    /// The last codes below kFirstStep: what came later, so that older scripts go on to mean what they meant.
    static const Action kLaterActions[];
    static const int kLaterActionCount;
    Action ActionOf(uint8_t code) const;

    fuzz_bytes m_bytes;
    RunRequest m_request;
    RunResult m_result;
    bool m_anySize = false;
    float m_spread = 0.0f;
    b2Vec2 m_origin = {0.0f, 0.0f};
    float m_timeStep = 1.0f / 60.0f;
    int m_velocityIterations = 8, m_positionIterations = 3;
    // Always in the same two places: what is kept under a world's address must not outlive it.
    std::optional<World> m_worlds[2];
    World *m_world = nullptr; ///< the present one
};

} // namespace fuzz

#endif
