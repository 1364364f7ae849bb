// SPDX-License-Identifier: MIT
// bmr::ConvexShape and bmr::OutlineShape, and what the glue shows of a contact. What refuses leaves the
// shape, the outline or the body as it was.
#include <cfloat>

#include <box2d/box2d.h>

#include "boomerang/convex_shape.h"
#include "boomerang/outline_shape.h"
#include "contracts.h"
#include "debug/inspect.h"

using namespace contracts;

namespace {

/// So many vertices: of a large circle how many are left depends on how its points were rounded.
std::string CountOf(size_t count, size_t given) {
    return count > 10000 && count < given ? "fewer vertices" : VerticesOf(count);
}

/// Points in rows of 256: a square of 4 vertices, or of 5 where the last row is short.
std::vector<bmr_vec2> Grid(size_t count) {
    std::vector<bmr_vec2> points;
    for (size_t i = 0; i < count; ++i)
        points.push_back({static_cast<double>(i % 256), static_cast<double>(i / 256)});
    return points;
}

/// Every second point, then the others.
std::vector<bmr_vec2> TwiceAround(const std::vector<bmr_vec2> &points) {
    std::vector<bmr_vec2> star;
    for (size_t i = 0; i < points.size(); ++i)
        star.push_back(points[2 * i % points.size()]);
    return star;
}

/// A bad vertex array, and what Set and SetRaw say to it.
struct Vertices {
    std::string name;
    std::vector<bmr_vec2> points;
    Answer hull, raw;
};

/// (What core says of points at random: tests/random/fuzz_polygon.cpp, polygon32.cpp.)
std::vector<Vertices> BadVertexArrays() {
    using Points = std::vector<bmr_vec2>;
    const Answer few = BMR_ERROR_TOO_FEW_POINTS, many = BMR_ERROR_TOO_MANY_POINTS,
                 dented = BMR_ERROR_NOT_CONVEX, far = BMR_ERROR_OUT_OF_RANGE, nan = BMR_ERROR_NOT_FINITE,
                 close = BMR_ERROR_TOO_CLOSE, fewer = "fewer vertices";
    const auto made = [](size_t count) { return Answer(VerticesOf(count)); };
    Points line;
    for (int i = 0; i < 20; ++i)
        line.push_back({1.0 * i, 2.0 * i});
    std::vector<Vertices> all = {
        {"one point", {{1, 2}}, few, few},
        {"two points", {{1, 2}, {3, 4}}, few, few},
        {"two equal points", {{1, 2}, {1, 2}}, few, few},
        {"3 points on a line", {{0, 0}, {1, 1}, {2, 2}}, few, few},
        {"20 points on a line", line, few, dented},
        {"20 equal points", Points(20, {1, 1}), few, far},
        {"a triangle as good as without a width", {{0, 0}, {1, 0}, {0.5, 1e-8}}, far, far},
        {"a triangle smaller than Box2D's slop", {{0, 0}, {3e-3, 0}, {0, 3e-3}}, made(3), made(3)},
        {"a pentagram", TwiceAround(Ellipse(5)), made(5), dented},
        {"a star of 21 points, twice around", TwiceAround(Ellipse(21)), made(21), dented},
        {"65,535 points on a circle", Ellipse(65535, 1000, 1000), fewer, dented},
        {"65,536 points on a circle", Ellipse(65536, 1000, 1000), fewer, many},
        {"65,536 points in a square", Grid(65536), made(4), many}};
    for (const size_t n : {size_t{4}, size_t{20}}) {
        const Points shape = n == 20 ? Ellipse(20) : Points{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        const auto changed = [&](const char *how, const Answer &hull, const Answer &raw,
                                 const std::function<void(Points &)> &change) {
            Points points = shape;
            change(points);
            all.push_back({"a polygon of " + std::to_string(n) + how, points, hull, raw});
        };
        const auto scaled = [&](const char *how, double factor, const Answer &answer) {
            changed(how, answer, answer, [factor](Points &p) {
                for (bmr_vec2 &point : p)
                    point = {point.x * factor, point.y * factor};
            });
        };
        // A shape of up to 8 points takes, welds and turns what Box2D does.
        const bool small = n == 4;
        const Answer whole = made(n), tiny = small ? close : far;
        changed(" with a NaN", nan, nan, [](Points &p) { p[1].y = kNaN; });
        changed(" with an infinity", nan, nan, [](Points &p) { p[1].y = kInfinity; });
        changed(" with a negative infinity", nan, nan, [](Points &p) { p[2].x = -kInfinity; });
        changed(" with a coordinate of 1e38", far, far, [](Points &p) { p[1].x = 1e38; });
        changed(" with a coordinate beyond 1e9", small ? made(4) : far, small ? dented : far,
                [](Points &p) { p[2].y = -1.0000001e9; });
        changed(" with a coordinate of 1e-38", small ? whole : made(19), small ? whole : dented,
                [](Points &p) { p[1].x = 1e-38; });
        changed(", every point twice", whole, small ? close : dented, [](Points &p) {
            for (size_t i = 0; i < p.size(); i += 2)
                p.insert(p.begin() + static_cast<ptrdiff_t>(i), Points::value_type(p[i]));
        });
        changed(", clockwise", whole, dented, [](Points &p) { std::reverse(p.begin(), p.end()); });
        changed(" with two vertices exchanged", whole, dented, [](Points &p) { std::swap(p[1], p[2]); });
        changed(" with a dent", made(n - 1), dented, [](Points &p) {
            p[1] = {-0.1 * p[1].x, -0.1 * p[1].y};
        });
        if (small) // the middles of the other's sides are rounded
            changed(" with a vertex in the middle of a side", whole, dented, [](Points &p) {
                p.insert(p.begin() + 1, {(p[0].x + p[1].x) / 2, (p[0].y + p[1].y) / 2});
            });
        scaled(", as it is", 1.0, whole);
        scaled(" of half width 1e-38", 1e-38, tiny);
        scaled(" of half width 4e-10", 4e-10, tiny);
        scaled(" of half width 1e-9", 1e-9, tiny);
        scaled(" of half width 1e9", 1e9, whole);
        scaled(" of half width 1e38", 1e38, far);
    }
    return all;
}

/// What a setter says to this shape, and whether an error left it as it was, with its vertices. A skin stays.
std::string SetOf(bmr::ConvexShape &shape, const std::function<bmr_error(bmr::ConvexShape &)> &set,
                  size_t given) {
    shape.m_radius = 0.125f;
    const std::vector<b2Vec2> vertices(shape.GetVertices(), shape.GetVertices() + shape.GetVertexCount());
    unsigned char before[sizeof shape];
    std::memcpy(before, static_cast<const void *>(&shape), sizeof shape);
    const bmr_error error = set(shape);
    if (error == BMR_OK && shape.m_radius != 0.125f)
        return "another skin";
    if (error == BMR_OK)
        return CountOf(static_cast<size_t>(shape.GetVertexCount()), given);
    const bool same = std::memcmp(before, static_cast<const void *>(&shape), sizeof shape) == 0 &&
                      std::equal(vertices.begin(), vertices.end(), shape.GetVertices());
    return same ? Answer(error).text : "the shape is not as it was";
}

/// What a setter says to a shape of 12 vertices, and to a box, whose vertices lie in the shape itself.
std::string SetTo(const std::function<bmr_error(bmr::ConvexShape &)> &set, size_t given = 0) {
    bmr::ConvexShape large, box;
    if (large.SetRegular(12, 3.0f) != BMR_OK)
        return "no shape to begin with";
    box.SetAsBox(1.0f, 2.0f);
    const std::string said = SetOf(large, set, given), saidOfBox = SetOf(box, set, given);
    // (Simplify leaves a box its 4 vertices.)
    return saidOfBox == said || saidOfBox == "4 vertices" ? said : "a box says: " + saidOfBox;
}

std::vector<b2Vec2> Vectors(const std::vector<bmr_vec2> &points) {
    std::vector<b2Vec2> made;
    for (const bmr_vec2 &p : points)
        made.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
    return made;
}

size_t AtLeast0(double value) {
    return static_cast<size_t>(std::max(value, 0.0));
}

const Rules kSize = kFinite + kAboveZero, kAbove2 = Gives(BMR_ERROR_TOO_FEW_POINTS, {INT_MIN, -1, 0, 1, 2}),
            kMany = kAbove2 + Gives("3 vertices", {3}) + Gives("16383 vertices", {16383}) +
                    Gives("fewer vertices", {16384, 65535}) +
                    Gives(BMR_ERROR_TOO_MANY_POINTS, {65536, INT_MAX}),
            kRound = kSize + OutOfRange({1e-38, 1e-9, 1e38, FLT_MAX}) + Gives("20 vertices", {1e9});

} // namespace

TEST_CASE("boomerang/convex_shape.h: setters") {
    using Setter = bmr_error (bmr::ConvexShape::*)(const b2Vec2 *, int32);
    for (const Setter set : {&bmr::ConvexShape::Set, &bmr::ConvexShape::SetRaw}) {
        const bool raw = set == &bmr::ConvexShape::SetRaw;
        for (const Vertices &vertices : BadVertexArrays()) {
            CAPTURE(vertices.name);
            const std::vector<b2Vec2> points = Vectors(vertices.points);
            const auto count = static_cast<int32>(points.size());
            const std::string said = SetTo(
                [&](bmr::ConvexShape &shape) { return (shape.*set)(points.data(), count); }, points.size());
            CHECK(said == (raw ? vertices.raw : vertices.hull).text);
        }
        for (const int32 count : {0, 4})
            CHECK(SetTo([&](bmr::ConvexShape &shape) { return (shape.*set)(nullptr, count); }) ==
                  Answer(BMR_ERROR_NULL_ARGUMENT).text);
        // So many points in a square.
        const Rules counts = kAbove2 + Gives(BMR_ERROR_TOO_FEW_POINTS, {3}),
                    hull = counts + Gives("5 vertices", {16383, 65535}) + Gives("4 vertices", {16384}),
                    asItIs = counts + Gives(BMR_ERROR_NOT_CONVEX, {16383, 16384}) +
                             Gives(BMR_ERROR_TOO_MANY_POINTS, {65536, INT_MAX});
        Row(
            raw ? "SetRaw" : "Set",
            [&](Asked &ask) {
                const double count = ask.Number("count", raw ? 65535 : 65536, raw ? asItIs : hull);
                std::vector<b2Vec2> points = Vectors(Grid(std::min(AtLeast0(count), size_t{65536})));
                points.reserve(1); // there is an array, of no points
                return SetTo(
                    [&](bmr::ConvexShape &shape) {
                        return (shape.*set)(points.data(), static_cast<int32>(count));
                    },
                    AtLeast0(count));
            },
            raw ? Answer(BMR_ERROR_NOT_CONVEX) : "4 vertices");
    }
    Row(
        "SetAsBox",
        [](Asked &ask) {
            static const Rules any =
                kFinite + Gives("4 vertices", {-0.0, -1, 1e-38, 1e-9, 1e9, 1e38, FLT_MAX});
            const float half = ask.Float("half width", 1,
                                         kSize + Gives("4 vertices", {1e-38, 1e-9, 1e9, 1e38, FLT_MAX})),
                        y = ask.Float("y of the centre", 0, any), angle = ask.Float("angle", 0, any);
            return SetTo([&](bmr::ConvexShape &shape) {
                return y == 0.0f && angle == 0.0f ? shape.SetAsBox(half, 1.0f)
                                                  : shape.SetAsBox(half, 1.0f, {0.0f, y}, angle);
            });
        },
        "4 vertices");
    Row(
        "SetRegular",
        [](Asked &ask) {
            const double count = ask.Number("count", 20, kMany);
            const float radius = ask.Float("radius", 1000, kRound);
            return SetTo(
                [&](bmr::ConvexShape &shape) { return shape.SetRegular(static_cast<int32>(count), radius); },
                AtLeast0(count));
        },
        "20 vertices");
    Row(
        "SetEllipse",
        [](Asked &ask) {
            const double count = ask.Number("count", 20, kMany);
            const float height = ask.Float("height", 500, kRound);
            return SetTo(
                [&](bmr::ConvexShape &shape) {
                    return shape.SetEllipse(static_cast<int32>(count), height == 500.0f ? 1000.0f : 1.0f,
                                            height);
                },
                AtLeast0(count));
        },
        "20 vertices");
    Row(
        "SetRounded",
        [](Asked &ask) {
            const Rules halves = kSize + Gives(BMR_ERROR_CORNER_TOO_LARGE, {1e-38, 1e-9}) +
                                 Gives("4 vertices", {1e9}) + OutOfRange({1e38, FLT_MAX}),
                        radii = kSize + Gives("4 vertices", {1e-38, 1e-9}) +
                                Gives(BMR_ERROR_CORNER_TOO_LARGE, {1e9, 1e38, FLT_MAX});
            const float half = ask.Float("half width", 2, halves),
                        radius = ask.Float("radius of a corner", 0.5f, radii);
            return SetTo([&](bmr::ConvexShape &shape) { return shape.SetRounded(half, 1.0f, radius, 4); });
        },
        "16 vertices");
    Row(
        "SetRounded, of 1 km",
        [](Asked &ask) {
            const Rules counts = Gives(BMR_ERROR_TOO_FEW_POINTS, {INT_MIN, -1, 0, 1}) +
                                 Gives("6 vertices", {2}) + Gives("fewer vertices", {16383}) +
                                 Gives(BMR_ERROR_TOO_MANY_POINTS, {16384, 65535, 65536, INT_MAX});
            const double count = ask.Number("count of a corner", 3, counts);
            return SetTo(
                [&](bmr::ConvexShape &shape) {
                    return shape.SetRounded(1000.0f, 500.0f, 500.0f, static_cast<int32>(count));
                },
                4 * AtLeast0(count));
        },
        "10 vertices");
    Row(
        "Simplify",
        [](Asked &ask) {
            const Rules tolerances = kNotNegative + Gives(BMR_ERROR_NEGATIVE, {-kInfinity}) +
                                     Gives(BMR_ERROR_NOT_FINITE, {kNaN}) +
                                     Gives("12 vertices", {-0.0, 1e-38, 1e-9}) +
                                     Gives("3 vertices", {kInfinity, 1e9, 1e38, FLT_MAX});
            const float tolerance = ask.Float("tolerance", 0, tolerances);
            return SetTo([&](bmr::ConvexShape &shape) { return shape.Simplify(tolerance); });
        },
        "12 vertices");
    bmr::ConvexShape never;
    CHECK(never.Simplify(0.01f) == BMR_ERROR_TOO_FEW_POINTS);
    CHECK(bmr::ConvexShape(never).GetVertexCount() == 0);
    CHECK(bmr::ConvexShape::From(static_cast<const b2Shape *>(nullptr)) == nullptr);
}

// --- shapes and bodies in a world ---

namespace {

/// Two bodies with a big shape each, near each other, and their contact.
struct World {
    b2World world{b2Vec2(0.0f, 0.0f)};
    b2Body *a, *b;

