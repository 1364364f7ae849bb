// SPDX-License-Identifier: MIT
// Shapes that a game changes in place, unannounced.
#include "yard.h"

using namespace as_stock;

AS_STOCK("each vertex that is changed in place is seen") {
    for (int corners = 3; corners <= 8; ++corners) {
        Heard game(run);
        TwoPlanks planks(game, 0.6f);
        b2Vec2 points[8];
        for (int i = 0; i < corners; ++i)
            points[i] = 0.3f * b2Rot(Real(i) * 2.0f * b2_pi / Real(corners)).GetXAxis();
        auto *shape = static_cast<b2PolygonShape *>(planks.b->GetFixtureList()->GetShape());
        shape->Set(points, corners);
        for (int i = -1; i < corners; ++i) { // first that they are other vertices at all
            if (i >= 0) {
                points[i] *= 1.01f;
                shape->Set(points, corners); // in the same order
            }
            const uint64_t before = bmr::internal::ReadCounts().hulls;
            game.Step();
            game.Stage(game.Touching() == 0, "apart");
            run.ExpectCounted(run.RemembersEdges() || bmr::internal::ReadCounts().hulls > before,
                              "the hull is built anew");
        }
        const uint64_t before = bmr::internal::ReadCounts().hulls;
        game.Step();
        run.Expect(bmr::internal::ReadCounts().hulls == before, "control: nothing has changed");
    }
}

namespace {

/// Two diagonal rows of six boxes, one body each, in which one box of each is to become another quadrangle
/// within its row. With the box's normals Box2D gives points of the two quadrangles, though they are apart.
struct DiagonalRows {
    explicit DiagonalRows(Game &game, float skin = b2_polygonRadius) {
        for (int k = 0; k < 2; ++k) {
            const float place = 0.25f * Real(k);
            b2Body *body = game.Body(b2_dynamicBody, {-place, place});
            for (int i = 0; i < 6; ++i) {
                const float at = 0.12f * (Real(i) - 2.5f);
                game.Box(body, 0.1f, 0.1f, {at, at})->GetShape()->m_radius = skin;
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

} // namespace

// No hull is built of them. Its radius is 0: that of fixtures without skins is no larger.
AS_STOCK("vertices that leave their normals, within the hull, are not proved apart by it") {
    for (const float skin : {b2_polygonRadius, 0.0f}) {
        Heard game(run, {0.0f, 0.0f});
        DiagonalRows rows(game, skin);
        game.Step(5);
        game.StagePairs();
        game.Stage(game.Touching() == 0, "apart");
        rows.MoveVertices();
        game.Step();
        game.Stage(game.Touching() == (skin > 0.0f ? 1 : 0), "points of the two that were moved");
    }
    Heard game(run, {0.0f, 0.0f});
    DiagonalRows rows(game, 0.0f);
    rows.MoveVertices(); // before there is a contact
    game.Step(5);
    game.StagePairs();
}

AS_STOCK("normals that are changed in place count, though no vertex is another one") {
    Heard game(run, {0.0f, 0.0f});
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
    game.Step();
    game.Stage(game.Touching() == 1, "points of the two that have other normals");
}

AS_STOCK("an edge that was edited away separates nothing") {
    constexpr float kEighth = 0.785398185f;
    Heard game(run);
    b2Body *middle = game.Body(b2_dynamicBody, {0.0f, 0.0f});
    b2Vec2 corners[8];
    for (int i = 0; i < 8; ++i)
        corners[i] = b2Mul(b2Rot((Real(i) + 0.5f) * kEighth), b2Vec2(0.5f, 0.0f));
    b2PolygonShape octagon;
    octagon.Set(corners, 8);
    auto *shape = static_cast<b2PolygonShape *>(game.Fixture(middle, octagon)->GetShape());
    // A corner of a box towards each face, so that the octagon's edge is the one to remember.
    for (int i = 0; i < 8; ++i) {
        const b2Rot there(Real(i) * kEighth);
        game.Box(b2Mul(there, b2Vec2(0.78f, 0.0f)), {0.12f, 0.12f}, (Real(i) + 1.0f) * kEighth);
    }
    game.Step(3);
    game.Stage(game.Touching() == 0 && game.world.GetContactCount() >= 8, "a ring, apart");
    shape->SetAsBox(0.75f, 0.75f);
    game.Step();
    game.Stage(game.Touching() >= 4, "the box reaches into the ring");
    game.Step(10);
}
