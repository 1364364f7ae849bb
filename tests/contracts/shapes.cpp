// SPDX-License-Identifier: MIT
// bmr::ConvexShape, and what the glue says of bodies. Each call is made in a process that has not called
// Install.
#include <cfloat>
#include <climits>
#include <cstring>

#include <box2d/box2d.h>

#include "bad_vertex_arrays.h"
#include "boomerang/convex_shape.h"
#include "boomerang/inspect.h"

using namespace contracts;

namespace {

/// What a setter says to a shape that holds something, and whether an error left that as it was.
std::string SetTo(const std::function<bmr_error(bmr::ConvexShape &)> &set, double given = 0.0) {
    bmr::ConvexShape shape;
    if (shape.SetRegular(12, 3.0f) != BMR_OK)
        return "no shape to begin with";
    unsigned char before[sizeof shape];
    std::memcpy(before, static_cast<const void *>(&shape), sizeof shape);
    const bmr_error error = set(shape);
    if (error != BMR_OK)
        return Said(error, std::memcmp(before, static_cast<const void *>(&shape), sizeof shape) != 0);
    return CountOf(static_cast<size_t>(shape.GetVertexCount()), static_cast<size_t>(std::max(given, 0.0)));
}

std::vector<b2Vec2> Vectors(const std::vector<bmr_vec2> &points) {
    std::vector<b2Vec2> made;
    for (const bmr_vec2 &p : points)
        made.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
    return made;
}

using Setter = bmr_error (bmr::ConvexShape::*)(const b2Vec2 *, int32);

template <Setter Set> std::string SetVertices(const Vertices &vertices) {
    if (vertices.count > INT_MAX)
        return "-";
    const std::vector<b2Vec2> points = Vectors(vertices.points);
    return SetTo(
        [&](bmr::ConvexShape &shape) {
            return (shape.*Set)(vertices.null ? nullptr : points.data(), static_cast<int32>(vertices.count));
        },
        static_cast<double>(vertices.count));
}

const Table kVertices("bad vertex arrays of shapes", [] {
    return VertexArrayTable({{"`ConvexShape::Set`", SetVertices<&bmr::ConvexShape::Set>},
                             {"`ConvexShape::SetRaw`", SetVertices<&bmr::ConvexShape::SetRaw>}});
});

/// So many points in a square.
template <Setter Set> std::string SetCount(const Given &g) {
    std::vector<b2Vec2> points = Vectors(Grid(static_cast<size_t>(std::min(std::max(g[0], 0.0), 65536.0))));
    points.reserve(1); // there is an array, of no points
    return SetTo(
        [&](bmr::ConvexShape &shape) { return (shape.*Set)(points.data(), static_cast<int32>(g[0])); }, g[0]);
}

const Table kShapes("boomerang/convex_shape.h", [] {
    const Value largest("the largest float", FLT_MAX);
    const std::string four = "4 vertices";
    const Rules size = kFinite + kAboveZero,
                round =
                    size + Says("OUT_OF_RANGE", {1e-38, 1e-9, 1e38, largest}) + Says("20 vertices", {1e9}),
                any = kFinite + Says(four, {-0.0, -1, 1e-38, 1e-9, 1e9, 1e38, largest}),
                many = kAbove2 + Says("3 vertices", {3}) + Says("16383 vertices", {16383}) +
                       Says("fewer vertices", {16384, 65535}) + Says("TOO_MANY_POINTS", {65536, INT_MAX});
    Answers(
        "Set", four,
        {{"count", 65536,
          kAbove2 + Says("TOO_FEW_POINTS", {3}) + Says("5 vertices", {16383, 65535}) + Says(four, {16384})}},
        SetCount<&bmr::ConvexShape::Set>);
    Answers("SetRaw", "NOT_CONVEX",
            {{"count", 65535,
              kAbove2 + Says("TOO_FEW_POINTS", {3}) + Says("NOT_CONVEX", {16383, 16384}) +
                  Says("TOO_MANY_POINTS", {65536, INT_MAX})}},
            SetCount<&bmr::ConvexShape::SetRaw>);
    Answers("SetAsBox", four,
            {{"half width", size + Says(four, {1e-38, 1e-9, 1e9, 1e38, largest})},
             {"y of the centre", 0, any},
             {"angle", 0, any}},
            [](const Given &g) {
                return SetTo([&](bmr::ConvexShape &shape) {
                    return g[1] == 0.0 && g[2] == 0.0
                               ? shape.SetAsBox(g.Float(0), 1.0f)
                               : shape.SetAsBox(g.Float(0), 1.0f, {0.0f, g.Float(1)}, g.Float(2));
                });
            });
    Answers("SetRegular", "20 vertices", {{"count", 20, many}, {"radius", 1000, round}}, [](const Given &g) {
        return SetTo(
            [&](bmr::ConvexShape &shape) { return shape.SetRegular(static_cast<int32>(g[0]), g.Float(1)); },
            g[0]);
    });
    Answers("SetEllipse", "20 vertices", {{"count", 20, many}, {"height", 500, round}}, [](const Given &g) {
        return SetTo(
            [&](bmr::ConvexShape &shape) {
                return shape.SetEllipse(static_cast<int32>(g[0]), g[1] == 500.0 ? 1000.0f : 1.0f, g.Float(1));
            },
            g[0]);
    });
    Answers("SetRounded", "16 vertices",
            {{"half width", 2,
              size + Says("CORNER_TOO_LARGE", {1e-38, 1e-9}) + Says(four, {1e9}) +
                  Says("OUT_OF_RANGE", {1e38, largest})},
             {"radius of a corner", 0.5,
              size + Says(four, {1e-38, 1e-9}) + Says("CORNER_TOO_LARGE", {1e9, 1e38, largest})}},
            [](const Given &g) {
                return SetTo([&](bmr::ConvexShape &shape) {
                    return shape.SetRounded(g.Float(0), 1.0f, g.Float(1), 4);
                });
            });
    Answers("SetRounded, of 1 km", "10 vertices",
            {{"count of a corner", 3,
              Says("TOO_FEW_POINTS", {INT_MIN, -1, 0, 1}) + Says("6 vertices", {2}) +
                  Says("fewer vertices", {16383}) + Says("TOO_MANY_POINTS", {16384, 65535, 65536, INT_MAX})}},
            [](const Given &g) {
                return SetTo(
                    [&](bmr::ConvexShape &shape) {
                        return shape.SetRounded(1000.0f, 500.0f, 500.0f, static_cast<int32>(g[0]));
                    },
                    4.0 * g[0]);
            });
    Answers("Simplify", "12 vertices",
            {{"tolerance", 0,
              kNotNegative + Says("NEGATIVE", {-kInfinity}) + Says("NOT_FINITE", {kNaN}) +
                  Says("12 vertices", {-0.0, 1e-38, 1e-9}) +
                  Says("3 vertices", {kInfinity, 1e9, 1e38, largest})}},
            [](const Given &g) {
                return SetTo([&](bmr::ConvexShape &shape) { return shape.Simplify(g.Float(0)); });
            });
    Answers("Simplify, GetVertexCount of a copy", "12 vertices",
            {{"shape", 12, Says("TOO_FEW_POINTS, 0 vertices", {{"never set", 0}})}}, [](const Given &g) {
                bmr::ConvexShape shape;
                if (g[0] != 0.0)
                    shape.SetRegular(12, 3.0f);
                const bmr_error error = shape.Simplify(0.01f);
                const bmr::ConvexShape copy = shape;
                return (error != BMR_OK ? Said(error) + ", " : "") + std::to_string(copy.GetVertexCount()) +
                       " vertices";
            });
    Answers("From", "a shape", {{"shape", Says("`NULL`", {kNull})}}, [](const Given &g) {
        bmr::ConvexShape shape;
        shape.SetRegular(12, 3.0f);
        return bmr::ConvexShape::From(g.Or(0, &shape)) == nullptr ? "`NULL`" : "a shape";
    });
});

// --- shapes and bodies in a world ---

/// Two bodies with a big shape each, near each other, and their contact.
struct World {
    b2World world{b2Vec2(0.0f, 0.0f)};
    b2Body *a, *b;
    bool installed = bmr::Install();

