// SPDX-License-Identifier: MIT
// Contacts of big ConvexShapes: with every kind of shape, at rest and rolling, born and ended in every way,
// told of as Box2D tells of its own, with the plugin installed in any of its forms or not at all.
#include "as_stock.h"
#include "boomerang/convex_shape.h"
#include "box2d_shapes.h"
#include "start/install.h"

using bmr::ConvexShape;
using namespace as_stock;

namespace {

constexpr float kRadius = 0.5f;
constexpr float kPi = 3.14159265358979f;

/// With an edge at the bottom: one that an octagon of its vertices does not have.
ConvexShape Coin(int32 count, float radius = kRadius) {
    const double turned = double{kPi} / count - 0.5 * double{kPi};
    const std::vector<b2Vec2> vertices = shapes::Circle(count, double{radius}, 0.0, 0.0, turned);
    ConvexShape shape;
    REQUIRE(shape.Set(vertices.data(), count) == BMR_OK);
    return shape;
}

b2EdgeShape Edge(bool oneSided) {
    b2EdgeShape edge;
    const b2Vec2 left(-5.0f, 0.0f), right(5.0f, 0.0f);
    if (oneSided)
        edge.SetOneSided(right + b2Vec2(1.0f, 0.0f), right, left, left - b2Vec2(1.0f, 0.0f));
    else
        edge.SetTwoSided(left, right);
    return edge;
}

b2ChainShape Chain() {
    b2Vec2 points[11];
    for (int i = 0; i < 11; ++i)
        points[i].Set(5.0f - Real(i), 0.0f);
    b2ChainShape chain;
    chain.CreateChain(points, 11, {6.0f, 0.0f}, {-6.0f, 0.0f});
    return chain;
}

b2Body *Falling(Game &game, b2Vec2 place) {
    return game.Body(b2_dynamicBody, place);
}

} // namespace

AS_STOCK("a wheel rolls over the joints of a one-sided chain, and another passes from behind") {
    Heard game(run, {0.0f, -10.0f});
    game.Fixture(game.Body(b2_staticBody, {0.0f, 0.0f}), Chain());
    b2Body *wheel = Falling(game, {-4.0f, kRadius + 0.01f}), *below = Falling(game, {3.0f, -1.0f});
    game.Fixture(wheel, Coin(512));
    wheel->SetLinearVelocity({1.0f, 0.0f});
    wheel->SetAngularVelocity(-2.0f);
    game.Fixture(below, Coin(64));
    below->SetLinearVelocity({0.0f, 9.0f});
    game.Step(60);
    game.Stage(below->GetPosition().y > 0.0f, "it came through from behind");
    game.Step(140);
    game.Stage(wheel->GetPosition().x > -1.2f, "it rolled over several links");
}

AS_STOCK("bodies of many big shapes share a structure that holds their real polygons") {
    Heard game(run);
    b2Body *a = game.Body(b2_dynamicBody, {0.0f, 0.0f}, 0.785f),
           *b = game.Body(b2_dynamicBody, {0.0f, 2.0f}, 0.785f);
    for (b2Body *body : {a, b}) {
        body->SetSleepingAllowed(false);
        for (int i = 0; i < 10; ++i) {
            ConvexShape piece;
            REQUIRE(piece.SetRounded(0.2f, 0.1f, 0.05f, i % 2 == 0 ? 4 : 40) == BMR_OK);
            std::vector<b2Vec2> moved(piece.GetVertices(), piece.GetVertices() + piece.GetVertexCount());
            for (b2Vec2 &v : moved)
                v.x += 0.4f * Real(i) - 1.8f;
            REQUIRE(piece.Set(moved.data(), static_cast<int32>(moved.size())) == BMR_OK);
            game.Fixture(body, piece);
        }
    }
    b->SetTransform(b2Mul(b2Rot(0.785f), b2Vec2(0.0f, 0.5f)), 0.785f);
    game.Step(4);
    game.Stage(game.world.GetContactCount() >= 10 && game.Touching() == 0, "contacts, apart");
    game.StagePairs();
    b->SetLinearVelocity(b2Mul(b2Rot(0.785f), b2Vec2(0.1f, -1.0f)));
    game.Step(60);
    game.Stage(a->GetLinearVelocity().Length() > 0.1f, "a collision");
}

