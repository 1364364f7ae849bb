// SPDX-License-Identifier: MIT
// What happens to steps: many pairs at once, exceptions through them, steps of another world in the midst of
// them.
#include "game.h"
#include "impact_watch.h"
#include "shapes.h"
#include "state/snapshot.h"

namespace box2d_builds {

namespace {

void AddBoxes(testbed::Stage &stage, int count, bool bullets) {
    b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, -1.0f});
    stage.AddFixture(ground, testbed::MakeBox(8.0f, 0.5f), 0.0f);
    for (int i = 0; i < count; ++i) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.bullet = bullets && i % 2 == 0;
        def.position = {0.62f * static_cast<float>(i % 8) - 2.0f, 0.7f * static_cast<float>(i / 8)};
        def.angle = 0.05f * static_cast<float>(i % 5);
        def.linearVelocity = {0.0f, bullets ? -30.0f : 0.0f};
        stage.AddFixture(stage.AddBody(def), testbed::Material(1.0f, 0.4f, bullets ? 0.5f : 0.0f),
                         testbed::MakeBox(0.28f, 0.3f));
    }
}

/// Box2D begins with room for 16 pairs of boxes: the first step finds many more.
class Heap final : public Game {
public:
    void Build(testbed::Stage &stage, int) override { AddBoxes(stage, 64, false); }
};

/// A listener or a filter throws, again and again; the world is stepped on. The last time it is not: it ends
/// locked.
class Throws final : public Game, private b2ContactFilter {
public:
    enum class Where { Begin, End, PreSolve, PostSolve, Filter };
    explicit Throws(Where where) : m_where(where) {}

    void Build(testbed::Stage &stage, int) override {
        if (m_where == Where::Filter)
            stage.World().SetContactFilter(this);
        AddBoxes(stage, 24, true);
    }
    void BeforeStep(testbed::Stage &stage, int step) override {
        m_thrown = false;
        if (step % 25 == 24) // up again, and down once more
            for (b2Body *body = stage.World().GetBodyList(); body != nullptr; body = body->GetNext()) {
                const float up = body->GetType() == b2_dynamicBody ? 6.0f : 0.0f;
                body->SetTransform(body->GetPosition() + b2Vec2(0.0f, up), body->GetAngle());
                body->SetLinearVelocity({0.0f, -40.0f});
            }
        m_watch.StepBegins(stage.World());
    }
    void OnBegin(b2Contact &contact) override {
        m_watch.Told(contact);
        Told(Where::Begin);
    }
    void OnEnd(b2Contact &) override { Told(Where::End); }
    void OnPreSolve(b2Contact &contact, const b2Manifold &) override {
        m_watch.Told(contact);
        Told(Where::PreSolve);
    }
    void OnPostSolve(b2Contact &, const b2ContactImpulse &) override {
        // While the islands of a whole step are solved, Box2D's stack of memory has an entry that no
        // destructor gives back.
        if (m_watch.InImpacts())
            Told(Where::PostSolve);
    }

private:
    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override {
        Told(Where::Filter);
        return b2ContactFilter::ShouldCollide(a, b);
    }
    void Told(Where now) {
        if (now != m_where || m_thrown || ++m_told % 5 != 0)
            return;
        m_thrown = true;
        m_probes.Field("thrown", m_told);
        throw Thrown();
    }

    Where m_where;
    ImpactWatch m_watch;
    uint32_t m_told = 0;
    bool m_thrown = false; ///< since BeforeStep
};

/// Listeners of one world step another one, whose impacts are solved in the midst of this one's.
class OtherWorld final : public Game {
public:
    OtherWorld() : m_otherStage(m_otherScene, 2, &m_otherEvents) { m_otherEvents.StartStep(false); }
    void Build(testbed::Stage &stage, int) override {
        AddBoxes(stage, 24, true);
        AddBoxes(m_otherStage, 32, true);
    }
    void BeforeStep(testbed::Stage &, int) override { m_mayStep = 3; }
    void OnBegin(b2Contact &) override { StepOther(); }
    void OnEnd(b2Contact &) override { StepOther(); }
    void OnPreSolve(b2Contact &, const b2Manifold &) override { StepOther(); }
    void OnPostSolve(b2Contact &, const b2ContactImpulse &) override { StepOther(); }

private:
    void StepOther() {
        if (m_mayStep == 0 || ++m_told % 7 != 0)
            return;
        --m_mayStep;
        m_otherEvents.StartStep(false);
        m_otherStage.World().Step(1.0f / 60.0f, 8, 3);
        const testbed::StateHashes hashes = testbed::HashState(m_otherStage.World(), m_otherEvents);
        m_probes.Field("bodies", hashes.bodies);
        m_probes.Field("contacts", hashes.contacts);
        m_probes.Field("events", hashes.events);
    }

    class Nothing final : public testbed::Scene {
        void Build(testbed::Stage &, int) override {}
    } m_otherScene;
    testbed::EventRecorder m_otherEvents;
    testbed::Stage m_otherStage;
    int m_mayStep = 0;
    unsigned m_told = 0;
};

template <Throws::Where where> std::unique_ptr<Game> CreateThrowing() {
    return std::make_unique<Throws>(where);
}

} // namespace

void AddSteps(std::vector<GameInfo> &games) {
    games.push_back({"heap", "more pairs in a step than Box2D has room for at first", 120, Create<Heap>});
    games.push_back(
        {"throws-begin", "an exception when a contact begins", 100, CreateThrowing<Throws::Where::Begin>});
    games.push_back(
        {"throws-end", "an exception when a contact ends", 100, CreateThrowing<Throws::Where::End>});
    games.push_back({"throws-presolve", "an exception before a contact is solved", 100,
                     CreateThrowing<Throws::Where::PreSolve>});
    games.push_back({"throws-postsolve", "an exception after an impact was solved", 100,
                     CreateThrowing<Throws::Where::PostSolve>});
    games.push_back(
        {"throws-filter", "an exception from a filter", 100, CreateThrowing<Throws::Where::Filter>});
    games.push_back({"other-world", "listeners step another world", 100, Create<OtherWorld>});
}

} // namespace box2d_builds
