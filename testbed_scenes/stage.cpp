// SPDX-License-Identifier: MIT
#include "stage.h"

#include <cmath>

#include "scene.h"
#include "state/snapshot.h"

namespace testbed {

Stage::Stage(Scene &scene, unsigned long seed, EventRecorder *recorder)
    : m_scene(scene), m_recorder(recorder), m_random(seed), m_world(b2Vec2(0.0f, -10.0f)) {
    m_world.SetDestructionListener(this);
    if (recorder != nullptr || scene.Listens())
        m_world.SetContactListener(this);
}

b2Body *Stage::AddBody(b2BodyDef def) {
    def.userData.pointer = m_fixturesMade.size();
    m_fixturesMade.push_back(0);
    return m_world.CreateBody(&def);
}

b2Body *Stage::AddBody(b2BodyType type, b2Vec2 position, float angle) {
    b2BodyDef def;
    def.type = type;
    def.position = position;
    def.angle = angle;
    return AddBody(def);
}

b2Fixture *Stage::AddFixture(b2Body *body, b2FixtureDef def, const b2Shape &shape) {
    def.shape = &shape;
    def.userData.pointer = m_fixturesMade[NumberOf(*body)]++;
    return body->CreateFixture(&def);
}

b2Fixture *Stage::AddFixture(b2Body *body, const b2Shape &shape, float density) {
    b2FixtureDef def;
    def.density = density;
    return AddFixture(body, def, shape);
}

b2Joint *Stage::AddJoint(b2JointDef &def) {
    def.userData.pointer = m_jointsMade++;
    return m_world.CreateJoint(&def);
}

b2Joint *Stage::AddHinge(b2Body *bodyA, b2Body *bodyB, b2Vec2 anchor) {
    b2RevoluteJointDef def;
    def.Initialize(bodyA, bodyB, anchor);
    return AddJoint(def);
}

void Stage::BeginContact(b2Contact *contact) {
    if (m_recorder != nullptr)
        m_recorder->OnBegin(*contact);
    m_scene.OnBegin(*contact);
}

void Stage::EndContact(b2Contact *contact) {
    if (m_recorder != nullptr)
        m_recorder->OnEnd(*contact);
    m_scene.OnEnd(*contact);
}

void Stage::PreSolve(b2Contact *contact, const b2Manifold *old) {
    if (m_recorder != nullptr)
        m_recorder->OnPreSolve(*contact, *old);
    m_scene.OnPreSolve(*contact, *old);
}

void Stage::PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) {
    if (m_recorder != nullptr)
        m_recorder->OnPostSolve(*contact, *impulse);
    m_scene.OnPostSolve(*contact, *impulse);
}

void Stage::SayGoodbye(b2Joint *joint) {
    if (m_recorder != nullptr)
        m_recorder->OnGoodbye(*joint);
}

void Stage::SayGoodbye(b2Fixture *fixture) {
    if (m_recorder != nullptr)
        m_recorder->OnGoodbye(*fixture);
}

Random::Random(unsigned long seed) : m_generator(gsl_rng_alloc(gsl_rng_mt19937)) {
    gsl_rng_set(m_generator.get(), seed);
}

float Random::Uniform(float low, float high) {
    return low + (high - low) * static_cast<float>(gsl_rng_uniform(m_generator.get()));
}

int Random::Index(int count) {
    return static_cast<int>(gsl_rng_uniform_int(m_generator.get(), static_cast<unsigned long>(count)));
}

b2Vec2 Random::Direction(float low, float high) {
    // Two statements: the order in which a compiler evaluates arguments must not decide the scene.
    const float length = Uniform(low, high);
    const float angle = Uniform(-b2_pi, b2_pi);
    return {length * std::cos(angle), length * std::sin(angle)};
}

} // namespace testbed
