// SPDX-License-Identifier: MIT
// Polygons in float (convex32, swept32); and poses that are none.
#include "contracts.h"
#include "convex32/convex32.h"
#include "convex32/convex32_collide.h"
#include "convex32/convex32_distance.h"
#include "convex32/convex32_pieces.h"
#include "exact32/swept32.h"

using namespace contracts;

namespace {

std::vector<bmr_vec32> Floats(const std::vector<bmr_vec2> &points) {
    std::vector<bmr_vec32> made;
    for (const bmr_vec2 &p : points)
        made.push_back({static_cast<float>(p.x), static_cast<float>(p.y)});
    return made;
}

/// A circle of 40 points.
bmr_convex32_block *Convex() {
    struct Block {
        bmr_convex32_block *made = nullptr;
        Block() { bmr_convex32_create(Floats(Ellipse(40)).data(), 40, nullptr, &made); }
        ~Block() { bmr_convex32_destroy(made, nullptr); }
    };
    static const Block block;
    return block.made;
}

/// The end of a call that makes a polygon.
std::string MadeConvex(Asked &ask, bmr_error error, bmr_convex32_block *made) {
    if (error == BMR_OK) {
        const bmr_convex32 *p = &made->polygon;
        ask.Made(p->vertices, p->count * sizeof *p->vertices);
        ask.Made(p->normals, p->count * sizeof *p->normals);
        ask.Made(p->buckets, (size_t{1} << p->bucket_bits) * sizeof *p->buckets);
        bmr_convex32_destroy(made, ask.Allocator());
    }
    return ask.Says(error);
}

std::string ImpactOf(const bmr_sweep32 &moves, float t_max, float slop) {
    const bmr_proxy32 proxy = bmr_proxy32_polygon(Convex(), 0.01f);
    const bmr_sweep32 still = {{0, 0}, {0, 0}, {0, 0}, 0, 0, 0};
    bmr_vec32 direction = {0, 0};
    float t = -1.0f;
    static const char *const names[] = {"failed", "overlapped", "touching", "separated"};
    return names[bmr_convex32_impact(&proxy, &still, &proxy, &moves, t_max, slop, &direction, &t)];
}

} // namespace

TEST_CASE("core/convex32") {
    using Create = bmr_error (*)(const bmr_vec32 *, size_t, const bmr_allocator *, bmr_convex32_block **);
    const std::pair<const char *, Create> creates[] = {{"bmr_convex32_create", bmr_convex32_create},
                                                       {"bmr_convex32_create_raw", bmr_convex32_create_raw}};
    for (const auto &[name, create] : creates) {
        Row(name, [create = create](Asked &ask) {
            bmr_convex32_block *made = Untouched<bmr_convex32_block>();
            const double count = ask.Number("count", 40, Gives(BMR_ERROR_TOO_FEW_POINTS, {0, 2}));
            const bmr_error error = create(ask.NotNull("points", Convex()->polygon.vertices), Count(count),
                                           ask.Allocator(), ask.Result("result", &made));
            return MadeConvex(ask, error, made);
        });
    }
    // Every other edge is an inner one.
    Row("bmr_convex32_create_piece", [](Asked &ask) {
        const bmr_convex32 *hull = &Convex()->polygon;
        bmr_piece_corner32 corners[40];
        for (uint32_t i = 0; i < hull->count; ++i)
            corners[i] = {hull->vertices[i], hull->vertices[(i + 1) % hull->count], i % 2 == 0};
        bmr_convex32_block *made = Untouched<bmr_convex32_block>();
        const bmr_error error = bmr_convex32_create_piece(ask.NotNull("corners", &corners[0]), hull->count,
                                                          ask.Allocator(), ask.Result("result", &made));
        return MadeConvex(ask, error, made);
    });
    Row("bmr_convex32_simplify", [](Asked &ask) {
        const float tolerance =
            ask.Float("tolerance", 0.05f,
                      kNotNegative + Gives(BMR_ERROR_NOT_FINITE, {kNaN}) + Gives("40 vertices", {-0.0}) +
                          Gives("3 vertices", {kInfinity}));
        bmr_vec32 left[40] = {{77.0f, 77.0f}};
        size_t count = 77;
        const bmr_error error = bmr_convex32_simplify(&Convex()->polygon, tolerance, ask.Allocator(),
                                                      ask.Result("place of the points", &left[0]),
                                                      ask.Result("place of their count", &count));
        if (error == BMR_OK)
            ask.Made(left, count * sizeof *left);
        return error != BMR_OK || tolerance == 0.05f ? ask.Says(error) : VerticesOf(count);
    });
    Row(
        "bmr_convex32_support, bmr_convex32_support_from",
        [](Asked &ask) {
            const float x = ask.Float("direction", 1, Gives("0 and 0", {kNaN}));
            const double hint = ask.Number("hint", 3, Gives("5 and 5", {UINT32_MAX}));
            return std::to_string(bmr_convex32_support(&Convex()->polygon, {x, x})) + " and " +
                   std::to_string(
                       bmr_convex32_support_from(&Convex()->polygon, {x, x}, static_cast<uint32_t>(hint)));
        },
        "5 and 5");
    CHECK(bmr_convex32_support(&Convex()->polygon, {0, 0}) == 0);
    CHECK(bmr_convex32_support_from(&Convex()->polygon, {0, 0}, UINT32_MAX) == 0);
    Row(
        "bmr_convex32_contains",
        [](Asked &ask) {
            const float x =
                ask.Float("point", 0, Gives("inside", {kNaN}) + Gives("outside", {kInfinity, 1e38}));
            return bmr_convex32_contains(&Convex()->polygon, {x, x}) ? "inside" : "outside";
        },
        "inside");
    Row(
        "bmr_convex32_impact",
        [](Asked &ask) {
            const float angle = ask.Float("angle", 0, Gives("failed", {kNaN, kInfinity, 1e38})),
                        time = ask.Float("time", 1, Gives("failed", {kNaN}) + Gives("separated", {-1})),
                        slop = ask.Float("slop", 0.005f, Gives("failed", {kNaN}));
            return ImpactOf({{0, 0}, {9, 0}, {-9, 0}, 0, angle, 0}, time, slop);
        },
        "touching");
}