AS_STOCK("far from the origin nothing is proved apart that has points") {
    constexpr float kFar = 100000.0f; // floats are 8 mm apart
    // Sharp ends that meet head-on: their sides hardly separate them.
    std::vector<b2Vec2> vertices = {{1.0f, 0.0f}};
    for (int i = 0; i <= 12; ++i)
        vertices.push_back(0.25f * b2Rot(kPi * (0.5f + Real(i) / 12.0f)).GetXAxis());
    ConvexShape shape;
    run.Stage(shape.Set(vertices.data(), static_cast<int32>(vertices.size())) == BMR_OK, "a shape");
    Heard game(run);
    b2Body *const a = game.Body(b2_dynamicBody, {kFar, kFar});
    b2Body *const b = game.Body(b2_dynamicBody, {kFar + 2.0f, kFar});
    game.Fixture(a, shape);
    game.Fixture(b, shape);
    shapes::Engine engine(12);
    for (int i = 0; i < 4000; ++i) {
        const float angle = shapes::UniformF(engine, -3.2, 3.2);
        const b2Vec2 ends(2.0f + shapes::UniformF(engine, 0.02, 0.06), shapes::UniformF(engine, -0.01, 0.01));
        a->SetTransform({kFar, kFar}, angle);
        b->SetTransform(b2Vec2(kFar, kFar) + b2Mul(b2Rot(angle), ends), angle + kPi);
        game.Step(1, 0.0f);
    }
    run.ExpectCounted(bmr::internal::ReadCounts().evaluations > 1000, "they are looked at");
}

namespace {

/// A game's own contact between polygons: it counts.
class Counted : public b2Contact {
public:
    static void Register() { AddType(Create, Destroy, b2Shape::e_polygon, b2Shape::e_polygon); }
    static int alive, made;

private:
    Counted(b2Fixture *a, b2Fixture *b) : b2Contact(a, 0, b, 0) {}
    void Evaluate(b2Manifold *manifold, const b2Transform &xfA, const b2Transform &xfB) override {
        b2CollidePolygons(manifold, static_cast<const b2PolygonShape *>(m_fixtureA->GetShape()), xfA,
                          static_cast<const b2PolygonShape *>(m_fixtureB->GetShape()), xfB);
    }
    static b2Contact *Create(b2Fixture *a, int32, b2Fixture *b, int32, b2BlockAllocator *allocator) {
        ++alive;
        ++made;
        return new (allocator->Allocate(sizeof(Counted))) Counted(a, b);
    }
    static void Destroy(b2Contact *contact, b2BlockAllocator *allocator) {
        --alive;
        static_cast<Counted *>(contact)->~Counted();
        allocator->Free(contact, sizeof(Counted));
    }
};
int Counted::alive = 0, Counted::made = 0;

} // namespace

TEST_CASE("what a game had put into the register goes on making what is not ours") {
    const std::string text = InChild([](Run &run) {
        { // Box2D fills its register at the first contact
            Heard game(run);
            game.Wall({0.0f, 0.0f}, {1.0f, 1.0f});
            game.Box({0.5f, 0.0f}, {1.0f, 1.0f});
            game.world.Step(0.0f, 1, 1);
        }
        Counted::Register();
        const ConvexShape first = Coin(64); // Box2D is looked at: contacts are made
        const int madeBefore = Counted::made, aliveBefore = Counted::alive;
        Heard game(run, {0.0f, -10.0f});
        game.Wall({0.0f, -1.0f}, {5.0f, 1.0f});
        b2Body *box = Falling(game, {-2.0f, 0.5f}), *coin = Falling(game, {2.0f, 0.6f});
        game.Box(box, 0.2f, 0.2f);
        game.Fixture(coin, first);
        game.Step(60);
        const int made = Counted::made - madeBefore, alive = Counted::alive - aliveBefore;
        game.Stage(game.Touching() == 2, "two contacts that touch");
        game.world.DestroyBody(box);
        game.world.DestroyBody(coin);
        game.Stage(made == 1 && alive == 1 && Counted::alive == aliveBefore, "one is made, and destroyed");
    });
    CHECK(Difference(text, text) == "");
}

TEST_CASE("where Box2D is unknown a big shape is refused and stays what it was, a small one is not") {
    CHECK(InChild([](Run &run) {
              bmr::SetLibraryCheck([] { return "a test says so"; });
              ConvexShape shape;
              const bmr_error small = shape.SetRegular(6, 1.0f), big = shape.SetRegular(64, 1.0f);
              run.Print("%d %d %d", small == BMR_OK, big == BMR_ERROR_UNSUPPORTED, shape.GetVertexCount());
          }) == "1 1 6\n");
}

namespace {

/// Random polygons of Box2D's own size in a heap; `make` adds each to its body.
template <typename Add> void SmallHeap(Run &run, Add add) {
    Heard game(run, {0.0f, -10.0f});
    shapes::Engine engine(77);
    game.Fixture(game.Body(b2_staticBody, {0.0f, 0.0f}), Chain());
    for (int i = 0; i < 60; ++i) {
        b2Body *body = game.Body(b2_dynamicBody, {shapes::UniformF(engine, -3.0, 3.0), 1.0f + 0.4f * Real(i)},
                                 shapes::UniformF(engine, -3.0, 3.0));
        const b2PolygonShape polygon = shapes::RandomPolygon(engine, 0.8);
        add(game, body, polygon);
    }
    game.Step(200);
}

} // namespace

