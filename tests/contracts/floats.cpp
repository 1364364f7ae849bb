// SPDX-License-Identifier: MIT
// Polygons in float (convex32, swept32), and poses that are none.
#include "bad_poses.h"
#include "convex32/convex32_collide.h"
#include "convex32/convex32_distance.h"
#include "convex32/convex32_pieces.h"
#include "exact32/swept32.h"
#include "stage.h"

using namespace contracts;

namespace {

std::string MadeConvex(const Given &g, bmr_error error, bmr_convex32_block *made) {
    if (error != BMR_OK)
        return Said(error, made != Untouched<bmr_convex32_block>());
    const bmr_convex32 *p = &made->polygon;
    g.Made(p->vertices, p->count * sizeof *p->vertices);
    g.Made(p->normals, p->count * sizeof *p->normals);
    g.Made(p->buckets, (size_t{1} << p->bucket_bits) * sizeof *p->buckets);
    bmr_convex32_destroy(made, g.allocator);
    return Said(error);
}

std::string Simplify(const Given &g) {
    bmr_vec32 left[40] = {{77.0f, 77.0f}};
    size_t count = 77;
    const bmr_error error =
        bmr_convex32_simplify(&Convex()->polygon, g.Float(0), g.allocator, g.Or(1, left), g.Or(2, &count));
    if (error != BMR_OK)
        return Said(error, count != 77 || left[0].x != 77.0f);
    g.Made(left, count * sizeof *left);
    return g[0] == 0.05 ? Said(error) : std::to_string(count) + " vertices";
}

/// Every other edge is an inner one.
std::string CreatePiece(const Given &g) {
    const bmr_convex32 *hull = &Convex()->polygon;
    bmr_piece_corner32 corners[40];
    for (uint32_t i = 0; i < hull->count; ++i)
        corners[i] = {hull->vertices[i], hull->vertices[(i + 1) % hull->count], i % 2 == 0};
    bmr_convex32_block *made = Untouched<bmr_convex32_block>();
    const bmr_error error =
        bmr_convex32_create_piece(g.Or(0, corners), hull->count, g.allocator, g.Or(1, &made));
    return MadeConvex(g, error, made);
}

std::string ImpactOf(const bmr_sweep32 &moves, float t_max, float slop) {
    const bmr_proxy32 proxy = bmr_proxy32_polygon(Convex(), 0.01f);
    const bmr_sweep32 still = {{0, 0}, {0, 0}, {0, 0}, 0, 0, 0};
    bmr_vec32 direction = {0, 0};
    float t = -1.0f;
    static const char *const names[] = {"failed", "overlapped", "touching", "separated"};
    return names[bmr_convex32_impact(&proxy, &still, &proxy, &moves, t_max, slop, &direction, &t)];
}

const Table kFloats("core/convex32", [] {
    static const std::vector<bmr_vec32> points = Floats(Ellipse(60, 3.0));
    using Create = bmr_error (*)(const bmr_vec32 *, size_t, const bmr_allocator *, bmr_convex32_block **);
    const std::pair<const char *, Create> creates[] = {{"bmr_convex32_create", bmr_convex32_create},
                                                       {"bmr_convex32_create_raw", bmr_convex32_create_raw}};
    for (const auto &[name, create] : creates)
        Makes(name, {{"points", kNotNull}, {"result", kNotNull}}, [create = create](const Given &g) {
            bmr_convex32_block *made = Untouched<bmr_convex32_block>();
            const bmr_error error =
                create(g.Or(0, Convex()->polygon.vertices), 40, g.allocator, g.Or(1, &made));
            return MadeConvex(g, error, made);
        });
    Makes("bmr_convex32_create_piece", {{"corners", kNotNull}, {"result", kNotNull}}, CreatePiece);
    Makes("bmr_convex32_simplify",
          {{"tolerance", 0.05,
            kNotNegative + Says("NOT_FINITE", {kNaN}) + Says("40 vertices", {-0.0}) +
                Says("3 vertices", {kInfinity})},
           {"place of the points", kNotNull},
           {"place of their count", kNotNull}},
          Simplify);
    Refuses("bmr_convex32_audit", {{"polygon", kNotNull}},
            [](const Given &g) { return Said(bmr_convex32_audit(g.Or(0, &Convex()->polygon))); });
    Refuses("bmr_convex32_destroy", {{"polygon", kMayBeNull}}, [](const Given &g) {
        bmr_convex32_block *made = nullptr;
        bmr_convex32_create(points.data(), points.size(), nullptr, &made);
        if (g[0] == kNull)
            bmr_convex32_destroy(made, nullptr);
        bmr_convex32_destroy(g.Or(0, made), nullptr);
        return "OK";
    });
    Answers("bmr_convex32_support", "5", {{"direction", Says("0", {kNaN, 0})}}, [](const Given &g) {
        return std::to_string(bmr_convex32_support(&Convex()->polygon, {g.Float(0), g.Float(0)}));
    });
    Answers("bmr_convex32_support_from", "5",
            {{"direction", Says("0", {kNaN, {"0, hint `UINT32_MAX`", 0.0}})},
             {"hint", 3, Says("5", {UINT32_MAX})}},
            [](const Given &g) {
                const auto hint = static_cast<uint32_t>(g[0] == 0.0 ? UINT32_MAX : g[1]);
                return std::to_string(
                    bmr_convex32_support_from(&Convex()->polygon, {g.Float(0), g.Float(0)}, hint));
            });
    Answers("bmr_convex32_contains", "true",
            {{"point", 0, Says("true", {kNaN}) + Says("false", {kInfinity, 1e38})}}, [](const Given &g) {
                return Said(bmr_convex32_contains(&Convex()->polygon, {g.Float(0), g.Float(0)}));
            });
    Answers("bmr_convex32_impact", "touching",
            {{"time", 1, Says("failed", {kNaN}) + Says("separated", {-1})},
             {"angle", 0, Says("failed", {kNaN, kInfinity, 1e38})},
             {"slop", 0.005, Says("failed", {kNaN})}},
            [](const Given &g) {
                return ImpactOf({{0, 0}, {9, 0}, {-9, 0}, 0, g.Float(1), 0}, g.Float(0), g.Float(2));
            });
});

// --- poses ---

const bmr_transform32 kHere = {{0, 0}, 0, 1};

bmr_transform32 Transform(const bmr_pose &pose) {
    return {{static_cast<float>(pose.position.x), static_cast<float>(pose.position.y)},
            static_cast<float>(pose.s),
            static_cast<float>(pose.c)};
}

std::string Apart(const bmr_pose &pose) {
    const bmr_convex32 *polygon = &Convex()->polygon;
    const bmr_transform32 there = Transform(pose);
    bmr_convex32_memory memory = {};
    return bmr_convex32_apart(polygon, &kHere, polygon, &there, 0.0f, &memory) ? "apart" : "no answer";
}

std::string Collide(const bmr_pose &pose) {
    const bmr_convex32 *polygon = &Convex()->polygon;
    const bmr_transform32 there = Transform(pose);
    bmr_convex32_memory memory = {};
    bmr_manifold32 manifold = {};
    bmr_convex32_collide(&manifold, polygon, &kHere, polygon, &there, 0.02f, 0.0005f, &memory);
    return manifold.count == 0 ? "no point" : manifold.count == 1 ? "1 point" : "2 points";
}

std::string Distance(const bmr_pose &pose) {
    const bmr_proxy32 proxy = bmr_proxy32_polygon(Convex(), 0.01f);
    const bmr_transform32 there = Transform(pose);
    bmr_closest32 closest = {0, 0};
    return Said(double{bmr_convex32_distance(&proxy, &kHere, &proxy, &there, &closest).distance});
}

std::string Cast(const bmr_pose &pose) {
    const bmr_proxy32 proxy = bmr_proxy32_polygon(Convex(), 0.01f);
    const bmr_transform32 there = Transform(pose);
    bmr_cast32 cast;
    return bmr_convex32_cast(&proxy, &kHere, &proxy, &there, {-10.0f, 0.0f}, 0.005f, &cast) ? "hit"
                                                                                            : "no hit";
}

/// Its motions have angles instead of sines.
std::string Impact(const bmr_pose &pose) {
    const bmr_vec32 p = Transform(pose).p;
    return pose.c == 1.0 && pose.s == 0.0
               ? ImpactOf({{0, 0}, {p.x, p.y}, {p.x - 10.0f, p.y}, 0, 0, 0}, 1.0f, 0.005f)
               : "-";
}

std::string Swept(const bmr_pose &pose) {
    const bmr_vec32 points[8] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, 0}, {0, 0}, {0, 0}, {0, 0}};
    const bmr_transform32 there = Transform(pose);
    const bmr_motion32 still = {{0, 0}, {0, 0}, {0, 0}, 0, 1, 0},
                       moves = {{0, 0}, there.p, there.p, there.s, there.c, 0};
    bmr_swept32 a, b;
    bmr_swept32_make(&a, points, 4, &still);
    bmr_swept32_make(&b, points, 4, &moves);
    bmr_vec32 direction = {0, 0};
    static const char *const names[] = {"apart", "near", "no answer"};
    return names[bmr_swept32_compare(&a, &b, 0.01f, 0.005f, &direction)];
}

const Table kPoses("poses in float", [] {
    return Poses({{"`bmr_convex32_apart`", Apart},
                  {"`bmr_convex32_collide`", Collide},
                  {"`bmr_convex32_distance`", Distance},
                  {"`bmr_convex32_cast`", Cast},
                  {"`bmr_convex32_impact`", Impact},
                  {"`bmr_swept32_compare`", Swept}});
});

} // namespace