    World() {
        static const bool installed = bmr::Install();
        CHECK(installed);
        bmr::ConvexShape shape;
        shape.SetRegular(30, 1.0f);
        for (b2Body **body : {&a, &b}) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.position.Set(body == &a ? 0.0f : 2.2f, 0.0f);
            *body = world.CreateBody(&def);
            (*body)->CreateFixture(&shape, 1.0f);
        }
        world.Step(1.0f / 60.0f, 8, 3);
    }
    const bmr::ConvexShape &Shape() const { return *bmr::ConvexShape::From(a->GetFixtureList()->GetShape()); }
};

const b2Transform kHere(b2Vec2(0.0f, 0.0f), b2Rot(0.0f));

} // namespace

TEST_CASE("questions about a contact, and about a shape") {
    const World world;
    const auto shown = [&world] {
        return std::string(bmr::internal::Inspect(*world.world.GetContactList()).kind);
    };
    CHECK(shown() == "remembered-edge");
    world.b->SetTransform({NAN, 0.0f}, 0.0f);
    CHECK(shown() == "none");
    Row(
        "ConvexShape::RayCast",
        [&world](Asked &ask) {
            const float from = ask.Float("from", -5, Gives("no hit", {kNaN})),
                        to = ask.Float("to", 5, Gives("no hit", {kInfinity, -5})),
                        most = ask.Float("fraction", 1, Gives("hit", {kNaN}) + Gives("no hit", {-1}));
            b2RayCastOutput output;
            return world.Shape().RayCast(&output, {{from, 0.0f}, {to, 0.0f}, most}, kHere, 0) ? "hit"
                                                                                              : "no hit";
        },
        "hit");
    Row(
        "ConvexShape::TestPoint",
        [&world](Asked &ask) {
            const float x =
                ask.Float("point", 0, Gives("inside", {kNaN, kInfinity}) + Gives("outside", {1e38}));
            return world.Shape().TestPoint(kHere, {x, x}) ? "inside" : "outside";
        },
        "inside");
}

