// SPDX-License-Identifier: MIT
// The traps that Box2D lays for whoever keeps state about its bodies: shapes and poses that change
// unannounced. tests/faults takes the handling of each out of the glue and expects the test case here to
// fail.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "boomerang/inspect.h"
#include "forked_world.h"
#include "start/current_step.h"

using forked::CheckSameAsStock;
using forked::Game;
using forked::Run;

namespace {

constexpr float kSlant = 0.785398185f; // 45 degrees: boxes of planks overlap long before the planks do

/// `along` and `across` a slanted plank, in the world.
b2Vec2 Slanted(float along, float across) {
    return b2Mul(b2Rot(kSlant), b2Vec2(along, across));
}

b2Body *Slanting(Game &game, float across, b2BodyType type = b2_dynamicBody) {
    b2Body *body = game.Body(type, Slanted(0.0f, across), kSlant);
    body->SetSleepingAllowed(false);
    return body;
}

/// As in the steps of a world that has no listener of the game's: there a contact's own fixtures are not
/// compared again with their hulls, so that all else that is to keep hulls and contacts in step is tested for
/// itself.
class NoGameRuns {
public:
    NoGameRuns() { bmr::GameRan() = false; }
    ~NoGameRuns() { bmr::GameRan() = true; }
    NoGameRuns(const NoGameRuns &) = delete;
    NoGameRuns &operator=(const NoGameRuns &) = delete;
};

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

void Place(b2Body *body, b2Vec2 position) {
    body->SetTransform(position, body->GetAngle());
}

} // namespace

TEST_CASE("fixtures A and B may change places between two contacts of one body pair") {
    CheckSameAsStock([](Run &run) {
        Game game(run);
        // The second plank lies three beside its body's origin, so that no symmetry hides a mix-up.
        b2Body *a = Slanting(game, 0.0f), *b = Slanting(game, -2.2f);
        constexpr int kAll = Game::kPlankPieces, kHalf = kAll / 2;
        game.Plank(a, {0.0f, 0.0f}, 0, kHalf);
        game.Plank(b, {0.0f, 3.0f});
        game.Plank(a, {0.0f, 0.0f}, kHalf, kAll);
        b->SetLinearVelocity(Slanted(0.0f, -1.0f));
        game.Step(3);
        int first[2] = {0, 0};
        for (b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext())
            ++first[c->GetFixtureA()->GetBody() == b];
        game.Stage(first[0] > 0 && first[1] > 0, "both orders");
        game.StagePairs();
        game.Step(45);
        game.Stage(game.Touching() > 1, "a collision");
        game.Step(40);
    });
}

TEST_CASE("a fixture that is added outside the hull collides at once") {
    CheckSameAsStock([](Run &run) {
        Game game(run);
        TwoPlanks planks(game, 0.6f);
        const uint64_t before = bmr::internal::ReadCounts().hulls;
        game.Box(planks.b, 0.1f, 0.1f, {-1.0f, -0.6f});
        game.Step();
        run.Expect(!run.Counts() || bmr::internal::ReadCounts().hulls > before, "the hull is built anew");
        game.Stage(game.Touching() >= 1, "a collision");
        game.Step(20);
    });
}

TEST_CASE("remembered edges are counted where they are asked, and nowhere else") {
    CheckSameAsStock([](Run &run) {
        Game game(run);
        b2Body *a = Slanting(game, 0.0f), *b = Slanting(game, 0.6f);
        game.Box(a, 2.0f, 0.1f);
        game.Box(b, 2.0f, 0.1f);
        game.Step(5);
        game.Stage(game.world.GetContactCount() == 1 && game.Touching() == 0, "a contact, apart");
        const bmr::Counted s = bmr::internal::ReadCounts();
        run.Expect(!run.Counts() || s.provedApart == 5, "it is answered in each step");
        run.Expect(!run.Counts() || s.edgeChecks == (run.RemembersEdges() ? s.provedApart : 0),
                   "by an edge, if any");
    });
}

