// SPDX-License-Identifier: MIT
// What a game changes in shapes without telling Box2D, between steps and in the midst of one, and what it
// sees when they are drawn.
#include "shapes.h"
#include "drawn.h"
#include "edit.h"
#include "game.h"

namespace box2d_builds {

namespace {

b2PolygonShape &PolygonOf(b2Fixture *fixture) {
    return *static_cast<b2PolygonShape *>(fixture->GetShape());
}

/// Two bodies of parallel slanted planks, whose boxes overlap and which are apart: the plugin keeps a hull of
/// each. One plank becomes a sensor; then its vertices are changed, so that it reaches the other body; then,
/// in the midst of a step, a listener makes it solid again. The listener is told of two boxes whose contact
/// lies between the planks' contacts in the world's list: so contacts of the two hulls come before the
/// change, and the changed plank's after it.
///
/// Without the sensor: the plank is solid all the time, and the listener changes its vertices.
template <bool sensor> class StaleHull final : public Game {
public:
    void Build(testbed::Stage &stage, int) override {
        stage.World().SetGravity({0.0f, 0.0f});
        for (int i = 0; i < 2; ++i) {
            m_planks[i] = stage.AddBody(
                b2_dynamicBody, {-0.5f * static_cast<float>(i), 0.5f * static_cast<float>(i)}, kSlant);
            m_planks[i]->SetSleepingAllowed(false);
        }
        for (int i = 0; i < kPlanks; ++i)
            AddPlank(stage, 1, i);
        m_changing = AddPlank(stage, 0, 0);
    }

    void BeforeStep(testbed::Stage &stage, int step) override {
        if (step == 2)
            AddTwoBoxes(stage);
        if (step == 4)
            for (int i = 1; i < kPlanks; ++i)
                AddPlank(stage, 0, -i);
        const int phase = step % 20;
        if (phase == 8 && sensor)
            m_changing->SetSensor(true);
        if (phase == 12 && sensor)
            Change();
        m_turn = phase == 12;
        if (phase == 18) { // back to where it was
            PolygonOf(m_changing) = testbed::MakeBox(kHalfLength, kHalfWidth);
            for (int i = 0; i < 2; ++i) {
                m_planks[i]->SetTransform({-0.5f * static_cast<float>(i), 0.5f * static_cast<float>(i)},
                                          kSlant);
                m_planks[i]->SetLinearVelocity({0.0f, 0.0f});
                m_planks[i]->SetAngularVelocity(0.0f);
            }
        }
    }

    void OnPreSolve(b2Contact &contact, const b2Manifold &) override {
        if (!m_turn || contact.GetFixtureA()->GetBody() == m_planks[0] ||
            contact.GetFixtureA()->GetBody() == m_planks[1])
            return;
        if (sensor)
            m_changing->SetSensor(false);
        else
            Change();
        m_turn = false;
    }

private:
    static constexpr int kPlanks = 4;
    static constexpr float kSlant = 0.25f * b2_pi, kHalfLength = 1.0f, kHalfWidth = 0.03f;

    void Change() { PolygonOf(m_changing) = testbed::MakeBox(1.0f, 0.75f); }
    b2Fixture *AddPlank(testbed::Stage &stage, int body, int row) {
        return stage.AddFixture(
            m_planks[body], testbed::Material(1.0f),
            testbed::MakeBox(kHalfLength, kHalfWidth, {0.0f, 0.1f * static_cast<float>(row)}));
    }
    static void AddTwoBoxes(testbed::Stage &stage) {
        for (int i = 0; i < 2; ++i) {
            b2Body *box =
                stage.AddBody(i == 0 ? b2_staticBody : b2_dynamicBody, {10.0f, 0.5f * static_cast<float>(i)});
            stage.AddFixture(box, testbed::MakeBox(0.5f, 0.26f), 1.0f);
            box->SetSleepingAllowed(false);
        }
    }

    b2Body *m_planks[2] = {};
    b2Fixture *m_changing = nullptr;
    bool m_turn = false;
};

/// A tumbling crowd of wheels of several fixtures, whose vertices and radii a listener changes in the midst
/// of steps.
class Edits final : public Game {
public:
    void Build(testbed::Stage &stage, int) override {
        stage.World().SetGravity({0.0f, -2.0f});
        testbed::AddArena(stage, {0.0f, 0.0f}, 3.0f, 2.5f, 0.8f);
        for (int i = 0; i < 9; ++i) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.bullet = i % 3 == 0;
            def.position = {1.7f * static_cast<float>(i % 3 - 1), 1.4f * static_cast<float>(i / 3 - 1)};
            def.linearVelocity = {9.0f - 2.0f * static_cast<float>(i), 3.0f};
            def.angularVelocity = static_cast<float>(i % 4) - 1.5f;
            def.allowSleep = false;
            b2Body *body = stage.AddBody(def);
            testbed::AddFan(stage, body, testbed::StarOutline(8 + 2 * (i % 3), 0.3f, 0.6f),
                            testbed::Material(1.0f, 0.2f, 0.7f));
        }
    }
    void OnBegin(b2Contact &contact) override { Edit(contact, 0); }
    void OnEnd(b2Contact &contact) override { Edit(contact, 1); }
    void OnPreSolve(b2Contact &contact, const b2Manifold &) override { Edit(contact, 2); }
    void OnPostSolve(b2Contact &contact, const b2ContactImpulse &) override { Edit(contact, 3); }

private:
    void Edit(b2Contact &contact, unsigned occasion) {
        const unsigned number = m_told++ * 4 + occasion;
        if (number % 5 != 0)
            return;
        b2Body *body = contact.GetFixtureB()->GetBody();
        if (number % 2 == 0 && body->GetNext() != nullptr)
            body = body->GetNext();
        if (body->GetType() != b2_dynamicBody)
            return;
        b2Fixture *fixture = body->GetFixtureList();
        for (unsigned skip = number / 7 % 8; skip > 0 && fixture->GetNext() != nullptr; --skip)
            fixture = fixture->GetNext();
        b2PolygonShape &polygon = PolygonOf(fixture);
        if (number % 3 == 0) {
            polygon.m_radius = (polygon.m_radius > b2_polygonRadius ? 1.0f : 6.0f) * b2_polygonRadius;
            return;
        }
        ScaleInPlace(&polygon, 0.6f);
    }