// --- outlines ---

namespace {

using Ring = std::vector<b2Vec2>;
const Ring kElbow = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

bmr::OutlineShape Elbow() {
    bmr::OutlineShape outline;
    outline.Set(kElbow.data(), 6);
    return outline;
}

/// What Set says to an outline that has points.
std::string SetOutline(const b2Vec2 *points, int32 count, const bmr::OutlineHole *holes, int32 holeCount,
                       float tolerance, bmr_outline_fault *fault) {
    bmr::OutlineShape outline = Elbow();
    const bmr::OutlineShape before = outline;
    const bmr_error error = outline.Set(points, count, holes, holeCount, tolerance, fault);
    if (error == BMR_OK)
        return std::to_string(outline.GetPieceCount()) + " pieces";
    return outline != before ? "the outline is not as it was" : Answer(error).text;
}

/// What `call` says to a body of so many fixtures, and whether an error left that as it was.
std::string OfBody(const std::function<bmr_error(b2Body *)> &call, int fixtures = 1) {
    b2World world(b2Vec2(0.0f, 0.0f));
    b2BodyDef def;
    def.type = b2_dynamicBody;
    b2Body *const body = world.CreateBody(&def);
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    const b2Fixture *const fixture = fixtures > 0 ? body->CreateFixture(&box, 1.0f) : nullptr;
    const float mass = body->GetMass(), inertia = body->GetInertia();
    const bmr_error error = call(body);
    const bool same = body->GetFixtureList() == fixture && !(fixture && fixture->GetNext()) &&
                      body->GetMass() == mass && body->GetInertia() == inertia;
    return error == BMR_OK || same ? Answer(error).text : "the body is not as it was";
}

/// In the midst of a step: what `call` says there.
std::string Locked(const std::function<bmr_error(b2Body *)> &call) {
    struct Listener : b2ContactListener {
        const std::function<bmr_error(b2Body *)> *call = nullptr;
        std::string said = "never asked";
        void BeginContact(b2Contact *contact) override {
            said = Answer((*call)(contact->GetFixtureA()->GetBody())).text;
        }
    } listener;
    listener.call = &call;
    b2World world(b2Vec2(0.0f, 0.0f));
    world.SetContactListener(&listener);
    b2BodyDef def;
    def.type = b2_dynamicBody;
    for (int i = 0; i < 2; ++i)
        Elbow().CreateFixtures(world.CreateBody(&def), 1.0f);
    world.Step(1.0f / 60.0f, 8, 3);
    return listener.said;
}

const Answer kWorldLocked = BMR_ERROR_WORLD_LOCKED;
const Rules kUnsuited = Gives(BMR_ERROR_NOT_FINITE, {kNaN, kInfinity}) + kNotNegative;

} // namespace