TEST_CASE("a new fixture at the address of an old one is not the old one") {
    CheckSameAsStock([](Run &run) {
        Game game(run);
        TwoPlanks planks(game, 0.6f);
        b2Fixture *old = planks.b->GetFixtureList(); // the newest: the right end
        planks.b->DestroyFixture(old);
        b2Fixture *made = game.Box(planks.b, 0.1f, 0.7f, {1.0f, 0.0f});
        game.Stage(made == old, "the same address");
        game.Step();
        game.Stage(game.Touching() >= 1, "a collision");
        game.Step(20);
    });
}

TEST_CASE("a hull that two pairs share is forgotten by both when it grows") {
    CheckSameAsStock([](Run &run) {
        Game game(run);
        b2Body *bodies[3];
        for (int i = 0; i < 3; ++i) {
            bodies[i] = Slanting(game, 0.6f * static_cast<float>(i - 1));
            game.Plank(bodies[i]);
        }
        game.Step(5);
        game.Stage(game.world.GetContactCount() >= 4 && game.Touching() == 0, "two pairs, apart");
        game.StagePairs();
        game.Box(bodies[1], 0.1f, 0.8f, {-1.0f, 0.0f});
        game.Step();
        game.Stage(game.Touching() >= 2, "a collision on either side");
        game.Step(20);
    });
}

TEST_CASE("a sensor that turned solid again collides, also if the hull was built without it") {
    CheckSameAsStock([](Run &run) {
        const NoGameRuns quiet;
        Game game(run);
        b2Body *a = Slanting(game, -0.45f), *b = Slanting(game, 0.0f);
        for (int i = 0; i < 10; ++i)
            game.Box(a, 0.1f, 0.1f, {0.2f * static_cast<float>(i) - 1.9f, 0.0f});
        b2Fixture *turned = game.Box(b, 1.0f, 0.1f, {-1.0f, 0.0f});
        game.Box(b, 0.2f, 0.1f, {1.8f, 0.0f});
        game.Step(5);
        game.StagePairs();
        turned->SetSensor(true);
        game.Step(2);
        // They lie outside the hull: it is built again, now without the sensor.
        for (int i = 0; i < 6; ++i)
            game.Box(b, 0.35f, 0.1f + 0.001f * static_cast<float>(i), {0.4f, -0.45f});
        game.Step(2);
        turned->SetSensor(false);
        game.Step(2);
        game.Stage(game.Touching() == 0, "apart");
        Place(a, Slanted(0.0f, -0.15f));
        game.Step();
        game.Stage(game.Touching() >= 2, "the turned fixture collides");
        game.Step(20);
    });
}

TEST_CASE("a sensor's polygon does not enter its body's hull") {
    CheckSameAsStock([](Run &run) {
        Game game(run);
        b2Body *a = Slanting(game, 0.0f), *b = Slanting(game, 0.6f);
        game.Plank(a);
        b2PolygonShape wide;
        wide.SetAsBox(5.0f, 5.0f);
        game.Fixture(b, wide, true);
        game.Plank(b);
        b->SetLinearVelocity(Slanted(0.01f, 0.0f));
        game.Step(100);
        const bmr::Counted s = bmr::internal::ReadCounts();
        if (run.Counts() && run.RemembersEdges())
            run.Expect(s.provedApart > 4 * s.edgeChecks, "the body pair answers for the planks");
    });
}

TEST_CASE("the hull of a level does not swallow what is inside") {
    CheckSameAsStock([](Run &run) {
        Game game(run);
        b2Body *level = game.Body(b2_staticBody, {0.0f, 0.0f}, kSlant);
        for (const float side : {-4.0f, 4.0f}) {
            game.Box(level, 8.0f, 0.1f, {0.0f, side});
            game.Box(level, 0.1f, 8.0f, {side, 0.0f});
        }
        b2Body *plank = Slanting(game, -3.5f);
        game.Plank(plank);
        plank->SetLinearVelocity(Slanted(0.01f, 0.0f));
        game.Step(100);
        const bmr::Counted s = bmr::internal::ReadCounts();
        game.Stage(game.world.GetContactCount() >= 2, "contacts with the level");
        if (run.Counts() && run.RemembersEdges())
            run.Expect(s.provedApart > 4 * s.edgeChecks, "the pair of wall and plank answers");
        plank->SetLinearVelocity(Slanted(0.1f, -1.0f));
        game.Step(60);
        game.Stage(game.Touching() > 0, "a collision with the level");
    });
}

