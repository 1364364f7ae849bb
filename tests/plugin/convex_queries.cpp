// SPDX-License-Identifier: MIT
// What b2DistanceProxy, b2Distance, b2ShapeCast, b2TimeOfImpact, b2TestOverlap and sensors say of a
// ConvexShape. Built twice: with the library in front of Box2D (CONVEX_REAL 1) it is the real polygon, behind
// it (0) the octagon that Box2D is shown. Each is what the other must not be.
#include <box2d/box2d.h>

#include "boomerang/box2d.h"
#include "cases.h"
#include "convex_oracle.h"

using bmr::ConvexShape;
using namespace oracle;
using namespace shapes;

namespace {

constexpr bool kReal = CONVEX_REAL != 0;

/// A drawer as games write them, with room for one of Box2D's polygons.
struct SmallDrawer : IdleDraw {
    int polygons = 0, vertices = 0;
    b2Vec2 room[b2_maxPolygonVertices];
    void DrawSolidPolygon(const b2Vec2 *v, int32 count, const b2Color &) override {
        ++polygons;
        vertices += count;
        REQUIRE(count <= b2_maxPolygonVertices);
        std::copy_n(v, count, room);
    }
};

std::vector<b2Vec2> Coin(int count, double radius) {
    return shapes::Circle(count, radius, 0.0, 0.0, 3.14159265358979 / count);
}

ConvexShape Make(const std::vector<b2Vec2> &points) {
    ConvexShape shape;
    REQUIRE(shape.Set(points.data(), static_cast<int32>(points.size())) == BMR_OK);
    return shape;
}

/// What the queries are to see of it.
Polygon Seen(const ConvexShape &shape) {
    const b2Vec2 *vertices = kReal ? shape.GetVertices() : shape.m_vertices;
    const int32 count = kReal ? shape.GetVertexCount() : shape.m_count;
    return Polygon({vertices, vertices + count}, shape.m_radius);
}

ConvexShape RandomBig(Engine &engine) {
    constexpr int kCounts[] = {9, 16, 64, 255, 256, 257, 1000, 4096};
    const int count = kCounts[Below(engine, 8)];
    const float width = UniformF(engine, 0.2, 2.0);
    std::vector<b2Vec2> points = Coin(count, Uniform(engine, 0.3, 3.0));
    for (b2Vec2 &p : points)
        p = b2Vec2(width * p.x + 0.5f, p.y - 0.25f);
    return Make(points);
}

b2DistanceInput RandomInput(Engine &engine, const b2Shape &a, const b2Shape &b) {
    b2DistanceInput input;
    input.proxyA.Set(&a, 0);
    input.proxyB.Set(&b, 0);
    input.transformA = shapes::RandomPose(engine, 4.0);
    input.transformB = shapes::RandomPose(engine, 4.0);
    input.useRadii = false;
    return input;
}

} // namespace

TEST_CASE("a proxy has the vertices that are to be seen") {
    Engine engine(1);
    for (int i = 0; i < 20; ++i) {
        const ConvexShape shape = RandomBig(engine), copy(shape);
        for (const ConvexShape *s : {&shape, &copy}) {
            b2DistanceProxy proxy;
            proxy.Set(s, 0);
            CHECK(proxy.m_count == (kReal ? s->GetVertexCount() : 8));
            CHECK(proxy.m_vertices == (kReal ? s->GetVertices() : s->m_vertices));
            CHECK(proxy.m_radius == s->m_radius);
        }
    }
    // Of up to 8 vertices it is any polygon.
    const ConvexShape small = Make(Coin(7, 1.0));
    b2DistanceProxy proxy;
    proxy.Set(&small, 0);
    CHECK(proxy.m_vertices == small.m_vertices);
    CHECK(proxy.m_count == 7);
}