TEST_CASE("boomerang/outline_shape.h") {
    Row(
        "OutlineShape::Set",
        [](Asked &ask) {
            const b2Vec2 *hole =
                ask.Or("points of a hole", kElbow.data(), {{nullptr, BMR_ERROR_NULL_ARGUMENT}});
            const double points = ask.Number("count of a hole", 3, Gives(BMR_ERROR_NEGATIVE, {-1}));
            const bmr::OutlineHole inside = {hole, static_cast<int32>(points)};
            const bmr::OutlineHole *holes = ask.Or("holes", &inside, {{nullptr, BMR_ERROR_NULL_ARGUMENT}});
            const bool bad = hole == nullptr || points < 0 || holes == nullptr;
            const double holeCount = ask.Number("count of holes", 0, Gives(BMR_ERROR_NEGATIVE, {-1})),
                         count = ask.Number("count", 6,
                                            Gives(BMR_ERROR_NEGATIVE, {-6, INT_MIN}) +
                                                Gives(BMR_ERROR_TOO_FEW_POINTS, {0, 2}));
            return SetOutline(ask.NotNull("points", kElbow.data()), static_cast<int32>(count), holes,
                              bad ? 1 : static_cast<int32>(holeCount), ask.Float("tolerance", 0, kUnsuited),
                              nullptr);
        },
        "2 pieces");
    Ring small = kElbow; // of 1 m, far from the origin
    for (b2Vec2 &p : small)
        p = 0.5f * p + b2Vec2(3000.0f, 0.0f);
    bmr::OutlineShape elbow = Elbow(), far, never;
    far.Set(small.data(), 6);
    Row("CreateFixtures", [&](Asked &ask) {
        bmr::OutlineShape *outline =
            ask.Or("outline", &elbow, {{&never, BMR_ERROR_NO_POINTS}, {&far, BMR_ERROR_FAR_FROM_ORIGIN}});
        b2FixtureDef def;
        def.density = ask.Float("density", 1, kUnsuited + OutOfRange({3e38}));
        def.friction = ask.Float("friction", 1, kUnsuited);
        def.restitution =
            ask.Float("restitution", 1, Gives(BMR_ERROR_NOT_FINITE, {kNaN, kInfinity}) + Gives(kOk, {-1}));
        def.restitutionThreshold =
            ask.Float("restitution's threshold", 1, Gives(BMR_ERROR_NOT_FINITE, {kNaN}));
        const auto create = [&](b2Body *body) {
            return outline->CreateFixtures(ask.NotNull("body", body), def);
        };
        return ask.Or("in a step", false, {{true, kWorldLocked}})
                   ? Locked(create)
                   : OfBody(create, outline == &far ? 0 : 1); // (a box here would move the centre)
    });
    Row("DestroyFixtures", [&](Asked &ask) {
        const bool without = ask.Or("a body without this outline", false, {{true, kOk}}),
                   locked = ask.Or("in a step", false, {{true, kWorldLocked}});
        const auto destroy = [&](b2Body *body) {
            b2Body *const asked = ask.NotNull("body", body);
            if (asked != nullptr && !without && !locked)
                elbow.CreateFixtures(body, 1.0f);
            return elbow.DestroyFixtures(asked);
        };
        return locked ? Locked(destroy) : OfBody(destroy);
    });
    b2World world(b2Vec2(0.0f, 0.0f));
    const b2BodyDef def;
    b2Body *const body = world.CreateBody(&def);
    elbow.CreateFixtures(body, 1.0f);
    CHECK(bmr::OutlineShape::From(body->GetFixtureList()).GetPieceCount() == 2);
    CHECK(bmr::OutlineShape::From(static_cast<const b2Fixture *>(nullptr)).GetPieceCount() == 0);
    CHECK(elbow.GetPiece(0).GetVertexCount() == 4);
    CHECK(elbow.GetPiece(99).GetVertexCount() == 0);
    CHECK(elbow.GetPiece(-1).GetVertexCount() == 0);
    CHECK(never.GetPiece(0).GetVertexCount() == 0);
    CHECK((elbow.IsInnerEdge(0, 0) || elbow.IsInnerEdge(0, 1) || elbow.IsInnerEdge(0, 2) ||
           elbow.IsInnerEdge(0, 3)));
    CHECK(!elbow.IsInnerEdge(0, 99));
    CHECK(!elbow.IsInnerEdge(0, -1));
    for (int32 edge = 0; edge < 4; ++edge) {
        CHECK(!elbow.IsInnerEdge(9, edge));
        CHECK(!never.IsInnerEdge(0, edge));
    }
}

