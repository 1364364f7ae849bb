// SPDX-License-Identifier: MIT
// What bmr::ConvexShape says to bad points and sizes, beside Box2D's own polygon.
#include <climits>
#include <cmath>
#include <cstring>

#include <box2d/box2d.h>

#include "arguments.h"
#include "boomerang/convex_shape.h"
#include "boomerang/inspect.h"
#include "points.h"
#include "table.h"

using namespace bad_input;

namespace {

const float kNone32 = std::nanf(""), kInfinite32 = INFINITY;

std::vector<b2Vec2> Vectors(const Points &points) {
    std::vector<b2Vec2> made;
    for (size_t i = 0; i + 1 < points.xy.size(); i += 2)
        made.emplace_back(static_cast<float>(points.xy[i]), static_cast<float>(points.xy[i + 1]));
    return made;
}

/// What a setter says to a shape that holds something, and whether an error left that as it was.
template <typename Setter> std::string Answer(const Setter &set, const Points *given = nullptr) {
    bmr::ConvexShape shape;
    if (shape.SetRegular(12, 3.0f) != BMR_OK)
        return "no shape to begin with";
    unsigned char before[sizeof shape];
    std::memcpy(before, static_cast<const void *>(&shape), sizeof shape);
    const bmr_error error = set(shape);
    if (error != BMR_OK)
        return NameOf(error) + (std::memcmp(before, static_cast<const void *>(&shape), sizeof shape) == 0
                                    ? ""
                                    : ", and the shape has changed");
    const auto count = static_cast<size_t>(shape.GetVertexCount());
    return given != nullptr ? CountOf(count, *given) : std::to_string(count) + " vertices";
}

std::string Shape(const Points &points, size_t column) {
    const std::vector<b2Vec2> given = Vectors(points);
    const b2Vec2 *data = points.null ? nullptr : given.data();
    const int32 count = points.count > INT_MAX ? INT_MAX : static_cast<int32>(points.count);
    return Answer(
        [&](bmr::ConvexShape &shape) {
            return column == 0 ? shape.Set(data, count) : shape.SetRaw(data, count);
        },
        &points);
}

/// One number at a time is bad.
struct Size {
    const char *name;
    float value;
};
const Size kSizes[] = {{"NaN", kNone32},
                       {"infinite", kInfinite32},
                       {"minus infinity", -kInfinite32},
                       {"zero", 0.0f},
                       {"minus zero", -0.0f},
                       {"negative", -1.0f},
                       {"1e-38", 1e-38f},
                       {"1e-9", 1e-9f},
                       {"1e9", 1e9f},
                       {"1e38", 1e38f},
                       {"the largest float", FLT_MAX}};

const std::vector<std::string> kSizeColumns = {
    "`SetAsBox`, width",    "`SetAsBox`, centre",  "`SetAsBox`, angle",    "`SetRegular`, radius",
    "`SetEllipse`, height", "`SetRounded`, width", "`SetRounded`, corner", "`Simplify`, tolerance"};

std::string SizeAnswer(float value, size_t column) {
    return Answer([value, column](bmr::ConvexShape &shape) {
        switch (column) {
        case 0:
            return shape.SetAsBox(value, 1.0f);
        case 1:
            return shape.SetAsBox(1.0f, 1.0f, {0.0f, value}, 0.0f);
        case 2:
            return shape.SetAsBox(1.0f, 1.0f, {0.0f, 0.0f}, value);
        case 3:
            return shape.SetRegular(20, value);
        case 4:
            return shape.SetEllipse(20, 1.0f, value);
        case 5:
            return shape.SetRounded(value, 1.0f, 0.5f, 4);
        case 6:
            return shape.SetRounded(2.0f, 1.0f, value, 4);
        default:
            return shape.Simplify(value);
        }
    });
}

const int32 kCounts[] = {INT_MIN, -1, 0, 1, 2, 3, 16383, 16384, 65535, 65536, INT_MAX};
const std::vector<std::string> kCountColumns = {"`Set`", "`SetRaw`", "`SetRegular`", "`SetEllipse`",
                                                "`SetRounded`, of a corner"};

std::string CountAnswer(int32 count, size_t column) {
    if (column == 0 && count == INT_MAX)
        return "-"; // all of them would be looked at
    Points circle = {"", {}, 0};
    circle.count = static_cast<size_t>(std::max(count, 0)) * (column == 4 ? 4 : 1);
    std::vector<b2Vec2> given;
    given.reserve(1); // there is an array, of no points
    for (int32 i = 0; i < std::min(count, 65536) && column < 2; ++i)
        given.emplace_back(static_cast<float>(i % 256),
                           static_cast<float>(i / 256)); // a square of 4 vertices
    return Answer(
        [&](bmr::ConvexShape &shape) {
            switch (column) {
            case 0:
                return shape.Set(given.data(), count);
            case 1:
                return shape.SetRaw(given.data(), count);
            case 2:
                return shape.SetRegular(count, 1000.0f);
            case 3:
                return shape.SetEllipse(count, 1000.0f, 500.0f);
            default:
                return shape.SetRounded(1000.0f, 500.0f, 500.0f, count);
            }
        },
        &circle);
}

// --- everything else that the glue offers ---

/// Two bodies with a big shape each, 5 apart, and their contact once they are near.
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

std::string Slack(float value) {
    return value > 0.0f ? "above 0" : value == 0.0f ? "0" : "below 0, or NaN";
}

std::string ProofOf(const bmr::Proof &proof) {
    return bmr::NameOf(proof.kind);
}

std::string Ray(b2Vec2 from, b2Vec2 to, float fraction) {
    const World world;
    const b2RayCastInput input = {from, to, fraction};
    b2RayCastOutput output;
    b2Transform here;
    here.SetIdentity();
    return world.Shape().RayCast(&output, input, here, 0) ? "hit" : "no hit";
}

std::string InstallWith(void (*spoil)(bmr::Options *)) {
    bmr::Options options;
    spoil(&options);
    return Said(bmr::Install(options));
}

std::vector<Argument> OfTheGlue() {
    return {
        {"`Install`: no such structure",
         [] { return InstallWith([](bmr::Options *o) { o->structure = BMR_STRUCTURE_COUNT; }); }},
        {"`Install`: hooks that there are not",
         [] { return InstallWith([](bmr::Options *o) { o->hooks = 0xffffffffu; }); }},
        {"`Install`: a negative verbosity",
         [] { return InstallWith([](bmr::Options *o) { o->verbosity = INT_MIN; }); }},
        {"`Install`: twice",
         [] {
             const std::string first = Said(bmr::Install());
             return first + ", then " + Said(bmr::Install());
         }},
        {"`CertifiedSlack`: two bodies (a good one)",
         [] {
             const World world;
             return Slack(bmr::CertifiedSlack(world.a, world.b));
         }},
        {"`CertifiedSlack`: a body and itself",
         [] {
             const World world;
             return Slack(bmr::CertifiedSlack(world.a, world.a));
         }},
        {"`CertifiedSlack`: bodies of two worlds",
         [] {
             const World world, other;
             return Slack(bmr::CertifiedSlack(world.a, other.b));
         }},
        {"`CertifiedSlack`: a body without fixtures",
         [] {
             World world;
             b2BodyDef def;
             return Slack(bmr::CertifiedSlack(world.a, world.world.CreateBody(&def)));
         }},
        {"`CertifiedSlack`: a body at NaN",
         [] {
             World world;
             world.b->SetTransform({kNone32, 0.0f}, 0.0f);
             return Slack(bmr::CertifiedSlack(world.a, world.b));
         }},
        {"`CertifiedSlack`: a body at 1e38",
         [] {
             World world;
             world.b->SetTransform({1e38f, 0.0f}, 0.0f);
             return Slack(bmr::CertifiedSlack(world.a, world.b));
         }},
        {"`Inspect`: a body and itself",
         [] {
             const World world;
             return ProofOf(bmr::Inspect(world.a, world.a));
         }},
        {"`Inspect`: a body at NaN",
         [] {
             World world;
             world.b->SetTransform({kNone32, 0.0f}, 0.0f);
             return ProofOf(bmr::Inspect(world.a, world.b));
         }},
        {"`InspectHull`: no proof",
         [] {
             b2Vec2 vertices[4];
             return std::to_string(bmr::InspectHull(bmr::Proof(), false, 0, vertices, 4)) + " vertices";
         }},
        {"`NameOf`: no kind of proof",
         [] { return bmr::NameOf(bmr::ProofKind::Count) == nullptr ? "`nullptr`" : "a name"; }},
        {"`Invalidate`: a body without fixtures",
         [] {
             World world;
             b2BodyDef def;
             bmr::Invalidate(world.world.CreateBody(&def));
             return std::string("nothing happens");
         }},
        {"`ConvexShape::From`: `nullptr`",
         [] { return bmr::ConvexShape::From(nullptr) == nullptr ? "`nullptr`" : "a shape"; }},
        {"`ConvexShape`: never set",
         [] {
             const bmr::ConvexShape shape, copy = shape;
             return std::to_string(copy.GetVertexCount()) + " vertices";
         }},
        {"`ConvexShape::Simplify`: never set", [] { return Said(bmr::ConvexShape().Simplify(0.1f)); }},
        {"`ConvexShape::RayCast`: from outside (a good one)",
         [] {
             return Ray({-5, 0}, {5, 0}, 1.0f);
         }},
        {"`ConvexShape::RayCast`: from NaN",
         [] {
             return Ray({kNone32, 0}, {5, 0}, 1.0f);
         }},
        {"`ConvexShape::RayCast`: to infinity",
         [] {
             return Ray({-5, 0}, {kInfinite32, 0}, 1.0f);
         }},
        {"`ConvexShape::RayCast`: from and to one point",
         [] {
             return Ray({-5, 0}, {-5, 0}, 1.0f);
         }},
        {"`ConvexShape::RayCast`: a fraction of NaN",
         [] {
             return Ray({-5, 0}, {5, 0}, kNone32);
         }},
        {"`ConvexShape::RayCast`: a fraction below 0",
         [] {
             return Ray({-5, 0}, {5, 0}, -1.0f);
         }},
        {"`ConvexShape::TestPoint`: a point of NaN",
         [] {
             const World world;
             b2Transform here;
             here.SetIdentity();
             return Said(world.Shape().TestPoint(here, {kNone32, kNone32}));
         }},
    };
}

std::vector<std::string> SizeNames() {
    std::vector<std::string> names;
    for (const Size &size : kSizes)
        names.emplace_back(size.name);
    return names;
}

std::vector<std::string> CountNames() {
    std::vector<std::string> names;
    for (const int32 count : kCounts)
        names.push_back(std::to_string(count));
    return names;
}

} // namespace

int main(int argc, char **argv) {
    std::vector<Points> all = AllBadPoints();
    all.pop_back(); // a count that int32 does not have
    return Main(argc, argv,
                {{"points in a shape",
                  {"`ConvexShape::Set`", "`ConvexShape::SetRaw`"},
                  NamesOf(all),
                  [&all](size_t row, size_t column) { return Shape(all[row], column); }},
                 {"sizes of a shape", kSizeColumns, SizeNames(),
                  [](size_t row, size_t column) { return SizeAnswer(kSizes[row].value, column); }},
                 {"counts of a shape", kCountColumns, CountNames(),
                  [](size_t row, size_t column) { return CountAnswer(kCounts[row], column); }},
                 ArgumentTable("arguments of the glue", OfTheGlue())});
}