TEST_CASE("b2Distance") {
    Engine engine(2);
    for (int i = 0; i < 60; ++i) {
        const ConvexShape a = RandomBig(engine), b = RandomBig(engine);
        b2PolygonShape box;
        box.SetAsBox(UniformF(engine, 0.1, 1.0), 0.5f);
        const bool both = Below(engine, 2) == 0;
        b2DistanceInput input = both ? RandomInput(engine, a, b) : RandomInput(engine, box, b);
        const Polygon seenA = both ? Seen(a) : Polygon({box.m_vertices, box.m_vertices + 4}, box.m_radius);
        const Polygon seenB = Seen(b);
        b2SimplexCache cache;
        cache.count = 0;
        b2DistanceOutput output;
        for (int k = 0; k < 4; ++k) { // warm from the second on, and moved
            b2Distance(&output, &cache, &input);
            const double truth = Distance(Placed(seenA, input.transformA), Placed(seenB, input.transformB));
            CHECK(std::fabs(double{output.distance} - truth) <= 2e-5);
            CHECK(std::fabs((output.pointA - output.pointB).Length() - output.distance) <= 2e-5f);
            REQUIRE(cache.count >= 1);
            REQUIRE(cache.count <= 3);
            for (int v = 0; v < cache.count; ++v) {
                CHECK(cache.indexA[v] < input.proxyA.m_count);
                CHECK(cache.indexB[v] < input.proxyB.m_count);
            }
            CHECK(output.iterations >= 0);
            // The skins go off from both ends, or the points meet in the middle.
            b2DistanceInput skins = input;
            skins.useRadii = true;
            b2SimplexCache none;
            none.count = 0;
            b2DistanceOutput within;
            b2Distance(&within, &none, &skins);
            const float radii = input.proxyA.m_radius + input.proxyB.m_radius;
            CHECK(std::fabs(within.distance - std::max(0.0f, output.distance - radii)) <= 2e-5f);
            const float gap = (within.pointB - within.pointA).Length();
            CHECK(std::fabs(gap - within.distance) <= (within.distance > 0.0f ? 2e-5f : 0.0f));
            if (k == 1)
                input.transformB.p += b2Vec2(0.05f, -0.1f);
        }
    }
}

TEST_CASE("a cache that was never ours, with any numbers in it") {
    Engine engine(3);
    const ConvexShape a = RandomBig(engine), b = RandomBig(engine);
    b2DistanceInput input = RandomInput(engine, a, b);
    const double truth = Distance(Placed(Seen(a), input.transformA), Placed(Seen(b), input.transformB));
    b2SimplexCache cache;
    cache.metric = 1.0f;
    cache.count = 2;
    for (int i = 0; i < 3; ++i) {
        cache.indexA[i] = static_cast<uint8>(2 * i + 1);
        cache.indexB[i] = static_cast<uint8>(i + 3);
    }
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    CHECK(std::fabs(double{output.distance} - truth) <= 2e-5);
}

TEST_CASE("b2ShapeCast and b2TimeOfImpact, outside of any step") {
    // A coin flies at another: they meet when their rims do, at any angle.
    const ConvexShape coin = Make(Coin(512, 1.0));
    int later = 0;
    for (int i = 0; i < 64; ++i) {
        const float angle = 0.1f * static_cast<float>(i), turn = 0.37f * static_cast<float>(i);
        const b2Vec2 from(10.0f * std::cos(angle), 10.0f * std::sin(angle));
        b2ShapeCastInput cast;
        cast.proxyA.Set(&coin, 0);
        cast.proxyB.Set(&coin, 0);
        cast.transformA.Set(b2Vec2_zero, turn);
        cast.transformB.Set(from, 2.0f * turn);
        cast.translationB = -from;
        b2ShapeCastOutput hit;
        hit.iterations = 0;
        REQUIRE(b2ShapeCast(&hit, &cast));
        CHECK(hit.iterations > 0);
        // Box2D's own casts stop up to half a slop further away.
        const float gap = 10.0f * (1.0f - hit.lambda) - 2.0f;
        CHECK(gap < 2.0f * b2_linearSlop + 0.51f * b2_linearSlop);
        if (kReal)
            CHECK(gap > 2.0f * b2_linearSlop - 0.001f);
        later += gap < 2.0f * b2_linearSlop - 0.001f ? 1 : 0;

        b2TOIInput input;
        input.proxyA = cast.proxyA;
        input.proxyB = cast.proxyB;
        input.sweepA.localCenter.SetZero();
        input.sweepA.c0 = input.sweepA.c = b2Vec2_zero;
        input.sweepA.a0 = input.sweepA.a = turn;
        input.sweepA.alpha0 = 0.0f;
        input.sweepB = input.sweepA;
        input.sweepB.c0 = from;
        input.sweepB.a = turn + 0.5f;
        input.tMax = 1.0f;
        b2TOIOutput impact;
        b2TimeOfImpact(&impact, &input);
        CHECK(impact.state == b2TOIOutput::e_touching);
        const float left = 10.0f * (1.0f - impact.t) - 2.0f;
        CHECK(left < 1.3f * b2_linearSlop);
        if (kReal)
            CHECK(left > 0.7f * b2_linearSlop - 0.001f);
        input.tMax = 0.5f;
        b2TimeOfImpact(&impact, &input);
        CHECK(impact.state == b2TOIOutput::e_separated);
        CHECK(impact.t == 0.5f);
    }
    if (kReal)
        CHECK(later == 0);
    else
        CHECK(later > 30); // the control: octagons meet later
}