TEST_CASE("bad rings of OutlineShape::Set, and the edges that the fault names") {
    constexpr uint32_t kUnnamed = 12345, kNone = BMR_OUTLINE_NONE;
    constexpr float kMost = 1e9f;
    const struct {
        const char *name;
        Ring points;
        Answer answer;
        uint32_t first = kUnnamed, second = kUnnamed;
        Ring hole = {};
    } rows[] = {
        {"65,536 points", Ring(65536, b2Vec2(1.0f, 1.0f)), BMR_ERROR_TOO_MANY_POINTS},
        {"a coordinate of NaN", {{0, 0}, {NAN, 0}, {0, 1}}, BMR_ERROR_NOT_FINITE, 1, kNone},
        {"a coordinate of infinity", {{0, 0}, {INFINITY, 0}, {0, 1}}, BMR_ERROR_NOT_FINITE, 1, kNone},
        {"a coordinate of 2e9", {{0, 0}, {2e9f, 0}, {0, 1}}, BMR_ERROR_OUT_OF_RANGE, 1, kNone},
        {"a triangle of sides 1e-30", {{0, 0}, {1e-30f, 0}, {0, 1e-30f}}, BMR_ERROR_OUT_OF_RANGE},
        {"two points", {{0, 0}, {2, 0}}, BMR_ERROR_TOO_FEW_POINTS, 0, 0},
        {"two points, twice", {{0, 0}, {2, 0}, {2, 0}, {0, 0}}, BMR_ERROR_TOO_FEW_POINTS, 0, 0},
        {"as far as can be",
         {{-kMost, -kMost}, {kMost, -kMost}, {kMost, kMost}, {-kMost, kMost}},
         "1 pieces"},
        {"no points", {}, BMR_ERROR_TOO_FEW_POINTS, kNone, kNone},
        {"like an 8", {{0, 0}, {2, 2}, {2, 0}, {0, 2}}, BMR_ERROR_CROSSING_EDGES, 0, 2},
        {"a spike", {{0, 0}, {4, 0}, {2, 0}, {2, 2}}, BMR_ERROR_OVERLAPPING_EDGES, 0, 1},
        {"a point twice", {{0, 0}, {2, 0}, {2, 0}, {0, 2}}, "1 pieces"},
        {"a hole beside it", kElbow, BMR_ERROR_HOLE_OUTSIDE, 6, kNone, {{9, 9}, {10, 9}, {9, 10}}},
    };
    for (const auto &row : rows) {
        CAPTURE(std::string(row.name));
        const bmr::OutlineHole hole = {row.hole.data(), static_cast<int32>(row.hole.size())};
        bmr_outline_fault fault = {BMR_OK, {kUnnamed, kUnnamed}, {kUnnamed, kUnnamed}, {0.0, 0.0}};
        const b2Vec2 *points = row.points.empty() ? kElbow.data() : row.points.data();
        CHECK(SetOutline(points, static_cast<int32>(row.points.size()), &hole, row.hole.empty() ? 0 : 1, 0.0f,
                         &fault) == row.answer.text);
        CHECK(fault.edge[0] == row.first);
        CHECK(fault.edge[1] == row.second);
    }
}