TEST_CASE("no structure vouches for a body that is far from its own origin, be it the first or the second") {
    CheckSameAsStock([](Run &run) {
        constexpr float kFar = 3000.0f;
        for (const bool farFirst : {false, true}) {
            Game game(run);
            for (const bool far : {farFirst, !farFirst})
                game.Plank(Slanting(game, far ? kFar + 0.6f : 0.0f, far ? b2_kinematicBody : b2_dynamicBody),
                           {0.0f, far ? -kFar : 0.0f});
            game.Step(2);
            game.Stage(game.world.GetContactCount() >= 2 && game.Touching() == 0, "contacts, apart");
            int vouched = 0;
            for (const b2Contact *c = game.world.GetContactList(); c != nullptr; c = c->GetNext())
                vouched += run.HasPlugin() && bmr::Inspect(*c).structure != nullptr;
            run.Expect(vouched == 0, "edges at most");
        }
    });
}

TEST_CASE("teleports of either body are noticed") {
    CheckSameAsStock([](Run &run) {
        Game game(run);
        TwoPlanks planks(game, 0.6f);
        const auto rest = [&planks] {
            for (b2Body *body : {planks.a, planks.b}) {
                body->SetLinearVelocity({0.0f, 0.0f});
                body->SetAngularVelocity(0.0f);
                body->SetTransform(Slanted(0.0f, body == planks.a ? 0.0f : 0.6f), kSlant);
            }
        };
        for (int i = 0; i < 3; ++i) {
            Place(planks.b, Slanted(0.0f, 0.15f)); // A stays
            game.Step();
            game.Stage(game.Touching() > 0, "B came");
            rest();
            game.Step(2);
            game.Stage(game.Touching() == 0, "apart again");
            Place(planks.a, Slanted(0.0f, 0.45f)); // B stays
            game.Step();
            game.Stage(game.Touching() > 0, "A came");
            rest();
            planks.a->SetTransform(Slanted(0.0f, -0.1f), kSlant + 0.001f);
            planks.b->SetTransform(Slanted(0.1f, 0.5f), kSlant);
            game.Step(2);
            planks.b->SetTransform(Slanted(0.1f, 0.5f), -kSlant); // across
            game.Step(2);
            planks.b->SetTransform(Slanted(500.0f, 0.5f), -kSlant); // and back before anybody looks
            rest();
            game.Step(2);
        }
    });
}

TEST_CASE("bullets and sub-steps move bodies in the middle of a step") {
    CheckSameAsStock([](Run &run) {
        for (const bool subStepping : {false, true}) {
            Game game(run, {0.0f, -10.0f});
            game.world.SetSubStepping(subStepping);
            b2Body *wall = game.Body(b2_staticBody, {0.0f, 0.0f}, 0.1f);
            for (int i = -4; i <= 4; ++i)
                game.Box(wall, 0.05f, 0.45f, {0.02f * static_cast<float>(i), static_cast<float>(i)});
            b2Body *hanging = game.Body(b2_dynamicBody, {-0.5f, 1.0f}, 0.3f);
            game.Plank(hanging);
            for (int i = 0; i < 6; ++i) {
                b2Body *bullet = game.Body(
                    b2_dynamicBody, {8.0f + 0.3f * static_cast<float>(i), static_cast<float>(i) - 2.0f},
                    0.4f * static_cast<float>(i));
                game.Box(bullet, 0.2f, 0.1f, {0.1f, 0.0f});
                game.Box(bullet, 0.1f, 0.2f, {-0.1f, 0.0f});
                bullet->SetBullet(true);
                bullet->SetLinearVelocity({-80.0f, 3.0f});
                bullet->SetAngularVelocity(20.0f);
            }
            game.Step(subStepping ? 90 : 60);
        }
    });
}

