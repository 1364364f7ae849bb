// SPDX-License-Identifier: MIT
// Polygons in float (convex32).
#include "contracts.h"
#include "convex32/convex32.h"
#include "convex32/convex32_distance.h"
#include "convex32/convex32_pieces.h"

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
            const double count = ask.Number("count", 40,
                                            Gives(BMR_ERROR_TOO_FEW_POINTS, {0, 2}) +
                                                Gives(BMR_ERROR_TOO_MANY_POINTS, {kSizeMax / 16}));
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