    World() {
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

constexpr double kAnother = 0, kItself = 1, kOfAnotherWorld = 2, kWithoutFixtures = 3, kAtNaN = 4,
                 kFarAway = 5;

/// What is said of body a and this one.
std::string Asked(double second, const std::function<std::string(b2Body *, b2Body *)> &ask) {
    World world;
    const World other;
    b2BodyDef def;
    b2Body *b = second == kItself            ? world.a
                : second == kOfAnotherWorld  ? other.b
                : second == kWithoutFixtures ? world.world.CreateBody(&def)
                                             : world.b;
    if (second == kAtNaN || second == kFarAway)
        b->SetTransform({second == kAtNaN ? NAN : 1e38f, 0.0f}, 0.0f);
    return ask(world.a, b);
}

const Table kGlue("the glue", [] {
    Answers("Install", "true",
            {{"verbosity", 0, Says("true", {INT_MIN})}, {"calls before", 0, Says("false", {1})}},
            [](const Given &g) {
                bmr::Options options;
                options.verbosity = g[0] != 0.0 ? INT_MIN : options.verbosity;
                return Said((g[1] == 0.0 || bmr::Install()) && bmr::Install(options));
            });
    Answers("CertifiedSlack", "above 0",
            {{"second body", kAnother,
              Says("0", {{"the first", kItself},
                         {"of another world", kOfAnotherWorld},
                         {"without fixtures", kWithoutFixtures},
                         {"at NaN", kAtNaN}}) +
                  Says("above 0", {{"at 1e38", kFarAway}})}},
            [](const Given &g) {
                return Asked(g[0], [](b2Body *a, b2Body *b) {
                    const float slack = bmr::CertifiedSlack(a, b);
                    return slack > 0.0f ? "above 0" : slack == 0.0f ? "0" : "below 0, or NaN";
                });
            });
    Answers("Inspect", "remembered-edge",
            {{"second body", kAnother, Says("none", {{"the first", kItself}, {"at NaN", kAtNaN}})}},
            [](const Given &g) {
                return Asked(g[0], [](b2Body *a, b2Body *b) { return bmr::NameOf(bmr::Inspect(a, b).kind); });
            });
    Answers("InspectHull", "0 vertices", {{"proof", Says("0 vertices", {{"none", 0}})}}, [](const Given &) {
        b2Vec2 vertices[4];
        return std::to_string(bmr::InspectHull(bmr::Proof(), false, 0, vertices, 4)) + " vertices";
    });
    Answers("NameOf", "none",
            {{"kind of proof", 0, Says("`NULL`", {{"none", double(bmr::ProofKind::Count)}})}},
            [](const Given &g) {
                const char *name = bmr::NameOf(static_cast<bmr::ProofKind>(g[0]));
                return name != nullptr ? name : "`NULL`";
            });
    Answers("ConvexShape::RayCast", "hit",
            {{"from", -5, Says("no hit", {kNaN})},
             {"to", 5, Says("no hit", {kInfinity, {"where it is from", -5}})},
             {"fraction", Says("hit", {kNaN}) + Says("no hit", {-1})}},
            [](const Given &g) {
                const World world;
                const b2RayCastInput input = {{g.Float(0), 0.0f}, {g.Float(1), 0.0f}, g.Float(2)};
                b2RayCastOutput output;
                return world.Shape().RayCast(&output, input, kHere, 0) ? "hit" : "no hit";
            });
    Answers("ConvexShape::TestPoint", "true",
            {{"point", 0, Says("true", {kNaN, kInfinity}) + Says("false", {1e38})}}, [](const Given &g) {
                return Said(World().Shape().TestPoint(kHere, {g.Float(0), g.Float(0)}));
            });
});

} // namespace