TEST_CASE("up to 8 vertices all is as with Box2D's own polygons, to the bit") {
    const Scenario convex = [](Run &run) {
        SmallHeap(run, [](Game &game, b2Body *body, const b2PolygonShape &p) {
            b2PolygonShape again;
            again.Set(p.m_vertices, p.m_count);
            ConvexShape shape;
            const bmr_error error = shape.Set(p.m_vertices, p.m_count);
            game.Stage(error == BMR_OK && shape.m_count == again.m_count, bmr_error_describe(error));
            game.Fixture(body, shape);
        });
    };
    const Scenario plain = [](Run &run) {
        SmallHeap(run, [](Game &game, b2Body *body, const b2PolygonShape &p) {
            b2PolygonShape again;
            again.Set(p.m_vertices, p.m_count);
            game.Fixture(body, again);
        });
    };
    const Scenario nudged = [](Run &run) {
        SmallHeap(run, [](Game &game, b2Body *body, const b2PolygonShape &p) {
            b2Vec2 vertices[b2_maxPolygonVertices];
            std::copy_n(p.m_vertices, p.m_count, vertices);
            vertices[0].x = std::nextafter(vertices[0].x, 1e9f);
            ConvexShape shape;
            shape.Set(vertices, p.m_count);
            game.Fixture(body, shape);
        });
    };
    const std::string reference = InChild(plain);
    CHECK(reference.size() > 5000);
    const bmr::Options defaults;
    for (const bmr::Options *options : {static_cast<const bmr::Options *>(nullptr), &defaults})
        CHECK(Difference(reference, InChild(convex, options)) == "");
    CHECK(InChild(nudged) != reference);
}

namespace {

b2PolygonShape Box() {
    b2PolygonShape box;
    box.SetAsBox(5.0f, 1.0f, {0.0f, -1.0f}, 0.0f);
    return box;
}

b2CircleShape Circle() {
    b2CircleShape circle;
    circle.m_radius = 40.0f;
    circle.m_p.Set(0.0f, -40.0f);
    return circle;
}

/// Whose upper side is at 0.
template <typename Visit> void WithEveryGround(Visit visit) {
    visit("box", Box());
    visit("circle", Circle());
    visit("edge", Edge(false));
    visit("one-sided edge", Edge(true));
    visit("chain", Chain());
    ConvexShape big;
    const b2Vec2 side[] = {{5.0f, 0.0f},   {-5.0f, 0.0f}, {-5.2f, -0.1f}, {-5.3f, -0.2f}, {-5.2f, -1.8f},
                           {-5.0f, -2.0f}, {5.0f, -2.0f}, {5.2f, -1.8f},  {5.3f, -0.2f},  {5.2f, -0.1f}};
    REQUIRE(big.Set(side, 10) == BMR_OK);
    REQUIRE(big.GetVertexCount() == 10);
    visit("big", big);
}

/// How far the lowest vertex is above 0, skins left out.
float Gap(const b2Body *body) {
    const ConvexShape *shape = ConvexShape::From(body->GetFixtureList()->GetShape());
    float lowest = INFINITY;
    for (int32 i = 0; i < shape->GetVertexCount(); ++i)
        lowest = std::min(lowest, body->GetWorldPoint(shape->GetVertex(i)).y);
    return lowest;
}

} // namespace

AS_STOCK("a big shape rests with its own edge on every kind of shape, in either order") {
    for (const int32 count : {9, 64, 1024}) {
        for (const bool groundFirst : {true, false}) {
            WithEveryGround([&](const char *name, const b2Shape &ground) {
                Heard game(run, {0.0f, -10.0f});
                run.Print("%s, %d", name, count);
                b2Body *below = game.Body(b2_staticBody, {0.0f, 0.0f});
                if (groundFirst)
                    game.Fixture(below, ground);
                b2Body *coin = Falling(game, {0.3f, kRadius + 0.1f});
                game.Fixture(coin, Coin(count));
                if (!groundFirst)
                    game.Fixture(below, ground);
                game.Step(90);
                game.Stage(game.Touching() == 1, "one contact that touches");
                // The octagon that Box2D is shown would sink in until its own lowest vertex is here:
                // 0.038 deeper.
                const float gap = Gap(coin), middle = coin->GetPosition().y;
                const float skins = ground.m_radius + b2_polygonRadius;
                const float skin = ground.GetType() == b2Shape::e_circle ? b2_polygonRadius : skins;
                game.Stage(gap > skin - 4.0f * b2_linearSlop && gap < skin + 2.0f * b2_linearSlop,
                           "it lies on its lowest edge or vertex");
                game.Stage(middle > kRadius * std::cos(kPi / Real(count)) - 0.02f,
                           "its middle is as high as the real polygon holds it");
            });
        }
    }
}