    unsigned m_told = 0;
};

/// Draws its world between steps and in the midst of them.
class Draws final : public Game {
public:
    void Build(testbed::Stage &stage, int) override {
        m_world = &stage.World();
        m_drawn.SetFlags(b2Draw::e_shapeBit | b2Draw::e_aabbBit | b2Draw::e_pairBit |
                         b2Draw::e_centerOfMassBit | b2Draw::e_jointBit);
        m_world->SetDebugDraw(&m_drawn);
        b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, -1.0f});
        stage.AddFixture(ground, testbed::MakeBox(8.0f, 0.5f), 0.0f);
        b2Body *previous = nullptr;
        for (int i = 0; i < 12; ++i) {
            b2Body *body = stage.AddBody(b2_dynamicBody,
                                         {0.8f * static_cast<float>(i % 4), 0.8f * static_cast<float>(i / 4)},
                                         0.3f * static_cast<float>(i));
            stage.AddFixture(body, testbed::MakeRegular(3 + i % 6, 0.4f), 1.0f);
            if (i % 3 == 1)
                stage.AddHinge(previous, body, body->GetPosition());
            previous = body;
        }
    }
    void BeforeStep(testbed::Stage &, int) override { m_world->DebugDraw(); }
    void OnPreSolve(b2Contact &, const b2Manifold &) override { m_world->DebugDraw(); }
    void OnPostSolve(b2Contact &, const b2ContactImpulse &) override { m_world->DebugDraw(); }
    uint64_t Probes() const override { return m_drawn.Hash(); }

private:
    b2World *m_world = nullptr;
    Drawn m_drawn;
};

} // namespace

void AddShapes(std::vector<GameInfo> &games) {
    games.push_back({"stale-hull", "a sensor is changed, and turns solid in the midst of a step", 60,
                     Create<StaleHull<true>>});
    games.push_back(
        {"stale-hull-solid", "vertices are changed in the midst of a step", 60, Create<StaleHull<false>>});
    games.push_back({"edits", "listeners change vertices and radii in place", 200, Create<Edits>});
    games.push_back(
        {"draws", "the world is drawn between steps and in the midst of them", 120, Create<Draws>});
}

} // namespace box2d_builds