TEST_CASE("a radius that is changed in place counts at once") {
    CheckSameAsStock([](Run &run) {
        const NoGameRuns quiet;
        Game game(run);
        TwoPlanks planks(game, 0.28f);
        for (const float radius : {0.1f, 0.01f, 0.3f, 0.0f}) {
            for (b2Fixture *f = planks.a->GetFixtureList(); f != nullptr; f = f->GetNext())
                f->GetShape()->m_radius = radius;
            game.Step();
            game.Stage((game.Touching() > 0) == (radius > 0.05f), "the radius decides");
            planks.a->SetTransform({0.0f, 0.0f}, kSlant);
            planks.b->SetTransform(Slanted(0.0f, 0.28f), kSlant);
            for (b2Body *body : {planks.a, planks.b}) {
                body->SetLinearVelocity({0.0f, 0.0f});
                body->SetAngularVelocity(0.0f);
            }
            game.Step();
        }
    });
}

TEST_CASE("vertices that are changed in place count in the next step that the glue is told of") {
    CheckSameAsStock([](Run &run) {
        const NoGameRuns quiet;
        Game game(run);
        TwoPlanks planks(game, 0.6f);
        for (const float thickness : {0.55f, 0.1f, 0.6f}) {
            auto *shape = static_cast<b2PolygonShape *>(planks.b->GetFixtureList()->GetShape());
            shape->SetAsBox(1.0f, thickness, {1.0f, 0.0f}, 0.0f);
            if (run.HasPlugin())
                bmr::CurrentStep() = bmr::NextStep();
            game.Step();
            bmr::CurrentStep() = 0;
            game.Stage((game.Touching() > 0) == (thickness > 0.5f), "the new vertices decide");
            planks.a->SetTransform({0.0f, 0.0f}, kSlant);
            planks.b->SetTransform(Slanted(0.0f, 0.6f), kSlant);
            for (b2Body *body : {planks.a, planks.b}) {
                body->SetLinearVelocity({0.0f, 0.0f});
                body->SetAngularVelocity(0.0f);
            }
            game.Step();
        }
    });
}

TEST_CASE("each vertex that is changed in place is seen") {
    CheckSameAsStock([](Run &run) {
        for (int corners = 3; corners <= 8; ++corners) {
            Game game(run);
            TwoPlanks planks(game, 0.6f);
            b2Vec2 points[8];
            for (int i = 0; i < corners; ++i)
                points[i] =
                    0.3f *
                    b2Rot(static_cast<float>(i) * 2.0f * b2_pi / static_cast<float>(corners)).GetXAxis();
            auto *shape = static_cast<b2PolygonShape *>(planks.b->GetFixtureList()->GetShape());
            shape->Set(points, corners);
            for (int i = -1; i < corners; ++i) { // first that they are other vertices at all
                if (i >= 0) {
                    points[i] *= 1.01f;
                    shape->Set(points, corners); // in the same order
                }
                if (run.HasPlugin())
                    bmr::CurrentStep() = bmr::NextStep();
                const uint64_t before = bmr::internal::ReadCounts().hulls;
                game.Step();
                bmr::CurrentStep() = 0;
                game.Stage(game.Touching() == 0, "apart");
                // (Where edges are remembered, the piece's contacts may be too few for a structure.)
                run.Expect(!run.Counts() || run.RemembersEdges() ||
                               bmr::internal::ReadCounts().hulls > before,
                           "the hull is built anew");
            }
            const uint64_t before = bmr::internal::ReadCounts().hulls;
            if (run.HasPlugin())
                bmr::CurrentStep() = bmr::NextStep();
            game.Step();
            bmr::CurrentStep() = 0;
            run.Expect(bmr::internal::ReadCounts().hulls == before, "control: nothing has changed");
        }
    });
}

namespace {

/// Two diagonal rows of six boxes, one body each, in which one box of each is to become another quadrangle
/// within its row. With the box's normals Box2D gives points of the two quadrangles, though they are apart.
struct DiagonalRows {
    explicit DiagonalRows(Game &game) {
        for (int k = 0; k < 2; ++k) {
            const float place = 0.25f * static_cast<float>(k);
            b2Body *body = game.Body(b2_dynamicBody, {-place, place});
            for (int i = 0; i < 6; ++i) {
                const float at = 0.12f * (static_cast<float>(i) - 2.5f);
                game.Box(body, 0.1f, 0.1f, {at, at});
            }
            shapes[k] = static_cast<b2PolygonShape *>(body->GetFixtureList()->GetShape());
        }
    }
    void MoveVertices() {
        for (int k = 0; k < 2; ++k)
            for (int i = 0; i < 4; ++i)
                shapes[k]->m_vertices[i].Set(kCorners[k][i][0], kCorners[k][i][1]);
    }

