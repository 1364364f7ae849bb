// SPDX-License-Identifier: MIT
// Bad arguments of core's functions in float (convex32, swept32), and poses that are none.
#include "arguments.h"
#include "bad_poses.h"
#include "convex32/convex32_collide.h"
#include "convex32/convex32_distance.h"
#include "convex32/convex32_envelope.h"
#include "exact32/swept32.h"
#include "points.h"

using namespace bad_input;

namespace {

constexpr float kNone32 = std::numeric_limits<float>::quiet_NaN();

/// A circle's polygon of 40 vertices; every cell has a process of its own, which frees it.
struct World {
    bmr_convex32_block *convex = nullptr;

    World() {
        const std::vector<double> xy = Circle(40, 1.0);
        std::vector<bmr_vec32> points;
        for (size_t i = 0; i < xy.size(); i += 2)
            points.push_back({static_cast<float>(xy[i]), static_cast<float>(xy[i + 1])});
        bmr_convex32_create(points.data(), points.size(), nullptr, &convex);
    }
    World(const World &) = delete;
    World &operator=(const World &) = delete;
    ~World() { bmr_convex32_destroy(convex, nullptr); }
};

std::string Simplify(float tolerance) {
    const World world;
    bmr_vec32 points[40];
    size_t count = 77;
    const bmr_error error = bmr_convex32_simplify(&world.convex->polygon, tolerance, nullptr, points, &count);
    return error != BMR_OK ? Said(error) : std::to_string(count) + " vertices";
}

std::string Impact(float t_max, float slop, float angle = 0.0f) {
    const World world;
    const bmr_proxy32 proxy = bmr_proxy32_polygon(world.convex, 0.01f);
    const bmr_sweep32 still = {{0, 0}, {0, 0}, {0, 0}, 0, 0, 0},
                      moves = {{0, 0}, {9, 0}, {-9, 0}, 0, angle, 0};
    bmr_vec32 direction = {0, 0};
    float t = -1.0f;
    static const char *const names[] = {"FAILED", "OVERLAPPED", "TOUCHING", "SEPARATED"};
    return names[bmr_convex32_impact(&proxy, &still, &proxy, &moves, t_max, slop, &direction, &t)];
}

std::vector<Argument> Arguments() {
    return {
        {"`bmr_convex32_audit`: `NULL`", [] { return Said(bmr_convex32_audit(nullptr)); }},
        {"`bmr_convex32_destroy`: `NULL`",
         [] {
             bmr_convex32_destroy(nullptr, nullptr);
             return std::string("nothing happens");
         }},
        {"`bmr_convex32_support`: direction of NaN",
         [] {
             const World world;
             return std::to_string(bmr_convex32_support(&world.convex->polygon, {kNone32, 1.0f}));
         }},
        {"`bmr_convex32_support_from`: direction of zero, hint `UINT32_MAX`",
         [] {
             const World world;
             return std::to_string(
                 bmr_convex32_support_from(&world.convex->polygon, {0.0f, 0.0f}, UINT32_MAX));
         }},
        {"`bmr_convex32_contains`: a point of NaN",
         [] {
             const World world;
             return Said(bmr_convex32_contains(&world.convex->polygon, {kNone32, kNone32}));
         }},
        {"`bmr_convex32_simplify`: a tolerance of NaN", [] { return Simplify(kNone32); }},
        {"`bmr_convex32_simplify`: a tolerance below 0", [] { return Simplify(-1e-38f); }},
        {"`bmr_convex32_simplify`: a tolerance of -0", [] { return Simplify(-0.0f); }},
        {"`bmr_convex32_simplify`: an infinite tolerance", [] { return Simplify(INFINITY); }},
        {"`bmr_convex32_simplify`: no place for the points",
         [] {
             const World world;
             size_t count = 0;
             return Said(bmr_convex32_simplify(&world.convex->polygon, 0.1f, nullptr, nullptr, &count));
         }},
        {"`bmr_convex32_held`: a tolerance of NaN",
         [] {
             const World world;
             const std::vector<double> xy = Square(1.0);
             bmr_polygon *square = nullptr;
             bmr_polygon_create(reinterpret_cast<const bmr_vec2 *>(xy.data()), xy.size() / 2, nullptr,
                                &square);
             const bool held = bmr_convex32_held(&world.convex->polygon, square, kNone);
             bmr_polygon_destroy(square, nullptr);
             return Said(held);
         }},
        {"`bmr_convex32_impact`: a time of NaN", [] { return Impact(kNone32, 0.005f); }},
        {"`bmr_convex32_impact`: a time below 0", [] { return Impact(-1.0f, 0.005f); }},
        {"`bmr_convex32_impact`: an angle of NaN", [] { return Impact(1.0f, 0.005f, kNone32); }},
        {"`bmr_convex32_impact`: an infinite angle", [] { return Impact(1.0f, 0.005f, INFINITY); }},
        {"`bmr_convex32_impact`: an angle of 1e38", [] { return Impact(1.0f, 0.005f, 1e38f); }},
        {"`bmr_convex32_impact`: a slop of NaN", [] { return Impact(1.0f, kNone32); }},
    };
}

// --- poses ---

bmr_transform32 Transform(const bmr_pose &pose) {
    return {{static_cast<float>(pose.position.x), static_cast<float>(pose.position.y)},
            static_cast<float>(pose.s),
            static_cast<float>(pose.c)};
}

std::string Collide(const bmr_pose &pose) {
    const World world;
    const bmr_transform32 here = {{0, 0}, 0, 1}, there = Transform(pose);
    bmr_convex32_memory memory = {};
    bmr_manifold32 manifold = {};
    bmr_convex32_collide(&manifold, &world.convex->polygon, &here, &world.convex->polygon, &there, 0.02f,
                         0.0005f, &memory);
    return manifold.count == 0 ? "no point" : manifold.count == 1 ? "1 point" : "2 points";
}

std::string Apart(const bmr_pose &pose) {
    const World world;
    const bmr_transform32 here = {{0, 0}, 0, 1}, there = Transform(pose);
    bmr_convex32_memory memory = {};
    return bmr_convex32_apart(&world.convex->polygon, &here, &world.convex->polygon, &there, 0.0f, &memory)
               ? "apart"
               : "no answer";
}

std::string Distance(const bmr_pose &pose) {
    const World world;
    const bmr_proxy32 proxy = bmr_proxy32_polygon(world.convex, 0.01f);
    const bmr_transform32 here = {{0, 0}, 0, 1}, there = Transform(pose);
    bmr_closest32 closest = {0, 0};
    return Said(static_cast<double>(bmr_convex32_distance(&proxy, &here, &proxy, &there, &closest).distance));
}

std::string Cast(const bmr_pose &pose) {
    const World world;
    const bmr_proxy32 proxy = bmr_proxy32_polygon(world.convex, 0.01f);
    const bmr_transform32 here = {{0, 0}, 0, 1}, there = Transform(pose);
    bmr_cast32 cast;
    return bmr_convex32_cast(&proxy, &here, &proxy, &there, {-10.0f, 0.0f}, 0.005f, &cast) ? "hit" : "no hit";
}

std::string ImpactFrom(const bmr_pose &pose) {
    if (pose.c != 1.0 || pose.s != 0.0)
        return "-"; // its motions have angles
    const World world;
    const bmr_proxy32 proxy = bmr_proxy32_polygon(world.convex, 0.01f);
    const auto x = static_cast<float>(pose.position.x), y = static_cast<float>(pose.position.y);
    const bmr_sweep32 still = {{0, 0}, {0, 0}, {0, 0}, 0, 0, 0};
    const bmr_sweep32 moves = {{0, 0}, {x, y}, {x - 10.0f, y}, 0, 0, 0};
    bmr_vec32 direction = {0, 0};
    float t = -1.0f;
    static const char *const names[] = {"failed", "overlapped", "touching", "separated"};
    return names[bmr_convex32_impact(&proxy, &still, &proxy, &moves, 1.0f, 0.005f, &direction, &t)];
}

std::string Swept(const bmr_pose &pose) {
    const World world;
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

std::string PoseAnswer32(size_t row, size_t column) {
    const bmr_pose &pose = kPoses[row].pose;
    switch (column) {
    case 0:
        return Apart(pose);
    case 1:
        return Collide(pose);
    case 2:
        return Distance(pose);
    case 3:
        return Cast(pose);
    case 4:
        return ImpactFrom(pose);
    default:
        return Swept(pose);
    }
}

} // namespace

int main(int argc, char **argv) {
    return Main(argc, argv,
                {ArgumentTable("arguments in float", Arguments()),
                 {"poses in float",
                  {"`bmr_convex32_apart`", "`bmr_convex32_collide`", "`bmr_convex32_distance`",
                   "`bmr_convex32_cast`", "`bmr_convex32_impact`", "`bmr_swept32_compare`"},
                  PoseNames(),
                  PoseAnswer32}});
}