namespace {

class Touches : public b2ContactListener {
public:
    void BeginContact(b2Contact *) override { ++begun; }
    int begun = 0;
};

/// Does a still sensor of the shape feel a small disc at this distance from its middle?
bool SensorFeels(const b2Shape &shape, float distance, float angle, bool testOverlap) {
    b2CircleShape disc;
    disc.m_radius = 0.01f;
    const b2Vec2 at(distance * std::cos(angle), distance * std::sin(angle));
    if (testOverlap) {
        return b2TestOverlap(&shape, 0, &disc, 0, b2Transform(b2Vec2_zero, b2Rot(0.0f)),
                             b2Transform(at, b2Rot(0.0f)));
    }
    b2World world(b2Vec2_zero);
    Touches touches;
    world.SetContactListener(&touches);
    b2BodyDef def;
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.isSensor = true;
    world.CreateBody(&def)->CreateFixture(&fixture);
    def.type = b2_dynamicBody;
    def.position = at;
    world.CreateBody(&def)->CreateFixture(&disc, 1.0f);
    for (int i = 0; i < 3; ++i)
        world.Step(1.0f / 60.0f, 8, 3);
    return touches.begun > 0;
}

} // namespace

namespace {

void CheckSensors() {
    const ConvexShape coin = Make(Coin(512, 1.0));
    for (const bool testOverlap : {false, true}) {
        int felt = 0, inside = 0, outside = 0;
        for (int i = 0; i < 40; ++i) {
            const float angle = 0.157f * static_cast<float>(i);
            felt += SensorFeels(coin, 1.01f, angle, testOverlap) ? 1 : 0;
            inside += SensorFeels(coin, 0.9f, angle, testOverlap) ? 1 : 0;
            outside += SensorFeels(coin, 1.03f, angle, testOverlap) ? 1 : 0;
        }
        CHECK(inside == 40);
        CHECK(outside == 0);
        if (kReal)
            CHECK(felt == 40);
        else
            CHECK(felt < 32); // the control: near the octagon's corners alone
    }
}

} // namespace

TEST_CASE("sensors and b2TestOverlap feel what lies between the rim and the octagon") {
    CheckSensors();
    // And where questions are answered before they come to Box2D. (Behind Box2D, Install refuses.)
    CHECK(bmr::Install() == kReal);
    CheckSensors();
}

TEST_CASE("DebugDraw hands over no more than 8 vertices at a time, and nothing is drawn twice") {
    b2World world({0.0f, 0.0f});
    SmallDrawer drawer, other;
    drawer.SetFlags(b2Draw::e_shapeBit);
    world.SetDebugDraw(&drawer);
    const ConvexShape shape = Make(Coin(50, 1.0));
    b2BodyDef def;
    world.CreateBody(&def)->CreateFixture(&shape, 1.0f);
    constexpr int kPieces = 8; // 48 triangles, six to a piece
    for (int frame = 1; frame <= 2; ++frame) {
        drawer.polygons = other.polygons = 0;
        world.DebugDraw();
        CHECK(drawer.polygons == (kReal ? kPieces : 1)); // or the octagon
        bmr::DrawConvexShapes(world, drawer);
        CHECK(drawer.polygons == (kReal ? kPieces : 1 + kPieces));
        bmr::DrawConvexShapes(world, other); // control: nothing was drawn there
        CHECK(other.polygons == kPieces);
        bmr::DrawConvexShapes(world, drawer); // nor since
        CHECK(drawer.polygons == (kReal ? 2 * kPieces : 1 + 2 * kPieces));
    }
}