    static constexpr float kCorners[2][4][2] = {
        {{0.177f, 0.156f}, {0.214f, 0.2f}, {0.162f, 0.178f}, {0.009f, 0.011f}},
        {{-0.271f, -0.265f}, {0.262f, 0.103f}, {0.247f, 0.209f}, {-0.102f, 0.071f}}};
    b2PolygonShape *shapes[2];
};

void InvalidateAll(Game &game) {
    for (b2Body *body = game.world.GetBodyList(); body != nullptr; body = body->GetNext())
        bmr::Invalidate(body);
}

} // namespace

TEST_CASE("vertices that leave their normals, within the hull, are not proved apart by it") {
    CheckSameAsStock([](Run &run) {
        for (const bool tell : {false, true}) {
            Game game(run, {0.0f, 0.0f});
            DiagonalRows rows(game);
            game.Step(5);
            game.StagePairs();
            game.Stage(game.Touching() == 0, "apart");
            rows.MoveVertices();
            if (run.HasPlugin() && tell)
                InvalidateAll(game);
            if (run.HasPlugin() && !tell)
                bmr::CurrentStep() = bmr::NextStep();
            game.Step();
            bmr::CurrentStep() = 0;
            game.Stage(game.Touching() == 1, "points of the two that were moved");
        }
    });
}

// Nobody sees by himself that normals were changed alone.
TEST_CASE("normals that are changed in place count once the body is invalidated") {
    CheckSameAsStock([](Run &run) {
        Game game(run, {0.0f, 0.0f});
        DiagonalRows rows(game);
        b2Vec2 ofBox[4];
        std::copy_n(rows.shapes[0]->m_normals, 4, ofBox);
        rows.MoveVertices();
        for (b2PolygonShape *shape : rows.shapes)
            for (int i = 0; i < 4; ++i) {
                const b2Vec2 side = shape->m_vertices[(i + 1) % 4] - shape->m_vertices[i];
                shape->m_normals[i].Set(side.y, -side.x);
                shape->m_normals[i].Normalize();
            }
        game.Step(5);
        game.StagePairs();
        game.Stage(game.Touching() == 0, "apart");
        for (b2PolygonShape *shape : rows.shapes)
            std::copy_n(ofBox, 4, shape->m_normals);
        if (run.HasPlugin())
            InvalidateAll(game);
        game.Step();
        game.Stage(game.Touching() == 1, "points of the two that have other normals");
    });
}

TEST_CASE("an edge that was edited away separates nothing") {
    CheckSameAsStock([](Run &run) {
        constexpr float kEighth = 0.785398185f;
        Game game(run);
        b2Body *middle = game.Body(b2_dynamicBody, {0.0f, 0.0f});
        b2Vec2 corners[8];
        for (int i = 0; i < 8; ++i)
            corners[i] = b2Mul(b2Rot((static_cast<float>(i) + 0.5f) * kEighth), b2Vec2(0.5f, 0.0f));
        b2PolygonShape octagon;
        octagon.Set(corners, 8);
        auto *shape = static_cast<b2PolygonShape *>(game.Fixture(middle, octagon)->GetShape());
        // A corner of a box towards each face, so that the octagon's edge is the one to remember.
        for (int i = 0; i < 8; ++i) {
            const b2Rot there(static_cast<float>(i) * kEighth);
            b2Body *body = game.Body(b2_dynamicBody, b2Mul(there, b2Vec2(0.78f, 0.0f)),
                                     (static_cast<float>(i) + 1.0f) * kEighth);
            game.Box(body, 0.12f, 0.12f);
        }
        game.Step(3);
        game.Stage(game.Touching() == 0 && game.world.GetContactCount() >= 8, "a ring, apart");
        shape->SetAsBox(0.75f, 0.75f);
        if (run.HasPlugin())
            bmr::Invalidate(middle);
        game.Step();
        game.Stage(game.Touching() >= 4, "the box reaches into the ring");
        game.Step(10);
    });
}
