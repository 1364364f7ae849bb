// SPDX-License-Identifier: MIT
// "The bullet hits, the enemy goes": in a release build of Box2D no assertion keeps a listener from
// b2Body::SetEnabled(false), which ends the body's contacts at once, in the midst of the step.
#include "game.h"
#include "shapes.h"

namespace box2d_builds {

namespace {

enum class When { Begin, End, PreSolve, PostSolve };

/// Rows of bullets fly at a wall, each near its neighbours, so that in the search for impacts many contacts
/// wait. When told of one that hit the wall, the listener disables another bullet, which still flies.
template <When when> class ImpactDisables final : public Game {
public:
    void Build(testbed::Stage &stage, int) override {
        b2World &world = stage.World();
        world.SetGravity({0.0f, 0.0f});
        b2Body *wall = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
        for (int i = -8; i <= 8; ++i)
            stage.AddFixture(wall, testbed::MakeBox(0.1f, 0.6f, {0.0f, static_cast<float>(i)}), 0.0f);
        for (int row = 0; row < kRows; ++row)
            for (int i = 0; i < kInRow; ++i) {
                b2BodyDef def;
                def.type = b2_dynamicBody;
                def.bullet = true;
                def.position = {-2.0f - 0.9f * static_cast<float>(row),
                                0.7f * static_cast<float>(i - kInRow / 2)};
                def.angle = 0.3f * static_cast<float>(row + i);
                def.linearVelocity = {60.0f + static_cast<float>((7 * i + 3 * row) % 11),
                                      static_cast<float>(i % 3) - 1.0f};
                b2Body *body = stage.AddBody(def);
                b2FixtureDef material = testbed::Material(1.0f, 0.2f, 0.9f);
                stage.AddFixture(body, material, testbed::MakeBox(0.25f, 0.15f));
                m_bullets.push_back(body);
            }
    }

    void BeforeStep(testbed::Stage &, int step) override {
        m_mayDisable = 2;
        if (step % 8 != 7)
            return;
        for (std::size_t i = 0; i < m_bullets.size(); ++i) { // back to where they came from
            m_bullets[i]->SetEnabled(true);
            m_bullets[i]->SetTransform({-2.0f - 0.9f * static_cast<float>(i / kInRow),
                                        0.7f * static_cast<float>(static_cast<int>(i % kInRow) - kInRow / 2)},
                                       0.1f * static_cast<float>(step + static_cast<int>(i)));
            m_bullets[i]->SetLinearVelocity({70.0f, 0.0f});
            m_bullets[i]->SetAngularVelocity(static_cast<float>(i % 5) - 2.0f);
        }
    }

    void OnBegin(b2Contact &contact) override { Told(contact, When::Begin); }
    void OnEnd(b2Contact &contact) override { Told(contact, When::End); }
    void OnPreSolve(b2Contact &contact, const b2Manifold &) override { Told(contact, When::PreSolve); }
    void OnPostSolve(b2Contact &contact, const b2ContactImpulse &) override {
        Told(contact, When::PostSolve);
    }

private:
    static constexpr int kRows = 4, kInRow = 12;

    void Told(const b2Contact &contact, When now) {
        const b2Body *a = contact.GetFixtureA()->GetBody(), *b = contact.GetFixtureB()->GetBody();
        if (now != when || m_mayDisable == 0 || !a->GetWorld()->IsLocked())
            return;
        // One that has nothing to do with the two: what Box2D is in the midst of stays whole.
        for (b2Body *bullet : m_bullets)
            if (bullet != a && bullet != b && bullet->IsEnabled() && bullet->GetContactList() != nullptr &&
                Alone(bullet, contact)) {
                --m_mayDisable;
                const int before = m_mayDisable;
                m_mayDisable = 0;
                bullet->SetEnabled(false);
                m_mayDisable = before;
                m_probes.Field("disabled", testbed::NumberOf(*bullet));
                return;
            }
    }

    /// It is in nobody's island, and none of its contacts is with bodies of `contact` that move, nor next to
    /// `contact` in the world's list.
    static bool Alone(const b2Body *bullet, const b2Contact &contact) {
        const b2Contact *next = contact.GetNext();
        if (next != nullptr &&
            (next->GetFixtureA()->GetBody() == bullet || next->GetFixtureB()->GetBody() == bullet))
            return false;
        for (const b2ContactEdge *edge = bullet->GetContactList(); edge != nullptr; edge = edge->next)
            if (edge->other->GetType() == b2_dynamicBody &&
                (edge->contact->IsTouching() || edge->other == contact.GetFixtureA()->GetBody() ||
                 edge->other == contact.GetFixtureB()->GetBody()))
                return false;
        return true;
    }

    std::vector<b2Body *> m_bullets;
    int m_mayDisable = 0;
};

/// The enemy that was hit goes, and with it the contact that the listener is told of.
template <When when> class HitGoes final : public Game {
public:
    void Build(testbed::Stage &stage, int) override {
        stage.World().SetGravity({0.0f, 0.0f});
        for (int i = 0; i < kPairs; ++i) {
            const float y = 3.0f * static_cast<float>(i);
            b2BodyDef def;
            def.type = i % 2 == 0 ? b2_staticBody : b2_dynamicBody;
            def.position = {0.0f, y};
            b2Body *enemy = stage.AddBody(def);
            stage.AddFixture(enemy, testbed::MakeBox(0.2f, 0.5f), 1.0f);
            m_enemies.push_back(enemy);
            def.type = b2_dynamicBody;
            def.bullet = true;
            def.position = {-2.0f - 0.5f * static_cast<float>(i), y + 0.1f};
            def.linearVelocity = {150.0f, 0.0f};
            stage.AddFixture(stage.AddBody(def), testbed::MakeBox(0.1f, 0.1f), 1.0f);
        }
    }
    void OnBegin(b2Contact &contact) override { Told(contact, When::Begin); }
    void OnPreSolve(b2Contact &contact, const b2Manifold &) override { Told(contact, When::PreSolve); }
    void OnPostSolve(b2Contact &contact, const b2ContactImpulse &) override {
        Told(contact, When::PostSolve);
    }

private:
    static constexpr int kPairs = 8;

    void Told(const b2Contact &contact, When now) {
        if (now != when)
            return;
        for (b2Body *enemy : m_enemies)
            if (enemy == contact.GetFixtureA()->GetBody() || enemy == contact.GetFixtureB()->GetBody())
                enemy->SetEnabled(false);
    }

    std::vector<b2Body *> m_enemies;
};

/// Boxes deep in each other, half of them in sensors, among boxes apart. A sensor's contact that begins is
/// disabled, and turns solid; of the others each third loses its points before it is solved.
class PointsGo final : public Game {
public:
    void Build(testbed::Stage &stage, int) override {
        stage.World().SetGravity({0.0f, 0.0f});
        for (int i = 0; i < 80; ++i)
            for (const bool right : {false, true}) {
                const bool deep = i % 4 == 0;
                b2Body *const body = stage.AddBody(
                    b2_dynamicBody, {3.0f * static_cast<float>(i) + (right ? deep ? 0.8f : 1.1f : 0.0f),
                                     right ? 0.2f : 0.0f});
                b2FixtureDef material = testbed::Material(1.0f);
                material.isSensor = right && i % 8 == 0;
                stage.AddFixture(body, material, testbed::MakeBox(0.5f, 0.5f));
                body->SetSleepingAllowed(false);
            }
    }
    void OnBegin(b2Contact &contact) override {
        for (b2Fixture *fixture : {contact.GetFixtureA(), contact.GetFixtureB()}) {
            if (!fixture->IsSensor())
                continue;
            fixture->SetSensor(false);
            contact.SetEnabled(false);
        }
    }
    void OnPreSolve(b2Contact &contact, const b2Manifold &) override {
        if (++m_told % 3 != 0)
            return;
        contact.SetEnabled(false);
        contact.GetManifold()->pointCount = 0;
    }

private:
    int m_told = 0;
};

/// Boxes on the ground, and a sensor in one of them that turns solid as the first step touches it, and stays
/// enabled: two that touch, of no points. (Box2D's block solver reads what it never set, in a fresh world
/// zeros.)
class SensorTurnsSolid final : public Game {
public:
    void Build(testbed::Stage &stage, int) override {
        b2Body *const ground = stage.AddBody(b2_staticBody, {0.0f, -1.0f});
        stage.AddFixture(ground, testbed::Material(0.0f), testbed::MakeBox(60.0f, 1.0f));
        b2FixtureDef material = testbed::Material(0.0f);
        material.isSensor = true;
        stage.AddFixture(stage.AddBody(b2_staticBody, {0.4f, 0.9f}), material, testbed::MakeBox(0.5f, 0.5f));
        for (int i = 0; i < 12; ++i)
            stage.AddFixture(stage.AddBody(b2_dynamicBody, {0.99f * static_cast<float>(i), 0.45f}),
                             testbed::Material(1.0f), testbed::MakeBox(0.5f, 0.5f));
    }
    void OnBegin(b2Contact &contact) override {
        for (b2Fixture *fixture : {contact.GetFixtureA(), contact.GetFixtureB()})
            if (fixture->IsSensor())
                fixture->SetSensor(false);
    }
};

} // namespace

void AddDisabling(std::vector<GameInfo> &games) {
    games.push_back({"impact-disables-begin", "a third body is disabled when an impact begins a contact", 120,
                     Create<ImpactDisables<When::Begin>>, true});
    games.push_back({"impact-disables-end", "a third body is disabled when a contact ends", 120,
                     Create<ImpactDisables<When::End>>, true});
    games.push_back({"impact-disables-presolve", "a third body is disabled before an impact is solved", 120,
                     Create<ImpactDisables<When::PreSolve>>, true});
    games.push_back({"impact-disables-postsolve", "a third body is disabled after an impact was solved", 120,
                     Create<ImpactDisables<When::PostSolve>>, true});
    games.push_back({"hit-goes-begin", "the body that was hit is disabled when the contact begins", 60,
                     Create<HitGoes<When::Begin>>, true});
    games.push_back({"hit-goes-presolve", "the body that was hit is disabled before the contact is solved",
                     60, Create<HitGoes<When::PreSolve>>, true});
    games.push_back({"hit-goes-postsolve", "the body that was hit is disabled after the contact was solved",
                     60, Create<HitGoes<When::PostSolve>>, true});
    games.push_back({"points-go", "a sensor turns solid as it is touched, and contacts lose their points", 40,
                     Create<PointsGo>});
    games.push_back({"sensor-turns-solid", "a sensor turns solid as it is touched, and stays enabled", 60,
                     Create<SensorTurnsSolid>, true});
}

} // namespace box2d_builds