// --- poses that are none ---

namespace {

const bmr_transform32 kHere = {{0, 0}, 0, 1};

std::string Apart(const bmr_transform32 &there) {
    const bmr_convex32 *polygon = &Convex()->polygon;
    bmr_convex32_memory memory = {};
    return bmr_convex32_apart(polygon, &kHere, polygon, &there, 0.0f, &memory) ? "apart" : "no answer";
}

int32_t Collide(const bmr_transform32 &there) {
    const bmr_convex32 *polygon = &Convex()->polygon;
    bmr_convex32_memory memory = {};
    bmr_manifold32 manifold = {};
    bmr_convex32_collide(&manifold, polygon, &kHere, polygon, &there, 0.02f, 0.0005f, &memory);
    return manifold.count;
}

std::string Distance(const bmr_transform32 &there) {
    const bmr_proxy32 proxy = bmr_proxy32_polygon(Convex(), 0.01f);
    bmr_closest32 closest = {0, 0};
    return Word(double{bmr_convex32_distance(&proxy, &kHere, &proxy, &there, &closest).distance});
}

bool Cast(const bmr_transform32 &there) {
    const bmr_proxy32 proxy = bmr_proxy32_polygon(Convex(), 0.01f);
    bmr_cast32 cast;
    return bmr_convex32_cast(&proxy, &kHere, &proxy, &there, {-10.0f, 0.0f}, 0.005f, &cast);
}

std::string Swept(const bmr_transform32 &there) {
    const bmr_vec32 points[8] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, 0}, {0, 0}, {0, 0}, {0, 0}};
    const bmr_motion32 still = {{0, 0}, {0, 0}, {0, 0}, 0, 1, 0},
                       moves = {{0, 0}, there.p, there.p, there.s, there.c, 0};
    bmr_swept32 a, b;
    bmr_swept32_make(&a, points, 4, &still);
    bmr_swept32_make(&b, points, 4, &moves);
    bmr_vec32 direction = {0, 0};
    return bmr_swept32_find_apart(&a, &b, 0.01f, &direction) ? "apart" : "no answer";
}

} // namespace

TEST_CASE("a pose that is none proves nothing of two 40-gons, which a good one has 3 apart") {
    constexpr float kBad = std::numeric_limits<float>::quiet_NaN(),
                    kFar = std::numeric_limits<float>::infinity();
    const char *const no = "no answer", *const apart = "apart", *const finite = "finite",
                      *const infinite = "infinite";
    const struct {
        const char *name;
        bmr_transform32 pose; ///< place, sine, cosine
        const char *apart;
        int32_t points;
        const char *distance;
        bool hit;
        const char *impact; ///< motions have angles instead of sines: nullptr
        const char *swept;
    } rows[] = {
        {"5 to the right", {{5, 0}, 0, 1}, apart, 0, finite, true, "touching", apart},
        {"x is NaN", {{kBad, 0}, 0, 1}, no, 0, "NaN", false, "failed", no},
        {"y is NaN", {{5, kBad}, 0, 1}, no, 0, "NaN", false, "failed", no},
        {"x is infinite", {{kFar, 0}, 0, 1}, no, 0, infinite, false, "failed", no},
        {"y is minus infinity", {{5, -kFar}, 0, 1}, no, 0, infinite, false, "failed", no},
        {"x is 1e38", {{1e38f, 0}, 0, 1}, no, 0, finite, false, "separated", apart},
        {"x is 5 and y 1e-38", {{5, 1e-38f}, 0, 1}, apart, 0, finite, true, "touching", apart},
        {"the cosine is NaN", {{5, 0}, 0, kBad}, no, 0, "NaN", false, nullptr, no},
        {"the sine is infinite", {{5, 0}, kFar, 1}, no, 0, "NaN", false, nullptr, no},
        {"the rotation is 0", {{5, 0}, 0, 0}, apart, 2, finite, true, nullptr, apart},
        {"the rotation is 1 % too long", {{5, 0}, 0, 1.01f}, apart, 0, finite, true, nullptr, apart},
        {"the rotation is twice too long", {{5, 0}, 0, 2}, apart, 0, finite, true, nullptr, apart},
        {"the rotation is 1e38", {{5, 0}, 0, 1e38f}, no, 2, finite, false, nullptr, no},
    };
    for (const auto &row : rows) {
        CAPTURE(std::string(row.name));
        CHECK(Apart(row.pose) == row.apart);
        CHECK(Collide(row.pose) == row.points);
        CHECK(Distance(row.pose) == row.distance);
        CHECK(Cast(row.pose) == row.hit);
        const bmr_vec32 p = row.pose.p;
        if (row.impact != nullptr)
            CHECK(ImpactOf({{0, 0}, {p.x, p.y}, {p.x - 10.0f, p.y}, 0, 0, 0}, 1.0f, 0.005f) == row.impact);
        CHECK(Swept(row.pose) == row.swept);
    }
}
