// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_STAGE_H
#define BOOMERANG_TESTBED_STAGE_H

#include <cstdint>
#include <memory>
#include <vector>

#include <box2d/b2_math.h>
#include <box2d/box2d.h>
#include <gsl/gsl_rng.h>

#include "state/numbers.h"

namespace testbed {

enum class BodyKind {
    One,   ///< one fixture with all vertices (bmr::ConvexShape above 8): the worker with the plugin alone
    Many,  ///< stock fixtures of at most 8 vertices each, which share the first vertex
    Circle ///< what is round becomes a circle, all else as Many
};

/// How large the polygons are of a scene that lets that be chosen, and what they are made of.
struct PolygonChoice {
    BodyKind bodies = BodyKind::Many;
    int vertices = 0; ///< 0: there is nothing to choose
};

/// "one", "many" or "circle".
const char *NameOf(BodyKind kind);

/// The scenes' only source of chance: the same seed gives the same scene on every machine (GSL's mt19937).
class Random {
public:
    explicit Random(unsigned long seed);

    /// In [low, high).
    float Uniform(float low, float high);
    /// In [0, count); count > 0.
    int Index(int count);
    /// True once in `times` calls on average.
    bool OnceIn(int times) { return Index(times) == 0; }
    /// Of length in [low, high) and any direction.
    b2Vec2 Direction(float low, float high);

private:
    struct Free {
        void operator()(gsl_rng *generator) const { gsl_rng_free(generator); }
    };
    std::unique_ptr<gsl_rng, Free> m_generator;
};

class Scene;
class EventRecorder;

/// A world and the numbers of what is in it. Everything in a world is made through its stage, which numbers
/// bodies, joints and each body's fixtures in the order of their creation and keeps the number in the user
/// data: addresses differ from run to run, numbers do not.
class Stage final : private b2ContactListener, private b2DestructionListener {
public:
    /// Box2D calls the stage, and the stage calls the recorder (nullptr: none) ahead of the scene, because a
    /// scene may change the contact. The stage installs its contact listener only if there is a recorder or
    /// the scene has a listener: where neither is, the commands time Box2D without one.
    Stage(Scene &scene, unsigned long seed, EventRecorder *recorder);
    Stage(const Stage &) = delete;
    Stage &operator=(const Stage &) = delete;

    b2World &World() { return m_world; }
    Random &Rng() { return m_random; }
    /// For the scenes that let it be chosen; to be set before they build.
    const PolygonChoice &Polygons() const { return m_polygons; }
    void SetPolygons(const PolygonChoice &choice) { m_polygons = choice; }

    b2Body *AddBody(b2BodyDef def);
    b2Body *AddBody(b2BodyType type, b2Vec2 position, float angle = 0.0f);
    /// `def.shape` is ignored.
    b2Fixture *AddFixture(b2Body *body, b2FixtureDef def, const b2Shape &shape);
    b2Fixture *AddFixture(b2Body *body, const b2Shape &shape, float density);
    /// To be cast by the caller, who knows the type of the definition.
    b2Joint *AddJoint(b2JointDef &def);
    /// A revolute joint about a point of the world, without motor or limit.
    b2Joint *AddHinge(b2Body *bodyA, b2Body *bodyB, b2Vec2 anchor);

private:
    void BeginContact(b2Contact *contact) override;
    void EndContact(b2Contact *contact) override;
    void PreSolve(b2Contact *contact, const b2Manifold *old) override;
    void PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) override;
    void SayGoodbye(b2Joint *joint) override;
    void SayGoodbye(b2Fixture *fixture) override;

    Scene &m_scene;
    EventRecorder *m_recorder;
    Random m_random;
    PolygonChoice m_polygons;
    b2World m_world;
    std::vector<uint32_t> m_fixturesMade; // by body number
    uint32_t m_jointsMade = 0;
};

} // namespace testbed

#endif
